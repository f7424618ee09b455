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
    if (auto* inner = vtkDataObjectTree::SafeDownCast(children->GetCurrentDataObject()))
    {
      blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      CopyStructureToMultiBlock(inner, blocks);
      PassFieldData(inner, blocks);
    }
    copy->SetBlock(child, blocks);
    if (children->HasCurrentMetaData())
    {
      copy->GetMetaData(child)->Copy(children->GetCurrentMetaData());
    }
    ++child;
  }
}

void CopyStructure(vtkCompositeDataSet* composite, vtkCompositeDataSet* copy)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(composite);
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
