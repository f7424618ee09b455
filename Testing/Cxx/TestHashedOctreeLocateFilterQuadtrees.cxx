// SPDX-License-Identifier: BSD-3-Clause
#include "PlanarPoints.h"
#include "TestedFilter.h"
#include "TestedLocateFilter.h"

#include "vtkMultiBlockDataSet.h"

// What is found in quadtrees is compared with a look at every leaf of the core's quadtree.

using Filter = vtkHashedOctreeLocateFilter;
using hashedoctree::MortonKey;
using hashedoctree::Octree;

namespace
{
constexpr double Across = 0.3; ///< Where flat points lie.

/** The leaf that holds a position, or what is nearest to it; and its number among the leaves that
 * hold points, by depth and key, -1 if it holds none. Looks at all leaves. */
std::pair<Octree<2>::Node, vtkIdType> FindLeafByLooking(
  const Octree<2>& tree, const std::array<double, 2>& x)
{
  std::array<std::int64_t, 2> place;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double t = (x[axis] - tree.GetGrid().GetLower()[axis]) / tree.GetGrid().GetSide();
    place[axis] = static_cast<std::int64_t>(
      std::clamp(std::floor(std::ldexp(t, 31)), 0.0, std::ldexp(1.0, 31) - 1));
  }
  std::pair<Octree<2>::Node, vtkIdType> found{ tree.GetRoot(), -1 };
  vtkIdType number = 0;
  ForEachLeaf(tree,
    [&](const Octree<2>::Node& leaf)
    {
      const NodeBox<2> box(leaf.NodeKey);
      if (box.Lower[0] <= place[0] && place[0] < box.Upper[0] && box.Lower[1] <= place[1] &&
        place[1] < box.Upper[1])
      {
        found = { leaf, leaf.IsEmpty() ? -1 : number };
      }
      number += leaf.IsEmpty() ? 0 : 1;
    });
  return found;
}

void ExpectLocated(TestedLocateFilter& filter, const Octree<2>& tree, const SpacePlane& plane,
  const std::vector<double>& queries)
{
  const auto startDepth = static_cast<int>(filter.GetFieldValue("StartDepth"));
  ASSERT_EQ(filter.GetLocated()->GetNumberOfPoints(), static_cast<vtkIdType>(queries.size() / 3));
  for (std::size_t i = 0; i < queries.size() / 3; ++i)
  {
    const auto query = static_cast<vtkIdType>(i);
    const double* x = queries.data() + 3 * i;
    const auto [leaf, number] = FindLeafByLooking(tree, { x[plane.Axes[0]], x[plane.Axes[1]] });
    const int depth = leaf.NodeKey.GetDepth();
    ASSERT_EQ(filter.Get("LeafId", query), number);
    ASSERT_EQ(filter.Get("LeafDepth", query), depth);
    ASSERT_EQ(static_cast<std::uint64_t>(filter.Get("LeafKey", query)), leaf.NodeKey.GetValue());
    ASSERT_EQ(filter.Get("HitCost", query), 1 + std::abs(depth - startDepth));
    ASSERT_EQ(filter.Get("RootCost", query), 1 + depth);
  }
}

/** Of the shares of a column, to the base 3. */
double GetEntropy(vtkTable* histogram, const char* column)
{
  auto* weights = vtkDataArray::SafeDownCast(histogram->GetColumnByName(column));
  double total = 0.0;
  double sum = 0.0;
  for (vtkIdType row = 0; row < weights->GetNumberOfTuples(); ++row)
  {
    const double weight = weights->GetTuple1(row);
    total += weight;
    sum += weight > 0.0 ? weight * std::log(weight) : 0.0;
  }
  return (std::log(total) - sum / total) / std::log(3.0);
}

/** In the unit cube and around it. */
std::vector<double> MakeQueries(std::size_t count, unsigned seed)
{
  return MakeUniformPoints<3, double>(count, seed, -0.2, 1.2);
}
}

TEST(TestHashedOctreeLocateFilterQuadtrees, QueriesAreProjectedToThePlaneOfFlatPoints)
{
  const std::vector<double> planar = MakeUniformPoints<2, double>(150, 340);
  const std::vector<double> queries = MakeQueries(200, 341);
  for (const int maxDepth : { 4, 31 })
  {
    const auto core = MakeCoreQuadtree(planar, maxDepth);
    for (const SpacePlane& plane : AllPlanes)
    {
      TestedLocateFilter filter(
        MakePolyData(PutInSpace(planar, plane, Across)), MakePolyData(queries));
      filter->SetMaxDepth(maxDepth);
      filter.Update();
      ExpectLocated(filter, core.Tree, plane, queries);
    }
  }
}

TEST(TestHashedOctreeLocateFilterQuadtrees, TwoProjectsOtherPoints)
{
  const std::vector<double> points = MakeSpherePoints<3, double>(150, 342);
  const std::vector<double> queries = MakeQueries(100, 343);
  for (const SpacePlane& plane : AllPlanes)
  {
    const auto core = MakeCoreQuadtree(TakeFromSpace(points, plane));
    TestedLocateFilter filter(MakePolyData(points), MakePolyData(queries));
    filter->SetDimension(Filter::Two);
    filter->SetPlane(plane.Name);
    filter.Update();
    ExpectLocated(filter, core.Tree, plane, queries);
  }
}

TEST(TestHashedOctreeLocateFilterQuadtrees, StartDepthsAndPredictionsAreThoseOfFourChildren)
{
  std::vector<double> planar = MakeUniformPoints<2, double>(60, 344, 0.0, 1e-4);
  planar.insert(planar.end(), { 1, 1, 0.1, 0.1, 0.1, 0.1 });
  const auto points = MakePolyData(PutInSpace(planar, AllPlanes[0], Across));
  TestedFilter shown;
  shown->SetInputData(points);
  TestedLocateFilter filter(points, MakePolyData(MakeQueries(50, 345)));
  const char* weights[] = { "Leaves", "Points", "GridWeight" };
  for (const int model : { Filter::Leaves, Filter::Points, Filter::Grid })
  {
    shown->SetFrequencyModel(model);
    filter->SetFrequencyModel(model);
    shown.Update();
    filter.Update();
    EXPECT_EQ(filter.GetFieldValue("StartDepth"), shown.GetFieldValue("StartDepth"));
    EXPECT_EQ(filter.GetTableValue("Median", "PredictedMean"), shown.GetFieldValue("MeanHitCost"));
    EXPECT_EQ(filter.GetTableValue("Root", "PredictedMean"), shown.GetFieldValue("MeanRootCost"));
    EXPECT_NEAR(filter.GetTableValue("Entropy bound", "PredictedMean"),
      GetEntropy(shown.GetHistogram(), weights[model]), 1e-9);
    for (const char* way : { "Root", "Median", "Mean", "Local", "Decision tree" })
    {
      EXPECT_GT(filter.GetTableValue(way, "MeasuredMean"), 0.0) << way;
    }
    EXPECT_EQ(filter.GetTableValue("Root", "MeasuredMean"), filter.GetMean("RootCost"));
    EXPECT_EQ(filter.GetTableValue("Local", "MeasuredMean"), filter.GetMean("LocalCost"));
  }
}

TEST(TestHashedOctreeLocateFilterQuadtrees, QueriesThatAreNotFiniteAcrossThePlaneAreNotLocated)
{
  const std::vector<double> planar = MakeUniformPoints<2, double>(50, 346);
  TestedLocateFilter filter(MakePolyData(PutInSpace(planar, AllPlanes[0], Across)),
    MakePolyData({ 0.5, 0.5, NAN, 0.5, 0.5, 1e300, 0.5, 0.5, -INFINITY }));
  filter.Update();
  filter.ExpectWarning("2 of 3 query points");
  EXPECT_EQ(filter.Get("LeafDepth", 0), -1);
  EXPECT_GE(filter.Get("LeafDepth", 1), 0);
  EXPECT_EQ(filter.Get("LeafDepth", 2), -1);
}

TEST(TestHashedOctreeLocateFilterQuadtrees, BlocksOfBothDimensionsAreSearched)
{
  const auto flat =
    MakePolyData(PutInSpace(MakeUniformPoints<2, double>(60, 347), AllPlanes[1], Across));
  const auto full = MakeUniform(60, 348);
  const auto queries = MakePolyData(MakeQueries(40, 349));
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, flat);
  input->SetBlock(1, full);
  TestedLocateFilter filter(input, queries);
  filter.UpdateWithoutErrors();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (const unsigned block : { 0U, 1U })
  {
    TestedLocateFilter alone(input->GetBlock(block), queries);
    alone.Update();
    auto* located = vtkDataSet::SafeDownCast(output->GetBlock(block));
    ASSERT_NE(located, nullptr);
    for (vtkIdType query = 0; query < 40; ++query)
    {
      ASSERT_EQ(located->GetPointData()->GetArray("LeafKey")->GetVariantValue(query),
        alone.GetLocated()->GetPointData()->GetArray("LeafKey")->GetVariantValue(query));
    }
  }
}
