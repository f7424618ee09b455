// SPDX-License-Identifier: BSD-3-Clause
#ifndef PassFieldData_h
#define PassFieldData_h

#include "FieldValue.h"

#include "vtkAbstractArray.h"

namespace hashedoctree
{
/** Whether field data hold an array, or another one of its name, if it has one. */
inline bool HasArray(vtkFieldData* data, vtkAbstractArray* array)
{
  bool isThere = array->GetName() != nullptr && data->HasArray(array->GetName());
  for (int i = 0; !isThere && i < data->GetNumberOfArrays(); ++i)
  {
    isThere = data->GetAbstractArray(i) == array;
  }
  return isThere;
}

/** Gives an output the arrays of an input's field data, but for those that it has, itself or by
 * name. Either may have no field data; the output has some then. Private to the module. */
inline void PassFieldData(vtkDataObject* input, vtkDataObject* output)
{
  vtkFieldData* from = input->GetFieldData();
  vtkFieldData* to = GetOwnFieldData(output);
  for (int i = 0; from != nullptr && i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    if (!HasArray(to, array))
    {
      to->AddArray(array);
    }
  }
}
}

#endif
