// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_TestedAlgorithm_h
#define Testing_Cxx_TestedAlgorithm_h

#include "PointClouds.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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
  virtual ~TestedAlgorithm() = default;

  Algorithm* operator->() { return this->Filter; }
  Algorithm* GetFilter() { return this->Filter; }

  /** Value of the field data of port 0; NaN, which equals nothing, if there is none. */
  double GetFieldValue(const char* name)
  {
    vtkDataArray* array = this->Filter->GetOutputDataObject(0)->GetFieldData()->GetArray(name);
    return array != nullptr && array->GetNumberOfValues() == 1 ? array->GetTuple1(0) : NAN;
  }

  /** Runs it, and expects no error. */
  void UpdateWithoutErrors()
  {
    this->Filter->Update();
    EXPECT_EQ(this->Errors, std::vector<std::string>());
    EXPECT_EQ(this->PipelineErrors, std::vector<std::string>());
  }
  /** Runs it, and expects neither errors nor warnings. */
  void UpdateSilently()
  {
    this->UpdateWithoutErrors();
    EXPECT_EQ(this->Warnings, std::vector<std::string>());
  }
  virtual void ExpectEmptyOutputs() = 0;
  /** Runs it, and expects empty outputs without a word. */
  void UpdateToNothing()
  {
    this->UpdateSilently();
    this->ExpectEmptyOutputs();
  }
  /** Runs it with what it must refuse: with empty outputs, and one error that says `words`. */
  void UpdateInError(const std::string& words)
  {
    this->UpdateExpectingError(words);
    this->ExpectEmptyOutputs();
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
  /** Runs it, and expects one error that says `words`, no warning, and that the pipeline goes on.
   */
  void UpdateExpectingError(const std::string& words)
  {
    EXPECT_TRUE(this->Filter->GetExecutive()->Update());
    EXPECT_EQ(this->PipelineErrors, std::vector<std::string>());
    ASSERT_EQ(this->Errors.size(), 1U);
    EXPECT_NE(this->Errors[0].find(words), std::string::npos) << this->Errors[0];
    EXPECT_EQ(this->Warnings, std::vector<std::string>());
    this->Errors.clear();
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
