// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_TestedNeighborsFilter_h
#define Testing_Cxx_TestedNeighborsFilter_h

#include "TestedAlgorithm.h"

#include "vtkHashedOctreeNeighborsFilter.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

/** Value of an integer cell array, whatever its type. */
inline std::int64_t GetCellValue(vtkDataSet* cells, const char* name, vtkIdType cell)
{
  return static_cast<std::int64_t>(
    cells->GetCellData()->GetArray(name)->GetVariantValue(cell).ToTypeUInt64());
}

/** The filter that finds neighbours, and its output. */
class TestedNeighborsFilter : public TestedAlgorithm<vtkHashedOctreeNeighborsFilter>
{
public:
  TestedNeighborsFilter() = default;
  explicit TestedNeighborsFilter(const std::vector<double>& coordinates)
  {
    this->Filter->SetInputData(MakePolyData(coordinates));
  }

  vtkUnstructuredGrid* GetCells()
  {
    return vtkUnstructuredGrid::SafeDownCast(this->Filter->GetOutputDataObject(0));
  }
  std::int64_t Get(const char* array, vtkIdType cell)
  {
    return GetCellValue(this->GetCells(), array, cell);
  }
  void Update()
  {
    this->UpdateWithoutErrors();
    ASSERT_NE(this->GetCells(), nullptr);
  }
  void ExpectEmptyOutputs() override
  {
    ASSERT_NE(this->GetCells(), nullptr);
    EXPECT_EQ(this->GetCells()->GetNumberOfCells(), 0);
    EXPECT_EQ(this->GetCells()->GetNumberOfPoints(), 0);
    EXPECT_EQ(this->GetCells()->GetCellData()->GetNumberOfArrays(), 0);
    EXPECT_EQ(this->GetCells()->GetFieldData()->GetNumberOfArrays(), 0);
  }
};

#endif
