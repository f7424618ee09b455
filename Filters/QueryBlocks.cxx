// SPDX-License-Identifier: BSD-3-Clause
#include "QueryBlocks.h"

#include "BlockStructure.h"
#include "PassFieldData.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <stdexcept>

namespace hashedoctree
{
namespace
{
/** The flat indices of the blocks that have points. */
std::vector<std::uint64_t> ListPlacesOfPoints(vtkCompositeDataSet* composite)
{
  std::vector<std::uint64_t> places;
  const auto blocks = vtk::TakeSmartPointer(composite->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    auto* block = vtkDataSet::SafeDownCast(blocks->GetCurrentDataObject());
    if (block != nullptr && block->GetNumberOfPoints() > 0)
    {
      places.push_back(blocks->GetCurrentFlatIndex());
    }
  }
  return places;
}
}

QueryBlocks::QueryBlocks(vtkDataObject* points, vtkDataObject* queries,
  vtkInformationVector* outputVector, const ProcessGroup& processes)
  : Points(points)
  , Composite(vtkCompositeDataSet::SafeDownCast(queries))
  , IsNested(this->Composite != nullptr && GetTreeOfBlocks(points) != nullptr)
  , Ports(OctreePass::GetPorts(outputVector))
{
  if (!processes.IsTrueInAll(this->Composite != nullptr,
        "Some processes have blocks of query points, others have not; give all of them blocks."))
  {
    this->Blocks.push_back(vtkDataSet::SafeDownCast(queries));
    return;
  }
  if (this->IsNested && GetTreeOfBlocks(queries) == nullptr)
  {
    throw std::invalid_argument("AMR query points cannot be searched for in blocks of points; "
                                "merge the blocks of either input.");
  }
  this->Places = processes.Gather(ListPlacesOfPoints(this->Composite)).Values;
  std::sort(this->Places.begin(), this->Places.end());
  this->Places.erase(std::unique(this->Places.begin(), this->Places.end()), this->Places.end());
  this->Blocks.resize(this->Places.size(), nullptr);
  this->ForEachPlace([this](vtkCompositeDataIterator* place, std::size_t i)
    { this->Blocks[i] = vtkDataSet::SafeDownCast(place->GetCurrentDataObject()); });
  for (vtkDataSet* block : this->Blocks)
  {
    this->AddTargets(block);
  }
}

template <typename Function>
void QueryBlocks::ForEachPlace(const Function& function) const
{
  const auto place = vtk::TakeSmartPointer(this->Composite->NewIterator());
  place->SetSkipEmptyNodes(0); // Another process may have something there.
  for (place->InitTraversal(); !place->IsDoneWithTraversal(); place->GoToNextItem())
  {
    const auto found =
      std::lower_bound(this->Places.begin(), this->Places.end(), place->GetCurrentFlatIndex());
    if (found != this->Places.end() && *found == place->GetCurrentFlatIndex())
    {
      function(place.Get(), static_cast<std::size_t>(found - this->Places.begin()));
    }
  }
}

void QueryBlocks::AddTargets(vtkDataSet* block)
{
  for (std::size_t port = 0; port < this->Ports.size(); ++port)
  {
    if (this->IsNested)
    {
      this->Made.emplace_back(vtkSmartPointer<vtkMultiBlockDataSet>::New());
    }
    else if (port == 0)
    {
      vtkNew<vtkPolyData> none;
      vtkDataSet* like = block != nullptr ? block : none.Get();
      this->Made.emplace_back(vtk::TakeSmartPointer(like->NewInstance()));
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

bool QueryBlocks::IsFilled(std::size_t block, std::size_t port) const
{
  const vtkSmartPointer<vtkDataObject>* made = &this->Made[block * this->Ports.size()];
  if (port > 0 && made[port]->GetNumberOfElements(vtkDataObject::ROW) > 0)
  {
    return true; // Of queries that others may have.
  }
  return this->Blocks[block] != nullptr &&
    (this->IsNested || made[0]->GetNumberOfElements(vtkDataObject::POINT) > 0);
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
      CopyStructureToMultiBlock(
        GetTreeOfBlocks(this->Composite), vtkMultiBlockDataSet::SafeDownCast(output));
    }
    else
    {
      CopyStructure(this->Composite, output);
    }
    output->SetFieldData(vtkNew<vtkFieldData>()); // The structure brings what the queries have.
    PassFieldData(this->Composite, output);
    PassFieldData(this->Points, output);
    this->ForEachPlace(
      [&](vtkCompositeDataIterator* place, std::size_t block)
      {
        if (this->IsFilled(block, port))
        {
          output->SetDataSet(place, this->Made[block * this->Ports.size() + port]);
        }
      });
  }
}
}
