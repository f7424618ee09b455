// SPDX-License-Identifier: BSD-3-Clause
#include "KeptOctrees.h"

#include <iterator>

namespace hashedoctree
{
KeptOctrees::Pointer KeptOctrees::Find(vtkPointSet* points) const
{
  const auto kept = this->Octrees.find(points);
  return kept == this->Octrees.end() ? nullptr : kept->second.Built;
}

void KeptOctrees::Keep(vtkPointSet* points, vtkMTimeType time, const Pointer& built)
{
  this->Octrees[points] = { points, time, built };
}

void KeptOctrees::ForgetChanged()
{
  for (auto kept = this->Octrees.begin(); kept != this->Octrees.end();)
  {
    vtkPointSet* points = kept->second.Points;
    const bool isSame = points != nullptr && points->GetMTime() == kept->second.Time;
    kept = isSame ? std::next(kept) : this->Octrees.erase(kept);
  }
}
}
