// SPDX-License-Identifier: BSD-3-Clause

// Queries from many threads at once, and builds on many.
#include "NoMoreThreads.h"
#include "PointSamples.h"
#include "Sanitized.h"
#include "TestedLocator.h"

#include "vtkAngularPeriodicDataArray.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkVersionMacros.h"

#include <array>
#include <atomic>
#include <stdexcept>
#include <thread>

namespace
{
struct Answers
{
  vtkIdType Closest;
  vtkIdType ClosestWithin;
  double Dist2;
  TestedLocator::Ids Few;
  TestedLocator::Ids Within;
  TestedLocator::Ids InBox;
  std::array<vtkIdType, 7> Costs;

  bool operator==(const Answers& other) const
  {
    return this->Closest == other.Closest && this->ClosestWithin == other.ClosestWithin &&
      this->Dist2 == other.Dist2 && this->Few == other.Few && this->Within == other.Within &&
      this->InBox == other.InBox && this->Costs == other.Costs;
  }
};

/** One query of each kind; the order of the points within a radius counts, too. */
Answers Ask(vtkHashedOctreePointLocator* locator, const double* x, vtkIdList* list)
{
  Answers answers{ -2, -2, -2.0, {}, {}, {}, {} };
  answers.Closest = locator->FindClosestPoint(x);
  answers.ClosestWithin = locator->FindClosestPointWithinRadius(0.02, x, answers.Dist2);
  locator->FindClosestNPoints(8, x, list);
  answers.Few.assign(list->begin(), list->end());
  locator->FindPointsWithinRadius(0.1, x, list);
  answers.Within.assign(list->begin(), list->end());
  const double box[6] = { x[0] - 0.1, x[0] + 0.1, x[1] - 0.1, x[1] + 0.1, x[2] - 0.1, x[2] + 0.1 };
  locator->FindPointsWithinBox(box, list);
  answers.InBox.assign(list->begin(), list->end());
  answers.Costs = { locator->GetLeafId(x), locator->GetDepth(x), locator->GetHitCost(x),
    locator->GetClosestPointCost(x), locator->GetClosestNPointsCost(8, x),
    locator->GetPointsWithinRadiusCost(0.1, x), locator->GetPointsWithinBoxCost(box) };
  return answers;
}

/** Threads that all ask everything at once, each from another place on: how many answers are not
 * the expected ones. */
std::size_t CountOtherAnswers(vtkHashedOctreePointLocator* locator,
  const std::vector<double>& queries, const std::vector<Answers>& expected,
  unsigned numberOfThreads)
{
  std::atomic<std::size_t> wrong{ 0 };
  std::vector<std::thread> threads;
  for (unsigned thread = 0; thread < numberOfThreads; ++thread)
  {
    threads.emplace_back(
      [&, thread]
      {
        vtkNew<vtkIdList> own;
        for (std::size_t i = 0; i < expected.size(); ++i)
        {
          const std::size_t query = (i + thread * 37) % expected.size();
          wrong += Ask(locator, &queries[3 * query], own) == expected[query] ? 0U : 1U;
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  return wrong;
}
}

TEST(TestHashedOctreePointLocatorThreads, ManyThreadsGetTheAnswersOfOne)
{
  using Class = vtkHashedOctreePointLocator;
  const std::size_t numberOfQueries = Sanitized ? 300 : 3000;
  const auto cloud = MakePolyData(MakeClusteredPoints<3, float>(5000, 41));
  const std::vector<double> queries = MakeUniformPoints<3, double>(numberOfQueries, 42, 0.2, 1.1);
  TestedLocator locator(cloud);
  locator->SetMaxPointsPerLeaf(8);
  locator->SetFixedStartDepth(5);
  for (const int model : { Class::Median, Class::Mean, Class::Root, Class::Fixed, Class::Local })
  {
    locator->SetStartDepthModel(model);
    locator->BuildLocator();
    std::vector<Answers> expected;
    vtkNew<vtkIdList> list;
    for (std::size_t i = 0; i < numberOfQueries; ++i)
    {
      expected.push_back(Ask(locator.Get(), &queries[3 * i], list));
    }
    for (const unsigned numberOfThreads : { 1U, 2U, 8U })
    {
      EXPECT_EQ(CountOtherAnswers(locator.Get(), queries, expected, numberOfThreads), 0U)
        << numberOfThreads << " threads, model " << model;
    }
  }
}

TEST(TestHashedOctreePointLocatorThreads, QueriesInsideVtkSMPTools)
{
  const auto cloud = MakeUniform(20000, 43);
  TestedLocator locator(cloud);
  locator->BuildLocator();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(4);
  std::atomic<vtkIdType> found{ 0 };
  vtkSMPTools::For(0, cloud->GetNumberOfPoints(),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        double x[3];
        cloud->GetPoint(i, x);
        found += locator->FindClosestPoint(x) == i ? 1 : 0;
      }
    });
  EXPECT_EQ(found, cloud->GetNumberOfPoints());
  vtkSMPTools::Initialize(0);
}

TEST(TestHashedOctreePointLocatorThreads, TheTreeDoesNotDependOnTheThreadsThatBuiltIt)
{
  const auto cloud = MakePolyData(MakeClusteredPoints<3, double>(100000, 44));
  const std::vector<double> queries = MakeUniformPoints<3, double>(100, 45, 0.2, 1.1);
  std::vector<Answers> expected;
  vtkNew<vtkIdList> list;
  for (const int numberOfThreads : { 1, 2, 8 }) // VTK takes no more than there are.
  {
    vtkSMPTools::SetBackend("STDThread");
    vtkSMPTools::Initialize(numberOfThreads);
    TestedLocator locator(cloud);
    std::vector<Answers> answers;
    for (std::size_t i = 0; i < 100; ++i)
    {
      answers.push_back(Ask(locator.Get(), &queries[3 * i], list));
    }
    expected = expected.empty() ? answers : expected;
    EXPECT_TRUE(answers == expected) << numberOfThreads << " threads";
  }
  vtkSMPTools::Initialize(0);
}

TEST(TestHashedOctreePointLocatorThreads, ArraysThatComputeTheirPointsAreReadOnOne)
{
  const auto cloud = MakePolyData(MakeUniformPoints<3, float>(200000, 46));
  vtkNew<vtkAngularPeriodicDataArray<float>> turned; // Keeps the last tuple that it was asked for.
  turned->SetAxis(2);
  turned->SetAngle(30.0);
  turned->InitializeArray(vtkFloatArray::SafeDownCast(cloud->GetPoints()->GetData()));
  vtkNew<vtkPoints> points;
  points->SetData(turned);
  cloud->SetPoints(points);

  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(8);
  TestedLocator locator(cloud);
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> dist2;
  EXPECT_TRUE(locator->FindClosestPoints(turned, ids, dist2));
  vtkSMPTools::Initialize(0);
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < 200000; ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    wrong += locator->FindClosestPoint(x) == i && ids->GetValue(i) == i ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
}

namespace
{
/** Holds a batch at its first progress until another thread has aborted it. */
struct Held
{
  std::atomic<bool> HasBegun{ false };
  std::atomic<bool> IsAborted{ false };
  void Hold(vtkObject*, unsigned long, void*)
  {
    this->HasBegun = true;
    while (!this->IsAborted)
    {
      std::this_thread::yield();
    }
  }
};
}

TEST(TestHashedOctreePointLocatorThreads, AnotherThreadMayAbortABatch)
{
  const auto cloud = MakePolyData(MakeUniformPoints<3, float>(20000, 47));
  TestedLocator locator(cloud);
  Held held;
  locator->AddObserver(vtkCommand::ProgressEvent, &held, &Held::Hold);
  std::thread other(
    [&]
    {
      while (!held.HasBegun)
      {
        std::this_thread::yield();
      }
      locator->AbortBatch();
      held.IsAborted = true;
    });
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(2);
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> dist2;
  vtkDataArray* positions = cloud->GetPoints()->GetData();
  EXPECT_FALSE(locator->FindClosestPoints(positions, ids, dist2));
  EXPECT_EQ(ids->GetNumberOfValues(), 0);
  EXPECT_EQ(dist2->GetNumberOfValues(), 0);
  other.join();
  EXPECT_TRUE(locator->FindClosestPoints(positions, ids, dist2)) << "the next one is not aborted";
  EXPECT_EQ(ids->GetNumberOfValues(), 20000);
  vtkSMPTools::Initialize(0);
}

namespace
{
/** Remembers which thread asked for a point first, since vtkDataSet wants it to be one alone, and
 * whether others did later. */
class ImageOfReaders : public vtkImageData
{
public:
  static ImageOfReaders* New();
  vtkTypeMacro(ImageOfReaders, vtkImageData);

  void GetPoint(vtkIdType id, double x[3]) override
  {
    if (!this->WasRead.exchange(true))
    {
      this->FirstReader = std::this_thread::get_id();
    }
    else if (std::this_thread::get_id() != this->FirstReader)
    {
      this->HasOtherReaders = true;
    }
    this->Superclass::GetPoint(id, x);
  }
  using vtkImageData::GetPoint;

  std::atomic<bool> WasRead{ false };
  std::atomic<bool> HasOtherReaders{ false };
  std::thread::id FirstReader;
};
vtkStandardNewMacro(ImageOfReaders);
}

TEST(TestHashedOctreePointLocatorThreads, DataSetsAreReadOnTheCallersThreadAndThenOnAll)
{
  vtkNew<ImageOfReaders> image;
  image->SetDimensions(60, 60, 60);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(2);
  const bool hasThreads = vtkSMPTools::GetEstimatedNumberOfThreads() > 1;
  TestedLocator locator(image);
  locator->BuildLocator();
  vtkSMPTools::Initialize(0);
  EXPECT_EQ(image->FirstReader, std::this_thread::get_id());
  EXPECT_EQ(image->HasOtherReaders, hasThreads) << "one processor has no others";
}

namespace
{
/** One of its points cannot be read. */
class TornImage : public vtkImageData
{
public:
  static TornImage* New();
  vtkTypeMacro(TornImage, vtkImageData);

  void GetPoint(vtkIdType id, double x[3]) override
  {
    if (id == 100000)
    {
      throw std::runtime_error("torn");
    }
    this->Superclass::GetPoint(id, x);
  }
  using vtkImageData::GetPoint;
};
vtkStandardNewMacro(TornImage);
}

TEST(TestHashedOctreePointLocatorThreads, WhatIsThrownOnAThreadIsAnError)
{
  vtkNew<TornImage> image;
  image->SetDimensions(60, 60, 60);
  for (const auto& [backend, threads] : { std::pair("Sequential", 1), { "STDThread", 2 } })
  {
    vtkSMPTools::SetBackend(backend);
    vtkSMPTools::Initialize(threads);
    TestedLocator locator(image);
    locator->BuildLocator();
    ASSERT_NO_FATAL_FAILURE(locator.ExpectError("torn"));
    locator.ExpectToFindNothing();
  }
  vtkSMPTools::Initialize(0);
}

/** What the locator does where threads are refused. */
class TestHashedOctreePointLocatorThreadsRefused : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0))
    {
      GTEST_SKIP() << "threads of this VTK stay once they are started";
    }
    if (std::thread::hardware_concurrency() < 2)
    {
      GTEST_SKIP() << "one processor has no other threads";
    }
  }

  template <typename Function>
  static void WithThreads(const Function& function)
  {
    // An error leaves VTK in the belief that a loop is running, so that later ones are nested.
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2, "STDThread", true }, function);
  }
};

TEST_F(TestHashedOctreePointLocatorThreadsRefused, ABuildIsAnErrorAndALaterOneIsDone)
{
  TestedLocator locator(MakeUniform(100000, 47));
  WithThreads(
    [&locator]
    {
      {
        const NoMoreThreads limit;
        locator->BuildLocator();
      }
      ASSERT_NO_FATAL_FAILURE(locator.ExpectError("cannot start a thread"));
      locator.ExpectToFindNothing();
      locator->ForceBuildLocator();
    });
  EXPECT_GT(locator->GetLevel(), 0);
}

TEST_F(TestHashedOctreePointLocatorThreadsRefused, BatchesAndBoxesAreErrors)
{
  const auto cloud = MakeUniform(100000, 48);
  TestedLocator locator(cloud);
  locator->BuildLocator();
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> dist2;
  vtkNew<vtkPolyData> leaves;
  WithThreads(
    [&]
    {
      const NoMoreThreads limit;
      EXPECT_FALSE(locator->FindClosestPoints(cloud->GetPoints()->GetData(), ids, dist2));
      ASSERT_NO_FATAL_FAILURE(locator.ExpectError("cannot start a thread"));
      locator->GenerateRepresentation(-1, leaves);
      locator.ExpectError("cannot start a thread");
    });
  EXPECT_EQ(ids->GetNumberOfValues(), 0);
  EXPECT_EQ(dist2->GetNumberOfValues(), 0);
  EXPECT_EQ(leaves->GetNumberOfCells(), 0);
}
