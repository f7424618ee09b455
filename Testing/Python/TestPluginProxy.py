# SPDX-License-Identifier: BSD-3-Clause
"""The proxy against the class that it stands for: names, defaults, ranges, values."""
import octreetesting  # loads the plugin
from hashedoctree import vtkHashedOctreeFilter
from paraview import servermanager, simple

ENUMERATIONS = {
    "FrequencyModel": ["Leaves", "Points", "Grid"],
    "StartDepthModel": ["Median", "Mean", "Root", "Fixed"],
    "OutputType": ["Voxels", "Outlines"],
}
filter_ = vtkHashedOctreeFilter()
# Not through simple, where domains bring defaults of their own.
proxy = servermanager.ProxyManager().NewProxy("filters", "HashedOctree")


def elements(name):
    property_ = proxy.GetProperty(name)
    return tuple(property_.GetElement(i) for i in range(property_.GetNumberOfElements()))


def value_of_class(name):
    value = getattr(filter_, "Get" + name)()
    return value if isinstance(value, tuple) else (value,)


# Every property of the class is one of the proxy, with the same name, and no others.
own = set(dir(vtkHashedOctreeFilter)) - set(dir(vtkHashedOctreeFilter.__bases__[0]))
names = {name[3:] for name in own
         if name.startswith("Set") and "Get" + name[3:] in own and "To" not in name[3:]}
assert len(names) == 10, names
octree = simple.HashedOctree(Input=simple.Sphere())
assert set(octree.ListProperties()) == names | {"Input"}, octree.ListProperties()

for name in sorted(names):
    # Defaults.
    assert elements(name) == value_of_class(name), (name, elements(name), value_of_class(name))
    # Documentation.
    text = proxy.GetProperty(name).GetDocumentation().GetDescription()
    assert text and len(text.strip()) > 20, name
    # Ranges: what the domain does not allow, the class clamps.
    domain = proxy.GetProperty(name).FindDomain("vtkSMIntRangeDomain")
    if domain:
        for exists, limit, beyond in ((domain.GetMinimumExists(0), domain.GetMinimum(0), -2**31),
                                      (domain.GetMaximumExists(0), domain.GetMaximum(0), 2**31 - 1)):
            getattr(filter_, "Set" + name)(beyond)
            expected = limit if exists else beyond
            assert value_of_class(name) == (expected,), (name, value_of_class(name), expected)
    # Names of values.
    domain = proxy.GetProperty(name).FindDomain("vtkSMEnumerationDomain")
    if name in ENUMERATIONS:
        entries = {domain.GetEntryText(i): domain.GetEntryValue(i)
                   for i in range(domain.GetNumberOfEntries())}
        expected = {text: getattr(vtkHashedOctreeFilter, text) for text in ENUMERATIONS[name]}
        assert entries == expected, (name, entries, expected)

# Values reach the class.
values = {"MaxPointsPerLeaf": 7, "MaxDepth": 9, "FrequencyModel": "Grid",
          "StartDepthModel": "Fixed", "FixedStartDepth": 3, "OutputType": "Outlines",
          "IncludeEmptyLeaves": 1, "IncludeInternalNodes": 1, "UseCustomBounds": 1,
          "CustomBounds": [-2.0, 2.0, -3.0, 3.0, -4.0, 4.0]}
assert set(values) == names
for name, value in values.items():
    setattr(octree, name, value)
octree.UpdatePipeline()
filter_ = octree.GetClientSideObject()
for name, value in values.items():
    value = getattr(vtkHashedOctreeFilter, value) if isinstance(value, str) else value
    value = tuple(value) if isinstance(value, list) else (value,)
    assert value_of_class(name) == value, (name, value_of_class(name), value)

# In ParaView the custom bounds begin as those of the input.
sphere = simple.Sphere(Radius=5.0, Center=[1.0, 2.0, 3.0], ThetaResolution=64, PhiResolution=64)
sphere.UpdatePipeline()
octree = simple.HashedOctree(Input=sphere)
bounds = sphere.GetDataInformation().GetBounds()
assert tuple(octree.CustomBounds) == bounds, (octree.CustomBounds, bounds)

# Names of the ports.
assert [octree.GetOutputPort(name).Port for name in
        ("Octree", "Depth Histogram", "Cost Curves")] == [0, 1, 2]
