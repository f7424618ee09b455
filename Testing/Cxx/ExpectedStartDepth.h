// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Cxx_ExpectedStartDepth_h
#define Testing_Cxx_ExpectedStartDepth_h

#include "OracleOctree.h"

#include "vtkHashedOctreeFilter.h"

#include <cmath>

/** The weights of the frequency models, in the order of vtkHashedOctreeFilter's. */
inline OracleOctree::Weight GetWeight(int frequencyModel)
{
  const OracleOctree::Weight weights[] = { OracleOctree::Leaves, OracleOctree::Points,
    OracleOctree::Grid };
  return weights[frequencyModel];
}

inline int GetExpectedStartDepth(
  vtkHashedOctreeFilter* filter, const OracleOctree& expected, int frequencyModel)
{
  const OracleOctree::Weight weight = GetWeight(frequencyModel);
  switch (filter->GetStartDepthModel())
  {
    case vtkHashedOctreeFilter::Median:
      return expected.GetBestStartDepth(weight);
    case vtkHashedOctreeFilter::Mean:
      return static_cast<int>(std::floor(expected.GetMeanDepth(weight) + 0.5L));
    case vtkHashedOctreeFilter::Root:
      return 0;
    default:
      return filter->GetFixedStartDepth();
  }
}

#endif
