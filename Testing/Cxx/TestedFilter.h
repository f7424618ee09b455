// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_TestedFilter_h
#define Testing_Cxx_TestedFilter_h

#include "TestedAlgorithm.h"

#include "vtkHashedOctreeFilter.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkTable.h"

/** The filter, and its three outputs. */
class TestedFilter : public TestedAlgorithm<vtkHashedOctreeFilter>
{
public:
  TestedFilter() = default;
  explicit TestedFilter(const std::vector<double>& coordinates)
  {
    this->Filter->SetInputData(MakePolyData(coordinates));
  }

  vtkDataSet* GetCells() { return vtkDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0)); }
  vtkTable* GetHistogram() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(1)); }
  vtkTable* GetCosts() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(2)); }

  void Update()
  {
    this->UpdateWithoutErrors();
    this->ExpectThreeOutputs();
  }
  void ExpectEmptyOutputs() override
  {
    this->ExpectThreeOutputs();
    for (int port = 0; port < this->Filter->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject* output = this->Filter->GetOutputDataObject(port);
      for (int type = 0; type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
      {
        EXPECT_EQ(output->GetNumberOfElements(type), 0) << port;
      }
      EXPECT_EQ(output->GetFieldData()->GetNumberOfArrays(), 0) << port;
    }
    EXPECT_EQ(this->GetCells()->GetCellData()->GetNumberOfArrays(), 0);
    EXPECT_EQ(this->GetHistogram()->GetNumberOfColumns(), 0);
    EXPECT_EQ(this->GetCosts()->GetNumberOfColumns(), 0);
  }

private:
  void ExpectThreeOutputs()
  {
    ASSERT_EQ(this->Filter->GetNumberOfOutputPorts(), 3);
    ASSERT_NE(this->GetCells(), nullptr);
    ASSERT_NE(this->GetHistogram(), nullptr);
    ASSERT_NE(this->GetCosts(), nullptr);
  }
};

#endif
