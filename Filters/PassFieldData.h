// SPDX-License-Identifier: BSD-3-Clause
#ifndef PassFieldData_h
#define PassFieldData_h

#include "FieldValue.h"

#include "vtkAbstractArray.h"

namespace hashedoctree
{
/** Gives an output the arrays of an input's field data that it has none of that name of. Either
 * may have no field data; the output has some then. Private to the module. */
inline void PassFieldData(vtkDataObject* input, vtkDataObject* output)
{
  vtkFieldData* from = input->GetFieldData();
  vtkFieldData* to = GetOwnFieldData(output);
  for (int i = 0; from != nullptr && i < from->GetNumberOfArrays(); ++i)
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
