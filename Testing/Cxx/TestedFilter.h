// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_TestedFilter_h
#define Testing_Cxx_TestedFilter_h

#include "vtkHashedOctreeFilter.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/** Points of the given VTK type, from three coordinates for each. */
inline vtkSmartPointer<vtkPoints> MakePoints(
  const std::vector<double>& coordinates, int type = VTK_DOUBLE)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  points->SetNumberOfPoints(static_cast<vtkIdType>(coordinates.size() / 3));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, coordinates.data() + 3 * i);
  }
  return points;
}

/** Points alone, without cells. */
inline vtkSmartPointer<vtkPolyData> MakePolyData(
  const std::vector<double>& coordinates, int type = VTK_DOUBLE)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(MakePoints(coordinates, type));
  return data;
}

/** The filter, and all that it says while it runs. */
class TestedFilter
{
public:
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<std::string> PipelineErrors; ///< Of the executive, not of the filter.
  std::vector<double> Progress;
  int Executions = 0;

  TestedFilter()
  {
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this, &TestedFilter::AddError);
    this->Filter->AddObserver(vtkCommand::WarningEvent, this, &TestedFilter::AddWarning);
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this, &TestedFilter::AddProgress);
    this->Filter->AddObserver(vtkCommand::StartEvent, this, &TestedFilter::AddExecution);
    this->Filter->GetExecutive()->AddObserver(
      vtkCommand::ErrorEvent, this, &TestedFilter::AddPipelineError);
  }
  explicit TestedFilter(const std::vector<double>& coordinates)
    : TestedFilter()
  {
    this->Filter->SetInputData(MakePolyData(coordinates));
  }
  TestedFilter(const TestedFilter&) = delete;
  void operator=(const TestedFilter&) = delete;

  vtkHashedOctreeFilter* operator->() { return this->Filter; }
  vtkHashedOctreeFilter* GetFilter() { return this->Filter; }

  vtkDataSet* GetCells() { return vtkDataSet::SafeDownCast(this->Filter->GetOutputDataObject(0)); }
  vtkTable* GetHistogram() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(1)); }
  vtkTable* GetCosts() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(2)); }

  /** Value of the field data of port 0; NaN, which equals nothing, if there is none. */
  double GetFieldValue(const char* name)
  {
    vtkDataArray* array = this->GetCells()->GetFieldData()->GetArray(name);
    return array != nullptr && array->GetNumberOfValues() == 1 ? array->GetTuple1(0) : NAN;
  }

  void Update()
  {
    this->Filter->Update();
    EXPECT_EQ(this->Errors, std::vector<std::string>());
    EXPECT_EQ(this->PipelineErrors, std::vector<std::string>());
    this->ExpectThreeOutputs();
  }
  /** Update() of an input that the filter must refuse, with one error that says `words`. */
  void UpdateInError(const std::string& words)
  {
    this->Filter->Update();
    ASSERT_EQ(this->Errors.size(), 1U);
    EXPECT_NE(this->Errors[0].find(words), std::string::npos) << this->Errors[0];
    EXPECT_EQ(this->Warnings, std::vector<std::string>());
    this->ExpectEmptyOutputs();
    this->Errors.clear();
    this->PipelineErrors.clear();
  }
  void ExpectEmptyOutputs()
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

  void AddError(vtkObject*, unsigned long, void* text) { Add(this->Errors, text); }
  void AddWarning(vtkObject*, unsigned long, void* text) { Add(this->Warnings, text); }
  void AddPipelineError(vtkObject*, unsigned long, void* text) { Add(this->PipelineErrors, text); }
  void AddProgress(vtkObject*, unsigned long, void* fraction)
  {
    this->Progress.push_back(*static_cast<const double*>(fraction));
  }
  void AddExecution(vtkObject*, unsigned long, void*) { ++this->Executions; }
  static void Add(std::vector<std::string>& texts, const void* text)
  {
    texts.emplace_back(static_cast<const char*>(text));
  }

  vtkNew<vtkHashedOctreeFilter> Filter;
};

#endif
