# SPDX-License-Identifier: BSD-3-Clause
"""The filter that locates query points: its proxy, and its outputs, in ParaView alone and from a
server."""
import numpy
from octreetesting import arrays, check_properties, check_values, fetch, write_sphere
from hashedoctree import vtkHashedOctreeLocateFilter
from paraview import servermanager, simple

path, number_of_points = write_sphere()
sphere = simple.XMLPolyDataReader(FileName=[path])
queries = simple.Transform(Input=sphere)
queries.Transform.Scale = [0.7, 0.9, 1.1]  # Partly outside the box of the sphere.

# The proxy.
locate = simple.HashedOctreeLocate(Input=sphere, QueryPoints=queries)
names = check_properties(locate, vtkHashedOctreeLocateFilter, inputs=["Input", "QueryPoints"])
values = {"Dimension": "Two", "Plane": "YZ", "MaxPointsPerLeaf": 7, "MergePoints": 1, "MaxDepth": 9,
          "FrequencyModel": "Grid", "StartDepthModel": "Fixed", "FixedStartDepth": 3,
          "IncludeEmptyLeaves": 1}
assert set(values) == names, names
if not servermanager.ActiveConnection.IsRemote():
    check_values(simple.HashedOctreeLocate(Input=sphere, QueryPoints=queries),
                 vtkHashedOctreeLocateFilter, values)
assert locate.SMProxy.GetProperty("QueryPoints").GetXMLLabel() == "Query Points"
assert [locate.GetOutputPort(name).Port for name in ("Located Queries", "Search Costs")] == [0, 1]

# Its outputs, against the cells of the octree.
octree = simple.HashedOctree(Input=sphere, IncludeEmptyLeaves=1)
octree.UpdatePipeline()
cells = arrays(fetch(octree, 0).GetCellData())
by_leaf_id = numpy.lexsort((cells["MortonKey"], cells["Depth"])) # Processes have a part each.
locate.IncludeEmptyLeaves = 1
locate.UpdatePipeline()


def columns(table):
    """The columns of a table by name; those of text are lists."""
    def values(column):
        return [column.GetValue(i) for i in range(column.GetNumberOfValues())]
    return {table.GetColumnName(i): values(table.GetColumn(i))
            for i in range(table.GetNumberOfColumns())}


COSTS = ["HitCost", "RootCost", "MedianCost", "MeanCost", "LocalCost", "DecisionTreeCost"]
located = fetch(locate, 0)
assert located.GetClassName() == "vtkPolyData" and located.GetNumberOfPolys() > 0, located
assert located.GetNumberOfPoints() == number_of_points, located
points = arrays(located.GetPointData())
assert located.GetPointData().GetScalars().GetName() == "HitCost"
assert set(points) == {"Normals", "LeafId", "LeafDepth", "LeafKey"} | set(COSTS), list(points)
ids = points["LeafId"]
assert ids.min() >= 0 and len(numpy.unique(ids)) > 100
for of_points, of_cells in (("LeafDepth", "Depth"), ("LeafKey", "MortonKey"),
                            ("HitCost", "HitCost"), ("RootCost", "RootCost")):
    assert (points[of_points] == cells[of_cells][by_leaf_id[ids]]).all(), of_points

table = columns(fetch(locate, 1))
assert list(table) == ["Model", "StartDepth", "PredictedMean", "MeasuredMean"], list(table)
assert table["Model"] == ["Root", "Median", "Mean", "Local", "Decision tree",
                          "Best for these queries", "Entropy bound"], table
means = dict(zip(table["Model"], table["MeasuredMean"]))
for model, array in (("Root", "RootCost"), ("Median", "MedianCost"), ("Mean", "MeanCost"),
                     ("Local", "LocalCost"), ("Decision tree", "DecisionTreeCost")):
    assert abs(means[model] - points[array].mean()) < 1e-12, (model, means[model])
figures = {name: values[0] for name, values in arrays(located.GetFieldData()).items()}
assert figures["MeanHitCost"] == means["Median"]
assert figures["StartDepth"] == table["StartDepth"][1]
by_start_depth = [(1 + abs(points["LeafDepth"] - start)).mean() for start in range(22)]
assert figures["BestStartDepth"] == numpy.argmin(by_start_depth)
assert abs(means["Best for these queries"] - min(by_start_depth)) < 1e-12

# Blocks in both inputs, of each kind: ParaView and the filters after this one see all of them.
groups = [simple.GroupDatasets(Input=[sphere, queries], OutputType="vtk" + kind)
          for kind in ("MultiBlockDataSet", "PartitionedDataSet", "PartitionedDataSetCollection")]
for points_group in groups:
    for queries_group in groups:
        blocks = simple.HashedOctreeLocate(Input=points_group, QueryPoints=queries_group)
        elevation = simple.Elevation(Input=blocks)
        elevation.UpdatePipeline()
        for source in (blocks, elevation):
            count = source.GetDataInformation().GetNumberOfPoints()
            kinds = (points_group.OutputType, queries_group.OutputType)
            assert count == 4 * number_of_points, (kinds, count)

# The points as their own queries cost what is predicted for points.
own = simple.HashedOctreeLocate(Input=sphere, QueryPoints=sphere, FrequencyModel="Points")
own.UpdatePipeline()
table = columns(fetch(own, 1))
assert table["PredictedMean"] == table["MeasuredMean"], table
ids = arrays(fetch(own, 0).GetPointData())["LeafId"]
assert sorted(ids) == list(range(number_of_points)), ids
