// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Support_CurveBuilders_h
#define Testing_Support_CurveBuilders_h

#include "CurveDivision.h"
#include "SampleTree.h"

#include <memory>
#include <random>

template <int Dim>
using CurveKeys = std::vector<hashedoctree::MortonKey<Dim>>;

/** Builders with points at random, who divide the curve and each make a tree of one part. */
template <int Dim>
struct CurveBuilders
{
  using Division = hashedoctree::CurveDivision<Dim>;
  std::unique_ptr<Division> Divided;
  std::vector<std::unique_ptr<hashedoctree::Octree<Dim>>> Trees;
  std::vector<CurveKeys<Dim>> Own;

  CurveBuilders(const PointSample<Dim, double>& sample, const hashedoctree::Octree<Dim>& whole,
    std::size_t number)
  {
    const auto& options = whole.GetOptions();
    std::vector<CurveKeys<Dim>> given(number);
    std::mt19937 random(7);
    for (std::size_t i = 0; i < whole.GetNumberOfPoints(); ++i)
    {
      // Those that take part, in an order that is not that of the curve.
      const std::size_t point = whole.GetPointIds()[i];
      given[random() % number].push_back(
        whole.GetGrid().GetKey(hashedoctree::GetPosition<Dim>(sample.GetSpan(), point)));
    }
    CurveKeys<Dim> samples;
    for (const CurveKeys<Dim>& keys : given)
    {
      const CurveKeys<Dim> ofBuilder = Division::Sample(keys, whole.GetNumberOfPoints(), number);
      samples.insert(samples.end(), ofBuilder.begin(), ofBuilder.end());
    }
    this->Divided = std::make_unique<Division>(samples, number, options.MaxDepth);
    this->Own.resize(number);
    for (const CurveKeys<Dim>& keys : given)
    {
      const std::vector<CurveKeys<Dim>> dealt = this->Divided->Deal(keys);
      for (std::size_t part = 0; part < number; ++part)
      {
        this->Own[part].insert(this->Own[part].end(), dealt[part].begin(), dealt[part].end());
      }
    }
    this->Build(whole);
  }

private:
  void Build(const hashedoctree::Octree<Dim>& whole)
  {
    const std::size_t overlap = Division::CountOverlap(whole.GetOptions().MaxPointsPerLeaf);
    std::vector<CurveKeys<Dim>> first;
    std::vector<CurveKeys<Dim>> last;
    for (const CurveKeys<Dim>& keys : this->Own)
    {
      first.push_back(Division::FindFirst(keys, overlap));
      last.push_back(Division::FindLast(keys, overlap));
    }
    for (std::size_t part = 0; part < this->Own.size(); ++part)
    {
      CurveKeys<Dim> keys = Division::GetAround(part, first, last, overlap);
      keys.insert(keys.end(), this->Own[part].begin(), this->Own[part].end());
      this->Trees.push_back(std::make_unique<hashedoctree::Octree<Dim>>(
        whole.GetGrid(), keys, whole.GetOptions(), hashedoctree::Execution()));
    }
  }
};

template <int Dim>
std::vector<PointSample<Dim, double>> MakeDividedSamples()
{
  auto samples = MakePointSamples<Dim, double>();
  samples.push_back({ "uniform", MakeUniformPoints<Dim, double>(3000, 11) });
  samples.push_back({ "clustered", MakeClusteredPoints<Dim, double>(3000, 12) });
  return samples;
}

/** Calls function(whole tree, builders) for all samples, limits and numbers of builders. */
template <int Dim, typename Function>
void ForEachDivision(const Function& function)
{
  for (const auto& sample : MakeDividedSamples<Dim>())
  {
    for (const typename hashedoctree::Octree<Dim>::Options options :
      { typename hashedoctree::Octree<Dim>::Options{},
        { 3, hashedoctree::MortonKey<Dim>::MaxDepth }, { 1, 4 }, { 40, 2 }, { 1, 0 },
        { 5000, hashedoctree::MortonKey<Dim>::MaxDepth } })
    {
      const SampleTree<Dim, double> made(sample, options);
      if (made.Tree.GetNumberOfPoints() == 0)
      {
        continue; // Nothing to divide.
      }
      for (const std::size_t number : { 1, 2, 3, 8 })
      {
        SCOPED_TRACE(::testing::Message()
          << sample.Name << ", " << number << " builders, at most " << options.MaxPointsPerLeaf
          << " points down to " << options.MaxDepth);
        function(made.Tree, CurveBuilders<Dim>(sample, made.Tree, number));
      }
    }
  }
}

#endif
