// SPDX-License-Identifier: BSD-3-Clause
#include "PointSamples.h"
#include "SameOutputs.h"
#include "Sanitized.h"
#include "TestedFilter.h"

#include "vtkSMPTools.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <future>
#include <iostream>
#include <thread>

namespace
{
constexpr std::size_t ManyPoints = Sanitized ? 100000 : 10000000;

/** Runs a function with the threads of a backend. */
void WithThreads(const char* backend, int threads, const std::function<void()>& function)
{
  SCOPED_TRACE(std::string(backend) + ", " + std::to_string(threads) + " threads");
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, backend, false }, function);
}

vtkSmartPointer<vtkPolyData> MakeManyPoints(std::size_t count, unsigned seed)
{
  return MakePolyData(MakeUniformPoints<3, float>(count, seed));
}

/** Processor time of all threads so far, in milliseconds: unlike the time of day, it does not grow
 * while other tests have the processors. */
double GetMilliseconds()
{
  return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/** The contract, for ten million points. */
constexpr double MaxMillisecondsToStop = 100.0;

/** Watches the progress of an algorithm, and calls stop() once when it reaches `fraction`. */
class ProgressWatch
{
public:
  /** A report of progress, which is also a look at the abort flag, and the time since the one
   * before. */
  struct Report
  {
    double Progress;
    double Wait;
  };
  std::vector<Report> Reports;
  /** When stop() might have been called to wait the longest: right after the look before. */
  double EarliestStop = 0.0;

  ProgressWatch(vtkAlgorithm* algorithm, double fraction, std::function<void()> stop)
    : Algorithm(algorithm)
    , Fraction(fraction)
    , Stop(std::move(stop))
    , Observer(algorithm->AddObserver(vtkCommand::ProgressEvent, this, &ProgressWatch::Look))
    , LastLook(GetMilliseconds())
  {
  }
  ~ProgressWatch() { this->Algorithm->RemoveObserver(this->Observer); }
  ProgressWatch(const ProgressWatch&) = delete;
  void operator=(const ProgressWatch&) = delete;

private:
  void Look(vtkObject*, unsigned long, void* data)
  {
    const double progress = *static_cast<const double*>(data);
    this->Reports.push_back({ progress, GetMilliseconds() - this->LastLook });
    if (progress >= this->Fraction && this->Stop)
    {
      this->EarliestStop = this->LastLook;
      this->Stop();
      this->Stop = nullptr;
    }
    this->LastLook = GetMilliseconds();
  }

  vtkAlgorithm* Algorithm;
  double Fraction;
  std::function<void()> Stop;
  unsigned long Observer;
  double LastLook;
};

/** Of two runs that report the same progress, the shorter wait for each report. */
std::vector<ProgressWatch::Report> ShorterWaits(
  std::vector<ProgressWatch::Report> reports, const std::vector<ProgressWatch::Report>& others)
{
  EXPECT_EQ(reports.size(), others.size());
  for (std::size_t i = 0; i < std::min(reports.size(), others.size()); ++i)
  {
    EXPECT_EQ(reports[i].Progress, others[i].Progress);
    reports[i].Wait = std::min(reports[i].Wait, others[i].Wait);
  }
  return reports;
}
}

TEST(TestHashedOctreeFilterExecution, ProgressMovesThroughTheWholeRun)
{
  TestedFilter filter;
  filter->SetInputData(MakeManyPoints(Sanitized ? 150000 : 500000, 60));
  for (const int outputType : { vtkHashedOctreeFilter::Voxels, vtkHashedOctreeFilter::Outlines,
         vtkHashedOctreeFilter::HyperTreeGrid })
  {
    filter->SetOutputType(outputType);
    filter.Progress.clear();
    filter.UpdateWithoutErrors();
    filter.ExpectProgressInSteps(0.2);
    filter.Progress.erase(
      std::unique(filter.Progress.begin(), filter.Progress.end()), filter.Progress.end());
    EXPECT_GT(filter.Progress.size(), 25U);
  }
}

TEST(TestHashedOctreeFilterExecution, ProgressMovesWhilePointsAreMerged)
{
  TestedFilter filter;
  filter->SetInputData(MakeManyPoints(300000, 65));
  filter->MergePointsOn();
  filter.UpdateWithoutErrors();
  filter.ExpectProgressInSteps(0.2);
}

TEST(TestHashedOctreeFilterExecution, AnAbortLeavesEmptyOutputsAndALaterUpdateSucceeds)
{
  const auto points = MakeManyPoints(20000, 61);
  TestedFilter untroubled;
  untroubled->SetInputData(points);
  const auto outputs = TakeOutputs(untroubled.GetFilter());
  TestedFilter filter;
  filter->SetInputData(points);
  for (const double fraction : { 0.0, 0.01, 0.1, 0.25, 0.5, 0.65, 0.8, 0.95 })
  {
    for (const int outputType : { vtkHashedOctreeFilter::Voxels, vtkHashedOctreeFilter::Outlines })
    {
      SCOPED_TRACE("from " + std::to_string(fraction) + " on");
      filter->SetOutputType(outputType);
      filter->Modified();
      filter.Progress.clear();
      {
        const ProgressWatch watch(
          filter.GetFilter(), fraction, [&filter] { filter->SetAbortExecute(1); });
        filter.Update();
      }
      EXPECT_TRUE(filter->GetAbortExecute());
      // It ends at the next report, beside what the executive itself reports at both ends.
      EXPECT_LE(std::count_if(filter.Progress.begin(), filter.Progress.end(),
                  [fraction](double progress) { return progress >= fraction; }),
        3);
      filter.ExpectEmptyOutputs();
      filter->SetAbortExecute(0);
    }
    filter->SetOutputType(vtkHashedOctreeFilter::Voxels);
    ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);
  }
  EXPECT_EQ(filter.Warnings, std::vector<std::string>());
}

TEST(TestHashedOctreeFilterExecution, AnOutputTypeThatIsSetMeanwhileChangesNothing)
{
  using Types = vtkHashedOctreeFilter;
  const auto points = MakeManyPoints(100, 66);
  for (const int before : { Types::Voxels, Types::Outlines, Types::HyperTreeGrid })
  {
    TestedFilter untroubled;
    untroubled->SetInputData(points);
    untroubled->SetOutputType(before);
    untroubled->Update();
    vtkDataObject* expected = untroubled->GetOutputDataObject(0);
    for (const int after : { Types::Voxels, Types::Outlines, Types::HyperTreeGrid })
    {
      TestedFilter filter;
      filter->SetInputData(points);
      filter->SetOutputType(before);
      const ProgressWatch watch(
        filter.GetFilter(), 0.0, [&filter, after] { filter->SetOutputType(after); });
      filter->Update();
      EXPECT_EQ(filter->GetOutputType(), after);
      vtkDataObject* output = filter->GetOutputDataObject(0);
      EXPECT_EQ(output->GetDataObjectType(), expected->GetDataObjectType());
      EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::CELL),
        expected->GetNumberOfElements(vtkDataObject::CELL));
      EXPECT_EQ(output->GetAttributes(vtkDataObject::CELL)->GetNumberOfArrays(), 5);
    }
  }
}

/** Of ten million points, merged or not. */
class TestHashedOctreeFilterExecutionAbort : public ::testing::TestWithParam<bool>
{
};

INSTANTIATE_TEST_SUITE_P(Merging, TestHashedOctreeFilterExecutionAbort, ::testing::Bool());

TEST_P(TestHashedOctreeFilterExecutionAbort, IsNeverHeededLate)
{
  // One thread has the longest way from one look at the abort flag to the next. The abort at the
  // end adds the time that it takes to free what was made until then. Two runs report the same:
  // what else the machine does can hold up either anywhere, a long way of our own is long in both.
  // (Of a virtual machine that was busy, a loop of 0.6 ms without memory or system calls took up to
  // 45 ms of processor time by this clock.)
  TestedFilter filter;
  filter->SetInputData(MakeManyPoints(ManyPoints, 62));
  filter->SetMergePoints(GetParam());
  filter->SetMaxPointsPerLeaf(GetParam() ? 50 : 1); // What merging adds comes before the cells.
  std::vector<ProgressWatch::Report> reports;
  for (int run = 0; run < 2; ++run)
  {
    WithThreads("Sequential", 1,
      [&]
      {
        const ProgressWatch watch(
          filter.GetFilter(), 0.95, [&filter] { filter->SetAbortExecute(1); });
        filter->Update();
        const double stopped = GetMilliseconds() - watch.EarliestStop;
        std::cout << "stopped after " << stopped << " ms\n";
        if (!Sanitized)
        {
          EXPECT_LE(stopped, MaxMillisecondsToStop);
        }
        reports = run == 0 ? watch.Reports : ShorterWaits(reports, watch.Reports);
        filter.ExpectEmptyOutputs();
        filter->SetAbortExecute(0);
        filter->Modified();
      });
  }
  const ProgressWatch::Report longest = *std::max_element(
    reports.begin(), reports.end(), [](const auto& a, const auto& b) { return a.Wait < b.Wait; });
  std::cout << "longest wait " << longest.Wait << " ms, up to progress " << longest.Progress
            << '\n';
  if (!Sanitized)
  {
    EXPECT_LE(longest.Wait, MaxMillisecondsToStop);
  }
}

TEST(TestHashedOctreeFilterExecution, AnotherThreadStopsIt)
{
  constexpr int threads = 2;
  TestedFilter filter;
  filter->SetInputData(MakeManyPoints(ManyPoints, 63));
  for (const double fraction : { 0.0, 0.04, 0.1, 0.2, 0.28 })
  {
    WithThreads("STDThread", threads,
      [&filter, fraction]
      {
        std::promise<void> reached;
        double asked = 0.0;
        std::thread other(
          [&]
          {
            reached.get_future().wait();
            std::this_thread::sleep_for(std::chrono::milliseconds(5)); // Into the work.
            asked = GetMilliseconds();
            filter->SetAbortExecute(1);
          });
        const ProgressWatch watch(
          filter.GetFilter(), fraction, [&reached] { reached.set_value(); });
        filter->Update();
        other.join();
        const double stopped = GetMilliseconds() - asked;
        std::cout << "stopped after " << stopped << " ms from progress " << fraction << " on\n";
        if (!Sanitized)
        {
          EXPECT_LE(stopped, threads * MaxMillisecondsToStop);
        }
        filter.ExpectEmptyOutputs();
        filter->SetAbortExecute(0);
      });
  }
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230101)
TEST(TestHashedOctreeFilterExecution, AnAbortOfItsContainerStopsIt)
{
  vtkNew<vtkHashedOctreeFilter> container;
  TestedFilter filter(MakeUniformPoints<3, double>(50, 48));
  filter->SetContainerAlgorithm(container);
  container->SetAbortExecute(1);
  filter.Update();
  filter.ExpectEmptyOutputs();
}
#endif

TEST(TestHashedOctreeFilterExecution, AnyPieceOfNoPort)
{
  TestedFilter filter(MakeUniformPoints<3, double>(50, 48));
  vtkStreamingDemandDrivenPipeline::SafeDownCast(filter->GetExecutive())->Update(-1);
  EXPECT_GT(filter.GetCells()->GetNumberOfCells(), 0);
}

TEST(TestHashedOctreeFilterExecution, WhoWantsGhostsChangesNoTree)
{
  TestedFilter filter(MakeUniformPoints<3, double>(50, 48));
  filter->UpdatePiece(0, 2, 3);
  EXPECT_EQ(filter->GetInputInformation(0, 0)->Get(
              vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()),
    0);
}

TEST(TestHashedOctreeFilterExecution, AnyNumberOfThreadsGivesTheSame)
{
  TestedFilter filter;
  filter->SetInputData(MakeManyPoints(50000, 64));
  filter->IncludeEmptyLeavesOn();
  filter->IncludeInternalNodesOn();
  std::vector<vtkSmartPointer<vtkDataObject>> outputs;
  WithThreads("Sequential", 1, [&] { outputs = TakeOutputs(filter.GetFilter()); });
  for (const int threads : { 1, 2, 8 }) // VTK takes no more than the machine has.
  {
    WithThreads("STDThread", threads,
      [&]
      {
        filter->Modified();
        ExpectSameOutputs(TakeOutputs(filter.GetFilter()), outputs);
      });
  }
}
