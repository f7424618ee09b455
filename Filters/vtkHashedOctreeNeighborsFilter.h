// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHashedOctreeNeighborsFilter
 * @brief   a leaf of the octree of a point set, and the leaves around it
 *
 * Builds the octree of the input's points as vtkHashedOctreeFilter does, takes one leaf of it, the
 * query leaf, and searches for its neighbours ("Statistical optimization of octree searches",
 * Castro, Lewiner, Lopes, Tavares, Bordignon, 2008, sections 3b and 3c; Figures 5 and 6). Where the
 * start depth is close to the neighbours' depths the search examines few nodes.
 *
 * The query leaf is the one that holds the position Center or, with UseLeafKey, the one whose
 * Morton key is LeafKey. Its neighbours are
 * - Adjacent: the leaves that touch its cell by a face, an edge or a corner;
 * - InRadius: the other leaves whose closed cells meet the closed ball of Radius around the center
 *   of the QUERY LEAF, not around Center. A ball that does not reach the border of the query leaf
 *   meets none; half the leaf's side is the least radius that does. Lengths are compared in double:
 *   a cell that the ball only touches is met or not by the last digit of Radius.
 * In the quadtree of points in a plane (see vtkHashedOctreeAlgorithm) cells are squares, the ball
 * is a disk, and Center is projected to the plane.
 *
 * Leaves are those that vtkHashedOctreeFilter shows with the same properties: without
 * IncludeEmptyLeaves those with points only (the sparse reading). Then a position may lie in an
 * empty cell, where there is no leaf (paper E4): the output is empty, with one warning. A leaf that
 * is the root has no neighbours.
 *
 * Input: any vtkPointSet; of composite data sets every block by itself, one tree per block.
 *
 * Output: vtkUnstructuredGrid of one VTK_VOXEL, or VTK_PIXEL, for each leaf: the query leaf, then
 * its neighbours in the order of the search, which depends on the tree and the query alone.
 * Neighbours share corners; the query leaf has its own, the last points, or surfaces and wireframes
 * of the output would not have the faces that it shares with neighbours. Cell arrays: Depth,
 * HitCost, RootCost, PointCount, MortonKey as those of vtkHashedOctreeFilter, and
 * - Role (int): one of Roles;
 * - Case (int, active scalars): one of Cases, how the depth of the neighbour compares with that of
 *   the query leaf, which decides how the search gets to it.
 *
 * Field data, one value each: StartDepth, NumberOfSameDepthNeighbors,
 * NumberOfDescendedNeighbors, NumberOfAboveNeighbors (neighbours of each case), ExaminedNodes
 * (nodes that the search for the neighbours examined, as AdjacentSearch.h and InRadiusSearch.h
 * count them; what finding the query leaf itself costs is its HitCost), SkippedPoints (not finite,
 * or too large). The output keeps the field data of the input, but for arrays of these names.
 *
 * Points with a coordinate that is not finite or too large are left out with one warning. An input
 * without points, or without one that can be used, has no neighbours: the output is empty. A
 * LeafKey that names no leaf is an error; of a composite data set the blocks that have no such leaf
 * stay empty, and one must have it; a piece whose other pieces are not of this group of processes
 * stays empty without an error, since another may have it. A Center that is not finite is an error,
 * and so is a Radius that is negative or NaN, where it is used. After an error the output is empty,
 * and the update done, as in vtkHashedOctreeFilter. The result does not depend on the number of
 * threads (vtkSMPTools), which build the tree and fill arrays; the search takes one. Progress is
 * reported and an abort heeded but for the search itself; an abort leaves the output empty.
 *
 * Of several processes that have the pieces of a data set each gives the leaves in its part of the
 * tree, in the order of the search; one has the query leaf. Field data are those of one search in
 * the whole tree.
 */

#ifndef vtkHashedOctreeNeighborsFilter_h
#define vtkHashedOctreeNeighborsFilter_h

#include "HashedOctreeFiltersModule.h" // For export macro
#include "vtkHashedOctreeAlgorithm.h"

class HASHEDOCTREEFILTERS_EXPORT vtkHashedOctreeNeighborsFilter : public vtkHashedOctreeAlgorithm
{
public:
  static vtkHashedOctreeNeighborsFilter* New();
  vtkTypeMacro(vtkHashedOctreeNeighborsFilter, vtkHashedOctreeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Which leaves are neighbours. */
  enum SearchModes
  {
    Adjacent = 0,
    InRadius = 1
  };

  /** The array Role. */
  enum Roles
  {
    Query = 0,
    Neighbor = 1
  };

  /** The array Case (paper sections 3b and 3c): the query leaf itself; a neighbour of its depth
   * (case 1 of the paper); a deeper one, below a node of that depth (case 2); a higher one, where
   * there is no node of that depth (case 3). */
  enum Cases
  {
    QueryLeaf = 0,
    SameDepth = 1,
    Descended = 2,
    Above = 3
  };

  ///@{
  /** One of SearchModes; default Adjacent. */
  virtual void SetSearchMode(int mode);
  vtkGetMacro(SearchMode, int);
  ///@}

  ///@{
  /** Position in world units whose leaf is the query leaf; default (0, 0, 0). Outside the root cube
   * it stands for the cell nearest to it. Not used with UseLeafKey. */
  virtual void SetCenter(double x, double y, double z);
  virtual void SetCenter(const double x[3]);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /** Whether LeafKey gives the query leaf instead of Center. Default off. */
  virtual void SetUseLeafKey(bool use);
  vtkGetMacro(UseLeafKey, bool);
  vtkBooleanMacro(UseLeafKey, bool);
  ///@}

  ///@{
  /** Key of the query leaf, a value of the array MortonKey; default 1, the root. The keys of depth
   * 21 in octrees are 2^63 and more: here they are the negative numbers with the same 64 bits. */
  virtual void SetLeafKey(vtkTypeInt64 key);
  vtkGetMacro(LeafKey, vtkTypeInt64);
  ///@}

  ///@{
  /** Radius of the ball of InRadius in world units; default 1. Not negative; may be infinite, which
   * gives all leaves. Not used in mode Adjacent. */
  virtual void SetRadius(double radius);
  vtkGetMacro(Radius, double);
  ///@}

protected:
  vtkHashedOctreeNeighborsFilter();
  ~vtkHashedOctreeNeighborsFilter() override = default;

  int GetTypeOfOutput(int port, vtkInformationVector** inputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHashedOctreeNeighborsFilter(const vtkHashedOctreeNeighborsFilter&) = delete;
  void operator=(const vtkHashedOctreeNeighborsFilter&) = delete;

  class Run;

  int SearchMode = Adjacent;
  double Center[3] = { 0.0, 0.0, 0.0 };
  bool UseLeafKey = false;
  vtkTypeInt64 LeafKey = 1;
  double Radius = 1.0;
};

#endif
