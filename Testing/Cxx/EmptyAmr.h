// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_EmptyAmr_h
#define Testing_Cxx_EmptyAmr_h

#include "vtkNonOverlappingAMR.h"
#include "vtkSmartPointer.h"

#include <vector>

/** An AMR data set with room for so many grids at each level. */
inline vtkSmartPointer<vtkNonOverlappingAMR> MakeEmptyAmr(const std::vector<unsigned>& gridsOfLevel)
{
  auto amr = vtkSmartPointer<vtkNonOverlappingAMR>::New();
#if __has_include("vtkAMRDataObject.h") // VTK 9.6
  amr->Initialize(gridsOfLevel);
#else
  const std::vector<int> signedGrids(gridsOfLevel.begin(), gridsOfLevel.end());
  amr->Initialize(static_cast<int>(signedGrids.size()), signedGrids.data());
#endif
  return amr;
}

#endif
