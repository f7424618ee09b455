// SPDX-License-Identifier: BSD-3-Clause
#include "CurveDivision.h"

#include "ForEachDimension.h"
#include "NodeHash.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

namespace hashedoctree
{
namespace
{
/** How many of some keys are in each node on the way to one key. */
template <int Dim>
class KeysAround
{
public:
  using Key = MortonKey<Dim>;

  KeysAround(Key center, const std::vector<Key>& keys)
    : Center(center)
  {
    for (const Key key : keys)
    {
      ++this->KeysBelow[static_cast<std::size_t>(Key::GetCommonDepth(center, key))];
    }
    std::partial_sum(this->KeysBelow.rbegin(), this->KeysBelow.rend(), this->KeysBelow.rbegin());
  }

  /** 0 where the node is not on the way. */
  std::uint64_t CountIn(Key node) const
  {
    const int depth = node.GetDepth();
    return this->Center.AtDepth(depth) == node ? this->KeysBelow[static_cast<std::size_t>(depth)]
                                               : 0;
  }

private:
  Key Center;
  std::array<std::uint64_t, Key::MaxDepth + 1> KeysBelow{}; ///< In its node at a depth.
};

/** The first `count` keys in an order, or all, in this order. */
template <typename Keys, typename Order>
Keys TakeFirst(const Keys& keys, std::size_t count, const Order& order)
{
  Keys first(std::min(count, keys.size()));
  std::partial_sort_copy(keys.begin(), keys.end(), first.begin(), first.end(), order);
  return first;
}

/** A number below `end` for each i, all over. */
std::uint64_t Scatter(std::uint64_t i, std::uint64_t end)
{
  return (i * GoldenMultiplier >> 32) % end;
}
}

template <int Dim>
typename CurveDivision<Dim>::Keys CurveDivision<Dim>::Sample(
  const Keys& keys, std::uint64_t allPoints, std::size_t numberOfParts)
{
  const std::uint64_t step = allPoints / (KeysPerPart * numberOfParts) + 1;
  Keys sample;
  for (std::uint64_t i = 0; i < keys.size(); i += step)
  {
    sample.push_back(keys[std::min<std::uint64_t>(i + Scatter(i, step), keys.size() - 1)]);
  }
  return sample;
}

template <int Dim>
CurveDivision<Dim>::CurveDivision(Keys sample, std::size_t numberOfParts, int maxDepth)
{
  std::sort(sample.begin(), sample.end());
  this->FirstOfPart.push_back(Key::Root().GetFirstAtMaxDepth());
  for (std::size_t part = 1; part < numberOfParts; ++part)
  {
    this->FirstOfPart.push_back(sample.empty()
        ? this->FirstOfPart.front()
        : sample[part * sample.size() / numberOfParts].AtDepth(maxDepth).GetFirstAtMaxDepth());
  }
}

template <int Dim>
CurveRange<Dim> CurveDivision<Dim>::GetRange(std::size_t part) const
{
  CurveRange<Dim> range;
  range.First = this->FirstOfPart[part];
  if (part + 1 < this->FirstOfPart.size())
  {
    range.Last = Key(this->FirstOfPart[part + 1].GetValue() - 1);
  }
  return range;
}

template <int Dim>
std::size_t CurveDivision<Dim>::FindPart(Key key) const
{
  const auto after = std::upper_bound(this->FirstOfPart.begin(), this->FirstOfPart.end(), key);
  return static_cast<std::size_t>(after - this->FirstOfPart.begin()) - 1;
}

template <int Dim>
Parted<MortonKey<Dim>> CurveDivision<Dim>::Deal(const Keys& keys) const
{
  Parted<Key> dealt{ Keys(keys.size()), std::vector<std::size_t>(this->GetNumberOfParts(), 0) };
  for (const Key key : keys)
  {
    ++dealt.Counts[this->FindPart(key)];
  }
  std::vector<std::size_t> next = dealt.GetBegins();
  for (const Key key : keys)
  {
    dealt.Values[next[this->FindPart(key)]++] = key;
  }
  return dealt;
}

template <int Dim>
typename CurveDivision<Dim>::Keys CurveDivision<Dim>::GetNodesAcross() const
{
  Keys nodes;
  for (const Key first : this->FirstOfPart)
  {
    if (first == this->FirstOfPart.front())
    {
      continue; // Nothing is before it.
    }
    const Key before(first.GetValue() - 1);
    for (int depth = Key::GetCommonDepth(before, first); depth >= 0; --depth)
    {
      nodes.push_back(first.AtDepth(depth));
    }
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

template <int Dim>
std::vector<std::uint64_t> CurveDivision<Dim>::CountInNodesAcross(
  std::size_t part, const Keys& keys) const
{
  const CurveRange<Dim> range = this->GetRange(part);
  const KeysAround<Dim> first(range.First, keys);
  const KeysAround<Dim> last(range.Last, keys);
  std::vector<std::uint64_t> counts;
  for (const Key node : this->GetNodesAcross())
  {
    // One that has a key of the part, and one of another, has an end of the part.
    counts.push_back(std::max(first.CountIn(node), last.CountIn(node)));
  }
  return counts;
}

template <int Dim>
Parted<MortonKey<Dim>> CurveDivision<Dim>::GetOverlaps(std::size_t part, const Keys& keys,
  const std::vector<std::uint64_t>& pointsOfParts, std::size_t overlap)
{
  const Keys first = TakeFirst(keys, overlap, std::less<>());
  const Keys last = TakeFirst(keys, overlap, std::greater<>());
  Parted<Key> overlaps;
  for (std::size_t other = 0; other < pointsOfParts.size(); ++other)
  {
    // What the parts between do not have.
    std::uint64_t missing = other == part ? 0 : overlap;
    for (std::size_t between = std::min(part, other) + 1; between < std::max(part, other);
         ++between)
    {
      missing -= std::min(missing, pointsOfParts[between]);
    }
    const Keys& nearest = other < part ? first : last;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(missing, nearest.size()));
    overlaps.Values.insert(
      overlaps.Values.end(), nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count));
    overlaps.Counts.push_back(count);
  }
  return overlaps;
}

#define HASHEDOCTREE_INSTANTIATE(Dim) template class CurveDivision<Dim>;
HASHEDOCTREE_FOR_EACH_DIMENSION(HASHEDOCTREE_INSTANTIATE)
#undef HASHEDOCTREE_INSTANTIATE
}
