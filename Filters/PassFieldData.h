// SPDX-License-Identifier: BSD-3-Clause
#ifndef PassFieldData_h
#define PassFieldData_h

#include "vtkAbstractArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"

namespace hashedoctree
{
/** Gives an output the arrays of an input's field data that it has none of that name of. Either
 * may have no field data. Private to the module. */
inline void PassFieldData(vtkDataObject* input, vtkDataObject* output)
{
  vtkFieldData* from = input->GetFieldData();
  vtkFieldData* to = output->GetFieldData();
  if (from == nullptr || to == nullptr)
  {
    return;
  }
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    if (to->GetAbstractArray(array->GetName()) == nullptr)
    {
      to->AddArray(array);
    }
  }
}
}

#endif
