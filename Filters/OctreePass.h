// SPDX-License-Identifier: BSD-3-Clause
#ifndef OctreePass_h
#define OctreePass_h

#include "Octree.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <optional>
#include <vector>

class vtkDataObject;
class vtkDataObjectTree;
class vtkHashedOctreeAlgorithm;
class vtkInformationVector;
class vtkPointSet;

namespace hashedoctree
{
/** The octree over the points of one data set, and what became of the points that are not in it. */
struct PointsOctree
{
  Octree<3> Tree;
  std::size_t SkippedPoints = 0; ///< Not finite.
  std::size_t OutsidePoints = 0; ///< Outside the given root.
  double BuildSeconds = 0.0;
};

/**
 * One pass of an algorithm over the point sets of its input: the input itself or, of a composite
 * one, each of its blocks. Builds the octree of each and fills the output ports with what a
 * function makes of it. Blocks without a point to use, and those of another kind, stay empty.
 * Private to the module.
 */
class OctreePass
{
public:
  /** What stands at each port; empty where there is nothing. */
  using Outputs = std::vector<vtkSmartPointer<vtkDataObject>>;
  /** Is given the progress of one point set, of which BuildShare is done. */
  using MakeOutputs = std::function<Outputs(const PointsOctree&, const Execution&)>;

  static constexpr double BuildShare = 0.3;

  /** `root`, where given, takes the place of the points' own bounds. */
  explicit OctreePass(vtkHashedOctreeAlgorithm* algorithm, std::optional<Box<3>> root = {});

  /** Warns once of points that are not finite. Throws Interrupted, and std::exception with what to
   * tell the user, also when there is no point to use in all of the input, unless that is one of
   * several pieces. */
  void Execute(
    vtkDataObject* input, vtkInformationVector* outputVector, const MakeOutputs& makeOutputs);

  /** Whether other processes, or other updates, have the rest of a distributed data set. */
  static bool IsPiece(vtkInformationVector* outputVector);

private:
  void ProcessBlocks(vtkDataObjectTree* input, vtkInformationVector* outputVector,
    const MakeOutputs& makeOutputs, const Execution& execution);
  Outputs Process(vtkPointSet* input, const MakeOutputs& makeOutputs, const Execution& execution);
  PointsOctree Build(vtkPointSet* input, const Execution& execution) const;
  [[noreturn]] void RefuseInput() const;

  vtkHashedOctreeAlgorithm* Algorithm;
  std::optional<Box<3>> Root;
  vtkIdType AllPoints = 0;
  std::size_t SkippedPoints = 0;
  std::size_t UsedPoints = 0;
};
}

#endif
