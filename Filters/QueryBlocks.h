// SPDX-License-Identifier: BSD-3-Clause
#ifndef QueryBlocks_h
#define QueryBlocks_h

#include "OctreePass.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <vector>

namespace hashedoctree
{
/**
 * The query points of vtkHashedOctreeLocateFilter, a data set or each block of a composite one, and
 * the data objects that what is made of them goes to. Blocks without points, and those that are no
 * vtkDataSet, are left out. Blocks of several processes that stand at one place of their composite
 * data sets are one; who has nothing there has null. Private to the module.
 */
class QueryBlocks
{
public:
  /** The arguments must outlive this, and the output ports hold what RequestDataObject() of the
   * filter puts there. All of the processes have to call it. Throws std::invalid_argument where
   * that cannot hold the blocks. */
  QueryBlocks(vtkDataObject* points, vtkDataObject* queries, vtkInformationVector* outputVector,
    const ProcessGroup& processes);

  const std::vector<vtkDataSet*>& Get() const { return this->Blocks; }

  /** For each block a target for each output port, which is composite where the points are. */
  OctreePass::Targets GetTargets() const;

  /** Gives the outputs of composite queries their structure, with the targets in it that were
   * filled. */
  void FillOutputs() const;

private:
  void AddTargets(vtkDataSet* block);
  /** Calls function(place, i) for the places of the blocks that have been added. */
  template <typename Function>
  void ForEachPlace(const Function& function) const;
  /** Whether an output port gets something at the place of a block. */
  bool IsFilled(std::size_t block, std::size_t port) const;

  vtkDataObject* Points;
  vtkCompositeDataSet* Composite; ///< Null for one data set.
  bool IsNested;                  ///< Whether the targets are composite, too.
  OctreePass::Targets Ports;
  std::vector<std::uint64_t> Places; ///< Of the blocks: their flat indices.
  std::vector<vtkDataSet*> Blocks;
  std::vector<vtkSmartPointer<vtkDataObject>> Made; ///< Targets that are not the ports themselves.
};
}

#endif
