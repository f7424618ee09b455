// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_Rounding_h
#define Testing_Support_Rounding_h

#include <cfenv>

namespace hashedoctree
{
/** While it lives, the processor rounds as told, one of the FE_ numbers of <cfenv>. */
class Rounding
{
public:
  explicit Rounding(int mode) { std::fesetround(mode); }
  ~Rounding() { std::fesetround(this->Before); }
  Rounding(const Rounding&) = delete;
  Rounding& operator=(const Rounding&) = delete;

private:
  int Before = std::fegetround();
};
}

#endif
