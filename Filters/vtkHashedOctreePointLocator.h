// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHashedOctreePointLocator
 * @brief   finds points close to positions: exact, deterministic, in an octree kept in a hash table
 *
 * For use wherever a vtkAbstractPointLocator is taken, like vtkStaticPointLocator; unlike
 * vtkIncrementalPointLocator it inserts no points. The points are put into an octree whose
 * nodes are reached directly by position and depth, so that a search need not begin at the root: it
 * begins at a start depth estimated from the depths of the leaves ("Statistical optimization of
 * octree searches", Castro, Lewiner, Lopes, Tavares, Bordignon, 2008). The start depth changes what
 * a search costs, never what it finds.
 *
 * Data set: any vtkDataSet; of one without a vtkPoints (vtkImageData, vtkRectilinearGrid)
 * GetPoint() gives the points. Coordinates are kept as float or double as they come, everything
 * else as double; they are copied, so that between builds a query never looks at the data set's
 * points.
 *
 * What is promised, of data and positions of any kind:
 * - Distances are computed in double, as the sum of squared differences in axis order. The answer
 *   is the one that a comparison with every point would give.
 * - Of equally near points the one with the smallest id wins. FindClosestNPoints() sorts by
 *   distance, then by id. The order of FindPointsWithinRadius() is not specified, but depends only
 *   on the data, the properties of the locator and the query. (The results of some of VTK's filters
 *   depend on that order, with any locator, those of vtkShepardKernel with a high power by more
 *   than rounding.)
 * - A radius is inclusive: points with a squared distance of at most radius * radius are within.
 *   Radius 0 finds the points at x, an infinite radius all, one that is negative or NaN none.
 * - To ask for more points than there are finds all, for 0 or fewer none, both silently.
 * - A position may lie anywhere, any number of widths away from the data. One that is not finite
 *   has no closest point (-1, or an empty list).
 * - Without points, or without a data set, queries find nothing (-1, or an empty list): without
 *   points silently, without a data set after an error of each build. (But a tree that is kept by
 *   UseExistingSearchStructure, which VTK 9.1 does not have, still answers after
 *   SetDataSet(nullptr).)
 * - Lists are always reset first. A squared distance is set exactly when a point is found.
 * - Points with a coordinate that is not finite, or further from 0 than a quarter of the largest
 *   double (4.49e307), are never found; each build that meets some says so in one warning with
 *   their number, when it is done.
 * - Points whose array has more or fewer than three components are an error of each build, and then
 *   there are none.
 * - Ghost points and hidden ones (vtkGhostType) are points like all others.
 * - One point, points that are all equal, few points far from many: all as above. Leaves at depth
 *   21 with more than four times as many points as they may hold (at least 32) have trees of their
 *   own. (With a smaller MaxDepth leaves are as large as was asked for.)
 * - A search looks at all points where they are nearly equally near: at one place, in the middle of
 *   a sphere, or from far away (at most of them from a thousand widths above a plane, at all from a
 *   million there, and from 1e15 anywhere). It also does where squared distances come
 *   near what is too small or too large for a double, in boxes with sides below 1e-141 or beyond
 *   1e150.
 * - How the processor rounds, and which numbers it takes for zero, must be as it was at the build.
 *   (Where it rounds downwards or to zero, lengths must not be too large for a double, neither as
 *   they are nor in cells of the last depth.)
 *
 * Every query builds the tree first if it must: when there is none, or when the locator, the data
 * set or its points were modified after the last build (and UseExistingSearchStructure is off). So
 * the data set may be changed, emptied or replaced between queries. Which changes are noticed:
 * - Of a vtkPointSet, vtkPolyData, vtkStructuredGrid or vtkUnstructuredGrid, of no class derived
 *   from these, with vtkPoints in a vtkFloatArray, vtkDoubleArray, vtkTypeFloat32Array or
 *   vtkTypeFloat64Array: Modified() of the data set, of the points or of their array. Changes
 *   inside cells or attributes are not, and need no new tree. (New cells of vtkPolyData or
 *   vtkStructuredGrid, as by SetPolys(), are Modified() of the data set.)
 * - Of all other data: what GetMTime() tells of. Each query takes the time to ask for it.
 * - In the coordinate arrays of a vtkRectilinearGrid: none; call Modified() of the grid.
 *
 * After BuildLocator(), called directly or by a query, the queries are thread safe as long as
 * nothing is modified. (Update() is not enough: it does not always build. And if you give the
 * locator to vtkPointSet::SetPointLocator(), call SetDataSet() as well, which VTK leaves to you.)
 * The build runs on the threads of vtkSMPTools; its result does not depend on their number. At most
 * 2^32 - 2 points, unless built with HASHEDOCTREE_64BIT_IDS, and 2^32 - 1 internal nodes; more, or
 * not enough memory, is an error (to tell of it takes a little, too, without which std::bad_alloc
 * is thrown). So is a first thread that vtkSMPTools cannot start; where it cannot start another,
 * VTK ends the program. Until the next build, as after Modified(), queries then find nothing, and
 * batches are the same error again. A query that has not enough memory for what it finds is an
 * error, too, and finds nothing; so is one without a list to put its ids into.
 *
 * Of vtkLocator's own properties: Automatic and Tolerance are not used, MaxLevel is MaxDepth. After
 * a build, Level is the depth of the deepest leaf, NumberOfBuckets the number of leaves, empty ones
 * too (both 0 without points), and Bounds are those of the points that can be found. Without any,
 * and before a build, they are uninitialized, as by vtkMath::UninitializeBounds().
 */

#ifndef vtkHashedOctreePointLocator_h
#define vtkHashedOctreePointLocator_h

#include "HashedOctreeFiltersModule.h" // For export macro
#include "vtkAbstractPointLocator.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkVersionMacros.h" // For the version that brought ForceBuildLocator()

#include <atomic>           // For the end of a batch
#include <initializer_list> // For the outputs of a batch
#include <memory>           // For std::shared_ptr

class HASHEDOCTREEFILTERS_EXPORT vtkHashedOctreePointLocator : public vtkAbstractPointLocator
{
public:
  static vtkHashedOctreePointLocator* New();
  vtkTypeMacro(vtkHashedOctreePointLocator, vtkAbstractPointLocator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // The (x, y, z) forms, which the ones below would hide.
  using vtkAbstractPointLocator::FindClosestNPoints;
  using vtkAbstractPointLocator::FindClosestPoint;
  using vtkAbstractPointLocator::FindPointsWithinRadius;

  /** How often a leaf is searched for: once, empty or not, once for each of its points, or in
   * proportion to its volume (paper section 4). */
  enum FrequencyModels
  {
    Leaves = 0,
    Points = 1,
    Grid = 2
  };

  /** Where a search starts: at the weighted median of the leaves' depths, at their weighted mean to
   * the nearest depth, at the root (the classical search, from there down), at FixedStartDepth, or
   * at the weighted median of the leaves near the position: those in the same one of at most 4096
   * cells.
   * Where it is known that no points are near the position, the closest ones are always searched
   * for from the root. */
  enum StartDepthModels
  {
    Median = 0,
    Mean = 1,
    Root = 2,
    Fixed = 3,
    Local = 4
  };

  ///@{
  /** Points that a leaf above MaxDepth may hold. At least 1; default 64. */
  vtkSetClampMacro(MaxPointsPerLeaf, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaxPointsPerLeaf, int);
  ///@}

  ///@{
  /** The last depth: leaves there are not split, however many points they hold. In [0, 21]; default
   * 21. It is vtkLocator's MaxLevel under the name that it has elsewhere in the module; a MaxLevel
   * above 21 counts as 21. */
  void SetMaxDepth(int depth);
  int GetMaxDepth() const;
  ///@}

  ///@{
  /** One of FrequencyModels; default Leaves. A change moves the start depth of a tree that is up to
   * date, at once, and does not rebuild it, but GetBuildTime() is then that of the change. Without
   * memory for start depths of the Local model it is an error, and there is no change. */
  void SetFrequencyModel(int model);
  vtkGetMacro(FrequencyModel, int);
  ///@}

  ///@{
  /** One of StartDepthModels; default Median. A change does not rebuild the tree, as above. */
  void SetStartDepthModel(int model);
  vtkGetMacro(StartDepthModel, int);
  ///@}

  ///@{
  /** Start depth of the Fixed model, in [0, 21]; default 0. It may be deeper than the tree. A
   * change does not rebuild the tree, as above. */
  void SetFixedStartDepth(int depth);
  vtkGetMacro(FixedStartDepth, int);
  ///@}

  /** Id of the point closest to x, or -1. Near the points the mean cost is O(1), farther away
   * O(depth), but for points that are nearly equally near. Thread safe after a build. */
  vtkIdType FindClosestPoint(const double x[3]) override;

  /** Id of the point closest to x among those within the radius, or -1. `dist2` is set to its
   * squared distance, and left alone when there is none. Costs what FindClosestPoint() does,
   * mostly less. Thread safe after a build. */
  vtkIdType FindClosestPointWithinRadius(double radius, const double x[3], double& dist2) override;

  /** Ids of the `count` points closest to x, sorted by distance, then by id; of all points when
   * there are no more. Mean cost O(count log count) near the points. Thread safe after a build. */
  void FindClosestNPoints(int count, const double x[3], vtkIdList* result) override;

  /** Ids of the points within the radius of x, in no order to rely on. Costs O(points within, and
   * nodes that the sphere cuts). Thread safe after a build. */
  void FindPointsWithinRadius(double radius, const double x[3], vtkIdList* result) override;

  /** Ids of the points in a box given as (xmin, xmax, ymin, ymax, zmin, zmax), those on its faces
   * included, in no order to rely on. Sides may be infinite; none for a box that is inside out or
   * has a side that is NaN. Costs as above. Thread safe after a build. */
  void FindPointsWithinBox(const double bounds[6], vtkIdList* result);

  ///@{
  /**
   * Many searches at once, on the threads of vtkSMPTools. Every search finds the points that
   * the one of the same name for one position finds, in the order told here. `queries` has three
   * components, of any type; the other arrays get new memory, and must all be different, from
   * `queries` and the coordinates of the data set, too. Fires ProgressEvent with the fraction done
   * of all but a build; AbortBatch(), called by an observer or from another thread, ends the
   * batches that run, after the search that a thread is at, or after the build where there is one.
   * Returns whether all was done: if aborted, or after an error (no three components, not enough
   * memory, no thread, a build that failed), all outputs are empty, with one component; where they
   * are not arrays of their own, all arrays are left alone.
   * - FindClosestPoints(): one id and squared distance for each position.
   * - FindClosestNPoints(): `count` components for each position, by distance, then by id; one
   *   component without positions.
   *   Both: -1 and infinity where there is no (other) point; nothing for a count of 0 or less.
   * - FindPointsWithinRadius(): those of position i, by distance, then by id, stand at offsets[i]
   *   to offsets[i + 1] - 1 in `ids` and `dist2`; `offsets` has one value more than there are
   *   positions.
   *
   * In large trees scattered positions are taken along the Morton curve, a million at a time, so
   * that one search finds in the caches what the last one loaded. That takes up to 24 bytes (32
   * with 64-bit ids) for each of that million in the meantime; FindPointsWithinRadius() also holds
   * all that it finds twice.
   *
   * One batch at a time, but AbortBatch() may be called at any time, by any thread. Builds the tree
   * if it must.
   */
  bool FindClosestPoints(vtkDataArray* queries, vtkIdTypeArray* ids, vtkDoubleArray* dist2);
  bool FindClosestNPoints(
    int count, vtkDataArray* queries, vtkIdTypeArray* ids, vtkDoubleArray* dist2);
  bool FindPointsWithinRadius(double radius, vtkDataArray* queries, vtkIdTypeArray* offsets,
    vtkIdTypeArray* ids, vtkDoubleArray* dist2);
  void AbortBatch() { ++this->AbortedBatches; }
  ///@}

  ///@{
  /**
   * The leaf that holds x, or is nearest to it on each axis where x lies outside the root.
   * - GetLeafId(): the cell that it is in GenerateRepresentation(-1), or -1 if it holds no point.
   * - GetDepth(): its depth, 0 for the root.
   * - GetHitCost(): how many nodes the search for it examines from the start depth there, which is
   *   1 + |depth - start depth| (paper section 4).
   * -1 (the cost 0) without points, or if x is not finite. Trees in leaves at depth 21 do not
   * count. Thread safe after a build.
   */
  vtkIdType GetLeafId(const double x[3]);
  int GetDepth(const double x[3]);
  vtkIdType GetHitCost(const double x[3]);
  ///@}

  ///@{
  /**
   * How many nodes the query of that name examines: looks into the hash table, and into the
   * children of a node, which are measured together and count as one (in GetHitCost() each counts).
   * The query is made and counted; the others count nothing, and are no slower for it. 0 where
   * there is nothing to search for or in, and where one look into the map of free space, which does
   * not count, tells that a ball is empty. Thread safe after a build.
   */
  vtkIdType GetClosestPointCost(const double x[3]);
  vtkIdType GetClosestNPointsCost(int count, const double x[3]);
  vtkIdType GetPointsWithinRadiusCost(double radius, const double x[3]);
  vtkIdType GetPointsWithinBoxCost(const double bounds[6]);
  ///@}

  /** Builds the tree unless it is up to date or, where there is one of any points,
   * UseExistingSearchStructure is on. O(n). */
  void BuildLocator() override;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  /** Builds the tree. O(n). */
  void ForceBuildLocator() override;
#else
  /** Builds the tree. O(n). */
  virtual void ForceBuildLocator();
#endif
  /** Frees the tree, if any; Level, NumberOfBuckets and Bounds are as before a build. */
  void FreeSearchStructure() override;

  /**
   * The nodes at a depth that hold points, as boxes; all leaves that hold points for a negative
   * level. 0 is the root, GetLevel() the deepest; deeper levels have no nodes. Each is one cell, a
   * vtkPolyLine along its edges, where VTK's locators give polygons, several for each node. Ordered
   * by depth, then by Morton key. Cell arrays as in vtkHashedOctreeFilter: Depth (active scalars),
   * HitCost (from GetStartDepth()), RootCost, PointCount, MortonKey. Builds the tree if it must.
   */
  void GenerateRepresentation(int level, vtkPolyData* pd) override;

  /** The depth at which searches start in the tree of the last build, by the properties as they are
   * now; of Local the median of all leaves. Does not build; 0 where there is no tree. */
  int GetStartDepth() const;

  /** Bytes of the whole search structure of the last build, copied coordinates included. Does not
   * build; 0 before one, and hardly any without points. */
  vtkIdType GetIndexBytes() const;

protected:
  vtkHashedOctreePointLocator();
  ~vtkHashedOctreePointLocator() override;

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  /** Builds the tree, then tells of errors and warnings. */
  void BuildLocatorInternal() override;
#else
  virtual void BuildLocatorInternal();
#endif

private:
  vtkHashedOctreePointLocator(const vtkHashedOctreePointLocator&) = delete;
  void operator=(const vtkHashedOctreePointLocator&) = delete;

  class Index;

  /** The index, built if it must be. */
  const Index& GetIndex();
  /** Replaces a list by what find(search, vector of Found) finds. */
  template <typename Found, typename Find>
  void FillList(vtkIdList* result, const Find& find);
  /** What count(search) counts. */
  template <typename Count>
  vtkIdType CountNodes(const Count& count);
  /** Empties the outputs of a batch; false for arrays that it cannot work with. */
  bool PrepareBatch(vtkDataArray* queries, std::initializer_list<vtkDataArray*> outputs);
  /** Calls function(batch, positions) for the searches of a batch; false if they were not done. */
  template <typename Function>
  bool RunBatch(
    vtkDataArray* queries, std::initializer_list<vtkDataArray*> outputs, const Function& function);
  bool IsUpToDate() const;
  bool HasSamePoints() const;
  /** Builds anew; the index has what went wrong, if anything, which this does not tell. */
  void BuildIndex();
  void Fill(Index& index);
  void SetStartDepthProperty(int& property, int value);
  void ChooseStartDepths(Index& index) const;

  int MaxPointsPerLeaf = 64;
  int FrequencyModel = Leaves;
  int StartDepthModel = Median;
  int FixedStartDepth = 0;
  std::atomic<unsigned> AbortedBatches{ 0 }; ///< How often AbortBatch() was called.
  std::shared_ptr<Index> Built; ///< Kept by a batch to its end, whatever its observers do.
};

#endif
