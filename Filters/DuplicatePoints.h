// SPDX-License-Identifier: BSD-3-Clause
#ifndef DuplicatePoints_h
#define DuplicatePoints_h

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

namespace hashedoctree
{
/** Which points of a data set VTK marks as another piece's, so that they count there and not here.
 * The data set must outlive it. Private to the module. */
class DuplicatePoints
{
public:
  /** Of none. */
  DuplicatePoints() = default;
  /** An array of marks that does not have one for each point marks none. */
  explicit DuplicatePoints(vtkDataSet* dataSet)
  {
    vtkUnsignedCharArray* marks = dataSet->GetPointGhostArray();
    if (dataSet->HasAnyGhostPoints() && marks->GetNumberOfComponents() == 1 &&
      marks->GetNumberOfTuples() == dataSet->GetNumberOfPoints())
    {
      this->Marks = marks;
    }
  }

  bool AreThere() const { return this->Marks != nullptr; }
  bool Have(vtkIdType point) const
  {
    return this->Marks != nullptr &&
      (this->Marks->GetValue(point) & vtkDataSetAttributes::DUPLICATEPOINT) != 0;
  }

private:
  vtkUnsignedCharArray* Marks = nullptr;
};
}

#endif
