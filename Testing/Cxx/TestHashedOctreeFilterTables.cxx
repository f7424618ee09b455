// SPDX-License-Identifier: BSD-3-Clause
#include "ExpectOctree.h"
#include "PointSamples.h"
#include "SameOutputs.h"

// Types, rows and values of the tables are compared with the plain octree wherever
// ExpectOctree() is called; here is what the models and options do to them.

TEST(TestHashedOctreeFilterTables, EveryModelGivesItsStartDepth)
{
  const std::vector<double> samples[] = { MakeClusteredPoints<3, double>(600, 20),
    MakeSpherePoints<3, double>(600, 21), { 1, 2, 3 } };
  for (const std::vector<double>& coordinates : samples)
  {
    TestedFilter filter(coordinates);
    filter->IncludeEmptyLeavesOn();
    for (int frequency = 0; frequency <= vtkHashedOctreeFilter::Grid; ++frequency)
    {
      for (int model = 0; model <= vtkHashedOctreeFilter::Fixed; ++model)
      {
        for (const int fixed : { 0, 5, 21 })
        {
          SCOPED_TRACE("FrequencyModel " + std::to_string(frequency) + ", StartDepthModel " +
            std::to_string(model) + ", FixedStartDepth " + std::to_string(fixed));
          filter->SetFrequencyModel(frequency);
          filter->SetStartDepthModel(model);
          filter->SetFixedStartDepth(fixed);
          UpdateAndExpectOctree(filter, coordinates);
        }
      }
    }
  }
}

TEST(TestHashedOctreeFilterTables, ModelsDifferWhereTheyShould)
{
  // So that the test above cannot pass by all models being one. Around a small cluster most leaves
  // lie deep, but some do not, and they have most of the volume.
  std::vector<double> coordinates = MakeUniformPoints<3, double>(60, 25, 0.0, 1e-4);
  coordinates.insert(coordinates.end(), { 1, 1, 1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1 });
  TestedFilter filter(coordinates);
  filter.Update();
  EXPECT_LT(filter.GetFieldValue("StartDepthGrid"), filter.GetFieldValue("StartDepthPoints"));
  EXPECT_NE(filter.GetFieldValue("StartDepthPoints"), filter.GetFieldValue("StartDepthLeaves"));
  const double median = filter.GetFieldValue("StartDepth");
  filter->SetStartDepthModel(vtkHashedOctreeFilter::Mean);
  filter.Update();
  EXPECT_LT(filter.GetFieldValue("StartDepth"), median);
}

TEST(TestHashedOctreeFilterTables, MedianIsWhereTheCostsAreLeast)
{
  const char* columns[] = { "CostLeaves", "CostPoints", "CostGrid" };
  TestedFilter filter(MakeSpherePoints<3, double>(20000, 22));
  for (int model = 0; model <= vtkHashedOctreeFilter::Grid; ++model)
  {
    SCOPED_TRACE(columns[model]);
    filter->SetFrequencyModel(model);
    filter.Update();
    auto* costs = vtkDataArray::SafeDownCast(filter.GetCosts()->GetColumnByName(columns[model]));
    vtkIdType cheapest = 0;
    for (vtkIdType row = 1; row < costs->GetNumberOfTuples(); ++row)
    {
      cheapest = costs->GetTuple1(row) < costs->GetTuple1(cheapest) ? row : cheapest;
    }
    EXPECT_EQ(filter.GetFieldValue("StartDepth"), static_cast<double>(cheapest));
    EXPECT_EQ(filter.GetFieldValue("MeanHitCost"), costs->GetTuple1(cheapest));
    EXPECT_EQ(filter.GetFieldValue("MeanRootCost"), costs->GetTuple1(0));
  }
}

TEST(TestHashedOctreeFilterTables, CountAllLeavesWhateverPort0Shows)
{
  TestedFilter filter(MakeSpherePoints<3, double>(500, 23));
  const auto outputs = TakeOutputs(filter.GetFilter());
  for (int shown = 1; shown < 8; ++shown)
  {
    filter->SetOutputType(shown & 1);
    filter->SetIncludeEmptyLeaves((shown & 2) != 0);
    filter->SetIncludeInternalNodes((shown & 4) != 0);
    const auto others = TakeOutputs(filter.GetFilter());
    ExpectSame(others[1], outputs[1]);
    ExpectSame(others[2], outputs[2]);
    ExpectSameArrays(others[0]->GetFieldData(), outputs[0]->GetFieldData());
  }
}

TEST(TestHashedOctreeFilterTables, MeansOfTheCellsAreThoseOfTheFieldData)
{
  TestedFilter filter(MakeSpherePoints<3, double>(3000, 24));
  filter->IncludeEmptyLeavesOn();
  filter.Update();
  const auto mean = [&filter](const char* name)
  {
    vtkDataArray* costs = filter.GetCells()->GetCellData()->GetArray(name);
    double sum = 0.0;
    for (vtkIdType cell = 0; cell < costs->GetNumberOfTuples(); ++cell)
    {
      sum += costs->GetTuple1(cell);
    }
    return sum / static_cast<double>(costs->GetNumberOfTuples());
  };
  EXPECT_EQ(filter.GetFieldValue("MeanHitCost"), mean("HitCost"));
  EXPECT_EQ(filter.GetFieldValue("MeanRootCost"), mean("RootCost"));
}
