// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHashedOctreeFilter
 * @brief   the octree of a point set, kept in a hash table, with the statistics of its depths
 *
 * Builds the octree of the input's points: a cube is split into eight while it holds more than
 * MaxPointsPerLeaf points, down to MaxDepth. The root is the cube at the lower corner of the
 * points' bounds (or of CustomBounds) whose side is their largest extent, 1 if all points coincide.
 * Of points in a plane across an axis it is a quadtree, with squares for cubes: see
 * vtkHashedOctreeAlgorithm. Any node of a hashed octree can be reached directly by position and
 * depth, so that a search need not begin at the root: it begins at a start depth estimated from the
 * depths of the leaves, and their weighted median examines the fewest nodes ("Statistical
 * optimization of octree searches", Castro, Lewiner, Lopes, Tavares, Bordignon, 2008).
 *
 * Input: any vtkPointSet; of composite data sets every block by itself, one tree per block. Outputs
 * are then composite data sets of its structure: port 0 of its kind, the tables in a
 * vtkMultiBlockDataSet. Blocks without coordinates of their own (vtkImageData) are left out with
 * one warning; an input with no other points, as AMR, is an error.
 *
 * Output port 0, the nodes of the tree as cells, ordered by depth, then by Morton key, in a
 * vtkUnstructuredGrid of VTK_VOXEL or, of a quadtree, VTK_PIXEL (Voxels), or in a vtkPolyData of a
 * VTK_POLY_LINE each along its edges (Outlines). Leaves with points are always in it. Or the whole
 * tree as VTK's own kind of tree, a vtkHyperTreeGrid with the root for its only cell
 * (HyperTreeGrid): all nodes are its vertices, the children of each side by side in VTK's order,
 * and leaves without points are masked, unless they are included. Cell arrays, one value per cell
 * or vertex:
 * - Depth (int, active scalars): 0 is the root;
 * - HitCost (int): nodes that a search for this leaf from the start depth examines, counted in a
 *   real search; 1 + |Depth - StartDepth|. 0 on internal nodes, where no search ends;
 * - RootCost (int): the same for a search from the root;
 * - PointCount (vtkTypeInt64): points in the node;
 * - MortonKey (unsigned 64-bit): key of the node, 1 for the root, a child's key being
 *   8 * key + octant, where x is the high bit of the octant (in VTK's own octrees it is the low
 *   one); in a quadtree 4 * key + quadrant, where the first axis of the plane is the high bit.
 *
 * Field data of all outputs, one value each: Dimension (2 or 3), StartDepth, MeanHitCost,
 * MeanRootCost (means over all leaves in the chosen FrequencyModel), CostRatio (root / hit),
 * NumberOfPoints, NumberOfNodes (internal nodes and all leaves), NumberOfLeaves,
 * NumberOfEmptyLeaves, DeepestDepth, StartDepthLeaves, StartDepthPoints, StartDepthGrid (by the
 * chosen StartDepthModel in each frequency model), TreeBytes (the tree without the points and their
 * order), BuildSeconds, SkippedPoints (not finite, or too large), OutsidePoints (outside
 * CustomBounds). All outputs keep the field data of the input, but for arrays of these names.
 *
 * Output port 1, vtkTable, one row for each depth from 0 to the deepest: Depth, Leaves,
 * EmptyLeaves, Points, GridWeight (volume of the leaves, in a quadtree their area, in cells of the
 * deepest depth).
 *
 * Output port 2, vtkTable, one row for each start depth from 0 to the deepest, and at least to 1,
 * mean number of nodes that one search examines: StartDepth, CostLeaves, CostPoints, CostGrid (the
 * model), MeasuredLeaves, MeasuredPoints (counted in searches for every leaf), ContinuousLeaves
 * (the paper's differentiable cost at StartDepth + 1/2), MeanHitCost (by FrequencyModel in the row
 * of the start depth that was chosen, NaN in the others).
 *
 * The tables always count all leaves, empty ones too. Points with a coordinate that is not finite,
 * or further from 0 than a quarter of the largest double (4.49e307), are left out with one warning.
 * An input without points, or without one that can be used, has no tree: the outputs are empty, of
 * a composite input the block is null. Where all points lie outside CustomBounds a warning says so,
 * unless other pieces are missing. After an error, which is said once, the outputs are empty, too;
 * to the pipeline the update is done, so that what follows shows that there is nothing. The result,
 * but for BuildSeconds, does not depend on the number of threads (vtkSMPTools). Progress is
 * reported throughout; an abort is heeded within a tenth of a second and leaves all outputs empty
 * (VTK keeps AbortExecute set: reset it before the next update). Points with the same cell at
 * MaxDepth share a leaf, however many they are. At most 2^32 - 2 points, unless built with
 * HASHEDOCTREE_64BIT_IDS, and 2^32 - 1 internal nodes (as a hyper tree grid, nodes of all kinds).
 *
 * Several processes that have the pieces of a data set make one tree together, of which each has a
 * part with about as many points as each other. Together their outputs hold each node once, with
 * the values that one process would give it, in the order above within each process. A hyper tree
 * grid holds the nodes around a process's own, too: their leaves are masked, and the values of
 * internal ones are not those of the whole tree. VTK's generator of ghost cells, which takes such
 * grids for pieces with trees of their own, waits for ever. The tables are those of the whole, in
 * the first process; the others have tables without columns. Field data are of the whole, in all:
 * TreeBytes is the sum, BuildSeconds the longest time.
 */

#ifndef vtkHashedOctreeFilter_h
#define vtkHashedOctreeFilter_h

#include "HashedOctreeFiltersModule.h" // For export macro
#include "vtkHashedOctreeAlgorithm.h"

class HASHEDOCTREEFILTERS_EXPORT vtkHashedOctreeFilter : public vtkHashedOctreeAlgorithm
{
public:
  static vtkHashedOctreeFilter* New();
  vtkTypeMacro(vtkHashedOctreeFilter, vtkHashedOctreeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What port 0 holds; of a quadtree squares for boxes. */
  enum OutputTypes
  {
    Voxels = 0,
    Outlines = 1,
    HyperTreeGrid = 2
  };

  ///@{
  /** One of OutputTypes; default Voxels. Set while the filter runs, it counts from the next run on.
   */
  vtkSetClampMacro(OutputType, int, Voxels, HyperTreeGrid);
  vtkGetMacro(OutputType, int);
  ///@}

  ///@{
  /** Whether port 0 also holds the internal nodes, each around its children; a hyper tree grid
   * always does. Default off. */
  vtkSetMacro(IncludeInternalNodes, bool);
  vtkGetMacro(IncludeInternalNodes, bool);
  vtkBooleanMacro(IncludeInternalNodes, bool);
  ///@}

  ///@{
  /** Whether CustomBounds gives the root instead of the points' own bounds, so that trees of
   * different points share one grid. Points outside CustomBounds are left out and counted, of
   * quadtrees too; points on its faces are inside. A block with all of its points outside has no
   * tree, and so nothing that counts them; nor has such a piece of a process that works alone.
   * Default off. */
  vtkSetMacro(UseCustomBounds, bool);
  vtkGetMacro(UseCustomBounds, bool);
  vtkBooleanMacro(UseCustomBounds, bool);
  ///@}

  ///@{
  /** (xmin, xmax, ymin, ymax, zmin, zmax) in world units, each minimum at most its maximum; default
   * the unit cube. Bounds that are turned around, not finite or beyond 4.49e307 are an error. */
  vtkSetVector6Macro(CustomBounds, double);
  vtkGetVector6Macro(CustomBounds, double);
  ///@}

protected:
  vtkHashedOctreeFilter();
  ~vtkHashedOctreeFilter() override = default;

  int GetTypeOfOutput(int port, vtkInformationVector** inputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHashedOctreeFilter(const vtkHashedOctreeFilter&) = delete;
  void operator=(const vtkHashedOctreeFilter&) = delete;

  class Run;

  int OutputType = Voxels;
  bool IncludeInternalNodes = false;
  bool UseCustomBounds = false;
  double CustomBounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
};

#endif
