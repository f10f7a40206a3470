# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""smoke_test of NIST's Fire Dynamics Simulator: white seen through 1 m of soot has a grey of 111 of 255.

    PYTHONPATH=build/lib/python3/dist-packages /usr/bin/python3 Documentation/Gallery/smoke_test.py smoke-test.png

It draws a cube of soot before a white wall, as data with an extinction of 0.8286/m, and what light is there, of
255. Shown by sRGB, that light is 176 of 255.
"""

import math
import sys

import godrays
import vtkmodules.all as vtk

EXTINCTION = 8700 * 9.524e-5  # of soot [m^2/kg] and its density [kg/m^3]


def draw(size):
    """Window, renderer, and what light is left through the soot and beside it, as measured and as shown."""
    image = vtk.vtkImageData()
    image.SetDimensions(11, 11, 11)
    image.SetOrigin(-0.5, -0.5, -0.5)
    image.SetSpacing(0.1, 0.1, 0.1)
    image.AllocateScalars(vtk.VTK_FLOAT, 1)
    image.GetPointData().GetScalars().Fill(9.524e-5)
    opacity, black = vtk.vtkPiecewiseFunction(), vtk.vtkColorTransferFunction()
    opacity.AddPoint(0, 1 - math.exp(-EXTINCTION))  # of 1 m
    opacity.AddPoint(1, 1 - math.exp(-EXTINCTION))
    black.AddRGBPoint(0, 0, 0, 0)
    soot = vtk.vtkVolume()
    soot.SetMapper(vtk.vtkGPUVolumeRayCastMapper())
    soot.GetMapper().SetInputData(image)
    soot.GetProperty().SetScalarOpacity(opacity)
    soot.GetProperty().SetColor(black)
    soot.GetProperty().SetScalarOpacityUnitDistance(1)
    wall = vtk.vtkPlaneSource()
    wall.SetOrigin(-4, -4, -1)
    wall.SetPoint1(4, -4, -1)
    wall.SetPoint2(-4, 4, -1)
    actor = vtk.vtkActor()
    actor.SetMapper(vtk.vtkPolyDataMapper())
    actor.GetMapper().SetInputConnection(wall.GetOutputPort())
    actor.GetProperty().LightingOff()
    renderer = vtk.vtkRenderer()
    renderer.AddActor(actor)
    renderer.AddVolume(soot)
    renderer.GetActiveCamera().ParallelProjectionOn()
    renderer.GetActiveCamera().SetParallelScale(0.8)
    renderer.GetActiveCamera().SetPosition(0, 0, 4)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    rays = godrays.enable(
        renderer, light=(0.4, 0.5, 0.3), medium=soot, world_unit_in_meters=1, data_albedo=(0, 0, 0))
    rays.SetAutomaticExposure(False)  # which gives data back on average what a medium takes of them
    window.Render()
    left = godrays.measure(renderer)["Transmittance"]
    pixels = vtk.vtkUnsignedCharArray()
    found = []
    for x in size[0] // 2, 8:
        window.GetPixelData(x, size[1] // 2, x, size[1] // 2, 0, pixels, 0)
        found.append((float(left[size[1] // 2, x].mean()), int(pixels.GetComponent(0, 0))))
    return window, renderer, found


if __name__ == "__main__":
    window, renderer, found = draw((480, 320))
    for (left, shown), x in zip(found, (0.5, 0.12)):
        print(f"{left:.5f} of the light is left, {255 * left:.0f} of 255, shown as {shown}")
        text = round(255 * left)
        label = vtk.vtkTextActor()
        label.SetInput(str(text))
        label.GetTextProperty().SetFontSize(28)
        label.GetTextProperty().SetColor(*[1.0 if text < 128 else 0.0] * 3)
        label.GetTextProperty().SetJustificationToCentered()
        label.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        label.GetPositionCoordinate().SetValue(x, 0.47)
        renderer.AddViewProp(label)
    window.Render()
    shot = vtk.vtkWindowToImageFilter()
    shot.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(sys.argv[1])
    writer.SetInputConnection(shot.GetOutputPort())
    writer.Write()
