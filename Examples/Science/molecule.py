# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A protein with its drug as the lamp: HIV-1 protease, 1HPV of the Protein Data Bank, about amprenavir."""

import godrays
import numpy
import stage
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import numpy_to_vtk

RADII = {"C": 1.7, "N": 1.55, "O": 1.52, "S": 1.8}  # van der Waals [angstrom]
COLORS = {"A": "#3f8fd2", "B": "#e08a3c"}  # the two chains
protein, drug = [], []
with open(stage.find("pymol/data/tut/1hpv.pdb", "pymol-data"), encoding="ascii") as file:
    for line in file:
        if line[:6] in ("ATOM  ", "HETATM") and line[17:20] != "HOH":
            name = line[12:16].strip()
            atom = [float(line[30:38]), float(line[38:46]), float(line[46:54])]
            (drug if line[:6] == "HETATM" else protein).append((*atom, name[0], line[21]))


def balls(renderer, atoms, scale):
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.array([atom[:3] for atom in atoms]), deep=True))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    radii = numpy_to_vtk(numpy.array([scale * RADII.get(atom[3], 1.6) for atom in atoms]), deep=True)
    radii.SetName("radius")
    data.GetPointData().AddArray(radii)
    shades = numpy.array([
        [int(COLORS.get(atom[4], "#d0d0d0")[i : i + 2], 16) for i in (1, 3, 5)] for atom in atoms],
        numpy.uint8)
    tints = numpy_to_vtk(shades, deep=True)
    tints.SetName("chain")
    data.GetPointData().SetScalars(tints)
    ball = vtk.vtkSphereSource()
    ball.SetRadius(1)
    ball.SetThetaResolution(20)
    ball.SetPhiResolution(14)
    mapper = vtk.vtkGlyph3DMapper()
    mapper.SetInputData(data)
    mapper.SetSourceConnection(ball.GetOutputPort())
    mapper.SetScaleArray("radius")
    mapper.SetScaleModeToScaleByMagnitude()
    mapper.SetColorModeToDefault()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    return actor


renderer = vtk.vtkRenderer()
renderer.SetBackground(0.01, 0.015, 0.03)
chains = balls(renderer, protein, 0.62)
chains.GetProperty().SetSpecular(0.3)
chains.GetProperty().SetSpecularPower(30)
lamp = balls(renderer, drug, 0.9)
lamp.GetMapper().ScalarVisibilityOff()
lamp.GetProperty().SetColor(1, 0.93, 0.7)
lamp.GetProperty().LightingOff()
renderer.AddLight(stage.light((1, -1, 1), (0.9, 0.95, 1), intensity=0.9))
rays = godrays.enable(renderer, light=lamp, preset="low-sun", intensity=2.5)
middle = numpy.mean([atom[:3] for atom in drug], axis=0)
stage.look(renderer, middle + (55, -62, 18), middle, 34)
window = stage.show(renderer)
