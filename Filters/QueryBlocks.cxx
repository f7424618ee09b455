// SPDX-License-Identifier: BSD-3-Clause
#include "QueryBlocks.h"

#include "BlockStructure.h"
#include "PassFieldData.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <stdexcept>

namespace hashedoctree
{
namespace
{
/** Calls function(iterator, data set) for the blocks that have points, always in the same order. */
template <typename Function>
void ForEachBlock(vtkCompositeDataSet* composite, const Function& function)
{
  const auto blocks = vtk::TakeSmartPointer(composite->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    auto* block = vtkDataSet::SafeDownCast(blocks->GetCurrentDataObject());
    if (block != nullptr && block->GetNumberOfPoints() > 0)
    {
      function(blocks.Get(), block);
    }
  }
}
}

QueryBlocks::QueryBlocks(
  vtkDataObject* points, vtkDataObject* queries, vtkInformationVector* outputVector)
  : Points(points)
  , Composite(vtkCompositeDataSet::SafeDownCast(queries))
  , IsNested(this->Composite != nullptr && vtkDataObjectTree::SafeDownCast(points) != nullptr)
  , Ports(OctreePass::GetPorts(outputVector))
{
  if (this->Composite == nullptr)
  {
    this->Blocks.push_back(vtkDataSet::SafeDownCast(queries));
    return;
  }
  if (this->IsNested && vtkDataObjectTree::SafeDownCast(queries) == nullptr)
  {
    throw std::invalid_argument("AMR query points cannot be searched for in blocks of points; "
                                "merge the blocks of either input.");
  }
  ForEachBlock(
    this->Composite, [&](vtkCompositeDataIterator*, vtkDataSet* block) { this->AddBlock(block); });
}

void QueryBlocks::AddBlock(vtkDataSet* block)
{
  this->Blocks.push_back(block);
  for (std::size_t port = 0; port < this->Ports.size(); ++port)
  {
    if (this->IsNested)
    {
      this->Made.emplace_back(vtkSmartPointer<vtkMultiBlockDataSet>::New());
    }
    else if (port == 0)
    {
      this->Made.emplace_back(vtk::TakeSmartPointer(block->NewInstance()));
    }
    else
    {
      this->Made.emplace_back(vtkSmartPointer<vtkTable>::New());
    }
  }
}

OctreePass::Targets QueryBlocks::GetTargets() const
{
  return this->Composite == nullptr ? this->Ports
                                    : OctreePass::Targets(this->Made.begin(), this->Made.end());
}

bool QueryBlocks::IsLocated(std::size_t block) const
{
  auto* located = vtkDataSet::SafeDownCast(this->Made[block * this->Ports.size()]);
  return this->IsNested || located->GetNumberOfPoints() > 0;
}

void QueryBlocks::FillOutputs() const
{
  if (this->Composite == nullptr)
  {
    return;
  }
  for (std::size_t port = 0; port < this->Ports.size(); ++port)
  {
    auto* output = vtkCompositeDataSet::SafeDownCast(this->Ports[port]);
    if (this->IsNested)
    {
      CopyStructureToMultiBlock(vtkDataObjectTree::SafeDownCast(this->Composite),
        vtkMultiBlockDataSet::SafeDownCast(output));
    }
    else
    {
      CopyStructure(this->Composite, output);
    }
    output->SetFieldData(vtkNew<vtkFieldData>()); // The structure brings what the queries have.
    PassFieldData(this->Composite, output);
    PassFieldData(this->Points, output);
    std::size_t block = 0;
    ForEachBlock(this->Composite,
      [&](vtkCompositeDataIterator* place, vtkDataSet*)
      {
        if (this->IsLocated(block))
        {
          output->SetDataSet(place, this->Made[block * this->Ports.size() + port]);
        }
        ++block;
      });
  }
}
}
