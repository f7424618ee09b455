// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResizeArray_h
#define ResizeArray_h

#include "LargePages.h"

#include "vtkAbstractArray.h"
#include "vtkNew.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace hashedoctree
{
/**
 * Gives an array its number of values, in new memory that nothing has been written to. Throws
 * std::bad_alloc when there is none, and the array is as it was: where VTK is compiled with
 * assertions, as in Debian's ParaView, the array itself would end the program. Private to the
 * module.
 */
template <typename Array>
void ResizeArray(Array* array, std::size_t size)
{
  using Value = typename Array::ValueType;
  if (size == 0)
  {
    array->SetNumberOfValues(0);
    return;
  }
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<vtkIdType>::max());
  void* memory = size <= most / sizeof(Value) ? std::malloc(size * sizeof(Value)) : nullptr;
  if (memory == nullptr)
  {
    throw std::bad_alloc();
  }
  UseLargePages(memory, size * sizeof(Value));
  array->SetArray(static_cast<Value*>(memory), static_cast<vtkIdType>(size), /*save=*/0,
    vtkAbstractArray::VTK_DATA_ARRAY_FREE);
}

/** A new array of one component with so many values. Throws as ResizeArray() does. */
template <typename Array>
vtkNew<Array> MakeArray(const char* name, std::size_t size)
{
  vtkNew<Array> array;
  array->SetName(name);
  ResizeArray(array.Get(), size);
  return array;
}
}

#endif
