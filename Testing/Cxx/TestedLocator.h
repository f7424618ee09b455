// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_TestedLocator_h
#define Testing_Cxx_TestedLocator_h

#include "BruteForceSearch.h"
#include "PointClouds.h"
#include "vtkHashedOctreePointLocator.h"

#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

/** The locator, and all that it says. What no test has asked for is a failure at the end. */
class TestedLocator
{
public:
  using Ids = std::vector<std::int64_t>;
  using Position = hashedoctree::Position<3>;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

  explicit TestedLocator(vtkDataSet* dataSet = nullptr)
  {
    this->Locator->AddObserver(vtkCommand::ErrorEvent, this, &TestedLocator::AddError);
    this->Locator->AddObserver(vtkCommand::WarningEvent, this, &TestedLocator::AddWarning);
    this->Locator->SetDataSet(dataSet);
  }
  TestedLocator(const TestedLocator&) = delete;
  void operator=(const TestedLocator&) = delete;
  ~TestedLocator()
  {
    EXPECT_EQ(this->Errors, std::vector<std::string>());
    EXPECT_EQ(this->Warnings, std::vector<std::string>());
  }

  vtkHashedOctreePointLocator* operator->() { return this->Locator; }
  vtkHashedOctreePointLocator* Get() { return this->Locator; }

  /** There must have been one error, with these words. */
  void ExpectError(const std::string& words)
  {
    ASSERT_EQ(this->Errors.size(), 1U);
    EXPECT_NE(this->Errors[0].find(words), std::string::npos) << this->Errors[0];
    this->Errors.clear();
  }
  /** There must have been one warning, about this many points that are not finite. */
  void ExpectWarningOfSkippedPoints(std::size_t skipped)
  {
    ASSERT_EQ(this->Warnings.size(), 1U);
    const std::string words = std::to_string(skipped) + " of ";
    EXPECT_NE(this->Warnings[0].find(words), std::string::npos) << this->Warnings[0];
    this->Warnings.clear();
  }

  Ids FindClosest(int count, const Position& x)
  {
    this->MakeListDirty();
    this->Locator->FindClosestNPoints(count, x.data(), this->List);
    return this->GetList();
  }
  /** Sorted by id. */
  Ids FindWithin(double radius, const Position& x)
  {
    this->MakeListDirty();
    this->Locator->FindPointsWithinRadius(radius, x.data(), this->List);
    Ids ids = this->GetList();
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  /** Sorted by id. */
  Ids FindWithinBox(const Position& lower, const Position& upper)
  {
    this->MakeListDirty();
    const double bounds[6] = { lower[0], upper[0], lower[1], upper[1], lower[2], upper[2] };
    this->Locator->FindPointsWithinBox(bounds, this->List);
    Ids ids = this->GetList();
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  /** Every query must find nothing, whatever it is asked. */
  void ExpectToFindNothing()
  {
    for (const Position& x : { Position{ 0, 0, 0 }, Position{ 1e30, -3, 5 } })
    {
      EXPECT_EQ(this->Locator->FindClosestPoint(x.data()), -1);
      for (const double radius : { 0.0, 1.0, 1e300, std::numeric_limits<double>::infinity() })
      {
        double dist2 = 77.0;
        EXPECT_EQ(this->Locator->FindClosestPointWithinRadius(radius, x.data(), dist2), -1);
        EXPECT_EQ(dist2, 77.0);
        EXPECT_EQ(this->FindWithin(radius, x), Ids());
      }
      EXPECT_EQ(this->FindWithinBox({ -1e300, -1e300, -1e300 }, { 1e300, 1e300, 1e300 }), Ids());
      for (const int count : { -1, 0, 1, 5, VTK_INT_MAX })
      {
        EXPECT_EQ(this->FindClosest(count, x), Ids());
      }
    }
  }

  /** Every query at x must answer as the oracle does; `all` is its FindAll() there. */
  void ExpectAnswers(
    const Position& x, const std::vector<OracleFound>& all, const std::vector<double>& radii)
  {
    ASSERT_EQ(this->Locator->FindClosestPoint(x.data()), all.empty() ? -1 : all[0].Id);
    for (const int count : { -3, 0, 1, 2, 8, 40 })
    {
      ASSERT_EQ(
        this->FindClosest(count, x), GetIds(all, static_cast<std::size_t>(std::max(count, 0))))
        << count << " closest";
    }
    for (const double radius : radii)
    {
      const std::size_t within = CountWithin(all, radius);
      Ids ids = GetIds(all, within);
      std::sort(ids.begin(), ids.end());
      ASSERT_EQ(this->FindWithin(radius, x), ids) << "radius " << radius;
      double dist2 = 77.0;
      ASSERT_EQ(this->Locator->FindClosestPointWithinRadius(radius, x.data(), dist2),
        within > 0 ? all[0].Id : -1)
        << "radius " << radius;
      ASSERT_EQ(dist2, within > 0 ? all[0].Dist2 : 77.0) << "radius " << radius;
    }
  }

  /** Whether the points in boxes are those that the oracle finds: on faces that go through points,
   * with sides that are infinite, and in boxes that hold nothing. */
  template <typename Oracle>
  void ExpectBoxes(const Oracle& oracle, const Position& a, const Position& b)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
    const Position lower{ std::min(a[0], b[0]), std::min(a[1], b[1]), std::min(a[2], b[2]) };
    const Position upper{ std::max(a[0], b[0]), std::max(a[1], b[1]), std::max(a[2], b[2]) };
    std::vector<hashedoctree::Box<3>> boxes{ { lower, upper }, { a, a }, { upper, lower },
      { { -infinity, -infinity, -infinity }, { infinity, infinity, infinity } } };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const double side : { infinity, -infinity, notANumber })
      {
        boxes.push_back({ lower, upper });
        boxes.back().Upper[axis] = side;
        boxes.push_back({ lower, upper });
        boxes.back().Lower[axis] = side;
      }
    }
    for (const hashedoctree::Box<3>& box : boxes)
    {
      ASSERT_EQ(this->FindWithinBox(box.Lower, box.Upper), oracle.FindWithin(box))
        << ::testing::PrintToString(box.Lower) << ::testing::PrintToString(box.Upper);
    }
  }

private:
  /** No query may keep anything of what was in the list before. */
  void MakeListDirty()
  {
    this->List->Reset();
    this->List->InsertNextId(123456);
    this->List->InsertNextId(-1);
  }
  Ids GetList() const { return Ids(this->List->begin(), this->List->end()); }

  void AddError(vtkObject*, unsigned long, void* text) { Add(this->Errors, text); }
  void AddWarning(vtkObject*, unsigned long, void* text) { Add(this->Warnings, text); }
  static void Add(std::vector<std::string>& texts, const void* text)
  {
    texts.emplace_back(static_cast<const char*>(text));
  }

  vtkNew<vtkHashedOctreePointLocator> Locator;
  vtkNew<vtkIdList> List;
};

/** Frees the tree of a locator when it hears of something. */
struct Freeing
{
  TestedLocator& Freed;
  void Free(vtkObject*, unsigned long, void*) { this->Freed->FreeSearchStructure(); }
};

#endif
