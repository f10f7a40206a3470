# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A surface of data that is split over processes, before the sun; a ball of light in it.

Usage: mpirun -np 4 pvbatch parallel.py GodRays.so picture.png
"""

import sys

from paraview.simple import *

plugin, picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())

view = CreateView("GodRaysRenderView")
view.ViewSize = [480, 360]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.03, 0.03, 0.06]

data = Wavelet(WholeExtent=[-20, 20, -20, 20, -20, 20])  # each process makes a part of it
surface = Contour(Input=data, ContourBy=["POINTS", "RTData"], Isosurfaces=[130.0, 200.0])
shown = Show(surface, view)
shown.ColorArrayName = ["POINTS", ""]
shown.DiffuseColor = [0.3, 0.35, 0.45]

ball = Show(Sphere(Radius=4.0, ThetaResolution=32, PhiResolution=32), view)
ball.ColorArrayName = ["POINTS", ""]
ball.AmbientColor = ball.DiffuseColor = [1.0, 0.85, 0.5]
ball.Ambient, ball.Diffuse = 1.0, 0.0

view.LightSource = "What is tagged as a light"
ball.GodRaysRole = "Light"
view.BackgroundGlowFalloff = 20  # degrees: all the gaps about the ball shine
view.CameraPosition = [55, 25, 70]
view.CameraFocalPoint = [0, 0, 0]
SaveScreenshot(picture, view)
