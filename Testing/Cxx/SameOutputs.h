// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_SameOutputs_h
#define Testing_Cxx_SameOutputs_h

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHashedOctreeFilter.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

/** Bit for bit. */
inline void ExpectSameArray(vtkDataArray* a, vtkDataArray* b, const std::string& name)
{
  ASSERT_TRUE(a && b) << name;
  ASSERT_EQ(a->GetDataType(), b->GetDataType()) << name;
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues()) << name;
  const auto bytes = static_cast<std::size_t>(a->GetNumberOfValues() * a->GetDataTypeSize());
  if (bytes > 0)
  {
    EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes), 0) << name;
  }
}

/** Same arrays in the same order; but for the time that the build took. */
inline void ExpectSameArrays(vtkFieldData* a, vtkFieldData* b)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    const std::string name = a->GetArrayName(i);
    ASSERT_EQ(name, b->GetArrayName(i));
    if (name != "BuildSeconds")
    {
      ExpectSameArray(a->GetArray(i), b->GetArray(i), name);
    }
  }
}

inline vtkCellArray* GetCellArray(vtkPointSet* data)
{
  auto* outlines = vtkPolyData::SafeDownCast(data);
  return outlines != nullptr ? outlines->GetLines()
                             : vtkUnstructuredGrid::SafeDownCast(data)->GetCells();
}

/** Expects the same of two data objects that the filter made: cells, or a table. */
inline void ExpectSame(vtkDataObject* a, vtkDataObject* b)
{
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->GetDataObjectType(), b->GetDataObjectType());
  ExpectSameArrays(a->GetFieldData(), b->GetFieldData());
  if (auto* table = vtkTable::SafeDownCast(a))
  {
    ExpectSameArrays(table->GetRowData(), vtkTable::SafeDownCast(b)->GetRowData());
    return;
  }
  auto* cells = vtkPointSet::SafeDownCast(a);
  auto* otherCells = vtkPointSet::SafeDownCast(b);
  ExpectSameArrays(cells->GetCellData(), otherCells->GetCellData());
  ExpectSameArray(cells->GetPoints()->GetData(), otherCells->GetPoints()->GetData(), "points");
  ExpectSameArray(GetCellArray(cells)->GetConnectivityArray(),
    GetCellArray(otherCells)->GetConnectivityArray(), "connectivity");
  ExpectSameArray(
    GetCellArray(cells)->GetOffsetsArray(), GetCellArray(otherCells)->GetOffsetsArray(), "offsets");
}

/** The outputs of the three ports, updated, and safe from later updates. */
inline std::vector<vtkSmartPointer<vtkDataObject>> TakeOutputs(vtkHashedOctreeFilter* filter)
{
  filter->Update();
  std::vector<vtkSmartPointer<vtkDataObject>> outputs;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    outputs.push_back(vtk::TakeSmartPointer(output->NewInstance()));
    outputs.back()->ShallowCopy(output);
  }
  return outputs;
}

inline void ExpectSameOutputs(const std::vector<vtkSmartPointer<vtkDataObject>>& a,
  const std::vector<vtkSmartPointer<vtkDataObject>>& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t port = 0; port < a.size(); ++port)
  {
    SCOPED_TRACE("port " + std::to_string(port));
    ExpectSame(a[port], b[port]);
  }
}

#endif
