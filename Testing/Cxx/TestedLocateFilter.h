// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_TestedLocateFilter_h
#define Testing_Cxx_TestedLocateFilter_h

#include "TestedAlgorithm.h"

#include "vtkHashedOctreeLocateFilter.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <cmath>
#include <cstdint>

/** The filter that locates queries, and its two outputs. */
class TestedLocateFilter : public TestedAlgorithm<vtkHashedOctreeLocateFilter>
{
public:
  TestedLocateFilter() = default;
  TestedLocateFilter(vtkDataObject* points, vtkDataObject* queries)
  {
    this->Filter->SetInputData(points);
    this->Filter->SetQueryPointsData(queries);
  }

  vtkDataSet* GetLocated()
  {
    return vtkDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0));
  }
  vtkTable* GetTable() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(1)); }

  /** Value of a point array, whatever its type. */
  std::int64_t Get(const char* array, vtkIdType query)
  {
    return static_cast<std::int64_t>(
      this->GetLocated()->GetPointData()->GetArray(array)->GetVariantValue(query).ToTypeInt64());
  }
  /** Value of a column in the row of a model; NaN if there is no such row. */
  double GetTableValue(const std::string& model, const char* column)
  {
    for (vtkIdType row = 0; row < this->GetTable()->GetNumberOfRows(); ++row)
    {
      if (this->GetTable()->GetValueByName(row, "Model").ToString() == model)
      {
        return this->GetTable()->GetValueByName(row, column).ToDouble();
      }
    }
    return NAN;
  }
  /** Mean of a point array over the queries that are finite. */
  double GetMean(const char* array)
  {
    double sum = 0.0;
    double count = 0.0;
    for (vtkIdType query = 0; query < this->GetLocated()->GetNumberOfPoints(); ++query)
    {
      if (this->Get("LeafDepth", query) >= 0)
      {
        sum += static_cast<double>(this->Get(array, query));
        count += 1.0;
      }
    }
    return sum / count;
  }

  void Update()
  {
    this->UpdateWithoutErrors();
    ASSERT_NE(this->GetLocated(), nullptr);
    ASSERT_NE(this->GetTable(), nullptr);
  }
  void ExpectEmptyOutputs() override
  {
    ASSERT_NE(this->GetLocated(), nullptr);
    EXPECT_EQ(this->GetLocated()->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->GetLocated()->GetPointData()->GetNumberOfArrays(), 0);
    EXPECT_EQ(this->GetLocated()->GetFieldData()->GetNumberOfArrays(), 0);
    ASSERT_NE(this->GetTable(), nullptr);
    EXPECT_EQ(this->GetTable()->GetNumberOfColumns(), 0);
  }
};

#endif
