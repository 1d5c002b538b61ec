#!/usr/bin/env pvbatch
# SPDX-License-Identifier: BSD-3-Clause
# The cell, coloured by tension, in the flow field of its mid-plane.
#   xvfb-run -a -s -noreset pvbatch cell_in_flow.py RUN/snapshots picture.png 3.3      the brightest yellow is 3.3 mm/s
import sys
from paraview.simple import *

folder, out, fastest = sys.argv[1], sys.argv[2], float(sys.argv[3])
cells = XDMFReader(FileNames=[folder + "/cells.xdmf"])
fields = XDMFReader(FileNames=[folder + "/fields.xdmf"])
view = CreateView("RenderView")
view.ViewSize = [640, 400]
view.ViewTime = list(fields.TimestepValues)[-1]
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
view.OrientationAxesVisibility = 0
cells.UpdatePipeline(view.ViewTime)
box = cells.GetDataInformation().GetBounds()
x = (box[0] + box[1]) / 2
fields.UpdatePipeline(view.ViewTime)
_, _, _, width, _, height = fields.GetDataInformation().GetBounds()

surface = Show(GenerateSurfaceNormals(ExtractSurface(cells)), view)
ColorBy(surface, ("POINTS", "tension_uN_per_m"))
tension = GetColorTransferFunction("tension_uN_per_m")
tension.RescaleTransferFunction(-12, 12)
surface.SetScalarBarVisibility(view, True)
bar = GetScalarBar(tension, view)
bar.Title, bar.ComponentTitle, bar.TitleColor, bar.LabelColor = "tension, µN/m", "", [0, 0, 0], [0, 0, 0]
bar.TitleFontSize, bar.LabelFontSize = 16, 14
bar.Orientation, bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Horizontal", "Any Location", [0.3, 0.02], 0.4
bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.0f", "%.0f"

piece = Clip(fields)
piece.ClipType = "Box"
piece.ClipType.Position, piece.ClipType.Length = [x - 10, 0, 0], [20, width, height]
plane = Slice(piece)
plane.SliceType.Normal, plane.SliceType.Origin = [0, 1, 0], [x, width / 2, 0]
wall = Transform(plane)  # drawn on the far wall, so that it does not cut the cell
wall.Transform.Translate = [0, width / 2, 0]
flow = Show(wall, view)
flow.Ambient, flow.Diffuse = 1, 0
ColorBy(flow, ("POINTS", "velocity_mm_per_s", "X"))
velocity = GetColorTransferFunction("velocity_mm_per_s")
velocity.ApplyPreset("Viridis (matplotlib)", True)
velocity.RescaleTransferFunction(0, fastest)
frame = Show(Outline(piece), view)
frame.AmbientColor = frame.DiffuseColor = [0.3, 0.3, 0.3]
view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [x, width / 2, 4], [x + 6.5, -13.5, 10], [0, 0, 1]
Render(view)
SaveScreenshot(out, view)
