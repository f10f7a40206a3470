# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the examples share: checks that are told one by one, and their pictures."""

import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkHDRReader, vtkPNGReader

_failures = []


def check(what, condition, figures=""):
    print(f"{'good' if condition else 'BAD'}: {what} {figures}")
    if not condition:
        _failures.append(what)


def end():
    """End the test; with an error if a check has failed."""
    sys.exit(f"{len(_failures)} checks failed" if _failures else 0)


def read(file):
    """A .png file in levels of 255 or the light of an .hdr file, as numbers with a sign: rows from the
    bottom, columns, colours."""
    reader = vtkHDRReader() if file.endswith(".hdr") else vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
    return values if values.dtype.kind == "f" else values.astype(int)


def baseline(name):
    """The picture of an example in Testing/Baseline, as read() has it."""
    return read(str(pathlib.Path(__file__).parents[1] / "Baseline" / f"Example-{name}.png"))


def encoded(light):
    """Linear light as levels of 255, by sRGB's transfer."""
    light = numpy.minimum(light, 1)
    curve = 1.055 * numpy.maximum(light, 0.0031308) ** (1 / 2.4) - 0.055
    return 255 * numpy.where(light <= 0.0031308, 12.92 * light, curve)
