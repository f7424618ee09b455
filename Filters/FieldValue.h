// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldValue_h
#define FieldValue_h

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

namespace hashedoctree
{
/** The field data of a data object, which gets some where it has none. Private to the module. */
inline vtkFieldData* GetOwnFieldData(vtkDataObject* dataObject)
{
  if (dataObject->GetFieldData() == nullptr)
  {
    dataObject->SetFieldData(vtkNew<vtkFieldData>());
  }
  return dataObject->GetFieldData();
}

/** Adds an array of one value to the field data. Private to the module. */
template <typename Array, typename Value>
void AddFieldValue(vtkFieldData* fieldData, const char* name, Value value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextValue(static_cast<typename Array::ValueType>(value));
  fieldData->AddArray(array);
}
}

#endif
