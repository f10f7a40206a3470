#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Make PNGs of the sky over a day: python3 make_sky.py <folder>

Each is a fisheye picture with the zenith in the middle, and a strip of the horizon, azimuth from north by
east over south to west. The sun is set by date and place. Colours are divided by the sun's, exposed for
the picture and encoded for the display.
"""

import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

import godrays

# Name, date and time in Florence, height of the observer [m], atmosphere.
PICTURES = (
    ("sky-noon", "2024-06-21T13:15:00+02:00", 2.0, "earth-clear"),
    ("sky-low-sun", "2024-06-21T20:45:00+02:00", 2.0, "earth-hazy"),
    ("sky-dusk", "2024-06-21T21:15:00+02:00", 2.0, "earth-clear"),
)
SIZE = 160  # pixels: the height of a picture


def make_source(time, height, atmosphere):
    sun = godrays.vtkGodRaysSunPosition()
    sun.SetDateTime(time)
    sun.SetLatitude(43.77)
    sun.SetLongitude(11.26)
    source = godrays.vtkGodRaysSkySource()
    source.GetAtmosphere().LoadPreset(atmosphere)
    source.SetObserverHeight(height)
    source.SetSunElevation(sun.GetElevation())
    source.SetSunAzimuth(sun.GetAzimuth())
    source.SunDiscOn()
    source.MultipleScatteringOn()
    return source


def render(source, mapping, resolution, extent):
    source.SetMapping(mapping)
    source.SetResolution(resolution)
    source.UpdateExtent(extent)
    image = source.GetOutput()
    width, height, _ = image.GetDimensions()
    radiance = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)
    return radiance / numpy.array(source.GetAtmosphere().GetSunIrradiance())


def encode(light):
    """Display values of light: a shoulder for what is bright, and the curve of sRGB."""
    light = 1.0 - numpy.exp(-light)
    curve = 1.055 * numpy.maximum(light, 0.0031308) ** (1.0 / 2.4) - 0.055
    return numpy.where(light <= 0.0031308, 12.92 * light, curve)


def write(pixels, name):
    height, width, _ = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    colors = numpy.ascontiguousarray((255.0 * pixels + 0.5).astype(numpy.uint8))
    image.GetPointData().SetScalars(numpy_to_vtk(colors.reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(name)
    writer.Write()


def main(folder):
    for name, time, height, atmosphere in PICTURES:
        source = make_source(time, height, atmosphere)
        dome = render(source, source.FISHEYE, SIZE, (0, SIZE - 1, 0, SIZE - 1, 0, 0))
        y, x = numpy.mgrid[0:SIZE, 0:SIZE] - (SIZE - 1) / 2.0
        dome[numpy.hypot(x, y) > SIZE / 2.0] = 0.0
        # Elevations of 0 to 45 degrees, as high as the dome.
        rows = 4 * SIZE
        upper = (0, 2 * rows - 1, rows // 2, rows // 2 + SIZE - 1, 0, 0)
        strip = render(source, source.EQUIRECTANGULAR, rows, upper)
        exposure = 0.4 / numpy.median(strip)
        write(encode(exposure * numpy.concatenate((dome, strip), axis=1)), f"{folder}/{name}.png")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
