# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What ParaView's window has in its pipeline at the beginning of TestGodRaysWindow."""

from paraview.simple import *

line = Line(registrationName="Line", Point1=[-2.3, 0, 0], Point2=[2.3, 0, 0], Resolution=10)
columns = Glyph(registrationName="Columns", Input=line, GlyphType="Box", GlyphMode="All Points")
columns.GlyphType.XLength, columns.GlyphType.YLength, columns.GlyphType.ZLength = 0.2, 2.4, 0.2
columns.OrientationArray = ["POINTS", "No orientation array"]
columns.ScaleArray = ["POINTS", "No scale array"]
columns.ScaleFactor = 1.0
lantern = Sphere(registrationName="Lantern", Radius=0.35, Center=[-0.2, 0.25, -1])
lantern.ThetaResolution = lantern.PhiResolution = 48
