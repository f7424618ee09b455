// SPDX-License-Identifier: BSD-3-Clause
#ifndef hashedoctree_NodeCorners_h
#define hashedoctree_NodeCorners_h

#include "Octree.h"

#include <cstddef>
#include <cstdint>

namespace hashedoctree
{
/**
 * The corners of nodes, each numbered once, so that nodes of any depth that touch at a corner share
 * it. Corners are told apart by their integer coordinates in the grid of MaxDepth, never by
 * distances.
 */
template <int Dim>
class NodeCorners
{
public:
  static constexpr unsigned CornersOfNode = 1U << Dim;

  /**
   * Numbers the corners of `nodes`, which may be listed in any order, as they are met on a walk
   * along the Morton curve (NodeWalk). Writes CornersOfNode numbers for each node to
   * `connectivity`, in the order of the list; bit a of a corner's place in its node says that it is
   * the upper one on axis a, so the first axis is the LOW bit, as in a VTK_VOXEL. The first `apart`
   * nodes of the list share no corner with any other; theirs have the last numbers. O(nodes) where
   * they are ordered by depth, then by key; one thread. Beside the results it takes memory for the
   * corners that nodes further along the curve can share, only. Throws Interrupted. Instantiated
   * for int and long long; the numbers must fit.
   */
  template <typename Integer>
  NodeCorners(const Buffer<typename Octree<Dim>::Node>& nodes, std::size_t apart,
    Integer* connectivity, const Execution& execution);

  std::size_t GetNumberOfCorners() const { return this->Count; }

  /** Integer coordinates of a corner, each in [0, 2^MaxDepth]; see Grid::GetCorner(). */
  Cell<Dim> GetCorner(std::size_t corner) const;

private:
  Buffer<std::uint64_t> Codes; ///< Of each corner; sized for the most there can be.
  std::size_t Count = 0;
};
}

#endif
