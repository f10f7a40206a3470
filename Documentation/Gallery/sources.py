# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery's pictures of the sources of scenes. Usage: sources.py <folder>"""

import os
import sys

import godrays
import vtkmodules.all as vtk


def add(renderer, mapper, source, color=(1, 1, 1), lighting=True):
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetLighting(lighting)
    renderer.AddActor(actor)
    return actor


def add_light(renderer, position, color):
    light = vtk.vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(position)
    light.SetColor(color)
    renderer.AddLight(light)
    return light


def look(renderer, position, focus, angle, clipping=None):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(focus)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)
    if clipping:
        camera.SetClippingRange(clipping)
    else:
        renderer.ResetCameraClippingRange()


def set_sky(renderer, below, above):
    renderer.SetBackground(below)
    renderer.SetBackground2(above)
    renderer.GradientBackgroundOn()


def warp(terrain):
    """The surface of a terrain, with the terrain's own normals."""
    surface = vtk.vtkWarpScalar()
    surface.SetInputConnection(terrain.GetOutputPort())
    surface.UseNormalOn()
    surface.SetNormal(0, 0, 1)
    normals = vtk.vtkAssignAttribute()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.Assign("Normals", "NORMALS", "POINT_DATA")
    polygons = vtk.vtkDataSetSurfaceFilter()
    polygons.SetInputConnection(normals.GetOutputPort())
    return polygons


def add_plume(renderer, mapper, size, spacing, inlet, seconds, opacities, greys, unit):
    """The smoke of an inlet (its height and radius) after a time, as a volume; (density, value) for each list."""
    source = godrays.vtkGodRaysSmokeSource()
    source.SetDimensions(*size)
    source.SetSpacing(spacing)
    source.SetDiffusivity(0.0005)
    source.SetRiseSpeed(0.7)
    source.SetTurbulence(0.7)
    source.SetSourceCenter(0, 0, inlet[0])
    source.SetSourceRadius(inlet[1])
    source.SetSourceRate(4)
    source.SetTimeStep(0.99 * source.GetLargestTimeStep())
    source.UpdateTimeStep(seconds)
    opacity = vtk.vtkPiecewiseFunction()
    color = vtk.vtkColorTransferFunction()
    for density, alpha in opacities:
        opacity.AddPoint(density, alpha)
    for density, *grey in greys:
        color.AddRGBPoint(density, *(3 * grey if len(grey) == 1 else grey))
    mapper.SetInputConnection(source.GetOutputPort())
    volume = vtk.vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetColor(color)
    volume.GetProperty().SetScalarOpacityUnitDistance(unit)
    renderer.AddVolume(volume)
    return volume


def smoke(renderer):
    volume = add_plume(
        renderer, vtk.vtkSmartVolumeMapper(), (128, 96, 192), 1 / 48, (0.3, 0.13), 6.5,
        ((0, 0), (0.05, 0.1), (0.6, 0.7)), ((0, 0.25), (0.05, 0.27), (0.6, 0.5)), 0.1)
    volume.GetProperty().SetInterpolationTypeToLinear()
    ground = vtk.vtkPlaneSource()
    ground.SetOrigin(-30, -30, 0)
    ground.SetPoint1(30, -30, 0)
    ground.SetPoint2(-30, 30, 0)
    add(renderer, vtk.vtkPolyDataMapper(), ground, (0.3, 0.27, 0.22))
    renderer.SetBackground(0.32, 0.38, 0.48)
    look(renderer, (0, -7.5, 1.1), (0, 0, 1.9), 38)
    sun = add_light(renderer, (0.03, 1, 0.2), (1, 0.86, 0.62))
    godrays.enable(renderer, light=sun, preset="low-sun")


def medium(renderer):
    """Smoke in haze over hills, lit from the side: a volume as the medium."""
    volume = add_plume(
        renderer, vtk.vtkGPUVolumeRayCastMapper(), (128, 128, 128), 1 / 32, (0.3, 0.3), 6.0,
        ((0.01, 0), (0.6, 0.6)), ((0, 0.97, 0.96, 0.95),), 0.12)
    volume.SetPosition(0, 0, 0.25)
    hills = godrays.vtkGodRaysTerrainSource()
    hills.SetDimensions(301, 301)
    hills.SetWidth(24)
    hills.SetHeight(1.6)
    hills.SetFeatures(3.2)
    hills.SetSeed(3)
    surface = vtk.vtkPolyDataMapper()
    surface.ScalarVisibilityOff()
    add(renderer, surface, warp(hills), (0.42, 0.4, 0.3)).SetPosition(0, 4, -0.9)
    for i in range(4):  # beams, whose shadows are in the smoke
        beam = vtk.vtkCubeSource()
        beam.SetBounds(-1.5, -1.3, -1.2, 1.2, 1.3 + 0.9 * i, 1.45 + 0.9 * i)
        add(renderer, vtk.vtkPolyDataMapper(), beam, (0.55, 0.22, 0.13))
    set_sky(renderer, (0.5, 0.58, 0.68), (0.16, 0.3, 0.52))
    look(renderer, (0.5, -8.5, 1.7), (0, 0, 1.9), 34)
    sun = add_light(renderer, (-1, 0.1, 0.38), (1, 0.88, 0.68))
    rays = godrays.enable(renderer, light=sun, medium=volume, preset="haze", optical_depth=0.08)
    rays.GetModel().SetDataAlbedo(0.95, 0.95, 0.95)
    return rays


def terrain(renderer):
    source = godrays.vtkGodRaysTerrainSource()
    source.SetDimensions(1001, 1001)
    source.SetHeight(27)
    source.SetFeatures(3.2)
    source.SetSeed(3)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Color")
    actor = add(renderer, mapper, warp(source))
    actor.GetProperty().SetAmbient(0.28)
    actor.GetProperty().SetDiffuse(0.9)
    set_sky(renderer, (0.62, 0.72, 0.85), (0.25, 0.42, 0.7))
    look(renderer, (-4, -62, 13), (0, 0, 4.5), 34)
    add_light(renderer, (-1, -0.4, 0.7), (0.5, 0.55, 0.65))
    sun = add_light(renderer, (0.13, 1, 0.02), (1, 0.86, 0.62))
    godrays.enable(renderer, light=sun, preset="low-sun")


def fire(renderer):
    source = godrays.vtkGodRaysFireSource()
    source.UpdateTimeStep(5)
    mapper = vtk.vtkPointGaussianMapper()
    mapper.SetScaleArray("Size")
    mapper.SetScaleFactor(1)
    mapper.EmissiveOn()
    add(renderer, mapper, source)
    for i in range(5):
        log = vtk.vtkCylinderSource()
        log.SetRadius(0.06)
        log.SetHeight(0.9)
        log.SetResolution(24)
        place = vtk.vtkTransform()
        place.Translate(0, 0, -0.28)
        place.RotateZ(72 * i)
        place.RotateX(18)
        place.RotateZ(90)
        actor = add(renderer, vtk.vtkPolyDataMapper(), log, (0.25, 0.16, 0.1))
        actor.SetUserTransform(place)
    renderer.SetBackground(0.02, 0.02, 0.03)
    look(renderer, (0, -3.6, 0.8), (0, 0, 0.55), 30)
    glow = add_light(renderer, (0, -0.3, 0.5), (1, 0.5, 0.2))
    glow.PositionalOn()
    glow.SetConeAngle(180)


def clouds(renderer):
    source = godrays.vtkGodRaysCloudLayerSource()
    source.SetWidth(4000)
    source.SetAltitude(300)
    source.SetCloudSize(220)
    source.SetCoverage(0.48)
    source.SetSoftness(0.3)
    source.SetColor(0.4, 0.4, 0.43)
    source.SetResolution(700)
    source.SetTextureResolution(2)
    source.SetSeed(5)
    source.UpdateTimeStep(10)
    add(renderer, vtk.vtkPolyDataMapper(), source, lighting=False).ForceTranslucentOn()
    hills = godrays.vtkGodRaysTerrainSource()
    hills.SetDimensions(600, 600)
    hills.SetWidth(4000)
    hills.SetHeight(260)
    hills.SetFeatures(5)
    mapper = vtk.vtkPolyDataMapper()
    mapper.ScalarVisibilityOff()
    add(renderer, mapper, warp(hills), (0.07, 0.09, 0.07), lighting=False)
    set_sky(renderer, (0.55, 0.58, 0.6), (0.12, 0.25, 0.5))
    look(renderer, (0, -900, 60), (0, 0, 310), 48, clipping=(10, 8000))
    sun = add_light(renderer, (0.05, 1, 0.37), (1, 0.86, 0.62))
    godrays.enable(renderer, light=sun, preset="long-shafts", intensity=2.6)


def main():
    for scene in (smoke, medium, terrain, fire, clouds):
        renderer = vtk.vtkRenderer()
        scene(renderer)
        window = vtk.vtkRenderWindow()
        window.AddRenderer(renderer)
        window.SetSize(800, 600)
        window.SetMultiSamples(0)
        window.SetOffScreenRendering(True)
        window.Render()
        picture = vtk.vtkWindowToImageFilter()
        picture.SetInput(window)
        picture.ReadFrontBufferOff()
        picture.ShouldRerenderOff()
        writer = vtk.vtkJPEGWriter()
        writer.SetQuality(88)
        writer.SetInputConnection(picture.GetOutputPort())
        writer.SetFileName(os.path.join(sys.argv[1], f"source-{scene.__name__}.jpg"))
        writer.Write()


if __name__ == "__main__":
    main()
