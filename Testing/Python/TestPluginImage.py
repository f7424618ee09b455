# SPDX-License-Identifier: BSD-3-Clause
"""Octree cells as ParaView shows them by default: leaves as boxes, coloured by depth."""
import octreetesting
from demo import white_view
from paraview import simple

view = white_view(300, 300)

sphere = simple.Sphere(ThetaResolution=32, PhiResolution=32)
octree = simple.HashedOctree(Input=sphere)
shown = simple.Show(octree, view)
assert shown.Representation == "Surface", shown.Representation
assert list(shown.ColorArrayName) == ["CELLS", "Depth"], shown.ColorArrayName

simple.GetColorTransferFunction("Depth").ApplyPreset("Cool to Warm", True)  # ParaView 6 has another default

simple.ResetCamera(view)
view.CameraPosition = [2.0, 1.5, 1.8]
view.CameraFocalPoint = [0.0, 0.0, 0.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
simple.Render(view)
octreetesting.compare_with_baseline(view)
