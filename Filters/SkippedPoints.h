// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkippedPoints_h
#define SkippedPoints_h

#include "vtkObject.h"
#include "vtkSetGet.h" // For the warning macro
#include "vtkType.h"

#include <cstddef>

namespace hashedoctree
{
/** Warns, in an object's name, of points that a PointSelection left out, `skipped` of `all`.
 * Private to the module. */
inline void WarnOfSkippedPoints(vtkObject* object, std::size_t skipped, vtkIdType all)
{
  vtkWarningWithObjectMacro(object, << skipped << " of " << all
                                    << " points left out, for a coordinate that is not finite or "
                                       "too large.");
}
}

#endif
