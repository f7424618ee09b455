// SPDX-License-Identifier: BSD-3-Clause
#include "KeptOctrees.h"

#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hashedoctree
{
vtkMTimeType KeptOctrees::GetTime(vtkPointSet* points)
{
  // Not all classes tell of their points, or of the arrays of these, marks among them.
  const vtkMTimeType ofPoints =
    points->GetPoints() != nullptr ? points->GetPoints()->GetMTime() : 0;
  return std::max({ points->GetMTime(), ofPoints, points->GetPointData()->GetMTime() });
}

KeptOctrees::Pointer KeptOctrees::Find(vtkPointSet* points) const
{
  const auto kept = this->Octrees.find(points);
  return kept != this->Octrees.end() && kept->second.IsGood() ? kept->second.Built : nullptr;
}

void KeptOctrees::Keep(vtkPointSet* points, vtkMTimeType time, const Pointer& built)
{
  this->Octrees[points] = { points, time, built };
}

void KeptOctrees::ForgetOthers(vtkDataObject* input)
{
  if (std::exchange(this->UpdateTime, input->GetUpdateTime()) != input->GetUpdateTime())
  {
    this->Forget();
  }
  for (auto kept = this->Octrees.begin(); kept != this->Octrees.end();)
  {
    kept = kept->second.IsGood() ? std::next(kept) : this->Octrees.erase(kept);
  }
}

bool KeptOctrees::Kept::IsGood() const
{
  return this->Points != nullptr && GetTime(this->Points) == this->Time;
}
}
