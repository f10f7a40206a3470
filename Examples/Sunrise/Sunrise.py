# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sunrise: a short day over a terrain, from dawn to dusk, the camera turning with the sun.

Usage: Sunrise.py [picture.png | film.ogv] [1280x720] [elevations.vti] [number of frames]
"""

import math
import re
import sys

import godrays
import vtkmodules.all as vtk

output, size, elevations, frames = None, "1280x720", None, 120
for argument in sys.argv[1:]:
    if argument.endswith((".png", ".ogv")):
        output = argument
    elif argument.endswith(".vti"):
        elevations = argument
    elif re.fullmatch(r"\d+x\d+", argument):
        size = argument
    elif argument.isdigit() and int(argument) > 0:
        frames = int(argument)
    else:
        sys.exit(f"{argument} is neither a .png, .ogv or .vti file nor a number of frames.{__doc__}")

# In metres; x is east, y north and z up. Real heights are drawn threefold.
if elevations:
    heights = vtk.vtkXMLImageDataReader()
    if not heights.CanReadFile(elevations):
        sys.exit(f"{elevations} is no picture of VTK: make one with Examples/make_terrain.py.")
    heights.SetFileName(elevations)
else:
    heights = godrays.vtkGodRaysTerrainSource()
    heights.SetDimensions(401, 401)
    heights.SetWidth(30000)
    heights.SetHeight(4000)
    heights.SetFeatures(5)
    heights.SetGain(0.45)
    heights.SetSeed(4)
heights.Update()
grid = heights.GetOutput()
values = grid.GetPointData().GetScalars()
if not values or grid.GetDimensions()[2] != 1:
    sys.exit(
        f"{elevations} has no elevations: one slice of values at its points, in metres. Make one with "
        "Examples/make_terrain.py."
    )
surface = vtk.vtkImageDataGeometryFilter()
surface.SetInputConnection(heights.GetOutputPort())
warp = vtk.vtkWarpScalar()
warp.SetInputConnection(surface.GetOutputPort())
exaggeration = 3 if elevations else 1
warp.SetScaleFactor(exaggeration)
normals = vtk.vtkPolyDataNormals()
normals.SetInputConnection(warp.GetOutputPort())
normals.SplittingOff()
normals.Update()
west, east, south, north, low, high = normals.GetOutput().GetBounds()
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(normals.GetOutputPort())
mapper.ScalarVisibilityOff()
ground = vtk.vtkActor()
ground.SetMapper(mapper)
ground.GetProperty().SetColor(0.45, 0.42, 0.33)
renderer = vtk.vtkRenderer()
renderer.AddActor(ground)

sun = vtk.vtkLight()
renderer.AddLight(sun)
sky = godrays.vtkGodRaysSkyPass.Attach(renderer)
sky.SetOrigin((west + east) / 2, (south + north) / 2, low)
rays = godrays.enable(
    renderer,
    light=sun,
    preset="low-sun",
    automatic_exposure=False,  # the sky behind says how bright the sun is
    intensity=2,
    background_glow_falloff=10,
    shadows=True,
)

day = godrays.vtkGodRaysSunPosition()  # at Jacksboro, Tennessee
day.SetDate(2024, 12, 21)
day.SetTimeZone(-5)
day.SetLatitude(36.33)
day.SetLongitude(-84.18)
dawn, dusk = day.GetSunrise() - 0.3, day.GetSunset() + 0.3  # [h]


def set_time(hours):
    day.SetTimeOfDay(hours)
    sky.SetSunElevation(day.GetElevation())
    sky.SetSunAzimuth(day.GetAzimuth())
    # As for a camera or an eye, less light is needed of a higher sun.
    sky.SetExposure(3 / (1 + 1.5 * max(math.sin(math.radians(day.GetElevation())), 0)))
    sky.UpdateLight(sun)
    # The sun is a little to the right, and low in the picture while it is low.
    azimuth = math.radians(day.GetAzimuth() - 8)
    distance = 0.35 * min(east - west, north - south)
    x, y = distance * math.sin(azimuth), distance * math.cos(azimuth)
    eye_x, eye_y = (west + east) / 2 - x, (south + north) / 2 - y
    base = grid.GetOrigin()[2]
    below = base + values.GetTuple1(grid.FindPoint(eye_x, eye_y, base)) * exaggeration
    height = max(0.4 * low + 0.6 * high, below + 0.15 * (high - low))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(eye_x, eye_y, height)
    camera.SetFocalPoint(eye_x + x, eye_y + y, height + 0.12 * distance)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(50)
    camera.SetClippingRange(0.01 * distance, 10 * distance)


set_time(day.GetSunrise() + 0.5)
window = vtk.vtkRenderWindow()
window.AddRenderer(renderer)
window.SetSize([int(each) for each in size.split("x")])
picture = vtk.vtkWindowToImageFilter()
picture.SetInput(window)
picture.ReadFrontBufferOff()
picture.ShouldRerenderOff()
writer = vtk.vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
if output:
    window.SetMultiSamples(0)
    window.SetOffScreenRendering(True)
if output and output.endswith(".png"):
    window.Render()
    writer.SetFileName(output)
    writer.Write()
elif output:
    film = vtk.vtkOggTheoraWriter()
    film.SetInputConnection(picture.GetOutputPort())
    film.SetFileName(output)
    film.SubsamplingOn()  # as players have it
    film.SetRate(25)
    film.Start()
    for frame in range(frames):
        set_time(dawn + (dusk - dawn) * frame / max(frames - 1, 1))
        window.Render()
        picture.Modified()
        writer.SetFileName(f"{output[:-4]}-{frame:04}.png")
        writer.Write()
        film.Write()
        text = f"frame {frame + 1} of {frames}: {day.GetDateTime()[11:16]}"
        print(f"\r{text}, sun {day.GetElevation():.1f} degrees high ", end="", flush=True)
    film.End()
    print()
    if film.GetError() or writer.GetErrorCode():
        sys.exit(f"{output} or one of its frames could not be written.")
else:

    def advance(*_):
        set_time(day.GetTimeOfDay() + 0.02 if day.GetTimeOfDay() < dusk else dawn)
        window.Render()

    interactor = vtk.vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.Initialize()
    interactor.AddObserver("TimerEvent", advance)
    interactor.CreateRepeatingTimer(40)
    interactor.Start()
