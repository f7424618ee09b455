// SPDX-License-Identifier: BSD-3-Clause
#include "AlgorithmProblems.h"

#include "Execution.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <exception>
#include <new>

namespace hashedoctree
{
std::string DescribeProblem(const char* ofMemory)
{
  try
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    return ofMemory;
  }
  catch (const std::exception& exception)
  {
    return exception.what();
  }
}

void ReportProblem(vtkAlgorithm* algorithm, vtkInformationVector* outputVector)
{
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject::GetData(outputVector, port)->Initialize(); // Makes room for the text, too.
  }
  try
  {
    const std::string problem =
      DescribeProblem("There is not enough memory for the octree and what is made of it; take "
                      "fewer points, raise MaxPointsPerLeaf or lower MaxDepth.");
    vtkErrorWithObjectMacro(algorithm, << problem);
  }
  catch (const Interrupted&)
  {
  }
}
}
