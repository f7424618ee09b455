# SPDX-License-Identifier: BSD-3-Clause
"""The locator's proxy against its class, and in the interpolators that offer it."""
import octreetesting  # loads the plugin
import numpy
from hashedoctree import vtkHashedOctreePointLocator
from paraview import servermanager, simple

ENUMERATIONS = {
    "FrequencyModel": ["Leaves", "Points", "Grid"],
    "StartDepthModel": ["Median", "Mean", "Root", "Fixed", "Local"],
}
PROPERTIES = ["MaxPointsPerLeaf", "MaxDepth", "FixedStartDepth"] + list(ENUMERATIONS)
proxy = servermanager.ProxyManager().NewProxy("point_locators", "HashedOctreePointLocator")

# Every property of the class is one of the proxy, and no others.
own = set(dir(vtkHashedOctreePointLocator)) - set(dir(vtkHashedOctreePointLocator.__bases__[0]))
assert {name[3:] for name in own if name.startswith("Set")} == set(PROPERTIES), own
iterator = proxy.NewPropertyIterator()
names = set()
while not iterator.IsAtEnd():
    names.add(iterator.GetKey())
    iterator.Next()
assert names == set(PROPERTIES), names

for name in PROPERTIES:
    property_ = proxy.GetProperty(name)
    octreetesting.check_property(property_, vtkHashedOctreePointLocator(), name,
                                 ENUMERATIONS.get(name))

# All interpolators offer it, after ParaView's own, which stays the default.
wavelet = simple.Wavelet(WholeExtent=[-5, 5] * 3)
target = simple.Sphere(Radius=4.0, Center=[0.1234, 0.2345, 0.3456], ThetaResolution=30)
INTERPOLATORS = [kind + shape + "Interpolator" for kind in ("Point", "SPH")
                 for shape in ("Dataset", "Line", "Plane", "Volume")]
LOCATORS = ["StaticPointLocator", "HashedOctreePointLocator"]
for name in INTERPOLATORS:
    filter_ = servermanager._getPyProxy(servermanager.ProxyManager().NewProxy("filters", name))
    filter_.SMProxy.ResetPropertiesToDefault()
    property_ = filter_.SMProxy.GetProperty("Locator")
    domain = property_.FindDomain("vtkSMProxyListDomain")
    offered = [domain.GetProxy(i).GetXMLName() for i in range(domain.GetNumberOfProxies())]
    assert offered == LOCATORS, (name, offered)
    assert property_.GetProxy(0).GetXMLName() == LOCATORS[0], name


def interpolate(kernel, locator, values=None):
    filter_ = simple.PointDatasetInterpolator(Input=wavelet, Source=target)
    filter_.Kernel = kernel
    filter_.Locator = locator
    for name, value in (values or {}).items():
        setattr(filter_.Locator, name, value)
    filter_.UpdatePipeline()
    used = filter_.GetClientSideObject().GetLocator()
    output = octreetesting.fetch(filter_, 0)
    return used, octreetesting.arrays(output.GetPointData())


for kernel in ("VoronoiKernel", "GaussianKernel", "ShepardKernel"):
    used, expected = interpolate(kernel, "Static Point Locator")
    assert used.GetClassName() == "vtkStaticPointLocator", used
    for values in ({}, {"StartDepthModel": "Fixed", "FixedStartDepth": 2, "MaxPointsPerLeaf": 3}):
        used, actual = interpolate(kernel, "Hashed Octree Point Locator", values)
        assert used.GetClassName() == "vtkHashedOctreePointLocator", used
        assert used.GetStartDepth() == 2 or not values, used
        assert used.GetLevel() > 0
        assert "RTData" in expected and set(actual) == set(expected), (set(actual), set(expected))
        for name, array in expected.items():
            assert array.size > 0 and numpy.allclose(array, actual[name], rtol=1e-5), (kernel, name)
