# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the pictures of README.md, and one of each look and medium for the gallery.

Usage: first.py <folder> [<name>...]

The names are c60, cells, minimal, pyvista and presets; all are written without a name. Prints the number of shafts that
stand out by 3 L* and by 8 L*, the mean change of lit data [CIE 1976], and the place of the sun.
"""

import os
import pathlib
import re
import runpy
import sys
import tempfile

import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import default_scenes
import defaults
import godrays

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = (1280, 720)
LOWER, UPPER = (4 / 255, 5 / 255, 8 / 255), (14 / 255, 17 / 255, 24 / 255)
VIRIDIS = (0.27, 0.0, 0.33), (0.23, 0.32, 0.55), (0.13, 0.57, 0.55), (0.37, 0.79, 0.38), (0.99, 0.91, 0.14)
LOOKS = "default", "low-sun", "long-shafts", "cathedral", "soft-haze", "halo"
MEDIA = "clear-air", "haze", "fog", "dust", "smoke", "sea-water"


def color(prop):
    """Gives an actor the colours of VIRIDIS over the range of its mapper."""
    low, high = prop.GetMapper().GetScalarRange()
    colors = vtk.vtkColorTransferFunction()
    for index, each in enumerate(VIRIDIS):
        colors.AddRGBPoint(low + index / 4 * (high - low), *each)
    prop.GetMapper().SetLookupTable(colors)
    return prop


def make_c60():
    """Returns a molecule of 60 carbon atoms as balls and sticks: a truncated icosahedron."""
    golden = (1 + 5**0.5) / 2
    atoms = set()
    for corner in (0, 1, 3 * golden), (1, 2 + golden, 2 * golden), (golden, 2, 2 * golden + 1):
        for signs in numpy.ndindex(2, 2, 2):
            x, y, z = (round(value * (1 - 2 * sign), 9) + 0.0 for value, sign in zip(corner, signs))
            atoms |= {(x, y, z), (y, z, x), (z, x, y)}
    places = numpy.array(sorted(atoms))
    points, bonds, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(places, deep=True))
    for one, other in numpy.argwhere(numpy.triu(abs(numpy.linalg.norm(
            places[:, None] - places[None], axis=2) - 2) < 0.01)):
        bonds.InsertNextCell(2, (int(one), int(other)))
    data.SetPoints(points)
    data.SetLines(bonds)
    ball, balls, sticks = vtk.vtkSphereSource(), vtk.vtkGlyph3D(), vtk.vtkTubeFilter()
    ball.SetRadius(0.55)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(24)
    balls.SetInputData(data)
    balls.SetSourceConnection(ball.GetOutputPort())
    balls.ScalingOff()
    sticks.SetInputData(data)
    sticks.SetRadius(0.2)
    sticks.SetNumberOfSides(16)
    both = vtk.vtkAppendPolyData()
    both.AddInputConnection(balls.GetOutputPort())
    both.AddInputConnection(sticks.GetOutputPort())
    normals = vtk.vtkPolyDataNormals()  # the arrays of balls and sticks have different names and are dropped
    default_scenes.through(both, normals)
    return color(default_scenes.actor(default_scenes.elevation(normals)))


def make_exploded_sphere():
    """Returns what pyvista.Icosphere(nsub=2).elevation().explode(0.3) is, for machines without PyVista."""
    solid, divided = vtk.vtkPlatonicSolidSource(), vtk.vtkLinearSubdivisionFilter()
    solid.SetSolidTypeToIcosahedron()
    divided.SetNumberOfSubdivisions(2)
    default_scenes.through(solid, divided).Update()
    mesh = divided.GetOutput()
    corners = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    corners /= numpy.linalg.norm(corners, axis=1, keepdims=True)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    pieces = corners[triangles]
    heights = pieces[..., 2].ravel()
    pieces = (pieces + 0.3 * pieces.mean(axis=1, keepdims=True)).reshape(-1, 3)
    points, cells, data = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(pieces, deep=True))
    for index in range(len(triangles)):
        cells.InsertNextCell(3, (3 * index, 3 * index + 1, 3 * index + 2))
    scalars = numpy_to_vtk(heights, deep=True)
    scalars.SetName("Elevation")
    data.SetPoints(points)
    data.SetPolys(cells)
    data.GetPointData().SetScalars(scalars)
    return color(default_scenes.actor(data))


def open_scene(*props, view=(0, 0), zoom=1.0, lower=LOWER, upper=UPPER):
    renderer = vtk.vtkRenderer()
    for prop in props:
        renderer.AddActor(prop)
    default_scenes.aim(renderer, *view, "z")
    renderer.GetActiveCamera().Dolly(zoom)
    renderer.ResetCameraClippingRange()
    default_scenes.set_gradient(renderer, lower, upper)
    return renderer


def draw(renderer, size, samples, **parameters):
    """Returns the picture without and with rays, the mask of data, and the place of the sun."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(samples)
    window.SetSize(size)
    window.AddRenderer(renderer)
    window.Render()
    data = defaults.read(window, "depth")[..., 0] < 1
    before = defaults.read(window, "colour")
    rays = godrays.enable(renderer, **parameters)
    window.Render()
    after = defaults.read(window, "colour")
    place = defaults.get_place(renderer, rays.GetLight(0)) if rays.GetNumberOfLights() else None
    godrays.disable(renderer)
    window.RemoveRenderer(renderer)
    window.Finalize()
    return before, after, data, place


def report(name, before, after, data, place):
    numbers = defaults.measure(before, after, data, place)
    print(f"{name}: {numbers.shafts} shafts, {numbers.clear_shafts} of 8 L*, dE {numbers.difference:.1f}, sun at "
        f"{place[0]:.2f}, {place[1]:.2f}", flush=True)


def write(picture, path, quality=85):
    """Writes a picture, the lower row first."""
    writer = vtk.vtkJPEGWriter()
    writer.SetQuality(quality)
    writer.SetInputData(godrays.to_image(numpy.ascontiguousarray(picture[::-1].astype(numpy.uint8))))
    writer.SetFileName(path)
    writer.Write()


def write_scene(name, renderer, folder, size=SIZE, **parameters):
    report(name, *draw(renderer, size, 0, **parameters))
    write(draw(renderer, size, 8, **parameters)[1], os.path.join(folder, f"{name}.jpg"))


def write_c60(folder):
    write_scene("c60", open_scene(make_c60(), view=(20, 10), zoom=1.55), folder)


def write_cells(folder):
    """Writes the picture that README's first code saves."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    code = re.search(r"## First pictures\n.*?```python\n(.*?)```", text, re.S).group(1)
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as here:
        os.chdir(here)
        exec(compile(code, "README.md", "exec"), {})
        os.chdir(before)
        reader = vtk.vtkPNGReader()
        reader.SetFileName(os.path.join(here, "cells.png"))
        write(defaults.to_array(reader), os.path.join(folder, "cells.jpg"))


def write_minimal(folder):
    with tempfile.TemporaryDirectory() as here:
        path = os.path.join(here, "minimal.png")
        sys.argv = ["MinimalSun.py", path]
        runpy.run_path(str(ROOT / "Examples" / "MinimalSun" / "MinimalSun.py"))
        reader = vtk.vtkPNGReader()
        reader.SetFileName(path)
        write(defaults.to_array(reader), os.path.join(folder, "minimal.jpg"))


def write_pyvista(folder):
    """Writes a picture like that of README's code with PyVista: its colours, camera and background."""
    ground = (6 / 255, 10 / 255, 20 / 255)
    renderer = open_scene(make_exploded_sphere(), lower=ground, upper=ground)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(1, 1, 1)
    renderer.ResetCamera()
    camera.Dolly(1.3)
    renderer.ResetCameraClippingRange()
    write_scene("pyvista", renderer, folder)


def write_presets(folder):
    """Writes one picture of each look and medium: a data set for looks and one for media, all else by default."""
    os.makedirs(os.path.join(folder, "presets"), exist_ok=True)
    size = (480, 300)
    for name in (*LOOKS, *MEDIA):
        if name in LOOKS:
            renderer = open_scene(make_c60(), view=(20, 10), zoom=1.45)
        else:
            renderer = open_scene(make_exploded_sphere(), view=(-45, 30), zoom=1.3)
        report(name, *draw(renderer, size, 0, preset=name))
        write(draw(renderer, size, 8, preset=name)[1], os.path.join(folder, "presets", f"{name}.jpg"))


WRITERS = {"c60": write_c60, "cells": write_cells, "minimal": write_minimal, "pyvista": write_pyvista,
    "presets": write_presets}

if __name__ == "__main__":
    target, *names = sys.argv[1:]
    for each in names or WRITERS:
        WRITERS[each](os.path.abspath(target))
