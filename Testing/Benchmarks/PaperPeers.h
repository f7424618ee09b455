// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_PaperPeers_h
#define Testing_Benchmarks_PaperPeers_h

#include "BrotherChildOctree.h"
#include "Octree.h"
#include "PaperHashedOctree.h"
#include "PointerOctree.h"

#include <memory>
#include <string>
#include <vector>

namespace paper_benchmark
{
using Key = hashedoctree::MortonKey<3>;
using Tree8 = PointerOctree<3>;
using TreeBrotherChild = BrotherChildOctree<3, ParentPointers::No>;
using TreeWithParents = BrotherChildOctree<3, ParentPointers::Yes>;
using TreePaper = PaperHashedOctree<3, hashedoctree::LowBitsHash>;
using TreePaperMixing = PaperHashedOctree<3, hashedoctree::MixingHash>;

/** The same tree in each of the structures. */
struct PaperTrees
{
  hashedoctree::Octree<3> Ours;
  std::unique_ptr<const Tree8> Pointers;
  std::unique_ptr<const TreeBrotherChild> BrotherChild;
  std::unique_ptr<const TreeWithParents> WithParents;
  std::unique_ptr<const TreePaper> Paper;
  std::unique_ptr<const TreePaperMixing> PaperMixing;
};

/** Places in PaperPeers, by what they are. */
enum PaperPeerIndex : std::size_t
{
  Pointers,
  BrotherChild,
  WithParents,
  PaperRoot,
  PaperStart,
  PaperMixing,
  OursRoot,
  OursMedian,
  OursLocal,
  NumberOfPeers
};

/** Their names in the report. */
const std::vector<std::string>& GetPeerNames();

/** A structure with a way to search it. What the searches over many queries return means nothing,
 * but makes sure that they are done. Not thread safe. */
class PaperPeer
{
public:
  using Keys = std::vector<std::uint64_t>;

  PaperPeer() = default;
  PaperPeer(const PaperPeer&) = delete;
  PaperPeer& operator=(const PaperPeer&) = delete;
  virtual ~PaperPeer() = default;

  /** The leaves that hold points, three coordinates each: from coordinates to leaves. */
  virtual std::uint64_t FindLeaves(const std::vector<float>& points) = 0;
  /** The leaves around leaves, which were given before. */
  virtual void SetLeaves(const std::vector<Key>& leaves) = 0;
  virtual std::uint64_t FindAdjacent() = 0;
  virtual std::uint64_t FindInRadius(double radius) = 0;

  /** Single answers, for comparison: the leaf of a point, and the leaves around the leaf of that
   * number among the given ones, sorted. */
  virtual std::uint64_t GetLeaf(const float* point) = 0;
  virtual Keys GetAdjacent(std::size_t leaf) = 0;
  virtual Keys GetInRadius(std::size_t leaf, double radius) = 0;
};

using PaperPeers = std::vector<std::unique_ptr<PaperPeer>>;

/** All peers, in the order of PaperPeerIndex. `startDepth` is that of the paper's layout and of
 * ours but for OursLocal, which has the local medians of all leaves. The trees must outlive them.
 */
PaperPeers MakePeers(const PaperTrees& trees, int startDepth);
}

#endif
