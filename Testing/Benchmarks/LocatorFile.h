// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Benchmarks_LocatorFile_h
#define Testing_Benchmarks_LocatorFile_h

#include "LocatorData.h"

#include "vtkPoints.h"

namespace locator_benchmark
{
/** The points of a polygonal data set (.vtp), of any precision. Throws std::runtime_error when
 * there are none. */
vtkSmartPointer<vtkPoints> ReadPoints(const std::string& path);

/** The same points in float, and named after the file. Throws, too, when they are fewer than
 * LeastSize or not all finite. */
LocatorData ReadOwnData(const std::string& path);
}

#endif
