# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView opens for each output by itself: cells, points, charts, a table."""
import sys

import octreetesting  # loads the plugin
from paraview import servermanager, simple, smtesting

smtesting.ProcessCommandLineArguments()
octree = simple.HashedOctree(Input=simple.Sphere(ThetaResolution=64, PhiResolution=64))
octree.UpdatePipeline()
controller = servermanager.ParaViewPipelineController()


def show(port, filter_=octree):
    """The view that ParaView prefers for a port, with the port shown in it."""
    view = servermanager._getPyProxy(
        controller.ShowInPreferredView(filter_.SMProxy, port, None))
    view.ViewSize = [400, 300]
    simple.Render(view)
    return view, view.Representations[0]


view, shown = show(0)
assert view.GetXMLName() == "RenderView", view.GetXMLName()
assert list(shown.ColorArrayName) == ["CELLS", "Depth"], shown.ColorArrayName

view, shown = show(2)
assert view.GetXMLName() == "HashedOctreeCostCurvesView", view.GetXMLName()
assert shown.XArrayName == "StartDepth" and not shown.UseIndexForXAxis
# In the order of the panel's list, which it would put them into when it is shown.
assert list(shown.SeriesVisibility) == sorted(octreetesting.COSTS[1:]), shown.SeriesVisibility
assert view.BottomAxisTitle and view.LeftAxisTitle

# Charts draw the tables of partitioned data sets, too.
partitions = simple.ConvertToPartitionedDataSetCollection(Input=octree.Input)
of_partitions = simple.HashedOctree(Input=partitions)
of_partitions.UpdatePipeline()
view, shown = show(1, of_partitions)
series = list(shown.GetProperty("SeriesVisibility").Available)
assert any(name.startswith("Leaves (") for name in series), series

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
if not smtesting.DoRegressionTesting(view.SMProxy):
    sys.exit("The picture differs from the baseline.")
