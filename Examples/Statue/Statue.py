# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""A statue before a sphere of light and a galaxy; five sliders hold the parameters of the sum."""

import math
import re
import sys

import godrays
import vtkmodules.all as vtk
from statue_scene import add_model, make_galaxy

# Of the model, with the range of the slider; the model takes more.
PARAMETERS = {
    "Exposure": (0, 0.2), "Decay": (0.8, 1), "Density": (0, 1), "Weight": (0, 1),
    "NumberOfSamples": (1, 200),
}  # fmt: skip

arguments = sys.argv[1:]
picture = arguments.pop(0) if arguments and arguments[0].endswith(".png") else None
is_sized = arguments and re.fullmatch(r"\d+x\d+", arguments[0])
width, height = map(int, (arguments.pop(0) if is_sized else "1280x720").split("x"))
renderer = vtk.vtkRenderer()
window = vtk.vtkRenderWindow()
window.AddRenderer(renderer)
try:
    add_model(window, arguments[0] if arguments else None)
except ValueError as fault:
    sys.exit(f"Statue: {fault}")
box = vtk.vtkBoundingBox(renderer.ComputeVisiblePropBounds())
size = box.GetDiagonalLength()
center = [0.0, 0.0, 0.0]
box.GetCenter(center)

ball = vtk.vtkSphereSource()
ball.SetRadius(0.07 * size)
ball.SetThetaResolution(48)
ball.SetPhiResolution(48)
mapper = vtk.vtkPolyDataMapper()
mapper.SetInputConnection(ball.GetOutputPort())
sphere = vtk.vtkActor()
sphere.SetMapper(mapper)
sphere.GetProperty().LightingOff()
sphere.GetProperty().SetColor(1, 0.93, 0.8)
renderer.AddActor(sphere)
galaxy = make_galaxy(size, center)
renderer.AddActor(galaxy)

renderer.RemoveAllLights()  # that a model may have brought
light = vtk.vtkLight()
light.PositionalOn()
light.SetConeAngle(180)
renderer.AddLight(light)
starlight = vtk.vtkLight()
starlight.SetLightTypeToHeadlight()
starlight.SetColor(0.27, 0.32, 0.45)
renderer.AddLight(starlight)
renderer.SetBackground(0.008, 0.008, 0.02)


def move_light(degrees):
    angle = math.radians(degrees)
    place = (
        center[0] + 0.39 * size * math.sin(angle), center[1] + 0.1 * size,
        center[2] - 0.39 * size * math.cos(angle),
    )  # fmt: skip
    sphere.SetPosition(place)
    light.SetPosition(place)


move_light(-20)
camera = renderer.GetActiveCamera()
camera.SetFocalPoint(center)
# The front of the model's box fills the picture.
distance = 0.5 * box.GetLength(2) + 1.55 * max(box.GetLength(1), 0.75 * box.GetLength(0))
camera.SetPosition(center[0] - 0.18 * size, center[1] - 0.1 * size, center[2] + distance)
camera.SetViewUp(0, 1, 0)
camera.SetViewAngle(36)
renderer.ResetCameraClippingRange()

model, published = godrays.vtkGodRaysRadialModel(), godrays.vtkGodRaysPublishedModel()
published.ApplyPreset("gianassi")
for each in published, model:
    rays = godrays.enable(
        renderer, light=sphere, ignored=[galaxy], background_glow=0.1, model=each,
        exposure=0.05, decay=0.98, density=0.8, weight=0.8,  # as published, but for the decay
    )  # fmt: skip

window.SetSize(width, height)
if picture:
    window.SetMultiSamples(0)
    window.SetOffScreenRendering(True)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(picture)
    writer.Write()
    sys.exit()

window.SetMultiSamples(0)  # with them, software OpenGL takes three times as long
interactor = vtk.vtkRenderWindowInteractor()
interactor.SetRenderWindow(window)
interactor.SetInteractorStyle(vtk.vtkInteractorStyleTrackballCamera())
sliders = []
for number, (name, (low, high)) in enumerate(PARAMETERS.items()):
    look = vtk.vtkSliderRepresentation2D()
    look.SetTitleText(name)
    look.SetMinimumValue(low)
    look.SetMaximumValue(high)
    look.SetValue(getattr(model, "Get" + name)())
    look.SetLabelFormat("%.3g")
    for x, point in (0.03, look.GetPoint1Coordinate()), (0.19, look.GetPoint2Coordinate()):
        point.SetCoordinateSystemToNormalizedDisplay()
        point.SetValue(x + 0.195 * number, 0.07)
    look.SetSliderLength(0.015)
    look.SetTitleHeight(0.025)
    look.SetLabelHeight(0.02)
    slider = vtk.vtkSliderWidget()
    slider.SetInteractor(interactor)
    slider.SetRepresentation(look)
    slider.SetAnimationModeToJump()

    def slide(slider, event, name=name):  # the widget renders
        value = slider.GetRepresentation().GetValue()
        for each in model, published:
            getattr(each, "Set" + name)(round(value) if name == "NumberOfSamples" else value)

    slider.AddObserver("InteractionEvent", slide)
    slider.EnabledOn()
    sliders.append(slider)

degrees, moves = -20, False


def press(interactor, event):
    global moves
    key = interactor.GetKeySym()
    moves ^= key == "space"
    if key == "g":  # the sum as published, tap by tap, and back
        rays.SetModel(published if rays.GetModel() is model else model)
        interactor.Render()


def tick(interactor, event):
    global degrees
    if moves:
        degrees += 1.5
        move_light(degrees)
        interactor.Render()


interactor.AddObserver("KeyPressEvent", press)
interactor.AddObserver("TimerEvent", tick)
interactor.CreateRepeatingTimer(33)
window.Render()
interactor.Start()
