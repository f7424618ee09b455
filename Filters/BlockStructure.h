// SPDX-License-Identifier: BSD-3-Clause
#ifndef BlockStructure_h
#define BlockStructure_h

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkMultiBlockDataSet.h"

namespace hashedoctree
{
/** A composite data set as the tree of blocks that it is. Null where it is none: AMR, too, which
 * derives from one since VTK 9.6, but whose levels are no blocks. Private to the module. */
vtkDataObjectTree* GetTreeOfBlocks(vtkDataObject* data);

/** Copies the structure of a tree of blocks and the field data within it, with
 * vtkMultiBlockDataSets for whatever is composite in it, which may hold any blocks: composite ones,
 * or tables that ParaView's charts can draw. Blocks without a name get that of the block that they
 * are in. Private to the module. */
void CopyStructureToMultiBlock(vtkDataObjectTree* tree, vtkMultiBlockDataSet* copy);

/** Copies the structure of a composite data set to an output, which is of its class or a
 * vtkMultiBlockDataSet. Private to the module. */
void CopyStructure(vtkCompositeDataSet* composite, vtkCompositeDataSet* copy);
}

#endif
