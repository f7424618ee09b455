// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHashedOctreeLocateFilter
 * @brief   what searches for query points find in an octree of other points, and what they cost
 *
 * Builds the octree (or quadtree) of the points of input port 0, the one that vtkHashedOctreeFilter
 * shows, and searches in it for every query point of input port 1. In a quadtree queries are
 * projected to its plane. The models say how often a leaf will be searched for; this filter says
 * how often it was, and what that cost by each way to start ("Statistical optimization of octree
 * searches", Castro, Lewiner, Lopes, Tavares, Bordignon, 2008, section 4).
 *
 * Input port 0: any vtkPointSet; of composite data sets every block by itself, one tree per block,
 * in each of which all queries are searched for. Input port 1, required: any vtkDataSet; of
 * composite data sets every block by itself, with a table of its own.
 *
 * Where one input is composite, both outputs are so, with a block for each of its, the tables in a
 * vtkMultiBlockDataSet; null for a block without points (or, of input port 0, without finite ones),
 * and for one that is no vtkPointSet (of input port 1, no vtkDataSet). Where both inputs are
 * composite, both outputs are vtkMultiBlockDataSets with the structure of the queries, in which
 * each block of queries is again one, with a block for each of the points; no other composite data
 * set may hold such blocks. Blocks keep their names. AMR queries together with composite points are
 * an error.
 *
 * Output port 0, of the kind of the queries: the queries as they are, with point arrays, one value
 * per query (arrays of the same names are replaced):
 * - LeafId (vtkIdType): cell of vtkHashedOctreeFilter's port 0, as voxels or outlines, that holds
 *   the query, for the same tree properties and IncludeEmptyLeaves, and without internal nodes;
 *   without empty leaves, in an octree, without MergePoints and points that are another piece's,
 *   also what vtkHashedOctreePointLocator::GetLeafId() gives. -1 where there is no such cell. More
 *   than 2^32 - 1 leaves, which only IncludeEmptyLeaves makes (unless built with
 *   HASHEDOCTREE_64BIT_IDS), are an error;
 * - LeafDepth (int): depth of the leaf, or of the empty cell without a LeafId;
 * - LeafKey (unsigned 64-bit): its Morton key;
 * - HitCost (int, active scalars): nodes that the search from the chosen start depth examines;
 * - RootCost, MedianCost, MeanCost (int): the same from the root, and from the median and the mean
 *   of the leaves' depths, weighted by FrequencyModel;
 * - LocalCost (int): from the weighted median of the leaves in the coarse cell around the query;
 * - DecisionTreeCost (int): where each depth that is looked at is chosen by the outcome of the look
 *   before, in the order that is optimal for FrequencyModel.
 * All costs are counted in searches that were made. Queries outside the root count for the leaf
 * that is nearest to them on each axis. Queries with a coordinate that is not finite have LeafId
 * -1, LeafDepth -1, LeafKey 0 and costs 0; one warning tells how many there are in all blocks, and
 * means leave them out (0 where no query is left). Queries that are another piece's (vtkGhostType
 * has DUPLICATEPOINT) get their arrays; means and warning leave them out. Field data of both
 * outputs, one value each: StartDepth (the chosen one), MeanHitCost (over the queries),
 * BestStartDepth (the one with the least mean cost for these queries, the smallest of equals; 0
 * where none is left), SkippedPoints (of the tree: not finite, or too large). All outputs keep the
 * field data of the points, and output 0, like a composite output of composite queries, that of the
 * queries; of arrays of one name it keeps its own, then the queries'.
 *
 * Output port 1, vtkTable, a row for each way to search: Root, Median, Mean, Fixed (if chosen),
 * Local, Decision tree, Best for these queries (from BestStartDepth), and last Entropy bound: no
 * search that chooses its depths without regard to the position goes below it (Local may).
 * Columns:
 * - Model (string);
 * - StartDepth (int): the depth that is looked at first; -1 of Local and the bound, which have
 * none;
 * - PredictedMean (double): mean nodes examined when leaves are searched for as FrequencyModel
 * says;
 * - MeasuredMean (double): mean nodes examined over the queries; of the bound, that of their
 * depths.
 *
 * Progress, abort, threads, errors, and points that are not finite: as in vtkHashedOctreeFilter;
 * but leaves are numbered and local start depths chosen in passes over the nodes during which no
 * abort is heeded. That, too, is done once for each tree, whatever the number of blocks of queries.
 * Without points for a tree the outputs are empty, as after an error, but that queries on a grid
 * (vtkImageData, vtkRectilinearGrid, vtkStructuredGrid) keep it; without queries with finite
 * coordinates the table has no rows.
 *
 * Several processes that have the pieces of both inputs make one tree together, and send each query
 * to the process that has its part of the tree. Each gives its own queries back, with what they
 * find in the whole tree; LeafId is then the number of the cell among those of all processes, by
 * depth, then by key. The tables are of the queries of all, in the first process; queries in blocks
 * at one place of their composite data sets are of one block, whose table is lost where the first
 * process does not have that place. Field data are of the whole, in all.
 */

#ifndef vtkHashedOctreeLocateFilter_h
#define vtkHashedOctreeLocateFilter_h

#include "HashedOctreeFiltersModule.h" // For export macro
#include "vtkHashedOctreeAlgorithm.h"

class HASHEDOCTREEFILTERS_EXPORT vtkHashedOctreeLocateFilter : public vtkHashedOctreeAlgorithm
{
public:
  static vtkHashedOctreeLocateFilter* New();
  vtkTypeMacro(vtkHashedOctreeLocateFilter, vtkHashedOctreeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The query points: what comes in by input port 1. */
  void SetQueryPointsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetQueryPointsData(vtkDataObject* queries) { this->SetInputData(1, queries); }
  ///@}

protected:
  vtkHashedOctreeLocateFilter();
  ~vtkHashedOctreeLocateFilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int GetTypeOfOutput(int port, vtkInformationVector** inputVector) override;
  int GetTypeOfComposite(vtkInformationVector** inputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHashedOctreeLocateFilter(const vtkHashedOctreeLocateFilter&) = delete;
  void operator=(const vtkHashedOctreeLocateFilter&) = delete;

  class Run;
};

#endif
