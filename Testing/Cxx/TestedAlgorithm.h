// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_TestedAlgorithm_h
#define Testing_Cxx_TestedAlgorithm_h

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/** An algorithm, and all that it says while it runs. */
template <typename Algorithm>
class TestedAlgorithm
{
public:
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<std::string> PipelineErrors; ///< Of the executive, not of the filter.
  std::vector<double> Progress;
  int Executions = 0;

  TestedAlgorithm()
  {
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this, &TestedAlgorithm::AddError);
    this->Filter->AddObserver(vtkCommand::WarningEvent, this, &TestedAlgorithm::AddWarning);
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this, &TestedAlgorithm::AddProgress);
    this->Filter->AddObserver(vtkCommand::StartEvent, this, &TestedAlgorithm::AddExecution);
    this->Filter->GetExecutive()->AddObserver(
      vtkCommand::ErrorEvent, this, &TestedAlgorithm::AddPipelineError);
  }
  TestedAlgorithm(const TestedAlgorithm&) = delete;
  void operator=(const TestedAlgorithm&) = delete;

  Algorithm* operator->() { return this->Filter; }
  Algorithm* GetFilter() { return this->Filter; }

  /** Runs it, and expects no error. */
  void UpdateWithoutErrors()
  {
    this->Filter->Update();
    EXPECT_EQ(this->Errors, std::vector<std::string>());
    EXPECT_EQ(this->PipelineErrors, std::vector<std::string>());
  }
  /** Runs it for a piece of an output. */
  void UpdatePiece(int port, int piece, int numberOfPieces)
  {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    vtkNew<vtkInformationVector> requests;
    requests->SetNumberOfInformationObjects(this->Filter->GetNumberOfOutputPorts());
    vtkInformation* request = requests->GetInformationObject(port);
    request->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
    request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), numberOfPieces);
    request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    Pipeline::SafeDownCast(this->Filter->GetExecutive())->Update(port, requests);
  }
  /** Its progress must have gone from 0 to 1, and no step of it further than `most`. */
  void ExpectProgressInSteps(double most) const
  {
    ASSERT_FALSE(this->Progress.empty());
    EXPECT_TRUE(std::is_sorted(this->Progress.begin(), this->Progress.end()));
    EXPECT_EQ(this->Progress.front(), 0.0);
    EXPECT_EQ(this->Progress.back(), 1.0);
    for (std::size_t i = 1; i < this->Progress.size(); ++i)
    {
      EXPECT_LE(this->Progress[i] - this->Progress[i - 1], most) << this->Progress[i];
    }
  }
  /** Runs it, and expects one error that says `words`, no warning, and that the pipeline knows. */
  void UpdateExpectingError(const std::string& words)
  {
    EXPECT_FALSE(this->Filter->GetExecutive()->Update());
    ASSERT_EQ(this->Errors.size(), 1U);
    EXPECT_NE(this->Errors[0].find(words), std::string::npos) << this->Errors[0];
    EXPECT_EQ(this->Warnings, std::vector<std::string>());
    this->Errors.clear();
    this->PipelineErrors.clear();
  }

  /** Expects that the runs until now said one warning, with `words` in it, and forgets it. */
  void ExpectWarning(const std::string& words)
  {
    ASSERT_EQ(this->Warnings.size(), 1U);
    EXPECT_NE(this->Warnings[0].find(words), std::string::npos) << this->Warnings[0];
    this->Warnings.clear();
  }

protected:
  vtkNew<Algorithm> Filter;

private:
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
};

#endif
