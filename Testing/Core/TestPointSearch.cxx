// SPDX-License-Identifier: BSD-3-Clause
#include "PointSearch.h"

#include "BruteForceSearch.h"
#include "Dimensions.h"
#include "MakePointTree.h"
#include "PointSamples.h"
#include "Rounding.h"
#include "Sanitized.h"
#include "SmallNumbersAreZero.h"

#include <algorithm>
#include <iostream>
#include <random>

using namespace hashedoctree;

template <typename Dimension>
class TestPointSearch : public ::testing::Test
{
protected:
  static constexpr int Dim = Dimension::value;

  /** Positions near, on, between, beside and far from the points of a box. */
  Position<Dim> MakePosition(const Box<Dim>& box, const Position<Dim>& point)
  {
    double extent = 0.0;
    for (int axis = 0; axis < Dim; ++axis)
    {
      extent = std::max(extent, box.Upper[axis] - box.Lower[axis]);
    }
    extent = extent > 0.0 ? extent : 1.0;
    std::uniform_real_distribution<double> uniform(-0.5, 0.5);
    const auto kind = this->Random() % 6;
    Position<Dim> x = point;
    for (int axis = 0; axis < Dim; ++axis)
    {
      const double u = uniform(this->Random);
      x[axis] = kind == 0 ? point[axis]
        : kind == 1       ? point[axis] + 1e-3 * extent * u
        : kind == 2       ? point[axis] + 1e-9 * extent * u
        : kind == 3       ? box.Lower[axis] + extent * (0.5 + 1.5 * u)
        : kind == 4       ? box.Lower[axis] + 1e6 * extent * u
                    : box.Lower[axis] + extent * static_cast<double>(this->Random() % 9) / 8.0;
    }
    return x;
  }

  template <typename Real>
  void ExpectAsBruteForce(const PointSample<Dim, Real>& sample, std::size_t maxPointsPerLeaf,
    int queries, int maxDepth = MortonKey<Dim>::MaxDepth)
  {
    SCOPED_TRACE(sample.Name + ", " + std::to_string(maxPointsPerLeaf) +
      " points per leaf, to depth " + std::to_string(maxDepth));
    const auto points = sample.GetSpan();
    const PointSelection<Dim> selection(points, {}, Execution());
    auto tree = MakePointTree(points, maxPointsPerLeaf, maxDepth);
    const BruteForceSearch<Dim, Real> oracle(points);
    for (int query = 0; query < queries; ++query)
    {
      Position<Dim> point{};
      const std::size_t pick = this->Random() % points.Count;
      if (selection.Keeps(points[pick]))
      {
        std::copy(points[pick], points[pick] + Dim, point.begin());
      }
      const Position<Dim> x = this->MakePosition(selection.GetBox(), point);
      const std::vector<OracleFound> all = oracle.FindAll(x);
      constexpr int step = Sanitized ? 8 : 3;
      for (int startDepth = query % step; startDepth <= MortonKey<Dim>::MaxDepth;
           startDepth += step)
      {
        tree.SetStartDepths({ StartDepthModel::Fixed, FrequencyModel::Leaves, startDepth });
        this->ExpectFound(PointSearch<Dim, Real>(tree), x, all);
      }
      tree.SetStartDepths({ StartDepthModel::Local, static_cast<FrequencyModel>(query % 3), 0 });
      this->ExpectFound(PointSearch<Dim, Real>(tree), x, all);
      this->ExpectFoundInBox(tree, oracle, x, point);
    }
  }

  template <typename Real>
  void ExpectFound(const PointSearch<Dim, Real>& search, const Position<Dim>& x,
    const std::vector<OracleFound>& all)
  {
    FoundPoint closest{};
    ASSERT_TRUE(search.FindClosest(x, closest));
    ASSERT_EQ(closest.Id, all[0].Id);
    ASSERT_EQ(closest.Dist2, all[0].Dist2);
    // On the radius is within it, just below is not.
    ASSERT_TRUE(search.FindClosest(x, closest, all[0].Dist2));
    ASSERT_EQ(closest.Id, all[0].Id);
    ASSERT_FALSE(search.FindClosest(x, closest, std::nextafter(all[0].Dist2, -1.0)));

    const std::size_t count = 1 + this->Random() % 40;
    std::vector<FoundPoint> few;
    search.FindClosest(x, count, few);
    ASSERT_EQ(few.size(), std::min(count, all.size()));
    for (std::size_t i = 0; i < few.size(); ++i)
    {
      ASSERT_EQ(few[i].Id, all[i].Id);
      ASSERT_EQ(few[i].Dist2, all[i].Dist2);
    }

    const double radius =
      std::sqrt(all[this->Random() % std::min<std::size_t>(60, all.size())].Dist2);
    std::vector<PointIndex> within;
    search.FindWithin(x, radius, within);
    std::vector<std::int64_t> found(within.begin(), within.end());
    std::sort(found.begin(), found.end());
    std::vector<std::int64_t> expected = GetIds(all, CountWithin(all, radius));
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(found, expected);
    std::vector<FoundPoint> measured;
    search.FindWithin(x, radius, measured);
    std::sort(measured.begin(), measured.end());
    ASSERT_EQ(measured.size(), expected.size());
    for (std::size_t i = 0; i < measured.size(); ++i)
    {
      ASSERT_EQ(measured[i].Id, all[i].Id);
      ASSERT_EQ(measured[i].Dist2, all[i].Dist2);
    }
  }

  /** Boxes whose corners are points, or positions, so that there are points on the faces. */
  template <typename Real>
  void ExpectFoundInBox(const PointTree<Dim, Real>& tree, const BruteForceSearch<Dim, Real>& oracle,
    const Position<Dim>& x, const Position<Dim>& point)
  {
    Box<Dim> box(x, x);
    box.Add({ point, point });
    if (this->Random() % 8 == 0)
    {
      box.Lower[this->Random() % Dim] = -INFINITY;
    }
    std::vector<PointIndex> within{ 7 };
    PointSearch<Dim, Real>(tree).FindWithin(box, within);
    std::vector<std::int64_t> found(within.begin(), within.end());
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, oracle.FindWithin(box));
  }

  std::mt19937_64 Random{ 151 };
};
TYPED_TEST_SUITE(TestPointSearch, Dimensions);

TYPED_TEST(TestPointSearch, FindsWhatBruteForceFindsFromAnyStartDepth)
{
  constexpr int dim = TestFixture::Dim;
  for (const auto& sample : MakePointSamples<dim, double>())
  {
    if (sample.Name != "empty" && sample.Name != "nothing finite")
    {
      this->ExpectAsBruteForce(sample, 1, 20);
      this->ExpectAsBruteForce(sample, 8, 60);
    }
  }
  for (const auto& sample : MakePointSamples<dim, float>())
  {
    if (sample.Name != "empty" && sample.Name != "nothing finite")
    {
      this->ExpectAsBruteForce(sample, 32, 60);
    }
  }
}

TYPED_TEST(TestPointSearch, FindsAmongMany)
{
  constexpr int dim = TestFixture::Dim;
  this->ExpectAsBruteForce(
    PointSample<dim, float>{ "uniform", MakeUniformPoints<dim, float>(20000, 152) }, 16, 40);
  this->ExpectAsBruteForce(
    PointSample<dim, float>{ "sphere", MakeSpherePoints<dim, float>(20000, 153) }, 16, 40);
  // More than the kernels take at a time.
  this->ExpectAsBruteForce(
    PointSample<dim, float>{ "sphere", MakeSpherePoints<dim, float>(5000, 158) }, 500, 40);
  this->ExpectAsBruteForce(
    PointSample<dim, double>{ "clusters", MakeClusteredPoints<dim, double>(20000, 154) }, 16, 40);
}

namespace
{
/** Heaps of points at one place each, whose ids are mixed, among others. */
template <int Dim>
PointSample<Dim, float> MakeHeaps()
{
  PointSample<Dim, float> sample{ "heaps", MakeUniformPoints<Dim, float>(1000, 159) };
  std::mt19937 random(160);
  for (int i = 0; i < 1000; ++i)
  {
    const std::size_t heap = Dim * (random() % 4);
    for (std::size_t axis = 0; axis < Dim; ++axis)
    {
      sample.Coordinates.push_back(sample.Coordinates[heap + axis]);
    }
  }
  return sample;
}
}

TYPED_TEST(TestPointSearch, FindsAmongManyAtOnePlace)
{
  constexpr int dim = TestFixture::Dim;
  this->ExpectAsBruteForce(MakeHeaps<dim>(), 16, 60);
  // Leaves that are large though their points are not at one place.
  this->ExpectAsBruteForce(MakeHeaps<dim>(), 16, 60, 2);
}

TYPED_TEST(TestPointSearch, FindsAsBruteForceInThinPoints)
{
  constexpr int dim = TestFixture::Dim;
  // Thinner than a cell of the last depth, and about as thick as some.
  for (const double thickness : { 0.0, 1e-12, 1e-8, 1e-5 })
  {
    std::vector<double> coordinates = MakeUniformPoints<dim, double>(500, 169);
    for (std::size_t i = 0; i < coordinates.size(); i += dim)
    {
      coordinates[i] = 0.25 + thickness * coordinates[i];
    }
    this->template ExpectAsBruteForce<double>({ "thin", coordinates }, 4, 30);
  }
}

TEST(TestPointSearchFacts, BothSidesOfAPlaneAreAlike)
{
  PointSample<3, float> sample{ "plane", MakeUniformPoints<3, float>(50000, 170) };
  for (std::size_t i = 0; i < sample.Coordinates.size(); i += 3)
  {
    sample.Coordinates[i + 2] = 0.0F;
  }
  const auto tree = MakePointTree(sample.GetSpan(), 64);
  const PointSearch<3, float> search(tree);
  for (const double height : { 1e-9, 1e-3, 0.1, 1.0, 10.0, 1e3 })
  {
    double nodes = 0.0;
    for (std::size_t i = 0; i < 100; ++i)
    {
      const float* point = sample.GetSpan()[i];
      const Position<3> above{ point[0] + 1e-4, point[1], height };
      const Position<3> below{ above[0], above[1], -height };
      ASSERT_EQ(search.CountNodesForClosest(above), search.CountNodesForClosest(below));
      ASSERT_EQ(search.CountNodesForClosest(above, 8), search.CountNodesForClosest(below, 8));
      ASSERT_EQ(search.CountNodesForWithin(above, 1.1 * height),
        search.CountNodesForWithin(below, 1.1 * height));
      ASSERT_EQ(search.CountNodesForWithin(above, 0.9 * height), 0U) << "no point can be there";
      nodes += static_cast<double>(search.CountNodesForClosest(above)) / 100;
    }
    EXPECT_LT(nodes, height < 1e-6 ? 1.5 : 14.0) << height; // 30 from 10 above rounded boxes.
  }
}

TEST(TestPointSearchFacts, NoPositionIsSlowBesideADenseSpot)
{
  // From afar all points of the spot are equally close to a float, and all but one to the eye.
  std::vector<double> coordinates = MakeUniformPoints<3, double>(50000, 157, 0.0, 1e-9);
  coordinates.insert(coordinates.end(), 3, 1.0);
  const PointSample<3, double> sample{ "spot", coordinates };
  auto tree = MakePointTree(sample.GetSpan(), 16);
  const BruteForceSearch<3, double> oracle(sample.GetSpan());
  for (const Position<3>& x : { Position<3>{ 0.3, 0.1, 0.2 }, Position<3>{ 2e-9, 1e-9, 0.0 },
         Position<3>{ 5e-10, 5e-10, 5e-10 }, Position<3>{ -3.0, 0.0, 7.0 },
         Position<3>{ 1e4, -1e4, 1e3 } })
  {
    for (const StartDepthModel model : { StartDepthModel::Median, StartDepthModel::Root })
    {
      tree.SetStartDepths({ model, FrequencyModel::Leaves, 0 });
      const PointSearch<3, double> search(tree);
      FoundPoint closest{};
      ASSERT_TRUE(search.FindClosest(x, closest));
      EXPECT_EQ(closest.Id, oracle.FindAll(x)[0].Id);
      EXPECT_LT(search.CountNodesForClosest(x), 150U);
      if (model == StartDepthModel::Root && x[0] == 5e-10)
      {
        EXPECT_GT(search.CountNodesForClosest(x), 21U) << "the leaf's own tree is not searched";
      }
    }
  }
}

TEST(TestPointSearchFacts, BoxesTellHowNearAPointIs)
{
  // Most points in one corner, and fewer and fewer away from it: on the way down, the nearest box
  // is the one around the corner, again and again, although single points beside it are nearer.
  std::mt19937 random(161);
  std::lognormal_distribution<float> coordinate(0.0F, 3.0F);
  PointSample<3, float> sample{ "corner", std::vector<float>(60000) };
  std::generate(
    sample.Coordinates.begin(), sample.Coordinates.end(), [&] { return coordinate(random); });
  const auto tree = MakePointTree(sample.GetSpan(), 16);
  const PointSearch<3, float> search(tree);
  const Box<3> box = PointSelection<3>(sample.GetSpan(), {}, Execution()).GetBox();
  double nodes = 0.0;
  constexpr int queries = 1000;
  for (int query = 0; query < queries; ++query)
  {
    Position<3> x;
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = std::uniform_real_distribution<double>(box.Lower[axis], box.Upper[axis])(random);
    }
    nodes += static_cast<double>(search.CountNodesForClosest(x));
  }
  EXPECT_LT(nodes / queries, 4.0);
}

TEST(TestPointSearchFacts, ExaminesFewNodesAmongUniformPoints)
{
  const PointSample<3, float> sample{ "uniform", MakeUniformPoints<3, float>(50000, 162) };
  const auto points = sample.GetSpan();
  const auto tree = MakePointTree(points, 64);
  const PointSearch<3, float> search(tree);
  const std::vector<double> uniform = MakeUniformPoints<3, double>(1000, 163);
  double forUniform = 0.0;
  double forOne = 0.0;
  double forFew = 0.0;
  double forMany = 0.0;
  double forBall = 0.0;
  for (std::size_t i = 0; i < 1000; ++i)
  {
    const Position<3> between{ uniform[3 * i], uniform[3 * i + 1], uniform[3 * i + 2] };
    forUniform += static_cast<double>(search.CountNodesForClosest(between)) / 1000;
    const Position<3> x{ points[i][0] + 1e-4, points[i][1], points[i][2] };
    forOne += static_cast<double>(search.CountNodesForClosest(x)) / 1000;
    forFew += static_cast<double>(search.CountNodesForClosest(x, 100)) / 1000;
    forMany += static_cast<double>(search.CountNodesForClosest(x, 1000)) / 1000;
    forBall += static_cast<double>(search.CountNodesForWithin(x, 0.002)) / 1000;
  }
  std::cout << "nodes " << forUniform << ", near a point " << forOne << ", for the 100 closest "
            << forFew << ", for 1000 " << forMany << ", in a small ball " << forBall << "\n";
  EXPECT_LT(forUniform, 3.7); // 3.8 where what has been searched is searched again.
  EXPECT_LT(forOne, 1.2);     // Most often that is the position's own leaf.
  EXPECT_LT(forFew, 20.0);
  EXPECT_LT(forMany, 60.0);
  EXPECT_LT(forBall, 2.0);
}

TEST(TestPointSearchFacts, ExaminesFewerNodesFromLocalStartDepths)
{
  // Half of the points in a dense corner: one start depth cannot suit both halves.
  const PointSample<3, float> sample{ "two densities",
    MakeTwoDensities<3, float>(8000, 166, 0.01) };
  const auto points = sample.GetSpan();
  auto tree = MakePointTree(points, 8);
  const PointSearch<3, float> search(tree);
  const auto countNodes = [&](StartDepthModel model)
  {
    tree.SetStartDepths({ model, FrequencyModel::Points, 0 });
    std::array<std::uint64_t, 2> nodes{};
    for (std::size_t i = 0; i < points.Count; ++i)
    {
      const Position<3> x{ points[i][0], points[i][1], points[i][2] };
      nodes[0] += search.CountNodesForClosest(x);
      nodes[1] += search.CountNodesForWithin(x, 1e-6);
    }
    return nodes;
  };
  const auto local = countNodes(StartDepthModel::Local);
  const auto median = countNodes(StartDepthModel::Median);
  for (const std::size_t kind : { 0U, 1U })
  {
    EXPECT_GE(local[kind], points.Count);
    EXPECT_LT(local[kind], 0.7 * static_cast<double>(median[kind]));
  }
}

TEST(TestPointSearchFacts, BallsFarFromAllPointsExamineNoNode)
{
  std::vector<double> coordinates = MakeUniformPoints<3, double>(50000, 165, 0.0, 0.01);
  coordinates.insert(coordinates.end(), 3, 1.0);
  const PointSample<3, double> sample{ "corners", coordinates };
  const auto tree = MakePointTree(sample.GetSpan(), 64);
  const PointSearch<3, double> search(tree);
  const Position<3> x{ 0.5, 0.6, 0.4 };
  EXPECT_EQ(search.CountNodesForWithin(x, 0.3), 0U);
  EXPECT_GT(search.CountNodesForWithin(x, 0.9), 0U);
  EXPECT_GT(search.CountNodesForWithin({ 0.005, 0.005, 0.005 }, 1e-9), 0U);
}

TEST(TestPointSearchFacts, ARootThatIsALeafIsOneNode)
{
  const PointSample<3, float> sample{ "few", MakeUniformPoints<3, float>(5, 168) };
  const auto tree = MakePointTree(sample.GetSpan(), 64);
  const PointSearch<3, float> search(tree);
  const Position<3> x{ 0.5, 0.5, 0.5 };
  EXPECT_EQ(search.CountNodesForClosest(x), 1U);
  EXPECT_EQ(search.CountNodesForClosest(x, 2), 1U);
  EXPECT_EQ(search.CountNodesForWithin(x, 0.1), 1U);
}

TEST(TestPointSearchFacts, BallsTakeWholeNodesAsTheyAre)
{
  const PointSample<3, float> sample{ "uniform", MakeUniformPoints<3, float>(50000, 167) };
  const auto tree = MakePointTree(sample.GetSpan(), 64);
  const PointSearch<3, float> search(tree);
  std::vector<PointIndex> found;
  for (const double away : { 0.5, 3.0, 1e3, 1e6 })
  {
    for (const double radius : { 2.0 * away + 1.0, double(INFINITY) })
    {
      const Position<3> x{ away, away, away };
      // The root, once the leaf of the position is found.
      EXPECT_LT(search.CountNodesForWithin(x, radius), 7U) << away << ' ' << radius;
      search.FindWithin(x, radius, found);
      EXPECT_EQ(found.size(), 50000U);
    }
  }
}

TEST(TestPointSearchFacts, SmallAndLargeBoxesAreSearchedLikeOthers)
{
  for (const double side : { 1e-141, 1e-138, 1.0, 1e145, 1e150 })
  {
    const std::vector<double> coordinates = MakeUniformPoints<3, double>(20000, 176, 0.0, side);
    const PointSpan<3, double> points{ coordinates.data(), 20000 };
    const auto tree = MakePointTree(points, 64);
    const Position<3> beside{ 1.5 * side, 0.5 * side, 0.5 * side };
    EXPECT_LT((PointSearch<3, double>(tree).CountNodesForClosest(beside)), 50U) << side;
  }
}

TEST(TestPointSearchFacts, ManyAreFoundInOrder)
{
  // Beyond the number that is kept in order all the time.
  for (const auto& sample :
    { PointSample<3, float>{ "uniform", MakeUniformPoints<3, float>(5000, 156) }, MakeHeaps<3>() })
  {
    SCOPED_TRACE(sample.Name);
    const auto points = sample.GetSpan();
    const auto tree = MakePointTree(points, 16);
    const PointSearch<3, float> search(tree);
    const Position<3> x{ points[0][0] + 1e-3, points[0][1], points[0][2] };
    const std::vector<OracleFound> all = BruteForceSearch<3, float>(points).FindAll(x);
    for (const std::size_t count : { 64U, 65U, 256U, 257U, 300U, 700U, 4999U, 5000U, 9000U })
    {
      std::vector<FoundPoint> found;
      search.FindClosest(x, count, found);
      ASSERT_EQ(found.size(), std::min(count, points.Count));
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        ASSERT_EQ(found[i].Id, all[i].Id);
      }
    }
  }
}

/** Compares the 20 closest and those within a radius of some of the points with brute force, in the
 * mode that the processor is in. */
template <typename Real>
void ExpectAsBruteForceInThisMode(
  const std::vector<Real>& coordinates, std::size_t maxPointsPerLeaf, double radius)
{
  const PointSpan<3, Real> points{ coordinates.data(), coordinates.size() / 3 };
  const auto tree = MakePointTree(points, maxPointsPerLeaf);
  const PointSearch<3, Real> search(tree);
  for (std::size_t query = 0; query < points.Count; query += points.Count / 100)
  {
    const Position<3> x = GetPosition<3>(points, query);
    const auto all = BruteForceSearch<3, Real>(points).FindAll(x);
    std::vector<FoundPoint> few;
    search.FindClosest(x, 20, few);
    std::vector<std::int64_t> found(20);
    std::transform(few.begin(), few.end(), found.begin(), [](const auto& p) { return p.Id; });
    ASSERT_EQ(found, GetIds(all, 20));
    std::vector<PointIndex> within;
    search.FindWithin(x, radius, within);
    ASSERT_EQ(within.size(), CountWithin(all, radius));
  }
}

#if defined(__SSE2__)
TEST(TestPointSearchFacts, NumbersThatAreTakenForZeroChangeNoAnswer)
{
  const SmallNumbersAreZero mode;
  for (const double extent : { 1e-300, 1e-200, 1e-156, 1e-153, 1e-148, 1e-140 })
  {
    SCOPED_TRACE(extent);
    ExpectAsBruteForceInThisMode(
      MakeUniformPoints<3, double>(300, 174, -extent, extent), 4, extent / 4.0);
  }
}
#endif

TEST(TestPointSearchFacts, ProcessorsMayRoundOtherwise)
{
  // Floats that far from 0 are multiples of 1/16: many lie on borders of cells.
  const std::vector<float> coordinates = MakeUniformPoints<3, float>(5000, 175, 857794.0, 857801.0);
  for (const int mode : { FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO })
  {
    SCOPED_TRACE(mode);
    const Rounding rounding(mode);
    ExpectAsBruteForceInThisMode(coordinates, 16, 1.0);
  }
}

TEST(TestPointSearchFacts, NothingToFind)
{
  const PointSample<3, float> sample{ "uniform", MakeUniformPoints<3, float>(100, 155) };
  const auto tree = MakePointTree(sample.GetSpan(), 8);
  const PointTree<3, float> empty;
  const Position<3> inside{ 0.5, 0.5, 0.5 };
  const auto expectNothing = [](const PointTree<3, float>& points, const Position<3>& x)
  {
    const PointSearch<3, float> search(points);
    FoundPoint closest{ 7.0, 7 };
    EXPECT_FALSE(search.FindClosest(x, closest));
    EXPECT_EQ(closest.Id, 7U);
    std::vector<FoundPoint> few{ closest };
    search.FindClosest(x, 5, few);
    EXPECT_TRUE(few.empty());
    std::vector<PointIndex> within{ 7 };
    search.FindWithin(x, 10.0, within);
    EXPECT_TRUE(within.empty());
  };
  expectNothing(empty, inside);
  expectNothing(tree, { NAN, 0.5, 0.5 });
  expectNothing(tree, { 0.5, INFINITY, 0.5 });

  const PointSearch<3, float> search(tree);
  FoundPoint closest{};
  EXPECT_FALSE(search.FindClosest(inside, closest, -1.0));
  EXPECT_FALSE(search.FindClosest(inside, closest, NAN));
  std::vector<FoundPoint> few{ closest };
  search.FindClosest(inside, 0, few);
  EXPECT_TRUE(few.empty());
  EXPECT_EQ(search.CountNodesForClosest(inside, 0), 0U);
  std::vector<PointIndex> within{ 7 };
  search.FindWithin(inside, -1.0, within);
  EXPECT_TRUE(within.empty());
  search.FindWithin(inside, NAN, within);
  EXPECT_TRUE(within.empty());
  for (const Position<3>& upper : { Position<3>{ 0.4, 1.0, 1.0 }, Position<3>{ 1.0, NAN, 1.0 } })
  {
    within.assign(1, 7);
    search.FindWithin(Box<3>(inside, upper), within);
    EXPECT_TRUE(within.empty());
  }
  search.FindWithin(Box<3>({ -INFINITY, -1.0, -1.0 }, { INFINITY, 2.0, INFINITY }), within);
  EXPECT_EQ(within.size(), 100U);
  search.FindWithin(inside, INFINITY, within);
  EXPECT_EQ(within.size(), 100U);
  search.FindClosest(inside, 1000, few);
  EXPECT_EQ(few.size(), 100U);
}
