# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The pipeline before the click of window.xml: a plate and a ball, both selected in this order."""

from paraview import servermanager, simple

plate = simple.Box(registrationName="plate", XLength=3, YLength=1, ZLength=2)
ball = simple.Sphere(registrationName="ball", Center=[0.5, 0.7, 0.3], Radius=0.8, ThetaResolution=96, PhiResolution=96)
view = simple.GetActiveViewOrCreate("RenderView")
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]
for source in (plate, ball):
    simple.Show(source, view)
view.CameraPosition = [3.2, 3.6, 5.2]
view.CameraFocalPoint = [0.1, 0.1, 0]
view.CameraViewUp = [0, 1, 0]
simple.Render(view)
selection = servermanager.ProxyManager().GetSelectionModel("ActiveSources")
selection.SetCurrentProxy(plate.SMProxy, selection.CLEAR_AND_SELECT)
selection.Select(ball.SMProxy, selection.SELECT)
