// SPDX-License-Identifier: BSD-3-Clause
#ifndef BatchArrays_h
#define BatchArrays_h

#include "ResizeArray.h"

#include "vtkDataArray.h"

#include <cstddef>
#include <initializer_list>

// The arrays that a batch of searches fills. Private to the locator.
namespace hashedoctree
{
/** For who keeps what an array told of its values. */
inline void TellOfChange(std::initializer_list<vtkDataArray*> arrays)
{
  for (vtkDataArray* array : arrays)
  {
    array->Modified();
  }
}

inline void Empty(std::initializer_list<vtkDataArray*> arrays)
{
  for (vtkDataArray* array : arrays)
  {
    array->Initialize();
    array->SetNumberOfComponents(1);
  }
  TellOfChange(arrays);
}

template <typename Array>
void SetSize(Array* array, int components, std::size_t tuples)
{
  ResizeArray(array, static_cast<std::size_t>(components) * tuples);
  // For which VTK keeps a tuple, too: without positions it would be all that takes memory.
  array->SetNumberOfComponents(tuples > 0 ? components : 1);
}
}

#endif
