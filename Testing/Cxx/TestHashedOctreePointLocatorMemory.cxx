// SPDX-License-Identifier: BSD-3-Clause

// What the locator does when memory ends: in a build, in a batch, and on threads of vtkSMPTools.
#include "MemoryLimit.h"
#include "PointSamples.h"
#include "Sanitized.h"
#include "TestedLocator.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSMPTools.h"

#include <functional>
#include <memory>
#include <new>

namespace
{
/** While it lives, there is no memory but for a message: what was freed is taken, too, in pieces.
 */
class NoMemory
{
public:
  NoMemory()
  {
    for (std::unique_ptr<char[]>& piece : this->Taken)
    {
      piece.reset(new (std::nothrow) char[65536]);
    }
    EXPECT_FALSE(this->Taken.back());
  }

private:
  std::vector<std::unique_ptr<char[]>> Taken = std::vector<std::unique_ptr<char[]>>(100000);
  MemoryLimit Limit{ 0 };
};

/** Tests of this kind; a sanitizer reserves more addresses than any limit here. */
class TestHashedOctreePointLocatorMemory : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (Sanitized)
    {
      GTEST_SKIP() << "sanitizers reserve more memory than the limit";
    }
    vtkSMPTools::SetBackend("Sequential"); // To start a thread takes more than what is left.
  }
  void TearDown() override { vtkSMPTools::Initialize(0); }
};
}

TEST_F(TestHashedOctreePointLocatorMemory, ABuildThatFailsAnywhereFindsNothing)
{
  TestedLocator locator(MakeUniform(100000, 261));
  locator->SetMaxPointsPerLeaf(1);
  locator->SetStartDepthModel(vtkHashedOctreePointLocator::Local);
  const double x[3] = { 0.5, 0.5, 0.5 };
  std::size_t failures = 0;
  for (std::size_t bytes = 0;; bytes += Megabyte / 2)
  {
    locator->FreeSearchStructure();
    {
      const MemoryLimit limit(bytes);
      locator->BuildLocator();
    }
    if (locator.Errors.empty())
    {
      break;
    }
    ++failures;
    ASSERT_NO_FATAL_FAILURE(locator.ExpectError("not enough memory for the index"));
    ASSERT_NO_FATAL_FAILURE(locator.ExpectToFindNothing());
    ASSERT_EQ(locator->GetLeafId(x), -1);
    ASSERT_EQ(locator->GetHitCost(x), 0);
    ASSERT_EQ(locator->GetLevel(), 0);
    ASSERT_EQ(locator->GetNumberOfBuckets(), 0);
    ASSERT_GT(locator->GetBounds()[0], locator->GetBounds()[1]);
    vtkNew<vtkDoubleArray> queries;
    queries->SetNumberOfComponents(3);
    queries->InsertNextTuple(x);
    vtkNew<vtkIdTypeArray> ids;
    vtkNew<vtkDoubleArray> dist2;
    ASSERT_FALSE(locator->FindClosestPoints(queries, ids, dist2));
    ASSERT_NO_FATAL_FAILURE(locator.ExpectError("not enough memory for the index"));
  }
  EXPECT_GT(failures, 10U);
  EXPECT_GE(locator->FindClosestPoint(x), 0);
}

TEST_F(TestHashedOctreePointLocatorMemory, AQueryThatFindsTooMuchFindsNothing)
{
  TestedLocator locator(MakeUniform(1000000, 264));
  locator->BuildLocator();
  const double x[3] = { 0.5, 0.5, 0.5 };
  const double box[6] = { -9, 9, -9, 9, -9, 9 };
  const std::function<vtkIdType(vtkIdList*)> queries[] = {
    [&](vtkIdList* found)
    {
      locator->FindClosestNPoints(900000, x, found);
      return found->GetNumberOfIds();
    },
    [&](vtkIdList* found)
    {
      locator->FindPointsWithinRadius(9.0, x, found);
      return found->GetNumberOfIds();
    },
    [&](vtkIdList* found)
    {
      locator->FindPointsWithinBox(box, found);
      return found->GetNumberOfIds();
    },
    [&](vtkIdList*) { return locator->GetClosestNPointsCost(900000, x); },
    [&](vtkIdList*) { return locator->GetPointsWithinRadiusCost(9.0, x); },
    [&](vtkIdList*) { return locator->GetPointsWithinBoxCost(box); },
  };
  for (const auto& query : queries)
  {
    SCOPED_TRACE(&query - queries);
    vtkNew<vtkIdList> found;
    found->InsertNextId(77);
    {
      const NoMemory noMemory;
      EXPECT_EQ(query(found), 0);
    }
    ASSERT_NO_FATAL_FAILURE(locator.ExpectError("not enough memory for what the query finds"));
    EXPECT_GT(query(found), 0);
  }
}

TEST_F(TestHashedOctreePointLocatorMemory, AListThatCouldNotGrowIsOfUseAgain)
{
  TestedLocator locator(MakeUniform(60000, 267));
  const double x[3] = { 0.5, 0.5, 0.5 };
  vtkNew<vtkIdList> list;
  list->InsertNextId(7);
  // The thread has room for as much already, so that it is the list that fails.
  vtkNew<vtkIdList> first;
  locator->FindPointsWithinRadius(9.0, x, first);
  ASSERT_EQ(first->GetNumberOfIds(), 60000);
  {
    const NoMemory none;
    locator->FindPointsWithinRadius(9.0, x, list);
  }
  ASSERT_NO_FATAL_FAILURE(locator.ExpectError("not enough memory"));
  EXPECT_EQ(list->GetNumberOfIds(), 0);
  locator->FindClosestNPoints(5, x, list);
  EXPECT_EQ(list->GetNumberOfIds(), 5);
}

TEST_F(TestHashedOctreePointLocatorMemory, WithoutRoomForLocalStartDepthsTheModelStays)
{
  TestedLocator locator(MakeUniform(20000, 263));
  locator->SetMaxPointsPerLeaf(1);
  locator->SetStartDepthModel(vtkHashedOctreePointLocator::Root);
  const double x[3] = { 0.5, 0.5, 0.5 };
  const vtkIdType costOfRoot = locator->GetHitCost(x);
  const vtkMTimeType before = locator->GetMTime();
  {
    const NoMemory noMemory;
    locator->SetStartDepthModel(vtkHashedOctreePointLocator::Local);
  }
  ASSERT_NO_FATAL_FAILURE(locator.ExpectError("not enough memory for local start depths"));
  EXPECT_EQ(locator->GetStartDepthModel(), vtkHashedOctreePointLocator::Root);
  EXPECT_EQ(locator->GetHitCost(x), costOfRoot);
  EXPECT_EQ(locator->GetMTime(), before);
  locator->SetStartDepthModel(vtkHashedOctreePointLocator::Local);
  EXPECT_LT(locator->GetHitCost(x), costOfRoot);
}

TEST_F(TestHashedOctreePointLocatorMemory, ARepresentationThatFailsIsEmpty)
{
  TestedLocator locator(MakeUniform(20000, 265));
  locator->SetMaxPointsPerLeaf(1);
  locator->BuildLocator();
  vtkNew<vtkPolyData> boxes;
  locator->GenerateRepresentation(0, boxes);
  EXPECT_EQ(boxes->GetNumberOfCells(), 1);
  {
    const NoMemory noMemory;
    locator->GenerateRepresentation(-1, boxes);
  }
  ASSERT_NO_FATAL_FAILURE(locator.ExpectError("not enough memory for the boxes"));
  EXPECT_EQ(boxes->GetNumberOfCells(), 0);
}

TEST_F(TestHashedOctreePointLocatorMemory, ABatchThatAsksForTooMuchIsEmpty)
{
  TestedLocator locator(MakeUniform(10, 266));
  vtkNew<vtkDoubleArray> queries;
  queries->SetNumberOfComponents(3);
  queries->SetNumberOfTuples(100000);
  queries->Fill(0.5);
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> dist2;
  {
    const MemoryLimit limit(100 * Megabyte); // The ids alone take eight times as much.
    EXPECT_FALSE(locator->FindClosestNPoints(1000, queries, ids, dist2));
  }
  ASSERT_NO_FATAL_FAILURE(locator.ExpectError("not enough memory for what the batch finds"));
  EXPECT_EQ(ids->GetNumberOfTuples(), 0);
  EXPECT_EQ(dist2->GetNumberOfTuples(), 0);
}

TEST_F(TestHashedOctreePointLocatorMemory, ABatchWhoseSearchesFailIsEmpty)
{
  // The outputs take 48 megabytes, which there are, and what a search keeps as much again.
  constexpr int count = 3000000;
  TestedLocator locator(MakePolyData(MakeUniformPoints<3, float>(count, 268)));
  vtkNew<vtkDoubleArray> queries;
  queries->SetNumberOfComponents(3);
  queries->InsertNextTuple3(0.5, 0.5, 0.5);
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkDoubleArray> dist2;
  locator->BuildLocator();
  {
    const MemoryLimit limit(70 * Megabyte);
    EXPECT_FALSE(locator->FindClosestNPoints(count, queries, ids, dist2));
  }
  ASSERT_NO_FATAL_FAILURE(locator.ExpectError("not enough memory for what the batch finds"));
  for (vtkDataArray* output : std::initializer_list<vtkDataArray*>{ ids, dist2 })
  {
    EXPECT_EQ(output->GetNumberOfTuples(), 0);
    EXPECT_EQ(output->GetNumberOfComponents(), 1);
  }
  EXPECT_TRUE(locator->FindClosestNPoints(count, queries, ids, dist2));
}

TEST_F(TestHashedOctreePointLocatorMemory, ABatchThatFindsTooMuchIsEmpty)
{
  // All points for each of the positions: half a gigabyte.
  const std::vector<double> coordinates = MakeUniformPoints<3, double>(20000, 262);
  TestedLocator locator(MakePolyData(coordinates));
  vtkNew<vtkDoubleArray> queries;
  queries->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < 1500; ++i)
  {
    queries->InsertNextTuple(&coordinates[3 * i]);
  }
  for (const auto& [backend, threads] : { std::pair("Sequential", 1), { "STDThread", 2 } })
  {
    SCOPED_TRACE(backend);
    vtkSMPTools::SetBackend(backend);
    vtkSMPTools::Initialize(threads);
    locator->BuildLocator();
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> ids;
    vtkNew<vtkDoubleArray> dist2;
    {
      const MemoryLimit limit(250 * Megabyte);
      EXPECT_FALSE(locator->FindPointsWithinRadius(10.0, queries, offsets, ids, dist2));
    }
    ASSERT_NO_FATAL_FAILURE(locator.ExpectError("not enough memory for what the batch finds"));
    EXPECT_EQ(offsets->GetNumberOfValues(), 0);
    EXPECT_EQ(ids->GetNumberOfValues(), 0);
    EXPECT_EQ(dist2->GetNumberOfValues(), 0);
    EXPECT_TRUE(locator->FindPointsWithinRadius(0.0, queries, offsets, ids, dist2));
    EXPECT_EQ(ids->GetNumberOfValues(), queries->GetNumberOfTuples());
  }
}
