# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView opens for each output by itself: cells, points, charts, a table."""
import octreetesting
from paraview import servermanager, simple

octree = simple.HashedOctree(Input=simple.Sphere(ThetaResolution=64, PhiResolution=64))
octree.UpdatePipeline()
controller = servermanager.ParaViewPipelineController()
LABELS = {1: {"Empty leaves", "All leaves", "Points"},
          2: {"Grid", "Leaves", "Points", "Leaves, measured", "Points, measured",
              "Chosen start depth"}}


def show(port, filter_=octree):
    """The view that ParaView prefers for a port, with the port shown in it."""
    view = servermanager._getPyProxy(
        controller.ShowInPreferredView(filter_.SMProxy, port, None))
    view.ViewSize = [400, 300]
    simple.Render(view)
    return view, view.Representations[0]


def drawn(shown):
    """What a chart's legend says, and how many rows the table has that is drawn."""
    chart = shown.SMProxy.GetClientSideObject().GetChart()
    plots = [plot for plot in map(chart.GetPlot, range(chart.GetNumberOfPlots()))
             if plot.GetVisible() and plot.GetLabel()]
    return {plot.GetLabel() for plot in plots}, plots[0].GetInput().GetNumberOfRows()


view, shown = show(0)
assert view.GetXMLName() == "RenderView", view.GetXMLName()
assert list(shown.ColorArrayName) == ["CELLS", "Depth"], shown.ColorArrayName

# A hyper tree grid is drawn as cells are, also where these were before.
of_grid = simple.HashedOctree(Input=octree.Input, OutputType="HyperTreeGrid")
of_grid.UpdatePipeline()
view, shown = show(0, of_grid)
assert view.GetXMLName() == "RenderView", view.GetXMLName()
assert list(shown.ColorArrayName) == ["CELLS", "Depth"], shown.ColorArrayName
alone = simple.CreateView("RenderView")
turned = simple.HashedOctree(Input=octree.Input)
simple.Show(turned, alone)
drawn_bounds = []
for kind in ("Voxels", "HyperTreeGrid", "Voxels"):
    turned.OutputType = kind
    turned.UpdatePipeline() # As by Apply: without it ParaView 5.13 draws nothing of another type.
    simple.Render(alone)
    drawn_bounds.append(alone.GetRenderer().ComputeVisiblePropBounds())
assert drawn_bounds[0] == drawn_bounds[2] and drawn_bounds[0][0] < drawn_bounds[0][1], drawn_bounds
assert all(abs(a - b) < 1e-5 for a, b in zip(*drawn_bounds[:2])), drawn_bounds

# A view goes on after an error, and after an input without points, both of which it shows as nothing.
heights = simple.Elevation(Input=octree.Input, LowPoint=[0.0, 0.0, -0.5], HighPoint=[0.0, 0.0, 0.5])
some = simple.Threshold(Input=heights, Scalars=["POINTS", "Elevation"])
mended = simple.HashedOctree(Input=some, UseCustomBounds=1)
simple.Show(mended, alone)
simple.Hide(turned, alone)
for lower, upper, least in ((0.0, 0.5, 0.0), (0.5, 0.0, 0.0), (-0.5, 0.5, 0.0), (-0.5, 0.5, 2.0),
                            (0.0, 0.5, 0.0)):
    mended.CustomBounds = [lower, upper] * 3
    some.LowerThreshold, some.UpperThreshold = least, 3.0
    simple.Render(alone)
    bounds = alone.GetRenderer().ComputeVisiblePropBounds()
    if lower > upper or least > 1.0:
        assert bounds[0] > bounds[1], bounds
    else:
        assert abs(bounds[0] - lower) < 0.1 and abs(bounds[1] - upper) < 0.1, bounds

view, shown = show(2)
assert view.GetXMLName() == "HashedOctreeCostCurvesView", view.GetXMLName()
assert shown.XArrayName == "StartDepth" and not shown.UseIndexForXAxis
labels = list(shown.SeriesLabel)
assert labels[labels.index("ContinuousLeaves") + 1] == "Leaves, continuous (at depth + 1/2)", labels
# In the order of the panel's list, which it would put them into when it is shown. Not the continuous
# cost, which belongs half a depth further on.
drawn_costs = set(octreetesting.COSTS) - {"StartDepth", "ContinuousLeaves"}
assert list(shown.SeriesVisibility) == sorted(drawn_costs), shown.SeriesVisibility
assert view.BottomAxisTitle and view.LeftAxisTitle
assert view.BottomAxisUseCustomLabels and list(view.BottomAxisLabels)[:4] == ["0", "0", "1", "1"]

# The eye of a table shows it in the active view: if that is the other one's chart, it stays as it is.
for port in (1, 2):
    view, shown = show(port)
    simple.Show(servermanager.OutputPort(octree, 3 - port), view)
    simple.Render(view)
    assert len(view.Representations) == 2, view.Representations
    assert drawn(shown)[0] == LABELS[port], drawn(shown)

# Charts draw the tables of composite data, and what is chosen for a column holds in every block.
blocks = simple.GroupDatasets(Input=[octree.Input, simple.Sphere(Center=[9.0, 0.0, 0.0])])
partitions = simple.ConvertToPartitionedDataSetCollection(Input=octree.Input)
for composite in (blocks, partitions):
    of_composite = simple.HashedOctree(Input=composite)
    of_composite.UpdatePipeline()
    for port, columns in ((1, octreetesting.HISTOGRAM), (2, octreetesting.COSTS)):
        view, shown = show(port, of_composite)
        for name in shown.ListProperties():
            if name.startswith("Series") and name != "SeriesLabelPrefix":
                available = list(shown.GetProperty(name).Available)
                assert available == sorted(columns), (name, available)
        assert drawn(shown)[0] == LABELS[port], drawn(shown)
        if composite is blocks:
            rows = drawn(shown)[1]
            shown.CompositeDataSetIndex = [2]
            simple.Render(view)
            labels, fewer = drawn(shown)
            assert labels == LABELS[port] and fewer < rows, (labels, fewer, rows)

# The charts take tables only: of a mesh, or a line, they would draw nothing but a legend.
line = simple.PlotOverLine(Input=simple.Wavelet())
line.UpdatePipeline()
for port in (1, 2):
    view, _ = show(port)
    for filter_ in (octree, of_composite):
        assert view.SMProxy.CanDisplayData(filter_.SMProxy, port)
        assert not view.SMProxy.CanDisplayData(filter_.SMProxy, 0)
    assert not view.SMProxy.CanDisplayData(line.SMProxy, 0)

# Query points without cells must be seen, too.
locate = simple.HashedOctreeLocate(Input=octree.Input, QueryPoints=simple.PointSource())
locate.UpdatePipeline()
view, shown = show(0, locate)
assert view.GetXMLName() == "RenderView", view.GetXMLName()
assert shown.Representation == "Point Gaussian", shown.Representation
assert list(shown.ColorArrayName) == ["POINTS", "HitCost"], shown.ColorArrayName
view, shown = show(1, locate)
assert view.GetXMLName() == "SpreadSheetView", view.GetXMLName()

view, shown = show(1)
assert view.GetXMLName() == "HashedOctreeDepthHistogramView", view.GetXMLName()
assert shown.XArrayName == "Depth" and not shown.UseIndexForXAxis
assert list(shown.SeriesVisibility) == ["EmptyLeaves", "Leaves", "Points"], shown.SeriesVisibility
assert view.BottomAxisTitle and view.LeftAxisTitle
assert view.BottomAxisUseCustomLabels and list(view.BottomAxisLabels)[:4] == ["0", "0", "1", "1"]
octreetesting.compare_with_baseline(view)
