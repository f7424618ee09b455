// SPDX-License-Identifier: BSD-3-Clause
#include "NodeCorners.h"

namespace hashedoctree
{
namespace
{
/** Corners on one axis. A corner's coordinates are the digits of its code in this base. */
template <int Dim>
constexpr std::uint64_t CodeBase = (std::uint64_t(1) << MortonKey<Dim>::MaxDepth) + 1;

/** Lower corner and side of a node, in cells of MaxDepth. */
template <int Dim>
struct Extent
{
  Cell<Dim> Lower;
  std::uint32_t Side;

  explicit Extent(MortonKey<Dim> key)
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

constexpr std::size_t BatchSize = 131072;   // Nodes or corners between two reports of progress.
constexpr std::size_t PrefetchDistance = 6; // Nodes ahead whose corners are on the way.
}

template <int Dim>
std::uint64_t NodeCorners<Dim>::Code(const Cell<Dim>& corner)
{
  std::uint64_t code = 0;
  for (const std::uint32_t coordinate : corner)
  {
    code = code * CodeBase<Dim> + coordinate;
  }
  return code + 1; // A table knows no key 0.
}

template <int Dim>
Cell<Dim> NodeCorners<Dim>::GetCorner(std::size_t corner) const
{
  Cell<Dim> coordinates;
  std::uint64_t code = this->Codes[corner] - 1;
  for (int axis = Dim - 1; axis >= 0; --axis)
  {
    coordinates[axis] = static_cast<std::uint32_t>(code % CodeBase<Dim>);
    code /= CodeBase<Dim>;
  }
  return coordinates;
}

template <int Dim>
template <typename Integer>
NodeCorners<Dim>::NodeCorners(const Buffer<typename Octree<Dim>::Node>& nodes,
  Integer* connectivity, const Execution& execution)
  : Codes(nodes.GetSize() * CornersOfNode)
{
  const std::size_t numberOfNodes = nodes.GetSize();
  std::size_t room = std::min(this->Codes.GetSize(), 2 * numberOfNodes + CornersOfNode);
  NodeTable<Integer> numbers(room);
  for (std::size_t node = 0; node < numberOfNodes; ++node)
  {
    if (room < this->Codes.GetSize() && this->Count + CornersOfNode > room)
    {
      room = std::min(this->Codes.GetSize(), 2 * room);
      numbers = NodeTable<Integer>(room);
      for (std::size_t corner = 0; corner < this->Count; ++corner)
      {
        numbers.Insert(this->Codes[corner], static_cast<Integer>(corner));
        if (corner % BatchSize == 0)
        {
          execution.Tell(static_cast<double>(node) / static_cast<double>(numberOfNodes));
        }
      }
    }
    const Extent<Dim> ahead(nodes[std::min(node + PrefetchDistance, numberOfNodes - 1)].NodeKey);
    const Extent<Dim> extent(nodes[node].NodeKey);
    for (unsigned corner = 0; corner < CornersOfNode; ++corner)
    {
      numbers.Prefetch(Code(ahead.GetCorner(corner)));
      const std::uint64_t code = Code(extent.GetCorner(corner));
      const Integer* number = numbers.Find(code);
      if (number == nullptr)
      {
        this->Codes[this->Count] = code;
        number = &numbers.Insert(code, static_cast<Integer>(this->Count++));
      }
      connectivity[node * CornersOfNode + corner] = *number;
    }
    if (node % BatchSize == 0)
    {
      execution.Tell(static_cast<double>(node) / static_cast<double>(numberOfNodes));
    }
  }
}

#define HASHEDOCTREE_INSTANTIATE(Dim)                                                              \
  template class NodeCorners<Dim>;                                                                 \
  template NodeCorners<Dim>::NodeCorners(                                                          \
    const Buffer<Octree<Dim>::Node>&, long*, const Execution&);                                    \
  template NodeCorners<Dim>::NodeCorners(                                                          \
    const Buffer<Octree<Dim>::Node>&, long long*, const Execution&);
HASHEDOCTREE_INSTANTIATE(1)
HASHEDOCTREE_INSTANTIATE(2)
HASHEDOCTREE_INSTANTIATE(3)
HASHEDOCTREE_INSTANTIATE(4)
#undef HASHEDOCTREE_INSTANTIATE
}
