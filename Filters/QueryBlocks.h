// SPDX-License-Identifier: BSD-3-Clause
#ifndef QueryBlocks_h
#define QueryBlocks_h

#include "OctreePass.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace hashedoctree
{
/**
 * The query points of vtkHashedOctreeLocateFilter, a data set or each block of a composite one, and
 * the data objects that what is made of them goes to. Blocks without points, and those that are no
 * vtkDataSet, are left out. Private to the module.
 */
class QueryBlocks
{
public:
  /** The arguments must outlive this, and the output ports hold what RequestDataObject() of the
   * filter puts there. Throws std::invalid_argument where that cannot hold the blocks. */
  QueryBlocks(vtkDataObject* points, vtkDataObject* queries, vtkInformationVector* outputVector);

  const std::vector<vtkDataSet*>& Get() const { return this->Blocks; }

  /** For each block a target for each output port, which is composite where the points are. */
  OctreePass::Targets GetTargets() const;

  /** Gives the outputs of composite queries their structure, with the targets in it that were
   * filled. */
  void FillOutputs() const;

private:
  void AddBlock(vtkDataSet* block);
  bool IsLocated(std::size_t block) const;

  vtkDataObject* Points;
  vtkCompositeDataSet* Composite; ///< Null for one data set.
  bool IsNested;                  ///< Whether the targets are composite, too.
  OctreePass::Targets Ports;
  std::vector<vtkDataSet*> Blocks;
  std::vector<vtkSmartPointer<vtkDataObject>> Made; ///< Targets that are not the ports themselves.
};
}

#endif
