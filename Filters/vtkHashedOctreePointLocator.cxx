// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHashedOctreePointLocator.h"

#include "AlgorithmExecution.h"
#include "AlgorithmProblems.h"
#include "DirectSearch.h"
#include "FoundOfThread.h"
#include "NodeList.h"
#include "OctreeCells.h"
#include "PointLocatorIndex.h"
#include "PointsAdaptor.h"
#include "PropertyModels.h"
#include "SkippedPoints.h"
#include "ThreadTeam.h"

#include "vtkCommand.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>
#include <variant>

using namespace hashedoctree;

vtkStandardNewMacro(vtkHashedOctreePointLocator);

namespace
{
constexpr int MaxDepthOfKeys = MortonKey<3>::MaxDepth;

static_assert(HasModelsOfCore<vtkHashedOctreePointLocator>() &&
    AreSame(vtkHashedOctreePointLocator::Local, StartDepthModel::Local),
  "models are cast");

constexpr std::size_t PointsPerThread = 32768; // Fewer take less time than a thread takes to come.
constexpr const char* NoMemoryForQuery =
  "There is not enough memory for what the query finds; ask for less.";

Box<3> ToBox(const double bounds[6])
{
  return { { bounds[0], bounds[2], bounds[4] }, { bounds[1], bounds[3], bounds[5] } };
}

/** Where a point set keeps its points. */
class PartsOfSet : public vtkPointSet
{
public:
  static constexpr auto PointsOfSet = &PartsOfSet::Points;
};

PointIndex GetId(const FoundPoint& point)
{
  return point.Id;
}
PointIndex GetId(PointIndex id)
{
  return id;
}
}

vtkHashedOctreePointLocator::vtkHashedOctreePointLocator()
{
  this->MaxLevel = MaxDepthOfKeys;
  // As FreeSearchStructure() does.
  this->Level = 0;
  vtkMath::UninitializeBounds(this->Bounds);
}

vtkHashedOctreePointLocator::~vtkHashedOctreePointLocator() = default;

void vtkHashedOctreePointLocator::SetMaxDepth(int depth)
{
  this->SetMaxLevel(std::min(depth, MaxDepthOfKeys));
}

int vtkHashedOctreePointLocator::GetMaxDepth() const
{
  return std::min(this->MaxLevel, MaxDepthOfKeys);
}

void vtkHashedOctreePointLocator::SetFrequencyModel(int model)
{
  this->SetStartDepthProperty(
    this->FrequencyModel, std::clamp<int>(model, FrequencyModels::Leaves, FrequencyModels::Grid));
}

void vtkHashedOctreePointLocator::SetStartDepthModel(int model)
{
  this->SetStartDepthProperty(this->StartDepthModel,
    std::clamp<int>(model, StartDepthModels::Median, StartDepthModels::Local));
}

void vtkHashedOctreePointLocator::SetFixedStartDepth(int depth)
{
  this->SetStartDepthProperty(this->FixedStartDepth, std::clamp(depth, 0, MaxDepthOfKeys));
}

void vtkHashedOctreePointLocator::SetStartDepthProperty(int& property, int value)
{
  if (property == value)
  {
    return;
  }
  const bool wasUpToDate = this->IsUpToDate();
  const int before = std::exchange(property, value);
  if (this->Built)
  {
    try
    {
      this->ChooseStartDepths(*this->Built);
    }
    catch (const std::bad_alloc&)
    {
      property = before;
      vtkErrorMacro(
        "There is not enough memory for local start depths; the property stays as it was.");
      return;
    }
  }
  // As Modified(), but whom it tells may change the points, or ask the locator.
  this->MTime.Modified();
  if (wasUpToDate)
  {
    this->BuildTime.Modified();
  }
  this->InvokeEvent(vtkCommand::ModifiedEvent);
}

bool vtkHashedOctreePointLocator::IsUpToDate() const
{
  return this->Built && this->BuildTime > this->MTime &&
    (this->DataSet == nullptr || this->HasSamePoints());
}

bool vtkHashedOctreePointLocator::HasSamePoints() const
{
  const Index& index = *this->Built;
  if (index.PointSet == nullptr)
  {
    return this->BuildTime > this->DataSet->GetMTime();
  }
  // Each query asks, and to ask the cells and all arrays, too, takes as long as finding a point.
  // Who has not changed since the build still has the parts that it had then; but a set that is
  // initialized says so before it lets its points go. Times and points are read where they stand:
  // calls would be a sixth of a query that finds one point or none.
  constexpr auto time = &vtkHashedOctreePointLocator::MTime;
  return this->BuildTime > index.PointSet->*time &&
    index.PointSet->*PartsOfSet::PointsOfSet == index.PointsOfSet &&
    this->BuildTime > index.PointsOfSet->*time && this->BuildTime > index.Coordinates->*time;
}

void vtkHashedOctreePointLocator::BuildLocator()
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  if (this->UseExistingSearchStructure && this->Built && this->Built->Bounds)
  {
    return;
  }
#endif
  if (!this->IsUpToDate())
  {
    this->BuildLocatorInternal();
  }
}

void vtkHashedOctreePointLocator::ForceBuildLocator()
{
  this->BuildLocatorInternal();
}

void vtkHashedOctreePointLocator::BuildLocatorInternal()
{
  this->BuildIndex();
  // All is built: who hears of this may ask the locator.
  if (!this->Built->Problem.empty())
  {
    vtkErrorMacro(<< this->Built->Problem);
  }
  else if (this->Built->SkippedPoints > 0)
  {
    WarnOfSkippedPoints(this, this->Built->SkippedPoints, this->DataSet->GetNumberOfPoints());
  }
}

void vtkHashedOctreePointLocator::BuildIndex()
{
  this->FreeSearchStructure();
  auto index = std::make_shared<Index>();
  try
  {
    this->Fill(*index);
  }
  catch (const std::exception&)
  {
    *index = Index(); // Makes room for the text, too.
    index->Problem = DescribeProblem(
      "There is not enough memory for the index of the points; take fewer of them.");
  }
  index->Watch(this->DataSet);
  if (index->Bounds)
  {
    this->Level = index->GetOctree().GetDeepestDepth();
    this->NumberOfBuckets = static_cast<vtkIdType>(index->GetOctree().GetNumberOfLeaves());
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Bounds[2 * axis] = index->Bounds->Lower[axis];
      this->Bounds[2 * axis + 1] = index->Bounds->Upper[axis];
    }
  }
  this->Built = std::move(index);
  this->BuildTime.Modified();
}

void vtkHashedOctreePointLocator::Fill(Index& index)
{
  if (this->DataSet == nullptr)
  {
    index.Problem = "There is no data set whose points could be found; call SetDataSet() first.";
    return;
  }
  if (this->DataSet->GetNumberOfPoints() == 0)
  {
    return;
  }
  RequirePointIndices(static_cast<std::size_t>(this->DataSet->GetNumberOfPoints()));
  const Execution threads = MakeExecution();
  const PointsAdaptor points(this->DataSet, threads);
  Octree<3>::Options options;
  options.MaxPointsPerLeaf = static_cast<std::size_t>(this->MaxPointsPerLeaf);
  options.MaxDepth = this->GetMaxDepth();
  const auto build = [&](auto span, const Execution& execution)
  {
    const PointSelection<3> selection(span, {}, execution);
    index.Tree = PointTree(span, selection, options, execution);
    index.SkippedPoints = selection.GetNumberOfSkippedPoints();
    if (selection.GetNumberOfPoints() > 0)
    {
      index.Bounds = selection.GetBox();
    }
  };
  points.Visit(
    [&](auto span)
    {
      const auto available = static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
      ThreadTeam::Run(threads, std::min(available, 1 + span.Count / PointsPerThread),
        [&](const Execution& execution) { build(span, execution); });
    });
  index.Leaves = LeafNumbers<3>(index.GetOctree(), EmptyOctants::Missing);
  this->ChooseStartDepths(index);
}

void vtkHashedOctreePointLocator::ChooseStartDepths(Index& index) const
{
  const StartDepthOptions options{ static_cast<hashedoctree::StartDepthModel>(
                                     this->StartDepthModel),
    static_cast<hashedoctree::FrequencyModel>(this->FrequencyModel), this->FixedStartDepth };
  std::visit([&options](auto& tree) { tree.SetStartDepths(options); }, index.Tree);
}

void vtkHashedOctreePointLocator::FreeSearchStructure()
{
  this->Built.reset();
  this->Level = 0;
  this->NumberOfBuckets = 0;
  vtkMath::UninitializeBounds(this->Bounds);
}

const vtkHashedOctreePointLocator::Index& vtkHashedOctreePointLocator::GetIndex()
{
  if (!this->IsUpToDate())
  {
    this->BuildLocator();
    if (!this->Built) // Who heard of a problem has freed it.
    {
      this->BuildIndex();
    }
  }
  return *this->Built;
}

vtkIdType vtkHashedOctreePointLocator::FindClosestPoint(const double x[3])
{
  FoundPoint found{};
  const bool exists = this->GetIndex().Search(
    [&](const auto& search) {
      return search.FindClosest({ x[0], x[1], x[2] }, found);
    });
  return exists ? static_cast<vtkIdType>(found.Id) : -1;
}

vtkIdType vtkHashedOctreePointLocator::FindClosestPointWithinRadius(
  double radius, const double x[3], double& dist2)
{
  FoundPoint found{};
  const bool exists = this->GetIndex().Search(
    [&](const auto& search) {
      return radius >= 0.0 && search.FindClosest({ x[0], x[1], x[2] }, found, radius * radius);
    });
  if (!exists)
  {
    return -1;
  }
  dist2 = found.Dist2;
  return static_cast<vtkIdType>(found.Id);
}

template <typename Found, typename Find>
void vtkHashedOctreePointLocator::FillList(vtkIdList* result, const Find& find)
{
  if (result == nullptr)
  {
    vtkErrorMacro("A query needs a list for the ids of what it finds.");
    return;
  }
  const Index& index = this->GetIndex();
  try
  {
    FoundOfThread<Found> found;
    index.Search([&](const auto& search) { find(search, found.Get()); });
    found.CopyTo(result, [](const Found& point) { return GetId(point); });
  }
  catch (const std::bad_alloc&)
  {
    result->Initialize(); // A list that could not grow may say that it did.
    vtkErrorMacro(<< NoMemoryForQuery);
  }
}

void vtkHashedOctreePointLocator::FindClosestNPoints(
  int count, const double x[3], vtkIdList* result)
{
  this->FillList<FoundPoint>(result,
    [count, x](const auto& search, auto& found) {
      search.FindClosest({ x[0], x[1], x[2] }, static_cast<std::size_t>(std::max(count, 0)), found);
    });
}

void vtkHashedOctreePointLocator::FindPointsWithinRadius(
  double radius, const double x[3], vtkIdList* result)
{
  this->FillList<PointIndex>(result,
    [radius, x](const auto& search, auto& found) {
      search.FindWithin({ x[0], x[1], x[2] }, radius, found);
    });
}

void vtkHashedOctreePointLocator::FindPointsWithinBox(const double bounds[6], vtkIdList* result)
{
  this->FillList<PointIndex>(
    result, [bounds](const auto& search, auto& found) { search.FindWithin(ToBox(bounds), found); });
}

vtkIdType vtkHashedOctreePointLocator::GetLeafId(const double x[3])
{
  const Index& index = this->GetIndex();
  return index.AtLeafOf(x, vtkIdType(-1),
    [&index](MortonKey<3> key) -> vtkIdType
    {
      const Octree<3>& tree = index.GetOctree();
      const FoundLeaf<3> leaf =
        FindLeaf(tree, key, index.GetStartDepths().Get(key), EmptyOctants::Missing);
      return leaf.Exists ? static_cast<vtkIdType>(index.Leaves.Get(tree, leaf)) : -1;
    });
}

int vtkHashedOctreePointLocator::GetDepth(const double x[3])
{
  const Index& index = this->GetIndex();
  return index.AtLeafOf(x, -1,
    [&index](MortonKey<3> key)
    { return FindLeaf(index.GetOctree(), key, index.GetStartDepths().Get(key)).Key.GetDepth(); });
}

vtkIdType vtkHashedOctreePointLocator::GetHitCost(const double x[3])
{
  const Index& index = this->GetIndex();
  return index.AtLeafOf(x, vtkIdType(0),
    [&index](MortonKey<3> key)
    { return CountExaminedNodes(index.GetOctree(), key, index.GetStartDepths().Get(key)); });
}

template <typename Count>
vtkIdType vtkHashedOctreePointLocator::CountNodes(const Count& count)
{
  const Index& index = this->GetIndex();
  try
  {
    return index.Search(
      [&count](const auto& search) { return static_cast<vtkIdType>(count(search)); });
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro(<< NoMemoryForQuery);
    return 0;
  }
}

vtkIdType vtkHashedOctreePointLocator::GetClosestPointCost(const double x[3])
{
  return this->CountNodes(
    [x](const auto& search) {
      return search.CountNodesForClosest({ x[0], x[1], x[2] });
    });
}

vtkIdType vtkHashedOctreePointLocator::GetClosestNPointsCost(int count, const double x[3])
{
  return this->CountNodes(
    [count, x](const auto& search)
    {
      return search.CountNodesForClosest(
        { x[0], x[1], x[2] }, static_cast<std::size_t>(std::max(count, 0)));
    });
}

vtkIdType vtkHashedOctreePointLocator::GetPointsWithinRadiusCost(double radius, const double x[3])
{
  return this->CountNodes(
    [radius, x](const auto& search) {
      return search.CountNodesForWithin({ x[0], x[1], x[2] }, radius);
    });
}

vtkIdType vtkHashedOctreePointLocator::GetPointsWithinBoxCost(const double bounds[6])
{
  return this->CountNodes(
    [bounds](const auto& search) { return search.CountNodesForWithin(ToBox(bounds)); });
}

void vtkHashedOctreePointLocator::GenerateRepresentation(int level, vtkPolyData* pd)
{
  if (pd == nullptr)
  {
    vtkErrorMacro("A representation needs a vtkPolyData for its boxes.");
    return;
  }
  const Index& index = this->GetIndex();
  NodeListOptions options;
  if (level >= 0)
  {
    options.InternalNodes = true;
    options.Depth = level;
  }
  try
  {
    // To initialize pd would free the index where this is the locator of pd.
    vtkNew<vtkPolyData> boxes;
    const auto nodes = ListNodes(index.GetOctree(), options, MakeExecution());
    OctreeCells(index.GetOctree(), index.GetStartDepths().GetOfTree(), nodes)
      .MakeOutlines(boxes, MakeExecution());
    pd->ShallowCopy(boxes);
  }
  catch (const std::exception&)
  {
    pd->Initialize();
    vtkErrorMacro(<< DescribeProblem(
                    "There is not enough memory for the boxes; ask for a smaller level."));
  }
}

int vtkHashedOctreePointLocator::GetStartDepth() const
{
  return this->Built ? this->Built->GetStartDepths().GetOfTree() : 0;
}

vtkIdType vtkHashedOctreePointLocator::GetIndexBytes() const
{
  return this->Built ? static_cast<vtkIdType>(this->Built->Leaves.GetBytes() +
                         this->Built->Visit([](const auto& tree) { return tree.GetBytes(); }))
                     : 0;
}

void vtkHashedOctreePointLocator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaxPointsPerLeaf: " << this->MaxPointsPerLeaf << "\n";
  os << indent << "MaxDepth: " << this->GetMaxDepth() << "\n";
  os << indent << "FrequencyModel: " << this->FrequencyModel << "\n";
  os << indent << "StartDepthModel: " << this->StartDepthModel << "\n";
  os << indent << "FixedStartDepth: " << this->FixedStartDepth << "\n";
  os << indent << "StartDepth: " << this->GetStartDepth() << "\n";
  os << indent << "IndexBytes: " << this->GetIndexBytes() << "\n";
}
