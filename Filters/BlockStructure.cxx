// SPDX-License-Identifier: BSD-3-Clause
#include "BlockStructure.h"

#include "PassFieldData.h"

#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSmartPointer.h"

namespace hashedoctree
{
namespace
{
/** Gives the blocks of one that has a name its name, as far as they have none: the partitions of a
 * block of a collection, in place of which the tables stand that charts tell by name. */
void PassName(vtkInformation* ofParent, vtkMultiBlockDataSet* blocks)
{
  const char* name = ofParent->Get(vtkCompositeDataSet::NAME());
  for (unsigned i = 0; name != nullptr && i < blocks->GetNumberOfBlocks(); ++i)
  {
    vtkInformation* ofChild = blocks->GetMetaData(i);
    if (!ofChild->Has(vtkCompositeDataSet::NAME()))
    {
      ofChild->Set(vtkCompositeDataSet::NAME(), name);
    }
  }
}
}

vtkDataObjectTree* GetTreeOfBlocks(vtkDataObject* data)
{
  const bool isAmr = data != nullptr && data->IsA("vtkAMRDataObject");
  return isAmr ? nullptr : vtkDataObjectTree::SafeDownCast(data);
}

void CopyStructureToMultiBlock(vtkDataObjectTree* tree, vtkMultiBlockDataSet* copy)
{
  const auto children = vtk::TakeSmartPointer(tree->NewTreeIterator());
  children->VisitOnlyLeavesOff();
  children->TraverseSubTreeOff();
  children->SkipEmptyNodesOff();
  unsigned child = 0;
  for (children->InitTraversal(); !children->IsDoneWithTraversal(); children->GoToNextItem())
  {
    vtkSmartPointer<vtkMultiBlockDataSet> blocks;
    if (auto* inner = GetTreeOfBlocks(children->GetCurrentDataObject()))
    {
      blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      CopyStructureToMultiBlock(inner, blocks);
      PassFieldData(inner, blocks);
    }
    copy->SetBlock(child, blocks);
    if (children->HasCurrentMetaData())
    {
      copy->GetMetaData(child)->Copy(children->GetCurrentMetaData());
      if (blocks)
      {
        PassName(children->GetCurrentMetaData(), blocks);
      }
    }
    ++child;
  }
}

void CopyStructure(vtkCompositeDataSet* composite, vtkCompositeDataSet* copy)
{
  vtkDataObjectTree* tree = GetTreeOfBlocks(composite);
  if (tree == nullptr || tree->GetDataObjectType() == copy->GetDataObjectType())
  {
    copy->CopyStructure(composite);
  }
  else
  {
    CopyStructureToMultiBlock(tree, vtkMultiBlockDataSet::SafeDownCast(copy));
  }
}
}
