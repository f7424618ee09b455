# SPDX-License-Identifier: BSD-3-Clause
"""The filter that finds neighbours: its proxy against the class, its widgets, and its output."""
import numpy
import octreetesting  # loads the plugin
from hashedoctree import vtkHashedOctreeNeighborsFilter
from paraview import simple

SEARCH_MODES = ["Adjacent", "InRadius"]
path, number_of_points = octreetesting.write_sphere()
sphere = simple.XMLPolyDataReader(FileName=[path])
sphere.UpdatePipeline()
neighbors = simple.HashedOctreeNeighbors(Input=sphere)
names = octreetesting.check_properties(neighbors, vtkHashedOctreeNeighborsFilter,
                                       {"SearchMode": SEARCH_MODES})
assert len(names) == 14, names

# In ParaView the ball begins in the middle of the input, a fifth as large: within a closed surface
# it meets more than the empty leaf around it.
bounds = sphere.GetDataInformation().GetBounds()
middle = [(bounds[2 * axis] + bounds[2 * axis + 1]) / 2 for axis in range(3)]
extent = max(bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3))
assert numpy.allclose(neighbors.Center, middle), neighbors.Center
assert numpy.isclose(neighbors.Radius, extent / 5), neighbors.Radius
neighbors.SearchMode = "InRadius"
neighbors.UpdatePipeline()
assert neighbors.GetDataInformation().GetNumberOfCells() > 1

# The widgets, one for each search mode, and what their properties are for.
groups = {}
for i in range(neighbors.SMProxy.GetNumberOfPropertyGroups()):
    group = neighbors.SMProxy.GetPropertyGroup(i)
    if group.GetPanelWidget():
        decorator = group.GetHints().FindNestedElementByName("PropertyWidgetDecorator")
        groups[group.GetPanelWidget()] = decorator.GetAttribute("value")
        for function, name in (("Center", "Center"), ("Radius", "Radius"),
                               ("WorldPosition", "Center"), ("Input", "Input")):
            property_ = group.GetProperty(function)
            assert property_ is None or property_.GetXMLName() == name, (function, name)
assert groups == {"InteractiveSphere": "1", "InteractiveHandle": "0"}, groups

# Values reach the class. At depth 1, key 15 is a leaf.
octreetesting.check_values(neighbors, vtkHashedOctreeNeighborsFilter, {
    "Dimension": "Three", "Plane": "YZ", "MaxPointsPerLeaf": 2, "MergePoints": 1, "MaxDepth": 1,
    "FrequencyModel": "Grid", "StartDepthModel": "Fixed", "FixedStartDepth": 3,
    "IncludeEmptyLeaves": 0, "SearchMode": "InRadius", "Center": [0.5, 0.0, 0.0],
    "Radius": 0.125, "UseLeafKey": 1, "LeafKey": 15})


def leaves(source):
    """Cell arrays, field data and the boxes of the cells."""
    source.UpdatePipeline()
    cells = octreetesting.fetch(source, 0)
    assert cells.GetClassName() == "vtkUnstructuredGrid", cells
    boxes = numpy.array([cells.GetCell(i).GetBounds() for i in range(cells.GetNumberOfCells())])
    figures = octreetesting.arrays(cells.GetFieldData())
    return (octreetesting.arrays(cells.GetCellData()),
            {name: values[0] for name, values in figures.items()}, boxes)


def touch(box, boxes):
    return ((box[0::2] <= boxes[:, 1::2]) & (boxes[:, 0::2] <= box[1::2])).all(axis=1)


def meet_ball(center, radius, boxes):
    nearest = numpy.clip(center, boxes[:, 0::2], boxes[:, 1::2])
    return ((nearest - center)**2).sum(axis=1) <= radius**2


# Compared with a look at every leaf of the octree.
points = octreetesting.fetch(sphere, 0)
for empty in (0, 1):
    octree = simple.HashedOctree(Input=sphere, IncludeEmptyLeaves=empty)
    all_arrays, all_figures, all_boxes = leaves(octree)
    keys = all_arrays["MortonKey"]
    for mode in SEARCH_MODES:
        neighbors = simple.HashedOctreeNeighbors(
            Input=sphere, IncludeEmptyLeaves=empty, SearchMode=mode, Radius=0.0625,
            Center=points.GetPoint(number_of_points // 3))
        arrays, figures, boxes = leaves(neighbors)
        assert list(arrays) == octreetesting.CELL_ARRAYS + ["Role", "Case"], list(arrays)
        query = boxes[0]
        center = (query[0::2] + query[1::2]) / 2
        expected = touch(query, all_boxes) if mode == "Adjacent" else \
            meet_ball(center, 0.0625, all_boxes)
        assert len(boxes) > 3 and set(arrays["MortonKey"]) == set(keys[expected]), (empty, mode)
        rows = [numpy.nonzero(keys == key)[0][0] for key in arrays["MortonKey"]]
        for name in octreetesting.CELL_ARRAYS:
            assert (arrays[name] == all_arrays[name][rows]).all(), name
        assert (boxes == all_boxes[rows]).all()
        assert list(arrays["Role"]) == [0] + [1] * (len(boxes) - 1), arrays["Role"]
        deeper = numpy.sign(arrays["Depth"] - arrays["Depth"][0])
        assert (arrays["Case"][1:] == numpy.choose(deeper + 1, [3, 1, 2])[1:]).all()
        assert arrays["Case"][0] == 0
        for case, name in enumerate(("SameDepth", "Descended", "Above"), 1):
            assert figures[f"NumberOf{name}Neighbors"] == (arrays["Case"] == case).sum(), name
        assert figures["StartDepth"] == all_figures["StartDepth"]
        assert figures["ExaminedNodes"] >= len(boxes) - 1

        # By its key, the same leaf.
        neighbors.UseLeafKey = 1
        neighbors.LeafKey = int(arrays["MortonKey"][0].astype(numpy.int64))
        by_key, _, _ = leaves(neighbors)
        assert (by_key["MortonKey"] == arrays["MortonKey"]).all()
