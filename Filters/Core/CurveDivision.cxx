// SPDX-License-Identifier: BSD-3-Clause
#include "CurveDivision.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace hashedoctree
{
namespace
{
template <typename Key>
bool IsBefore(Key a, Key b)
{
  return a < b;
}

template <typename Key>
bool IsAfter(Key a, Key b)
{
  return b < a;
}

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

/** The first `count` keys in an order, or all, in no order. */
template <typename Keys, typename Order>
Keys TakeFirst(Keys keys, std::size_t count, const Order& order)
{
  if (count < keys.size())
  {
    const auto end = keys.begin() + static_cast<std::ptrdiff_t>(count);
    std::nth_element(keys.begin(), end, keys.end(), order);
    keys.resize(count);
  }
  return keys;
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
    sample.push_back(keys[i]);
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
std::vector<typename CurveDivision<Dim>::Keys> CurveDivision<Dim>::Deal(const Keys& keys) const
{
  std::vector<Keys> parts(this->GetNumberOfParts());
  for (const Key key : keys)
  {
    parts[this->FindPart(key)].push_back(key);
  }
  return parts;
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
std::vector<typename CurveDivision<Dim>::Keys> CurveDivision<Dim>::GetOverlaps(std::size_t part,
  const Keys& keys, const std::vector<std::uint64_t>& pointsOfParts, std::size_t overlap)
{
  std::vector<Keys> overlaps(pointsOfParts.size());
  const Keys last = TakeFirst(keys, overlap, IsAfter<Key>);
  std::uint64_t missing = overlap; // What the parts between do not have.
  for (std::size_t after = part + 1; after < overlaps.size() && missing > 0; ++after)
  {
    overlaps[after] = TakeFirst(last, missing, IsAfter<Key>);
    missing -= std::min(missing, pointsOfParts[after]);
  }
  const Keys first = TakeFirst(keys, overlap, IsBefore<Key>);
  missing = overlap;
  for (std::size_t before = part; before-- > 0 && missing > 0;)
  {
    overlaps[before] = TakeFirst(first, missing, IsBefore<Key>);
    missing -= std::min(missing, pointsOfParts[before]);
  }
  return overlaps;
}

template class CurveDivision<1>;
template class CurveDivision<2>;
template class CurveDivision<3>;
template class CurveDivision<4>;
}
