// SPDX-License-Identifier: BSD-3-Clause
#include "AlgorithmProblems.h"

#include "Execution.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <exception>
#include <new>
#include <string>

namespace hashedoctree
{
void ReportProblem(vtkAlgorithm* algorithm, vtkInformationVector* outputVector)
{
  std::string problem;
  try
  {
    throw;
  }
  catch (const Interrupted&)
  {
  }
  catch (const std::bad_alloc&)
  {
    problem =
      "There is not enough memory for the octree and what is made of it; take fewer points, raise "
      "MaxPointsPerLeaf or lower MaxDepth.";
  }
  catch (const std::exception& exception)
  {
    problem = exception.what();
  }
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject::GetData(outputVector, port)->Initialize();
  }
  if (!problem.empty())
  {
    vtkErrorWithObjectMacro(algorithm, << problem);
  }
}
}
