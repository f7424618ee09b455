// SPDX-License-Identifier: BSD-3-Clause
#ifndef PointLocatorIndex_h
#define PointLocatorIndex_h

#include "LeafNumbers.h"
#include "PointSearch.h"
#include "PointTree.h"
#include "vtkHashedOctreePointLocator.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkTypeFloat32Array.h"
#include "vtkTypeFloat64Array.h"
#include "vtkUnstructuredGrid.h"

#include <cstddef>
#include <optional>
#include <string>
#include <typeinfo>
#include <variant>

/** What the locator has built: the tree over the points, in the precision that they came in, and
 * what they were when it was built. Private to the locator. */
class vtkHashedOctreePointLocator::Index
{
public:
  template <typename Real>
  using PointTree = hashedoctree::PointTree<3, Real>;

  std::variant<PointTree<float>, PointTree<double>> Tree;
  hashedoctree::LeafNumbers<3> Leaves;
  std::optional<hashedoctree::Box<3>> Bounds; ///< Of the points, if there are any.
  std::size_t SkippedPoints = 0;
  std::string Problem;                 ///< What went wrong, if anything; no point is found then.
  vtkPointSet* PointSet = nullptr;     ///< The locator's data set, if it is watched by its parts,
  vtkPoints* PointsOfSet = nullptr;    ///< its points,
  vtkDataArray* Coordinates = nullptr; ///< and their coordinates.

  /** Remembers what to ask whether the points have changed. Only of classes that are known, since
   * others may tell of a change in their GetMTime() alone. */
  void Watch(vtkDataSet* dataSet)
  {
    if (!IsOneOf<vtkPointSet, vtkPolyData, vtkStructuredGrid, vtkUnstructuredGrid>(dataSet))
    {
      return;
    }
    auto* pointSet = static_cast<vtkPointSet*>(dataSet);
    vtkPoints* points = pointSet->GetPoints();
    // From VTK 9.2 on arrays of a type, as readers and vtkPoints ask for them, are the latter two.
    if (IsOneOf<vtkPoints>(points) &&
      IsOneOf<vtkDoubleArray, vtkFloatArray, vtkTypeFloat32Array, vtkTypeFloat64Array>(
        points->GetData()))
    {
      this->PointSet = pointSet;
      this->PointsOfSet = points;
      this->Coordinates = points->GetData();
    }
  }

  /** Calls function(tree). */
  template <typename Function>
  decltype(auto) Visit(const Function& function) const
  {
    return std::visit(function, this->Tree);
  }
  /** Calls function(search). */
  template <typename Function>
  auto Search(const Function& function) const
  {
    return this->Visit(
      [&function](const auto& tree) { return function(hashedoctree::PointSearch(tree)); });
  }
  const hashedoctree::Octree<3>& GetOctree() const
  {
    return this->Visit(
      [](const auto& tree) -> const hashedoctree::Octree<3>& { return tree.GetOctree(); });
  }

  const hashedoctree::StartDepths<3>& GetStartDepths() const
  {
    return this->Visit([](const auto& tree) -> const hashedoctree::StartDepths<3>&
      { return tree.GetStartDepths(); });
  }

  /** Calls function(key at MaxDepth) for a position that has a leaf; else gives `nothing`. */
  template <typename Function, typename Value>
  Value AtLeafOf(const double x[3], Value nothing, const Function& function) const
  {
    const hashedoctree::Octree<3>& tree = this->GetOctree();
    const hashedoctree::Position<3> position{ x[0], x[1], x[2] };
    const bool hasLeaf = tree.GetNumberOfPoints() > 0 && hashedoctree::IsFinite(position);
    return hasLeaf ? static_cast<Value>(function(tree.GetGrid().GetKey(x))) : nothing;
  }

private:
  /** Whether an object is of one of the classes, and of none derived from it. */
  template <typename... Classes>
  static bool IsOneOf(const vtkObject* object)
  {
    return object != nullptr && ((typeid(*object) == typeid(Classes)) || ...);
  }
};

#endif
