# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A contour of a field in bands, about a lamp, as ParaView's window has them in the tutorial.

Usage: pvbatch contours.py GodRays.so picture.png [state.pvsm]
       paraview --script=contours.py     with the plugin loaded
"""

import sys

from paraview.simple import *

in_batch = len(sys.argv) > 2
if in_batch:
    LoadPlugin(sys.argv[1], remote=False, ns=globals())
elif GetActiveView() is not None:
    Delete(GetActiveView())  # the empty one of a new window

field = Wavelet(registrationName="Field", WholeExtent=[-20, 20, -20, 20, -20, 20])
shells = Contour(registrationName="Shells", Input=field, ContourBy=["POINTS", "RTData"])
shells.Isosurfaces = [157.0]
waves = Calculator(registrationName="Waves", Input=shells, ResultArrayName="Bands")
waves.Function = "sin(1.3*coordsZ)"
bands = Clip(registrationName="Bands", Input=waves, ClipType="Scalar", Scalars=["POINTS", "Bands"], Value=0.0)
heights = Elevation(registrationName="Heights", Input=bands, LowPoint=[0, 0, -20], HighPoint=[0, 0, 20])
lamp = Sphere(registrationName="Lamp", Radius=2.5, Center=[0, 0, 0], ThetaResolution=32, PhiResolution=32)

view = CreateView("GodRaysRenderView")
if not in_batch:
    AssignViewToLayout(view)
view.ViewSize = [800, 600]
view.UseColorPaletteForBackground = 0
view.Background = [0.02, 0.03, 0.06]
view.OrientationAxesVisibility = 0
shown = Show(heights, view)
ColorBy(shown, ("POINTS", "Elevation"))
table = GetColorTransferFunction("Elevation")
table.RGBPoints = [0, 0.23, 0.3, 0.75, 0.35, 0.2, 0.7, 0.75, 0.7, 0.95, 0.75, 0.3, 1, 0.98, 0.93, 0.8]
table.ColorSpace = "Lab"
shown.SetScalarBarVisibility(view, False)
bulb = Show(lamp, view)
bulb.AmbientColor = bulb.DiffuseColor = [1, 0.9, 0.7]
bulb.Ambient, bulb.Diffuse, bulb.Specular = 1, 0, 0
bulb.GodRaysRole = "Light"
view.LightSource = "What is tagged as a light"
view.Preset = "low-sun"
view.Intensity = 1.5
view.CameraPosition = [55, -78, 30]
view.CameraFocalPoint = [0, 0, 0]
view.CameraViewUp = [0, 0, 1]
Render(view)
if in_batch:
    SaveScreenshot(sys.argv[2], view)
    if len(sys.argv) > 3:
        SaveState(sys.argv[3])
