// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorCheck.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace locator_benchmark
{
LocatorCheck::LocatorCheck(const LocatorData& data, const Question& question, LocatorPeer& ours)
  : Data(data)
  , What(question)
{
  constexpr std::size_t numberOfPositions = 50;
  for (const auto& found :
    GetAnswers(ours, question, std::min(numberOfPositions, question.Positions->size()), INFINITY))
  {
    this->Right.push_back(this->Measure(found.first, found.second));
  }
  this->Sound = this->CompareAHandful();
}

LocatorCheck::Distances2 LocatorCheck::Measure(
  std::size_t position, const std::vector<vtkIdType>& ids) const
{
  Distances2 distances2;
  distances2.reserve(ids.size());
  for (const vtkIdType id : ids)
  {
    distances2.push_back(id < 0
        ? -1.0
        : this->Data.GetDistance2(static_cast<std::size_t>(id), (*this->What.Positions)[position]));
  }
  std::sort(distances2.begin(), distances2.end());
  return distances2;
}

LocatorCheck::Distances2 LocatorCheck::CompareWithEveryPoint(const Position& x) const
{
  Distances2 all(this->Data.GetNumberOfPoints());
  for (std::size_t id = 0; id < all.size(); ++id)
  {
    all[id] = this->Data.GetDistance2(id, x);
  }
  if (this->What.What == Operation::Radius)
  {
    const double radius2 = this->What.Radius * this->What.Radius;
    all.erase(
      std::partition(all.begin(), all.end(), [=](double d) { return d <= radius2; }), all.end());
    std::sort(all.begin(), all.end());
    return all;
  }
  const int count = GetNumberOfClosest(this->What.What);
  std::partial_sort(all.begin(), all.begin() + count, all.end());
  all.resize(static_cast<std::size_t>(count));
  return all;
}

bool LocatorCheck::CompareAHandful() const
{
  constexpr std::size_t handful = 3;
  for (std::size_t i = 0; i < std::min(handful, this->Right.size()); ++i)
  {
    if (this->CompareWithEveryPoint((*this->What.Positions)[i]) != this->Right[i])
    {
      return false;
    }
  }
  return true;
}

CheckResult LocatorCheck::Check(LocatorPeer& peer) const
{
  constexpr double seconds = 0.1;
  CheckResult result;
  for (const auto& found : GetAnswers(peer, this->What, this->Right.size(), seconds))
  {
    ++result.Checked;
    result.Different +=
      this->Measure(found.first, found.second) != this->Right[found.first] ? 1 : 0;
  }
  return result;
}

double LocatorCheck::GetMeanHits() const
{
  const std::size_t hits = std::accumulate(this->Right.begin(), this->Right.end(), std::size_t{ 0 },
    [](std::size_t sum, const Distances2& found) { return sum + found.size(); });
  return static_cast<double>(hits) / static_cast<double>(this->Right.size());
}
}
