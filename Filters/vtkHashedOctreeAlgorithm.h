// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHashedOctreeAlgorithm
 * @brief   what the filters over octrees of point sets have in common
 *
 * The properties of the tree, and of where searches in it start: filters with the same values build
 * the same tree. Input port 0 is any vtkPointSet; of composite data sets every block is taken by
 * itself, and the outputs are then composite data sets of its structure and, unless they are of
 * tables, of its kind, where the filter does not say otherwise. Blocks that have points but are no
 * vtkPointSets, as images, are left out with one warning; it is an error if there are no others
 * with points, and if an array of points has more or fewer than three components. The corners of an
 * octree's cells, an output of these filters, are taken as other points are, but with one warning.
 * Abstract.
 *
 * The tree is an octree or, of points in a plane across an axis, a quadtree: a square in two of the
 * coordinates, split into four. Its cells lie in the plane through the lowest third coordinate of
 * the points (of the custom bounds, where the filter has them and uses them); the third coordinate
 * has no other effect, but that a point where it is not finite is left out as in an octree. Each
 * block of a composite data set has the dimension and the plane that its own points
 * ask for; set Dimension and Plane to have one of all.
 *
 * On one process vtkHashedOctreeNeighborsFilter and vtkHashedOctreeLocateFilter keep their trees
 * from one update to the next, and build none where nothing has changed but properties of searches
 * (start depths, frequencies, empty leaves, all that says which neighbours are wanted) or the
 * points to locate. All else makes them build again: other properties, Modified() of the filter, of
 * the points or of their array, and a source that has generated the points again. Only points that
 * are changed in place without a word to any of these go unnoticed. Where the input is released
 * after use (ReleaseDataFlag), nothing that is kept is of use; Modified() frees it.
 *
 * Several processes that have the pieces of a data set make one tree together: those of Controller,
 * when as many pieces are asked for as there are processes, and of each the one of its rank, as
 * ParaView does. All of them have to update the filter then, since each waits for the others; and
 * where the filter or its input changes in one, call Modified() in all. An error or an abort in one
 * ends the update in all, with an error in the others; the next update runs again in all. But if
 * other filters follow, call Modified() in all before that update: those filters believe that they
 * are up to date, and ask for nothing.
 *
 * The points of all pieces are in the tree, and equal ones count each. Points that VTK marks as
 * another piece's (vtkGhostType has DUPLICATEPOINT) are left to that one, on one process as on
 * several; the bounds are around them, too, but the counts of points that are left out do not have
 * them. So, where pieces share a layer of points, mark it, as vtkGenerateGlobalIds does, or merge
 * points. Hidden points (HIDDENPOINT) are points like all others, and an array of marks without one
 * for each point marks none. In composite data sets, blocks at the same place in the structure are
 * pieces of one, if all processes have the same structure; otherwise, and where pieces are asked
 * for in another way, each process makes trees of its own points.
 */

#ifndef vtkHashedOctreeAlgorithm_h
#define vtkHashedOctreeAlgorithm_h

#include "HashedOctreeFiltersModule.h" // For export macro
#include "vtkDataObjectAlgorithm.h"
#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"

#include <memory> // For the octrees that are kept

namespace hashedoctree
{
class KeptOctrees;
}

class HASHEDOCTREEFILTERS_EXPORT vtkHashedOctreeAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkHashedOctreeAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Also forgets the trees that are kept, so that the next update builds them, and frees their
   * memory. */
  void Modified() override;

  /** How often a leaf is searched for: once, empty or not, once for each of its points, or in
   * proportion to its volume (paper section 4). */
  enum FrequencyModels
  {
    Leaves = 0,
    Points = 1,
    Grid = 2
  };

  /** Where a search starts: at the weighted median of the leaves' depths, at their weighted mean to
   * the nearest depth, at the root, or at FixedStartDepth. (Local is the locator's alone: here one
   * depth is for the whole tree.) */
  enum StartDepthModels
  {
    Median = 0,
    Mean = 1,
    Root = 2,
    Fixed = 3
  };

  /** Octrees or quadtrees: as the points ask for, always quadtrees, or always octrees. */
  enum Dimensions
  {
    Auto = 0,
    Two = 2,
    Three = 3
  };

  /** The plane of a quadtree: that of the two largest extents of the points, or a given one. */
  enum Planes
  {
    Widest = 0,
    XY = 1,
    YZ = 2,
    XZ = 3
  };

  ///@{
  /** One of Dimensions, less than 2 being Auto and more than 3 being Three; default Auto: Two where
   * exactly one extent of the points is 0, to the last digit, else Three, also for points on a line
   * along an axis and for points at one place, which determine no plane. With Two, other points are
   * projected to Plane. Where the filter uses custom bounds, their extents count in place of the
   * points'. */
  virtual void SetDimension(int dimension);
  vtkGetMacro(Dimension, int);
  ///@}

  ///@{
  /** One of Planes, used with Dimension Two; default Widest, where of equal extents that along z is
   * taken for the smaller one, then that along y. The first axis in the name is the first one of
   * the tree's, the high bit of an octant. */
  vtkSetClampMacro(Plane, int, Widest, XZ);
  vtkGetMacro(Plane, int);
  ///@}

  ///@{
  /** Points that a leaf above MaxDepth may hold. At least 1; default 1. */
  vtkSetClampMacro(MaxPointsPerLeaf, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaxPointsPerLeaf, int);
  ///@}

  ///@{
  /** Whether points in one cell of the grid (2^21 cells along each axis of an octree, 2^31 of a
   * quadtree, whatever MaxDepth) count as one: equal points, and those that differ in their last
   * digits only, unless a border of cells, such as the middle of the root, is between them. If off,
   * more than MaxPointsPerLeaf of them share a leaf at MaxDepth, at the default MaxDepth one too
   * small to be seen. Default off. */
  vtkSetMacro(MergePoints, bool);
  vtkGetMacro(MergePoints, bool);
  vtkBooleanMacro(MergePoints, bool);
  ///@}

  ///@{
  /** The last depth: leaves there are not split, however many points they hold. In [0, 31]; default
   * 21. In octrees, whose keys end there, more than 21 is 21. */
  vtkSetClampMacro(MaxDepth, int, 0, 31);
  vtkGetMacro(MaxDepth, int);
  ///@}

  ///@{
  /** One of FrequencyModels; default Leaves. */
  virtual void SetFrequencyModel(int model);
  vtkGetMacro(FrequencyModel, int);
  ///@}

  ///@{
  /** One of StartDepthModels; default Median. It changes what a search costs, never what it finds.
   */
  virtual void SetStartDepthModel(int model);
  vtkGetMacro(StartDepthModel, int);
  ///@}

  ///@{
  /** Start depth of the Fixed model, in [0, 31]; default 0. It may be deeper than the tree. In
   * octrees more than 21 is 21. */
  virtual void SetFixedStartDepth(int depth);
  vtkGetMacro(FixedStartDepth, int);
  ///@}

  ///@{
  /** Whose processes have the other pieces of a distributed data set; default the global
   * controller. Null makes each process work alone. (Python knows what GetController() returns once
   * vtkmodules.vtkParallelCore is imported.) */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  ///@{
  /** Whether octants without points are leaves where leaves are given: as cells of output 0 of
   * vtkHashedOctreeFilter, as neighbours of vtkHashedOctreeNeighborsFilter, and in the numbers that
   * vtkHashedOctreeLocateFilter gives them. Start depths, costs and tables always count them.
   * Default off, but on in vtkHashedOctreeNeighborsFilter. */
  virtual void SetIncludeEmptyLeaves(bool include);
  vtkGetMacro(IncludeEmptyLeaves, bool);
  vtkBooleanMacro(IncludeEmptyLeaves, bool);
  ///@}

protected:
  vtkHashedOctreeAlgorithm();
  ~vtkHashedOctreeAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  /** Tells that the outputs are on no grid, wherever the points are: what is on one and has less
   * than its extent is made again at each update. */
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  /** Asks for all of a grid of points, of which the source takes the piece, and for no ghosts,
   * which would be in several trees, however many are wanted of the output. */
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /** The type of data object at an output port when port 0 has a single data set; negative when
   * there is none to give. */
  virtual int GetTypeOfOutput(int port, vtkInformationVector** inputVector) = 0;

  /** As Modified(), where what has changed is of searches only: trees that are kept stay good. */
  void ModifiedSearches() { this->Superclass::Modified(); }
  /** Sets a property of searches. */
  template <typename Value>
  void SetOfSearches(Value& property, Value value)
  {
    if (property != value)
    {
      property = value;
      this->ModifiedSearches();
    }
  }

  /** The trees of the last update, of filters that keep them. */
  hashedoctree::KeptOctrees& GetKeptOctrees() { return *this->Kept; }

  /** The type of data object at all output ports but those of tables when port 0 has a composite
   * data set: the type of that; negative when it has a single one. */
  virtual int GetTypeOfComposite(vtkInformationVector** inputVector);

private:
  vtkHashedOctreeAlgorithm(const vtkHashedOctreeAlgorithm&) = delete;
  void operator=(const vtkHashedOctreeAlgorithm&) = delete;

  int Dimension = Auto;
  int Plane = Widest;
  int MaxPointsPerLeaf = 1;
  bool MergePoints = false;
  bool IncludeEmptyLeaves = false;
  int MaxDepth = 21;
  int FrequencyModel = Leaves;
  int StartDepthModel = Median;
  int FixedStartDepth = 0;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  std::unique_ptr<hashedoctree::KeptOctrees> Kept;
};

#endif
