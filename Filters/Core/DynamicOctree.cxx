// SPDX-License-Identifier: BSD-3-Clause
#include "DynamicOctree.h"

#include "ForEachDimension.h"
#include "NodeIndex.h"

#include <cassert>
#include <stdexcept>

namespace hashedoctree
{
namespace
{
/** The bit of an octant, for masks that are changed by |= and ^=. */
template <int Dim>
OctantMask<Dim> GetBit(unsigned octant)
{
  return static_cast<OctantMask<Dim>>(1U << octant);
}
}

template <int Dim>
DynamicOctree<Dim>::DynamicOctree(const Grid<Dim>& grid, const Options& options)
  : RootGrid(grid)
  , TreeOptions(options)
{
  assert(options.AreInRange());
  constexpr std::size_t depths = Key::MaxDepth + 1;
  this->Counts.Leaves.reserve(depths);
  this->Counts.EmptyLeaves.reserve(depths);
  this->Counts.Points.reserve(depths);
  this->TakeBlock(); // AboveRoot
}

template <int Dim>
bool DynamicOctree<Dim>::Insert(std::uint32_t id, const Position<Dim>& x)
{
  const Key key = this->GetKey(x);
  if (id == NoPoint)
  {
    throw std::invalid_argument("The id of a point must be below 2^32 - 1.");
  }
  if (this->HasPoint(id))
  {
    return false;
  }
  const int startDepth = this->GetStartDepth(FrequencyModel::Points);
  this->MakeRoom(id);
  this->Add(id, key, startDepth);
  return true;
}

template <int Dim>
bool DynamicOctree<Dim>::Erase(std::uint32_t id)
{
  if (!this->HasPoint(id))
  {
    return false;
  }
  this->Remove(id, this->GetStartDepth(FrequencyModel::Points));
  return true;
}

template <int Dim>
bool DynamicOctree<Dim>::Move(std::uint32_t id, const Position<Dim>& x)
{
  const Key key = this->GetKey(x);
  if (!this->HasPoint(id))
  {
    return false;
  }
  const int startDepth = this->GetStartDepth(FrequencyModel::Points);
  const Key leaf = FindLeaf(*this, this->Points[id].PointKey, startDepth).Key;
  if (key.AtDepth(leaf.GetDepth()) == leaf)
  {
    this->Points[id].PointKey = key;
    return true;
  }
  this->MakeRoom(id);
  this->Remove(id, startDepth);
  this->Add(id, key, startDepth);
  return true;
}

template <int Dim>
typename DynamicOctree<Dim>::Key DynamicOctree<Dim>::GetKey(const Position<Dim>& x) const
{
  if (!IsFinite(x))
  {
    throw std::invalid_argument("The position of a point must be finite.");
  }
  return this->RootGrid.GetKey(x.data());
}

/** Whatever a change may need, so that nothing fails once it has begun. */
template <int Dim>
void DynamicOctree<Dim>::MakeRoom(std::uint32_t id)
{
  constexpr std::size_t mostNewBlocks = Key::MaxDepth;
  const std::size_t blocks = this->Blocks.size() + mostNewBlocks;
  RequireNodeIndices(blocks);
  if (id >= this->Points.size())
  {
    this->Points.resize(id + std::size_t(1));
  }
  if (blocks > this->Blocks.capacity())
  {
    this->Blocks.reserve(2 * blocks);
  }
  this->Table.Reserve(this->Table.GetNumberOfKeys() + mostNewBlocks);
}

template <int Dim>
void DynamicOctree<Dim>::Add(std::uint32_t id, Key key, int startDepth)
{
  const FoundLeaf<Dim> leaf = FindLeaf(*this, key, startDepth, EmptyOctants::Missing);
  int depth = leaf.Key.GetDepth();
  std::uint32_t parent = leaf.ParentBlock;
  this->Points[id].PointKey = key;
  this->Link(id, parent, leaf.Key.GetOctant());
  ++this->NumberOfPoints;
  ++this->Counts.Points[static_cast<std::size_t>(depth)];
  if (!leaf.Exists)
  {
    --this->Counts.EmptyLeaves[static_cast<std::size_t>(depth)];
    this->TellTable(leaf.Key.GetParent(), parent);
  }
  // Only the child that the new point is in can be too full in its turn.
  for (; depth < this->TreeOptions.MaxDepth; ++depth)
  {
    const Key node = key.AtDepth(depth);
    if (this->FitInLeaf(&this->Blocks[parent].Children[node.GetOctant()], 1))
    {
      break;
    }
    parent = this->Split(node, parent);
  }
}

template <int Dim>
void DynamicOctree<Dim>::Remove(std::uint32_t id, int startDepth)
{
  const FoundLeaf<Dim> leaf = FindLeaf(*this, this->Points[id].PointKey, startDepth);
  const auto depth = static_cast<std::size_t>(leaf.Key.GetDepth());
  std::uint32_t parent = leaf.ParentBlock;
  this->Unlink(id, parent, leaf.Key.GetOctant());
  this->Points[id].PointKey = Key(0);
  --this->NumberOfPoints;
  --this->Counts.Points[depth];
  if ((this->Blocks[parent].Occupied >> leaf.Key.GetOctant() & 1U) == 0)
  {
    ++this->Counts.EmptyLeaves[depth];
    this->TellTable(leaf.Key.GetParent(), parent);
  }
  for (Key node = leaf.Key; node != Key::Root(); node = node.GetParent())
  {
    const Block& siblings = this->Blocks[parent];
    if (siblings.Internal != 0 || !this->FitInLeaf(siblings.Children.data(), NumberOfOctants))
    {
      break;
    }
    parent = this->Collapse(node.GetParent(), parent);
  }
  this->RemoveEmptyDepths();
}

/** Makes a leaf, which holds points, internal. Returns its block. */
template <int Dim>
std::uint32_t DynamicOctree<Dim>::Split(Key node, std::uint32_t parent)
{
  const auto depth = static_cast<std::size_t>(node.GetDepth());
  const std::uint32_t block = this->TakeBlock();
  std::uint64_t numberOfPoints = 0;
  std::uint32_t& child = this->Blocks[parent].Children[node.GetOctant()];
  for (std::uint32_t id = child; id != NoPoint; ++numberOfPoints)
  {
    const std::uint32_t next = this->Points[id].Next;
    this->Link(id, block, this->Points[id].PointKey.AtDepth(node.GetDepth() + 1).GetOctant());
    id = next;
  }
  child = block;
  this->Blocks[parent].Internal |= GetBit<Dim>(node.GetOctant());
  this->TellTable(node.GetParent(), parent);
  this->Table.Insert(node.GetValue(), Entry{ block, 0, this->Blocks[block].Occupied });

  this->AddDepth(depth + 1);
  --this->Counts.Leaves[depth];
  this->Counts.Points[depth] -= numberOfPoints;
  this->Counts.Leaves[depth + 1] += NumberOfOctants;
  this->Counts.Points[depth + 1] += numberOfPoints;
  this->Counts.EmptyLeaves[depth + 1] +=
    NumberOfOctants - CountOctants(this->Blocks[block].Occupied);
  return block;
}

/** Makes an internal node, whose children are leaves, a leaf. Returns the block of its parent. */
template <int Dim>
std::uint32_t DynamicOctree<Dim>::Collapse(Key node, std::uint32_t block)
{
  const auto depth = static_cast<std::size_t>(node.GetDepth());
  const std::uint32_t parent =
    node == Key::Root() ? AboveRoot : this->Table.Find(node.GetParent().GetValue())->Block;
  this->Blocks[parent].Internal ^= GetBit<Dim>(node.GetOctant());
  this->Blocks[parent].Children[node.GetOctant()] = NoPoint;
  const Block children = this->Blocks[block];
  std::uint64_t numberOfPoints = 0;
  for (std::uint32_t id : children.Children)
  {
    for (; id != NoPoint; ++numberOfPoints)
    {
      const std::uint32_t next = this->Points[id].Next;
      this->Link(id, parent, node.GetOctant());
      id = next;
    }
  }
  this->TellTable(node.GetParent(), parent);
  this->Table.Erase(node.GetValue());
  this->Blocks[block].Children[0] = this->FirstFree;
  this->FirstFree = block;

  ++this->Counts.Leaves[depth];
  this->Counts.Points[depth] += numberOfPoints;
  this->Counts.Leaves[depth + 1] -= NumberOfOctants;
  this->Counts.Points[depth + 1] -= numberOfPoints;
  this->Counts.EmptyLeaves[depth + 1] -= NumberOfOctants - CountOctants(children.Occupied);
  return parent;
}

/** Lets the counts reach down to a depth, whose parent they reach. */
template <int Dim>
void DynamicOctree<Dim>::AddDepth(std::size_t depth)
{
  if (depth == this->Counts.Leaves.size())
  {
    this->Counts.Leaves.push_back(0);
    this->Counts.EmptyLeaves.push_back(0);
    this->Counts.Points.push_back(0);
  }
}

template <int Dim>
void DynamicOctree<Dim>::RemoveEmptyDepths()
{
  while (this->Counts.Leaves.back() == 0)
  {
    this->Counts.Leaves.pop_back();
    this->Counts.EmptyLeaves.pop_back();
    this->Counts.Points.pop_back();
  }
}

template <int Dim>
void DynamicOctree<Dim>::Link(std::uint32_t id, std::uint32_t block, unsigned octant)
{
  std::uint32_t& first = this->Blocks[block].Children[octant];
  if (first != NoPoint)
  {
    this->Points[first].Previous = id;
  }
  this->Points[id].Next = first;
  this->Points[id].Previous = NoPoint;
  first = id;
  this->Blocks[block].Occupied |= GetBit<Dim>(octant);
}

template <int Dim>
void DynamicOctree<Dim>::Unlink(std::uint32_t id, std::uint32_t block, unsigned octant)
{
  const Point& point = this->Points[id];
  std::uint32_t& first = this->Blocks[block].Children[octant];
  (point.Previous == NoPoint ? first : this->Points[point.Previous].Next) = point.Next;
  if (point.Next != NoPoint)
  {
    this->Points[point.Next].Previous = point.Previous;
  }
  if (first == NoPoint)
  {
    this->Blocks[block].Occupied ^= GetBit<Dim>(octant);
  }
}

/** Whether the points of some lists, one after the other, are few enough for one leaf. */
template <int Dim>
bool DynamicOctree<Dim>::FitInLeaf(const std::uint32_t* lists, unsigned numberOfLists) const
{
  std::size_t room = this->TreeOptions.MaxPointsPerLeaf;
  for (unsigned i = 0; i < numberOfLists; ++i)
  {
    for (std::uint32_t id = lists[i]; id != NoPoint; id = this->Points[id].Next)
    {
      if (room == 0)
      {
        return false;
      }
      --room;
    }
  }
  return true;
}

/** A block without points, in room that has been made. */
template <int Dim>
std::uint32_t DynamicOctree<Dim>::TakeBlock()
{
  std::uint32_t block = this->FirstFree;
  if (block == AboveRoot)
  {
    block = static_cast<std::uint32_t>(this->Blocks.size());
    this->Blocks.emplace_back();
  }
  else
  {
    this->FirstFree = this->Blocks[block].Children[0];
  }
  this->Blocks[block] = Block{};
  this->Blocks[block].Children.fill(NoPoint);
  return block;
}

/** Gives the table the masks of an internal node. What is above the root has no entry. */
template <int Dim>
void DynamicOctree<Dim>::TellTable(Key node, std::uint32_t block)
{
  if (block != AboveRoot)
  {
    *this->Table.Find(node.GetValue()) =
      Entry{ block, this->Blocks[block].Internal, this->Blocks[block].Occupied };
  }
}

#define HASHEDOCTREE_INSTANTIATE(Dim) template class DynamicOctree<Dim>;
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
