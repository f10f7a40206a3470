# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What stands before the light, and what is behind it: a model of the user's, a winged figure by
default, and a galaxy."""

import math
import os

import vtkmodules.all as vtk


def add_surface(renderer, shape):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(shape.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.75, 0.72, 0.68)
    renderer.AddActor(actor)


def make_figure():
    """A robe from hem to crown, raised arms, and wings whose feathers let light through; y is up.

    Yields tubes: points, each with the tube's radius there (x, y, z, radius)."""
    yield [
        (0, 0, 0, 0.5), (0, 0.1, 0, 0.52), (0, 0.5, 0.02, 0.42), (0, 1.1, 0.06, 0.32),
        (0, 1.5, 0.06, 0.21), (0, 1.9, 0.03, 0.27), (0, 2.15, 0, 0.25), (0, 2.33, 0, 0.12),
        (0, 2.45, 0.02, 0.085), (0, 2.55, 0.04, 0.13), (0, 2.7, 0.05, 0.165),
        (0, 2.85, 0.04, 0.12), (0, 2.93, 0.03, 0.02),
    ]  # fmt: skip
    for side in -1, 1:
        yield [
            (0.2 * side, 2.18, 0, 0.1), (0.42 * side, 2.3, 0.1, 0.09),
            (0.6 * side, 2.62, 0.18, 0.075), (0.5 * side, 2.95, 0.2, 0.06),
            (0.3 * side, 3.25, 0.2, 0.05), (0.22 * side, 3.42, 0.2, 0.02),
        ]  # fmt: skip
        yield [
            (0.1 * side, 1.85, -0.2, 0.06), (0.45 * side, 2.25, -0.36, 0.09),
            (0.9 * side, 2.65, -0.45, 0.08), (1.5 * side, 2.85, -0.45, 0.05),
            (2.1 * side, 2.75, -0.4, 0.015),
        ]  # fmt: skip
        for i in range(11):
            along = i / 10  # the wing
            angle = math.radians(-98 + 78 * along)
            length = 0.75 + 1.1 * math.sin(math.pi * (0.15 + 0.75 * along))
            yield [
                (
                    side * (0.18 + 1.75 * along
                            + length * (part * math.cos(angle) + 0.1 * math.sin(3 * part))),
                    1.95 + 0.95 * math.sin(1.625 * along)
                    + length * (part * math.sin(angle) - 0.12 * part * part),
                    -0.4,
                    radius,
                )
                for part, radius in ((0, 0.04), (0.35, 0.075), (0.75, 0.07), (1, 0.01))
            ]  # fmt: skip


def add_figure(renderer):
    points, lines, radii = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkDoubleArray()
    for tube in make_figure():
        lines.InsertNextCell(len(tube))
        for *place, radius in tube:
            lines.InsertCellPoint(points.InsertNextPoint(place))
            radii.InsertNextValue(radius)
    skeleton = vtk.vtkPolyData()
    skeleton.SetPoints(points)
    skeleton.SetLines(lines)
    skeleton.GetPointData().SetScalars(radii)
    smooth = vtk.vtkSplineFilter()
    smooth.SetInputData(skeleton)
    smooth.SetSubdivideToSpecified()
    smooth.SetNumberOfSubdivisions(48)
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputConnection(smooth.GetOutputPort())
    tubes.SetVaryRadiusToVaryRadiusByAbsoluteScalar()
    tubes.SetNumberOfSides(24)
    tubes.CappingOn()
    add_surface(renderer, tubes)


def add_model(window, file):
    """Read a model (glTF with its materials, OBJ, PLY, STL) into the window's first renderer, or
    make the figure if there is no name. ValueError: what is wrong with the file."""
    renderer = window.GetRenderers().GetFirstRenderer()
    if file is None:
        add_figure(renderer)
        return
    readers = {
        ".glb": vtk.vtkGLTFImporter, ".gltf": vtk.vtkGLTFImporter, ".obj": vtk.vtkOBJReader,
        ".ply": vtk.vtkPLYReader, ".stl": vtk.vtkSTLReader,
    }  # fmt: skip
    ending = os.path.splitext(file)[1].lower()
    if ending not in readers:
        raise ValueError(
            f"{file} is no model that is read here; give a {', '.join(readers)} file"
        )
    if not os.access(file, os.R_OK):
        raise ValueError(f"{file} cannot be read; check its name and your right to read it")
    reader = readers[ending]()
    reader.SetFileName(file)
    vtk.vtkObject.GlobalWarningDisplayOff()  # what is wrong is told once
    if isinstance(reader, vtk.vtkImporter):
        reader.SetRenderWindow(window)
        reader.Update()
    else:
        normals = vtk.vtkPolyDataNormals()
        normals.SetInputConnection(reader.GetOutputPort())
        normals.Update()
        add_surface(renderer, normals)
    vtk.vtkObject.GlobalWarningDisplayOn()
    box = vtk.vtkBoundingBox(renderer.ComputeVisiblePropBounds())
    if not box.IsValid() or not 0 < box.GetDiagonalLength() < math.inf:
        raise ValueError(f"{file} holds no surface, or is damaged; write it again")


def make_galaxy(size, center):
    """Stars all about, and a spiral of two arms, which begins blue and ends, at its core, yellow."""
    points, colors, radii = vtk.vtkPoints(), vtk.vtkUnsignedCharArray(), vtk.vtkFloatArray()
    colors.SetNumberOfComponents(3)
    radii.SetName("radius")
    vtk.vtkMath.RandomSeed(3)
    for i in range(9000):
        place = [vtk.vtkMath.Gaussian(), vtk.vtkMath.Gaussian(), vtk.vtkMath.Gaussian()]
        chance = vtk.vtkMath.Random()
        if i < 2500:
            vtk.vtkMath.Normalize(place)
            place = [10 * each for each in place]
            brightness = 0.4 + 0.6 * chance**4
            color = 230, 235, 255
            radii.InsertNextValue(size * (0.01 + 0.017 * brightness))
        else:
            out = vtk.vtkMath.Random() ** 0.9  # of the core, as a part of the radius
            angle = math.pi * (i % 2) + 2.6 * math.log(1 + 15 * out)
            spread = 0.05 + 0.16 * out
            x = 2.2 * (out * math.cos(angle) + spread * place[0] / 2.5)
            z = 2.2 * (out * math.sin(angle) + spread * place[2] / 2.5)
            warm = math.exp(-1.7 * math.hypot(x, z))
            y = 0.1 * warm * place[1]
            brightness = 0.15 + 0.6 * chance**3
            color = 120 + 135 * warm, 140 + 80 * warm, 225 - 90 * warm
            radii.InsertNextValue(size * (0.007 + 0.02 * chance**6 + 0.009 * warm))
            place = [  # tilted towards the eye
                1.7 + 0.91 * x - 0.41 * y,
                1.2 + 0.27 * x + 0.61 * y - 0.74 * z,
                -6.4 + 0.3 * x + 0.68 * y + 0.67 * z,
            ]
        colors.InsertNextTuple3(*(brightness * each for each in color))
        points.InsertNextPoint([c + size * p for c, p in zip(center, place)])
    stars = vtk.vtkPolyData()
    stars.SetPoints(points)
    stars.GetPointData().SetScalars(colors)
    stars.GetPointData().AddArray(radii)
    mapper = vtk.vtkPointGaussianMapper()
    mapper.SetInputData(stars)
    mapper.SetScaleArray("radius")
    mapper.SetScaleFactor(1)
    mapper.EmissiveOn()
    galaxy = vtk.vtkActor()
    galaxy.SetMapper(mapper)
    return galaxy
