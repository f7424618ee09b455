// SPDX-License-Identifier: BSD-3-Clause
/**
 * Time to build the octree with one point per leaf, on one and two threads, beside
 * vtkStaticPointLocator::BuildLocator() on the same points.
 */
#include "Invariants.h"
#include "Octree.h"
#include "PointSamples.h"
#include "RatioReporter.h"
#include "Threads.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStaticPointLocator.h"

using namespace hashedoctree;

namespace
{
constexpr std::size_t NumberOfPoints = 1000000;
using Sample = PointSample<3, float>;

/** A build that is checked, and warms the caches, before the timing; a wrong tree has no time. */
bool IsSound(const Sample& sample, const Execution& execution)
{
  const PointSelection<3> selection(sample.GetSpan(), {}, execution);
  const Octree<3> tree(sample.GetSpan(), selection, {}, execution);
  return FindBrokenLaws(tree, sample.GetSpan(), selection).empty();
}

void BuildOctree(benchmark::State& state, const Sample& sample, unsigned threads)
{
  const Execution execution = threads == 1 ? Execution() : Execution(OnThreads(threads));
  if (!IsSound(sample, execution))
  {
    state.SkipWithError("the tree breaks its laws");
    return;
  }
  for (auto _ : state)
  {
    const PointSelection<3> selection(sample.GetSpan(), {}, execution);
    const Octree<3> tree(sample.GetSpan(), selection, {}, execution);
    benchmark::DoNotOptimize(tree.GetNumberOfNodes());
  }
}

void BuildStaticPointLocator(benchmark::State& state, const Sample& sample, int threads)
{
  vtkSMPTools::SetBackend(threads == 1 ? "Sequential" : "STDThread");
  vtkSMPTools::Initialize(threads);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetArray(const_cast<float*>(sample.Coordinates.data()),
    static_cast<vtkIdType>(sample.Coordinates.size()), /*save=*/1);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  const auto build = [&]
  {
    points->Modified(); // New points: their bounds are part of the build, as in ours.
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(data);
    locator->BuildLocator();
    benchmark::DoNotOptimize(locator->GetNumberOfBuckets());
  };
  build(); // As ours, which is checked.
  for (auto _ : state)
  {
    build();
  }
}

void Register(const Sample& sample)
{
  const auto add = [&sample](const std::string& subject, auto function, auto threads)
  {
    benchmark::RegisterBenchmark((subject + "/" + sample.Name).c_str(), function, sample, threads)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
  };
  add("HashedOctree, 1 thread", BuildOctree, 1U);
  add("HashedOctree, 2 threads", BuildOctree, 2U);
  add("vtkStaticPointLocator, 1 thread", BuildStaticPointLocator, 1);
  add("vtkStaticPointLocator, 2 threads", BuildStaticPointLocator, 2);
}
}

int main(int argc, char** argv)
{
  const std::size_t n = NumberOfPoints;
  Register({ "random cube", MakeUniformPoints<3, float>(n, 1) });
  Register({ "random sphere", MakeSpherePoints<3, float>(n, 2) });
  Register({ "clusters", MakeClusteredPoints<3, float>(n, 3) });
  return RunInTurns(argc, argv);
}
