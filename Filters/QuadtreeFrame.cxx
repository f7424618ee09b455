// SPDX-License-Identifier: BSD-3-Clause
#include "QuadtreeFrame.h"

#include "vtkHashedOctreeAlgorithm.h"

#include <algorithm>

namespace hashedoctree
{
namespace
{
using Algorithm = vtkHashedOctreeAlgorithm;

TreeFrame<2> MakeFrame(int plane, const Position<3>& inPlane)
{
  switch (plane)
  {
    case Algorithm::XY:
      return { { 0, 1 }, inPlane };
    case Algorithm::XZ:
      return { { 0, 2 }, inPlane };
    default:
      return { { 1, 2 }, inPlane };
  }
}
}

std::optional<TreeFrame<2>> FindQuadtreeFrame(
  vtkHashedOctreeAlgorithm* algorithm, const Box<3>& box)
{
  // By the plane across each axis, so that of equal extents the first one, XY, has the least.
  const std::array<int, 3> planes{ Algorithm::XY, Algorithm::XZ, Algorithm::YZ };
  std::array<double, 3> extents{};
  for (std::size_t i = 0; i < extents.size(); ++i)
  {
    extents[i] = box.Upper[2 - i] - box.Lower[2 - i];
  }
  const bool isFlat = std::count(extents.begin(), extents.end(), 0.0) == 1;
  const int dimension = algorithm->GetDimension();
  if (dimension == Algorithm::Three || (dimension == Algorithm::Auto && !isFlat))
  {
    return {};
  }
  const auto least = std::min_element(extents.begin(), extents.end()) - extents.begin();
  const bool isGiven = dimension == Algorithm::Two && algorithm->GetPlane() != Algorithm::Widest;
  return MakeFrame(
    isGiven ? algorithm->GetPlane() : planes[static_cast<std::size_t>(least)], box.Lower);
}
}
