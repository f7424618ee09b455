// SPDX-License-Identifier: BSD-3-Clause
#ifndef OctreePass_h
#define OctreePass_h

#include "KeptOctrees.h"
#include "ProcessGroup.h"

#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkInformationVector.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <optional>
#include <variant>
#include <vector>

class vtkHashedOctreeAlgorithm;

namespace hashedoctree
{
/**
 * One pass of an algorithm over the point sets of its input: the input itself or, of a composite
 * one, each of its blocks. Builds the octree or quadtree of each, or takes one that is kept, and
 * fills the targets with what a function makes of it, with the field data of the point set where it
 * has none of that name. Blocks without a point to use, and those of another kind, stay empty.
 *
 * Several processes that have the pieces of one input make one tree of each point set together, if
 * their composite inputs have the same structure, else each its own. What they have to do together
 * they do in the same order. Private to the module.
 */
class OctreePass
{
public:
  /** What is made of a tree, one data object for each of the targets; empty where there is nothing.
   */
  using Outputs = std::vector<vtkSmartPointer<vtkDataObject>>;
  /** What the outputs are put into: data objects of their types or, of a composite input, composite
   * ones that take its structure. */
  using Targets = std::vector<vtkDataObject*>;
  static constexpr double BuildShare = 0.3;

  /** `bounds`, where given, take the place of the points' own bounds. */
  OctreePass(vtkHashedOctreeAlgorithm* algorithm, const ProcessGroup& processes,
    const std::optional<Box<3>>& bounds);
  /** One process alone takes the octrees that are kept, and keeps those that it builds. Several
   * build all of theirs, since they would have to agree on which they have. */
  OctreePass(vtkHashedOctreeAlgorithm* algorithm, const ProcessGroup& processes, KeptOctrees& kept);

  /** `makeOutputs` returns the Outputs for a PointsOctree<2> or PointsOctree<3>, and is given the
   * progress of one point set, of which BuildShare is done. Warns once of points that are not
   * finite, once of blocks without coordinates of their own, and once of corners of an octree's
   * cells. Throws Interrupted, and std::exception with what to tell the user, also when there are
   * no other blocks with points, unless other pieces may have some. */
  template <typename Function>
  void Execute(vtkDataObject* input, const Targets& targets, const Function& makeOutputs)
  {
    this->ExecuteAny(input, targets,
      [&makeOutputs](const AnyPointsOctree& any, const Execution& execution) {
        return std::visit([&](const auto& octree) { return makeOutputs(octree, execution); }, any);
      });
  }

  /** Those who made the trees together, of all calls so far. */
  const ProcessGroup& GetProcesses() const { return this->Processes; }
  /** Whether they met finite points, but none in the bounds that were given. */
  bool AreAllOutside() const
  {
    return this->Met.Outside > 0 && this->Met.Skipped + this->Met.Outside == this->Met.Own;
  }

  static Targets GetPorts(vtkInformationVector* outputVector);

private:
  using MakeOutputs = std::function<Outputs(const AnyPointsOctree&, const Execution&)>;

  void ExecuteAny(vtkDataObject* input, const Targets& targets, const MakeOutputs& makeOutputs);
  void ProcessBlocks(vtkDataObjectTree* input, const Targets& targets,
    const MakeOutputs& makeOutputs, const Execution& execution);
  /** The data object is null where a process has nothing of a block. */
  Outputs Process(vtkDataObject* data, const MakeOutputs& makeOutputs, const Execution& execution);
  KeptOctrees::Pointer FindOrBuild(vtkPointSet* input, const Execution& execution);
  BuiltOctree Build(vtkPointSet* input, const Execution& execution) const;
  /** The given bounds, or the box around the selected points of all processes; nothing if there are
   * none. */
  std::optional<Box<3>> FindBounds(const PointSelection<3>& selection) const;
  /** Of what all processes have met together. Throws std::invalid_argument. */
  void TellOfPoints() const;

  vtkHashedOctreeAlgorithm* Algorithm;
  ProcessGroup Processes;
  std::optional<Box<3>> Bounds;
  KeptOctrees* Kept = nullptr;
  PointCounts Met;                  ///< By this process, and in the end by all processes.
  std::uint64_t ImplicitBlocks = 0; ///< With points, but no vtkPointSets.
  bool MetCorners = false;          ///< Of an octree's cells.
};
}

#endif
