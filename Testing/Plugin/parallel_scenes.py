# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw scenes that are split over processes, and write their pictures and times.

Usage: pvbatch parallel_scenes.py <folder> [<scene>...], under mpirun with as many processes as
wanted; or with Python, as a client of the server at GODRAYS_SERVER_PORT, which renders if
GODRAYS_REMOTE_RENDERING is 1, and does not if it is 0.

Each <scene>.png has rays, each <scene>-plain.png none; of a server that renders, each <scene>-dragged.png and
<scene>-plain-dragged.png is what the window shows while the camera is dragged, reduced by REDUCTION. If GODRAYS_FRAMES
says how many frames to time, pictures are larger, and times.json has of each scene: the seconds of
each frame with rays and without, and of the pass's stages where the pictures are joined.
"""

import json
import os
import sys
import time

from plugin_testing import *
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

FOLDER = sys.argv[1]
FRAMES = int(os.environ.get("GODRAYS_FRAMES", "0"))
SIZE = (800, 600) if FRAMES else (200, 150)
REDUCTION = 4
CENTERS = [(-1.7, 0.7, 0.0), (-0.9, -0.6, 0.3), (0.1, 0.8, -0.4), (0.9, -0.4, 0.2), (1.7, 0.6, 0.0)]


def add_spheres(view, centers=CENTERS):
    """Spheres, of which every process has a part, as one representation."""
    shown = show_joined(
        [
            simple.Sphere(Center=center, Radius=0.45, ThetaResolution=48, PhiResolution=48)
            for center in centers
        ],
        view,
    )
    shown.DiffuseColor = [0.4, 0.45, 0.5]
    return shown


def add_spheres_in_part_ignored(view, first, last):
    """Spheres, of which those from first to before last block no light."""
    add_spheres(view, CENTERS[:first] + CENTERS[last:])
    add_spheres(view, CENTERS[first:last]).GodRaysRole = "Ignored"


def opaque(view):
    add_spheres(view)


def gradient(view):
    add_spheres(view)
    view.BackgroundColorMode = "Gradient"
    view.Background = [0.05, 0.05, 0.1]
    view.Background2 = [0.3, 0.35, 0.5]


def tagged(view):
    add_spheres_in_part_ignored(view, 1, 3)


def lamp(view):
    add_spheres(view)
    view.LightSource = "What is tagged as a light"
    shown = simple.Show(simple.Sphere(Center=[0.0, 0.1, -1.5], Radius=0.5), view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = [1.0, 0.85, 0.5]
    shown.Ambient, shown.Diffuse = 1.0, 0.0
    shown.GodRaysRole = "Light"


def bright(view):
    """A light whose radiance is 4 times what a display shows: its shafts are not cut off."""
    add_spheres(view)
    view.LightSource = "What is tagged as a light"
    lamp = simple.AddLight(view=view)
    lamp.Coords = "Scene"
    lamp.Type = "Positional"
    lamp.Position = [0.0, 0.1, -1.5]
    lamp.FocalPoint = [0.0, 0.1, 0.0]
    lamp.Intensity = 4.0
    view.Lights = [lamp]
    view.Intensity = 0.25


def translucent(view):
    """A shell that is cut between the processes. Its parts stay where they are: those that ParaView 5.11
    moves to sort them go through XML that Debian's expat does not read."""
    data = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
    shell = simple.Contour(Input=data, ContourBy=["POINTS", "RTData"], Isosurfaces=[160.0])
    shell.ComputeNormals = 0
    shown = simple.Show(shell, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = [0.4, 0.45, 0.5]
    shown.Opacity = 0.4
    shown.UseDataPartitions = 1
    view.AutomaticExposure = 0  # one process has no alpha that says where translucent data are
    view.CameraPosition = [0, 0, 60]


def veil(view):
    """The same before the sky."""
    translucent(view)
    view.UseSky = 1
    view.SunFrame = "World, Y up"


def volume(view):
    data = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
    shown = simple.Show(data, view)
    shown.SetRepresentationType("Volume")
    simple.ColorBy(shown, ("POINTS", "RTData"))
    shown.RescaleTransferFunctionToDataRange()
    view.AutomaticExposure = 0  # which holds rays back over data, here nearly all of the picture
    view.Intensity = 4.0
    view.CameraPosition = [0, 0, 64]  # which leaves a rim of sky, where rays are seen


def medium(view):
    """A sun in fog, with the shadows of what the picture shows."""
    add_spheres_in_part_ignored(view, 1, 2)
    view.Preset = "fog"
    view.WorldUnitInMeters = 10.0


def shadows(view):
    """The same in shaders, with coarse shadow maps."""
    medium(view)
    view.Integrator = "Shadow Map"
    view.Integrator.Backend = "Graphics"
    view.Integrator.MapSize = 64


def sky(view):
    """A low sun behind the spheres, and its sky."""
    add_spheres(view)
    view.AutomaticExposure = 0  # the sky says how bright the sun is
    view.BackgroundGlow, view.BackgroundGlowFalloff = 0.4, 18  # wide enough for coarse pictures
    view.UseSky = 1
    view.SunFrame = "World, Y up"


def placed(view):
    """A sun that the first frame places, by the occluders of all processes."""
    add_spheres(view)
    view.SunAzimuth, view.SunElevation = 0.0, 10.0
    view.PlaceSun = 1


def one_process(view):
    """All of the scene is on one process."""
    add_pillars(view)


SCENES = {
    scene.__name__: scene
    for scene in (
        opaque, gradient, tagged, lamp, bright, medium, shadows, sky, translucent, veil, volume,
        placed, one_process,
    )  # fmt: skip
}


def save_dragged(view, path):
    """Write what the window shows while the camera is dragged."""
    view.ImageReductionFactor = REDUCTION
    view.SMProxy.InteractiveRender()
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.GetRenderWindow())
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


def time_frames(view):
    """The seconds of frames, and of the stages in each."""
    view.MeasureTimes = 1
    frames, stages = [], []
    for _ in range(FRAMES):
        begin = time.perf_counter()
        simple.Render(view)
        frames.append(time.perf_counter() - begin)
        stage = [0.0] * 4
        rays(view).GetStageTimes(stage)
        stages.append(stage)
    return frames, stages


IS_SERVED = os.environ.get("GODRAYS_REMOTE_RENDERING") == "1"
times = {}
for name in sys.argv[2:] or SCENES:
    view = make_view(size=SIZE, SunElevation=6.0, SunAzimuth=3.0)
    if "GODRAYS_REMOTE_RENDERING" in os.environ:
        view.RemoteRenderThreshold = 0.0 if IS_SERVED else 1e9
    SCENES[name](view)
    simple.Render(view)
    assert view.PlaceSun == 0
    path = os.path.join(FOLDER, name)
    simple.SaveScreenshot(path + ".png", view)
    if IS_SERVED:
        save_dragged(view, path + "-dragged.png")
    if FRAMES:
        times[name] = dict(zip(("frames", "stages"), time_frames(view)))
    view.UseGodRays = 0
    simple.SaveScreenshot(path + "-plain.png", view)
    if IS_SERVED:
        save_dragged(view, path + "-plain-dragged.png")
    if FRAMES:
        times[name]["plain"], _ = time_frames(view)
    simple.Delete(view)
if FRAMES:
    with open(os.path.join(FOLDER, "times.json"), "w", encoding="utf-8") as file:
        json.dump(times, file, indent=1)
