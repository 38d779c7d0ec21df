# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The pipeline before the clicks of panel.xml: the demo's elephant and a drill, from files."""

import os

from paraview import simple

folder = os.environ["SCREENSHOT_MESHES"]
upright = simple.Cylinder(Radius=0.072, Height=0.8, Resolution=128)
placed = simple.Transform(Input=upright)
placed.Transform.Rotate = [75, 0, -90]
placed.Transform.Translate = [-0.075, -0.17, 0.02]
mesh = simple.LegacyVTKReader(FileNames=[os.path.join(folder, "elephant.vtk")])
smooth = simple.GenerateSurfaceNormals(Input=mesh, Splitting=0)
names = ("smooth elephant.vtk", "drill.vtk")
for name, source in zip(names, (smooth, placed)):
    simple.SaveData(os.path.join(folder, name), proxy=source)
for source in (smooth, mesh, placed, upright):
    simple.Delete(source)

view = simple.GetActiveViewOrCreate("RenderView")
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
for name in names:
    path = os.path.join(folder, name)
    simple.Show(simple.LegacyVTKReader(registrationName=name, FileNames=[path]), view)
simple.SetActiveSource(simple.FindSource(names[0]))
view.CameraPosition = [0.68, 0.545, 4.0]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 1, 0]
simple.Render(view)
