// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Parted_h
#define hashedoctree_Parted_h

#include <cstddef>
#include <vector>

namespace hashedoctree
{
/** Values of several parts, one part after the other. */
template <typename T>
struct Parted
{
  std::vector<T> Values;
  std::vector<std::size_t> Counts; ///< How many each part has.

  /** Where each part begins among the values. */
  std::vector<std::size_t> GetBegins() const
  {
    std::vector<std::size_t> begins(this->Counts.size(), 0);
    for (std::size_t part = 1; part < begins.size(); ++part)
    {
      begins[part] = begins[part - 1] + this->Counts[part - 1];
    }
    return begins;
  }
};
}

#endif
