# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture of the whole sky: its radiance as .hdr, or as .png to look at.

Usage: SkyImage.py picture.hdr|picture.png [paraboloid|equirectangular|fisheye]
                   [time latitude longitude | elevation azimuth]
Times are as 2024-06-21T20:45+02:00; angles are in degrees, azimuths from north by east.
"""

import sys

import godrays
import vtkmodules.all as vtk

sky = godrays.vtkGodRaysSkySource()
sky.SetResolution(256)
sky.SunDiscOn()
sky.MultipleScatteringOn()
output, *arguments = sys.argv[1:] or [""]
if not output.endswith((".hdr", ".png")):
    sys.exit(__doc__)
mappings = {
    "paraboloid": sky.PARABOLOID,
    "equirectangular": sky.EQUIRECTANGULAR,
    "fisheye": sky.FISHEYE,
}
if arguments and arguments[0] in mappings:
    sky.SetMapping(mappings[arguments.pop(0)])

time, numbers = "2024-06-21T20:00+02:00", (43.77, 11.26)  # Florence on an evening in June
if len(arguments) in (2, 3):
    try:
        numbers = [float(each) for each in arguments[-2:]]
    except ValueError:
        sys.exit(__doc__)
elif arguments:
    sys.exit(__doc__)
if len(arguments) != 2:
    sun = godrays.vtkGodRaysSunPosition()
    if not sun.SetDateTime(arguments[0] if arguments else time):
        sys.exit(1)
    sun.SetLatitude(numbers[0])
    sun.SetLongitude(numbers[1])
    numbers = sun.GetElevation(), sun.GetAzimuth()
sky.SetSunElevation(numbers[0])
sky.SetSunAzimuth(numbers[1])

if output.endswith(".hdr"):
    writer = godrays.vtkGodRaysHDRWriter()
    writer.SetInputConnection(sky.GetOutputPort())
else:
    shown = godrays.vtkGodRaysToneMappingFilter()
    shown.SetInputConnection(sky.GetOutputPort())
    shown.SetKey(0.36)  # a bright picture
    if sky.GetMapping() != sky.EQUIRECTANGULAR:  # The corners, which look down, are black.
        size = sky.GetResolution()
        circle = vtk.vtkImageEllipsoidSource()
        circle.SetWholeExtent(0, size - 1, 0, size - 1, 0, 0)
        circle.SetCenter((size - 1) / 2, (size - 1) / 2, 0)
        circle.SetRadius(size / 2, size / 2, 1)
        upper = vtk.vtkImageMask()
        upper.SetInputConnection(0, shown.GetOutputPort())
        upper.SetInputConnection(1, circle.GetOutputPort())
        shown = upper
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(shown.GetOutputPort())
writer.SetFileName(output)
writer.Write()
sys.exit(1 if writer.GetErrorCode() else 0)
