// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_Parted_h
#define hashedoctree_Parted_h

#include <cstddef>
#include <numeric>
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
    std::vector<std::size_t> begins(this->Counts.size());
    std::exclusive_scan(this->Counts.begin(), this->Counts.end(), begins.begin(), std::size_t(0));
    return begins;
  }
};
}

#endif
