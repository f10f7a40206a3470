# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A colonnade before a low sun.

Usage: pvbatch built_in.py GodRays.so picture.png
"""

import sys

from paraview.simple import *

plugin, picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())

view = CreateView("GodRaysRenderView")
view.ViewSize = [480, 360]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0.08, 0.1, 0.18]

parts = [Box(XLength=5, YLength=0.3, ZLength=0.3, Center=[0, 1.3, 0])]
for x in (-2.2, -1.6, -1.05, -0.45, 0.15, 0.8, 1.35, 2.0):
    parts.append(Box(XLength=0.3, YLength=2.4, ZLength=0.3, Center=[x, 0, 0]))
for part in parts:
    shown = Show(part, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = [0.45, 0.45, 0.4]

view.SunAzimuth, view.SunElevation = 4, 9
view.SunColor = [1.0, 0.85, 0.6]
view.CameraPosition = [0, 0, 8]
view.CameraFocalPoint = [0, 0, 0]
SaveScreenshot(picture, view)
