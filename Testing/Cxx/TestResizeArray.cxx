// SPDX-License-Identifier: BSD-3-Clause
#include "ResizeArray.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

using namespace hashedoctree;

TEST(TestResizeArray, GivesRoomForTheValues)
{
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(3);
  for (const std::size_t size : { 6U, 300000U, 0U, 3U })
  {
    ResizeArray(array.Get(), size);
    EXPECT_EQ(array->GetNumberOfValues(), static_cast<vtkIdType>(size));
    EXPECT_EQ(array->GetNumberOfTuples(), static_cast<vtkIdType>(size / 3));
    array->Fill(7.0);
  }
  array->InsertNextValue(8.0); // The memory is one that VTK can make larger.
  EXPECT_EQ(array->GetValue(2), 7.0);
  EXPECT_EQ(array->GetValue(3), 8.0);
}

TEST(TestResizeArray, WithoutMemoryTheArrayStaysAsItIs)
{
  vtkNew<vtkDoubleArray> array;
  array->InsertNextValue(7.0);
  EXPECT_THROW(
    ResizeArray(array.Get(), std::numeric_limits<std::size_t>::max() / 2), std::bad_alloc);
  // Whose bytes would be a few, modulo 2^64.
  EXPECT_THROW(ResizeArray(array.Get(), (std::size_t(1) << 61) + 1), std::bad_alloc);
  EXPECT_EQ(array->GetNumberOfValues(), 1);
  EXPECT_EQ(array->GetValue(0), 7.0);
}
