// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_StopAt_h
#define Testing_Cxx_StopAt_h

#include "vtkAlgorithm.h"
#include "vtkCommand.h"

/** Asks an algorithm to stop when its progress reaches a fraction. */
class StopAt
{
public:
  StopAt(vtkAlgorithm* algorithm, double fraction)
    : Algorithm(algorithm)
    , Fraction(fraction)
    , Observer(algorithm->AddObserver(vtkCommand::ProgressEvent, this, &StopAt::Look))
  {
    algorithm->SetAbortExecute(0);
  }
  ~StopAt() { this->Algorithm->RemoveObserver(this->Observer); }
  StopAt(const StopAt&) = delete;
  void operator=(const StopAt&) = delete;

private:
  void Look(vtkObject*, unsigned long, void* progress)
  {
    if (*static_cast<const double*>(progress) >= this->Fraction)
    {
      this->Algorithm->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Algorithm;
  double Fraction;
  unsigned long Observer;
};

#endif
