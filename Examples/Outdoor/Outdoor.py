# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Outdoors: the sun behind clouds, mountains, and a fire on a slope with its smoke.
Or, with the argument baked, shafts of the clouds behind everything; or, with medium, in haze and smoke
that scatter light."""

import sys

import godrays
import vtkmodules.all as vtk
from bake_sky import bake_sky

renderer = vtk.vtkRenderer()


def add(mapper, source):
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    return actor


# The unit is 100 m; x is west, y south and z up. Mountains, 6 km wide:
heights = godrays.vtkGodRaysTerrainSource()
heights.SetDimensions(801, 801)
heights.SetWidth(60)
heights.SetHeight(11)
heights.SetFeatures(3)
heights.SetGain(0.45)
heights.SetSeed(3)
warp = vtk.vtkWarpScalar()
warp.SetInputConnection(heights.GetOutputPort())
warp.UseNormalOn()
warp.SetNormal(0, 0, 1)
normals = vtk.vtkAssignAttribute()
normals.SetInputConnection(warp.GetOutputPort())
normals.Assign("Normals", "NORMALS", "POINT_DATA")
surface = vtk.vtkDataSetSurfaceFilter()
surface.SetInputConnection(normals.GetOutputPort())
colours = vtk.vtkPolyDataMapper()
colours.SetScalarModeToUsePointFieldData()
colours.SelectColorArray("Color")
ground = add(colours, surface)
ground.GetProperty().SetAmbient(0.2)

# Clouds are translucent geometry: they let through what their opacity leaves.
layer = godrays.vtkGodRaysCloudLayerSource()
layer.SetWidth(160)
layer.SetAltitude(10)
layer.SetCloudSize(4)
layer.SetCoverage(0.65)
layer.SetSoftness(0.3)
layer.SetColor(0.25, 0.25, 0.26)
layer.SetResolution(600)
layer.SetWindSpeed(1)
layer.SetSeed(15)
layer.SetEndTime(1000)
clouds = add(vtk.vtkPolyDataMapper(), layer)
clouds.GetProperty().LightingOff()
clouds.ForceTranslucentOn()

# So does smoke, which is a volume. The fire below it shines.
plume = godrays.vtkGodRaysSmokeSource()
plume.SetDimensions(48, 48, 72)
plume.SetSpacing(1 / 15)
plume.SetDiffusivity(0.002)
plume.SetTurbulence(1.4)
plume.SetTurbulenceSize(0.8)
plume.SetSourceRadius(0.25)
plume.SetSourceRate(8)
plume.SetTimeStep(0.01)
plume.SetEndTime(1000)
opacity = vtk.vtkPiecewiseFunction()
opacity.AddPoint(0, 0)
opacity.AddPoint(1, 0.6)
grey = vtk.vtkColorTransferFunction()
grey.AddRGBPoint(0, 0.12, 0.12, 0.12)
grey.AddRGBPoint(1, 0.36, 0.36, 0.36)
mapper = vtk.vtkSmartVolumeMapper()
mapper.SetInputConnection(plume.GetOutputPort())
smoke = vtk.vtkVolume()
smoke.SetMapper(mapper)
smoke.SetPosition(3, -20.5, 0.3)
smoke.GetProperty().SetScalarOpacity(opacity)
smoke.GetProperty().SetScalarOpacityUnitDistance(0.15)
smoke.GetProperty().SetColor(grey)
smoke.GetProperty().SetInterpolationTypeToLinear()
renderer.AddVolume(smoke)

fire = godrays.vtkGodRaysFireSource()
fire.SetCenter(3, -20.5, -0.05)  # on the ground
fire.SetTurbulence(0.8)
fire.SetOpacity(0.03)
fire.SetEndTime(1000)
particles = vtk.vtkPointGaussianMapper()
particles.SetScaleArray("Size")
particles.SetScaleFactor(1)
particles.EmissiveOn()
flames = add(particles, fire)

sky = godrays.vtkGodRaysSkyPass.Attach(renderer)
sky.SetWorldUnitInMeters(100)
sky.SetNorth(0, -1, 0)
sky.SetSunElevation(11)
sky.SetSunAzimuth(176)
sky.SetExposure(4)
sky.SurfaceLightOff()  # which a sky without clouds would give
sun = vtk.vtkLight()
sky.UpdateLight(sun)
shade = vtk.vtkLight()  # what the clouds leave of it
shade.SetPosition(-0.5, -1, 1)
shade.SetColor(0.2, 0.22, 0.26)
renderer.AddLight(sun)
renderer.AddLight(shade)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -29, 0.1)
camera.SetFocalPoint(0, 0, 6.2)
camera.SetViewUp(0, 0, 1)
camera.SetViewAngle(55)
camera.SetClippingRange(0.2, 200)

mode = sys.argv[-1] if sys.argv[-1] in ("baked", "medium") else None
if mode == "medium":
    # Haze, with a visibility of 39 km on the ground. Molecules are in the sky already, so the haze has a
    # light of its own: of the sky's it would take the colour above the air.
    low = vtk.vtkLight()
    low.SetPosition(sun.GetPosition())
    low.SetColor(sun.GetDiffuseColor())
    low.SetIntensity(sun.GetIntensity())
    rays = godrays.enable(
        renderer,
        light=low,
        medium=smoke,
        model="atmosphere",
        mie_scattering=(1e-4, 1e-4, 1e-4),
        mie_scale_height=600,
        rayleigh_scattering=(0, 0, 0),
        world_unit_in_meters=100,
        intensity=sky.GetExposure(),
        automatic_exposure=False,
    )
else:
    rays = godrays.enable(
        renderer,
        light=[sun, flames],
        preset="low-sun",
        automatic_exposure=False,  # the sky behind says how bright the sun is
        intensity=0.75,
        sun_angular_radius=6,  # the sun is hidden: what shines is the bright sky about it
        background_glow=0,
    )

time = 4.98  # [s]; a second is ten of the clock


def advance():
    global time
    time += 0.02
    for source in layer, plume, fire:
        source.UpdateTimeStep(time)


advance()
if mode == "baked":
    # The shafts of the clouds alone, once, behind everything. They are made short enough to end within a
    # face of the panorama: sums along lines of one picture do not go on in the next. Their fall is measured
    # in heights of a picture, and streaks in angles in it: a face has others.
    rays.GetModel().SetDensity(0.85)
    rays.GetModel().SetReach(0)
    rays.GetModel().SetStreaks(0)
    scene = ground, smoke, flames
    for prop in scene:
        prop.VisibilityOff()
    renderer.AddActor(bake_sky(renderer))
    for prop in scene:
        prop.VisibilityOn()
    clouds.VisibilityOff()
    godrays.disable(renderer)

window = vtk.vtkRenderWindow()
window.AddRenderer(renderer)
count = len(sys.argv) - (mode is not None)
size = sys.argv[2] if count > 2 else "1280x720"
window.SetSize([int(each) for each in size.split("x")])
if count > 1:
    window.SetMultiSamples(0)
    window.SetOffScreenRendering(True)
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    picture.ShouldRerenderOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(picture.GetOutputPort())
    writer.SetFileName(sys.argv[1])
    writer.Write()
else:
    interactor = vtk.vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.Initialize()
    interactor.AddObserver("TimerEvent", lambda *_: (advance(), window.Render()))
    interactor.CreateRepeatingTimer(40)
    interactor.Start()
