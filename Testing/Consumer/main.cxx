// SPDX-License-Identifier: BSD-3-Clause
#include <vtkDataSet.h>
#include <vtkHashedOctreeFilter.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

int main()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 10; ++i)
  {
    points->InsertNextPoint(i, i % 3, i % 2);
  }
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  vtkNew<vtkHashedOctreeFilter> filter;
  filter->SetInputData(input);
  filter->Update();
  auto* cells = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  return cells && cells->GetNumberOfCells() >= 10 ? 0 : 1;
}
