// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_StopSign_h
#define hashedoctree_StopSign_h

#include <atomic>

namespace hashedoctree
{
/**
 * Whether a computation is to stop: goes up, and stays up, when a count of stops that somebody
 * keeps is no longer what it was when the sign was made. So computations that begin later, even
 * inside this one, neither stop for what came before them nor take its sign down. Any thread may
 * count up, and any may ask at any time, which costs hardly anything.
 */
class StopSign
{
public:
  using Count = std::atomic<unsigned>;

  /** Never goes up. */
  StopSign() = default;
  /** `stops` must outlive it. */
  explicit StopSign(const Count& stops)
    : Stops(&stops)
    , Before(stops)
  {
  }

  bool IsUp() const
  {
    return this->Stops != nullptr && this->Stops->load(std::memory_order_relaxed) != this->Before;
  }

private:
  const Count* Stops = nullptr;
  unsigned Before = 0;
};
}

#endif
