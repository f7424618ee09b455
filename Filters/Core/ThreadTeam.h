// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_ThreadTeam_h
#define hashedoctree_ThreadTeam_h

#include "Execution.h"

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace hashedoctree
{
/**
 * Threads that stay together for a computation with many parallel loops. What an Execution is
 * handed may start its threads for each loop; a team starts them once.
 *
 * The first of the threads to come leads: it runs the computation. The others wait for its loops
 * and take parts of them. Nobody waits for a thread that has not come, so that it works with any
 * number of threads, one after the other too, and within another parallel loop.
 *
 * The leader takes the parts of every loop from the front, the others from the back. So of two
 * threads each has much the same half in loop after loop, and finds what it wrote in its own cache.
 */
class ThreadTeam
{
public:
  using Computation = std::function<void(const Execution&)>;

  /** Runs the computation, on one of `numberOfThreads` threads of `threads`, and comes back when it
   * is done. The execution that it gets reports no progress, and its loops must not be called from
   * within one another. Throws what the computation or the body of a loop throws; the rest of such
   * a loop is left out. */
  static void Run(
    const Execution& threads, std::size_t numberOfThreads, const Computation& computation);

private:
  /** The end of a loop that a thread takes parts from. */
  enum class Side
  {
    Front,
    Back
  };
  /** Some of a loop, [First, Last). */
  struct Part
  {
    std::size_t First;
    std::size_t Last;
  };

  void Join(const Computation& computation);
  void Lead(const Computation& computation);
  void Follow();

  /** One parallel loop, called by the leader. */
  void DoLoop(std::size_t first, std::size_t last, std::size_t grain, const Execution::Body& body);
  /** Does parts of the loop as long as there are any. Holds the lock in between. */
  void DoParts(std::unique_lock<std::mutex>& lock, Side side);
  /** The next part of a loop that has some, which are fewer then. */
  Part TakePart(Side side);

  std::mutex Mutex;                ///< Guards all of the following.
  std::condition_variable Changed; ///< Tells of changes of these.
  bool HasLeader = false;
  bool IsDone = false;
  std::exception_ptr Error; ///< Of the loop, then of the computation.
  int Busy = 0;             ///< Followers within the loop.
  std::size_t First = 0;    ///< Where the first part that nobody has taken begins,
  std::size_t Last = 0;     ///< and where the last one ends.
  std::size_t Grain = 1;
  const Execution::Body* Body = nullptr;
};
}

#endif
