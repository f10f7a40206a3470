# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The image filters of the Python module godrays."""

import unittest

import godrays
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT


def make_image(width, height, value):
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.AllocateScalars(VTK_FLOAT, 1)
    image.GetPointData().GetScalars().Fill(value)
    return image


class ReferenceFilter(unittest.TestCase):
    def test_a_constant_gives_the_gain(self):
        rays = godrays.vtkGodRaysReferenceFilter()
        rays.SetInputData(make_image(7, 5, 0.5))
        rays.SetLightPosition(0.5, 0.5)
        rays.SetDecay(1.0)
        rays.Update()
        output = rays.GetOutput()
        self.assertEqual(output.GetDimensions(), (7, 5, 1))
        self.assertEqual(output.GetScalarType(), VTK_DOUBLE)
        low, high = output.GetScalarRange()
        gain = rays.GetNumberOfSamples() * rays.GetWeight() * rays.GetExposure()
        self.assertAlmostEqual(low, 0.5 * gain, 12)
        self.assertAlmostEqual(high, 0.5 * gain, 12)

    def test_light(self):
        rays = godrays.vtkGodRaysReferenceFilter()
        rays.SetLightDirection(0.25, -1)
        self.assertEqual(rays.GetLightClip(), (0.5, -2.0, 0.0))
        rays.SetLightClip((1, 2, 3))
        self.assertEqual(rays.GetLightClip(), (1.0, 2.0, 3.0))


if __name__ == "__main__":
    unittest.main()
