# SPDX-License-Identifier: BSD-3-Clause
"""What comes back when a session is saved: as ParaView's state, and as a script in Python."""
import os

import octreetesting
from paraview import servermanager, simple, smstate


def show(filter_, port):
    """Shows a port in the view that ParaView prefers for it."""
    controller = servermanager.ParaViewPipelineController()
    view = controller.ShowInPreferredView(filter_.SMProxy, port, None)
    simple.Render(servermanager._getPyProxy(view))


def make_session():
    """All filters and the locator, with hardly a property at its default."""
    path, _ = octreetesting.write_sphere()
    sphere = simple.OpenDataFile(path)
    sphere.UpdatePipeline()
    tree = {"Dimension": "Two", "Plane": "XZ", "MaxPointsPerLeaf": 3, "MaxDepth": 9,
            "FrequencyModel": "Grid", "StartDepthModel": "Fixed", "FixedStartDepth": 2}
    leaves = simple.HashedOctree(Input=sphere, **tree)
    keys = octreetesting.arrays(octreetesting.fetch(leaves, 0).GetCellData())["MortonKey"]
    simple.Delete(leaves)

    octree = simple.HashedOctree(
        registrationName="Octree", Input=sphere, OutputType="Outlines", IncludeEmptyLeaves=1,
        IncludeInternalNodes=1, UseCustomBounds=1, CustomBounds=[-2.0, 2.0, -3.0, 3.0, -4.0, 4.0],
        **tree)
    for port in range(3):
        show(octree, port)
    simple.HashedOctreeNeighbors(
        registrationName="Neighbors", Input=sphere, SearchMode="InRadius", Center=[0.1, 0.2, 0.3],
        Radius=0.2, UseLeafKey=1, LeafKey=int(keys[17]), IncludeEmptyLeaves=0, **tree)
    simple.HashedOctreeLocate(
        registrationName="Locate", Input=sphere, QueryPoints=simple.PointSource(NumberOfPoints=9),
        IncludeEmptyLeaves=1, **tree)
    interpolator = simple.PointLineInterpolator(
        registrationName="Interpolator", Input=sphere, Source="Line",
        Locator="Hashed Octree Point Locator")
    interpolator.Locator.MaxPointsPerLeaf = 5
    interpolator.Locator.StartDepthModel = "Local"


def describe_properties(proxy):
    """All values by name; what is a proxy is not among them."""
    properties = map(proxy.GetProperty, proxy.ListProperties())
    return {property_.GetXMLName(): octreetesting.elements(property_) for property_ in
            (property_.SMProperty for property_ in properties)
            if not property_.IsA("vtkSMProxyProperty")}


def describe_session():
    """Of each filter the properties and how much it gives, of each chart what it draws."""
    described = {}
    for name in ("Octree", "Neighbors", "Locate", "Interpolator"):
        filter_ = simple.FindSource(name)
        filter_.UpdatePipeline()
        information = filter_.GetDataInformation()
        described[name] = information.GetNumberOfCells(), information.GetNumberOfPoints()
        described[name, "properties"] = describe_properties(filter_)
    locator = simple.FindSource("Interpolator").Locator
    described["Locator", "properties"] = describe_properties(locator)
    for view in simple.GetViews():
        if view.GetXMLName() != "RenderView":
            shown, = view.Representations
            described[view.GetXMLName()] = (
                shown.GetXMLName(), shown.XArrayName, sorted(shown.SeriesVisibility),
                sorted(zip(*[iter(shown.SeriesLabel)] * 2)), view.BottomAxisTitle,
                view.LeftAxisTitle)
    return described


make_session()
before = describe_session()
assert before["Neighbors"][0] > 1, before["Neighbors"]
assert {"HashedOctreeDepthHistogramView", "HashedOctreeCostCurvesView"} < set(before), set(before)
state = os.path.join(octreetesting.argument("-T"), "session.pvsm")
simple.SaveState(state)
script = smstate.get_state()

for load in (lambda: simple.LoadState(state), lambda: exec(script, {})):
    simple.ResetSession()
    assert not simple.GetSources()
    load()
    after = describe_session()
    assert set(after) == set(before), set(after) ^ set(before)
    for name in before:
        assert after[name] == before[name], (name, before[name], after[name])
