# SPDX-License-Identifier: BSD-3-Clause
"""The proxy against the class that it stands for: names, defaults, ranges, values."""
import octreetesting  # loads the plugin
from hashedoctree import vtkHashedOctreeFilter
from paraview import simple

octree = simple.HashedOctree(Input=simple.Sphere())
names = octreetesting.check_properties(octree, vtkHashedOctreeFilter,
                                       {"OutputType": ["Voxels", "Outlines", "HyperTreeGrid"]})
assert len(names) == 13, names

# Values reach the class.
values = {"Dimension": "Two", "Plane": "XZ", "MaxPointsPerLeaf": 7, "MergePoints": 1, "MaxDepth": 9,
          "FrequencyModel": "Grid", "StartDepthModel": "Fixed", "FixedStartDepth": 3,
          "OutputType": "Outlines", "IncludeEmptyLeaves": 1, "IncludeInternalNodes": 1,
          "UseCustomBounds": 1,
          "CustomBounds": [-2.0, 2.0, -3.0, 3.0, -4.0, 4.0]}
assert set(values) == names
octreetesting.check_values(octree, vtkHashedOctreeFilter, values)

# What is used with one value of another property only, or with all but one, is shown with these.
for name, other, value, is_hidden in (
        ("Plane", "Dimension", vtkHashedOctreeFilter.Two, False),
        ("IncludeInternalNodes", "OutputType", vtkHashedOctreeFilter.HyperTreeGrid, True)):
    decorator = octree.SMProxy.GetProperty(name).GetHints().FindNestedElementByName(
        "PropertyWidgetDecorator")
    assert decorator.GetAttribute("property") == other
    assert decorator.GetAttribute("value") == str(value)
    assert decorator.GetAttribute("inverse") == ("1" if is_hidden else None)

# In ParaView the custom bounds begin as those of the input.
sphere = simple.Sphere(Radius=5.0, Center=[1.0, 2.0, 3.0], ThetaResolution=64, PhiResolution=64)
sphere.UpdatePipeline()
octree = simple.HashedOctree(Input=sphere)
bounds = sphere.GetDataInformation().GetBounds()
assert tuple(octree.CustomBounds) == bounds, (octree.CustomBounds, bounds)

# Names of the ports.
assert [octree.GetOutputPort(name).Port for name in
        ("Octree", "Depth Histogram", "Cost Curves")] == [0, 1, 2]
