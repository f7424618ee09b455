// SPDX-License-Identifier: BSD-3-Clause
#include "NodeCorners.h"

#include "ForEachDimension.h"
#include "NodeWalk.h"
#include "OpenCorners.h"

#include <algorithm>
#include <array>

namespace hashedoctree
{
namespace
{
/** Lower corner and side of a node, in cells of MaxDepth. */
template <int Dim>
struct NodeExtent
{
  Cell<Dim> Lower;
  std::uint32_t Side;

  explicit NodeExtent(MortonKey<Dim> key)
    : Lower(key.GetCell())
    , Side(1U << (MortonKey<Dim>::MaxDepth - key.GetDepth()))
  {
    for (std::uint32_t& coordinate : this->Lower)
    {
      coordinate *= this->Side;
    }
  }

  Cell<Dim> GetCorner(unsigned corner) const
  {
    Cell<Dim> coordinates = this->Lower;
    for (int axis = 0; axis < Dim; ++axis)
    {
      coordinates[axis] += (corner >> axis & 1U) * this->Side;
    }
    return coordinates;
  }
};

constexpr double WalkShare = 0.05;    // Of the progress, until the walk can begin.
constexpr std::size_t GroupSize = 16; // Nodes whose corners the machine loads together.
}

template <int Dim>
Cell<Dim> NodeCorners<Dim>::GetCorner(std::size_t corner) const
{
  return DecodeCorner<Dim>(this->Codes[corner]);
}

template <int Dim>
template <typename Integer>
NodeCorners<Dim>::NodeCorners(const Buffer<typename Octree<Dim>::Node>& nodes, std::size_t apart,
  Integer* connectivity, const Execution& execution)
  : Codes(nodes.GetSize() * CornersOfNode)
{
  const std::size_t numberOfNodes = nodes.GetSize();
  NodeWalk<Dim> walk(nodes, apart, execution.Part(0.0, WalkShare));
  const Execution rest = execution.Part(WalkShare, 1.0);
  OpenCorners<Dim> open;
  std::array<std::size_t, GroupSize> places;
  std::array<std::array<std::uint64_t, CornersOfNode>, GroupSize> codes;
  for (std::size_t walked = apart; walked < numberOfNodes; walked += GroupSize)
  {
    const double done = static_cast<double>(walked) / static_cast<double>(numberOfNodes);
    const std::size_t size = std::min(GroupSize, numberOfNodes - walked);
    for (std::size_t i = 0; i < size; ++i)
    {
      places[i] = walk.Next();
      const NodeExtent<Dim> extent(nodes[places[i]].NodeKey);
      for (unsigned corner = 0; corner < CornersOfNode; ++corner)
      {
        codes[i][corner] = EncodeCorner<Dim>(extent.GetCorner(corner));
        open.Prefetch(codes[i][corner]);
      }
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const MortonKey<Dim> first = nodes[places[i]].NodeKey.GetFirstAtMaxDepth();
      for (unsigned corner = 0; corner < CornersOfNode; ++corner)
      {
        const std::uint64_t code = codes[i][corner];
        const std::uint64_t number = open.FindOrInsert(code, this->Count, first, rest, done);
        if (number == this->Count)
        {
          this->Codes[this->Count++] = code;
        }
        connectivity[places[i] * CornersOfNode + corner] = static_cast<Integer>(number);
      }
    }
  }
  open.Clear(rest);
  for (std::size_t place = 0; place < apart; ++place)
  {
    const NodeExtent<Dim> extent(nodes[place].NodeKey);
    for (unsigned corner = 0; corner < CornersOfNode; ++corner)
    {
      connectivity[place * CornersOfNode + corner] = static_cast<Integer>(this->Count);
      this->Codes[this->Count++] = EncodeCorner<Dim>(extent.GetCorner(corner));
    }
  }
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class NodeCorners<Dim>;                                                                 \
  template NodeCorners<Dim>::NodeCorners(                                                          \
    const Buffer<Octree<Dim>::Node>&, std::size_t, int*, const Execution&);                        \
  template NodeCorners<Dim>::NodeCorners(                                                          \
    const Buffer<Octree<Dim>::Node>&, std::size_t, long long*, const Execution&);
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
