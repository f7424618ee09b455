// SPDX-License-Identifier: BSD-3-Clause
#include "LocatorCheck.h"

#include <algorithm>
#include <numeric>

namespace locator_benchmark
{
LocatorCheck::LocatorCheck(const LocatorData& data, const Question& question, LocatorPeer& ours)
  : Data(data)
  , What(question)
  , Checked(std::min(NumberOfPositions, question.Positions->size()))
  , Right(this->Measure(ours, this->Checked))
  , Sound(this->CompareAHandful())
{
}

std::vector<LocatorCheck::Distances2> LocatorCheck::Measure(
  LocatorPeer& peer, std::size_t numberOfPositions) const
{
  std::vector<Distances2> measured;
  for (const std::vector<vtkIdType>& ids : GetAnswers(peer, this->What, numberOfPositions))
  {
    const Position& x = (*this->What.Positions)[measured.size()];
    Distances2 distances2;
    for (const vtkIdType id : ids)
    {
      distances2.push_back(
        id < 0 ? -1.0 : this->Data.GetDistance2(static_cast<std::size_t>(id), x));
    }
    std::sort(distances2.begin(), distances2.end());
    measured.push_back(std::move(distances2));
  }
  return measured;
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
  const std::ptrdiff_t count = this->What.What == Operation::Closest ? 1
    : this->What.What == Operation::Closest8                         ? 8
                                                                     : 32;
  std::partial_sort(all.begin(), all.begin() + count, all.end());
  all.resize(static_cast<std::size_t>(count));
  return all;
}

bool LocatorCheck::CompareAHandful() const
{
  constexpr std::size_t Handful = 3;
  for (std::size_t i = 0; i < std::min(Handful, this->Checked); ++i)
  {
    if (this->CompareWithEveryPoint((*this->What.Positions)[i]) != this->Right[i])
    {
      return false;
    }
  }
  return true;
}

std::size_t LocatorCheck::CountDifferences(LocatorPeer& peer) const
{
  const std::vector<Distances2> measured = this->Measure(peer, this->Checked);
  std::size_t differences = 0;
  for (std::size_t i = 0; i < this->Checked; ++i)
  {
    differences += measured[i] != this->Right[i] ? 1 : 0;
  }
  return differences;
}

double LocatorCheck::GetMeanHits() const
{
  const std::size_t hits = std::accumulate(this->Right.begin(), this->Right.end(), std::size_t{ 0 },
    [](std::size_t sum, const Distances2& found) { return sum + found.size(); });
  return static_cast<double>(hits) / static_cast<double>(std::max<std::size_t>(this->Checked, 1));
}
}
