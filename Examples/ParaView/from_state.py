# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Show what a state file shows, as it shows it, with god rays.

Usage: pvbatch from_state.py GodRays.so state.pvsm picture.png
"""

import sys

from paraview.simple import *

plugin, state, picture = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
LoadState(state)

former = GetActiveViewOrCreate("RenderView")
view = CreateView("GodRaysRenderView")
view.SMProxy.Copy(former.SMProxy, "vtkSMProxyProperty")  # all but what it shows
view.UpdateVTKObjects()
for shown in former.Representations:
    if shown.Visibility:
        again = Show(shown.Input, view)
        again.SMProxy.Copy(shown.SMProxy, "vtkSMProxyProperty")
        again.LookupTable = shown.LookupTable
view.Preset = "low-sun"
SaveScreenshot(picture, view)
