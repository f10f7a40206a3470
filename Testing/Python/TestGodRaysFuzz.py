# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random sequences of what users do, in a window with rays and, step by step, in one without.

No step crashes, leaves an OpenGL error, or is told of without a remedy; what is read back is finite and not
negative; a look darkens nothing, and depth and alpha are as without rays; after Detach() the picture is, too.
Each sequence has a process of its own. Of one that fails, steps are left out while it still does; what is left
is printed with its seed. GODRAYS_SEED is the first seed, GODRAYS_LONG makes ten times as many sequences. With
CI=true VTK 9.1 takes the first quarter of them, and newer versions take the second.
"""

import ctypes
import os
import pickle
import random
import re
import unittest

import godrays
import numpy
import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkFloatArray,
    vtkOutputWindow,
    vtkStringOutputWindow,
    vtkUnsignedCharArray,
    vtkVersion,
)
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkBillboardTextActor3D,
    vtkCamera,
    vtkHardwareSelector,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkVolume,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

FIRST = int(os.environ.get("GODRAYS_SEED", "1"))
SEQUENCES = 2000 if "GODRAYS_LONG" in os.environ else 200
if os.environ.get("CI") == "true":
    SEQUENCES //= 4
    FIRST += SEQUENCES if (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) > (9, 1) else 0
STEPS = 12
MODELS = [f"vtkGodRays{stem.split('/')[1]}Model" for stem in os.environ["GODRAYS_MODELS"].split(",")]
INTEGRATORS = [f"vtkGodRays{stem.split('/')[1]}Integrator" for stem in os.environ["GODRAYS_INTEGRATORS"].split(",")]
REMEDY = r"[.] (Set|Move|Use|Add|The presets are)\b|; it stays |; nothing is changed|The presets are"
OPENGL = ctypes.CDLL("libGL.so.1")


def make_prop(chance):
    """A prop of some kind at some place."""
    kind = chance.choice(("box", "box", "sphere", "glass", "wire", "points", "clipped", "assembly", "volume", "text",
                          "billboard", "empty", "huge", "hidden"))
    place = [chance.uniform(-3, 3) for _ in range(3)]
    if kind == "volume":
        wave = vtkRTAnalyticSource()
        wave.SetWholeExtent(-3, 3, -3, 3, -3, 3)
        wave.Update()
        mapper = vtkGPUVolumeRayCastMapper()
        mapper.SetInputData(wave.GetOutput())
        mapper.SetAutoAdjustSampleDistances(False)
        mapper.SetSampleDistance(0.5)
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(50, 0)
        opacity.AddPoint(250, 0.3)
        prop = vtkVolume()
        prop.SetMapper(mapper)
        prop.GetProperty().SetScalarOpacity(opacity)
        prop.SetScale(0.3)
    elif kind == "text":
        prop = vtkTextActor()
        prop.SetInput("Text")
        prop.SetPosition(chance.randrange(20), chance.randrange(20))
        return prop
    elif kind == "billboard":
        prop = vtkBillboardTextActor3D()
        prop.SetInput("Billboard")
    else:
        source = vtkSphereSource() if kind == "sphere" else vtkCubeSource()
        mapper = vtkPolyDataMapper()
        if kind != "empty":
            mapper.SetInputConnection(source.GetOutputPort())
        if kind == "clipped":
            plane = vtkPlane()
            plane.SetNormal(1, 0.3, 0.2)
            mapper.AddClippingPlane(plane)
        prop = actor = vtkActor()
        actor.SetMapper(mapper)
        if kind == "assembly":
            prop = vtkAssembly()
            prop.AddPart(actor)
        actor.GetProperty().SetColor(*(chance.random() for _ in range(3)))
        actor.GetProperty().SetOpacity(0.5 if kind == "glass" else 1)
        actor.GetProperty().SetRepresentation({"points": 0, "wire": 1}.get(kind, 2))
        actor.GetProperty().SetPointSize(5)
        prop.SetScale(1e6 if kind == "huge" else chance.uniform(0.5, 2))
        prop.SetVisibility(kind != "hidden")
    prop.SetPosition(*place)
    return prop


def make_light(chance):
    light = vtkLight()
    light.SetPosition(*(chance.choice((chance.uniform(-4, 4), 0.0, 1e30)) if chance.random() < 0.05
                        else chance.uniform(-4, 4) for _ in range(3)))
    light.SetPositional(chance.random() < 0.5)
    light.SetConeAngle(chance.choice((20, 89.9, 180)))
    light.SetDiffuseColor(*(chance.random() for _ in range(3)))
    return light


class World:
    """A window whose scene changes; with rays, or without any."""

    def __init__(self, has_rays):
        self.rays = godrays.vtkGodRaysPass() if has_rays else None
        self.passes = [self.rays]
        self.problems = []
        self.pictures = []
        self.props = []
        self.lights = []
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.1, 0.12, 0.15)
        self.backdrop = vtkRenderer()  # else what a viewport leaves is what was there before
        self.new_window(random.Random(0))
        self.camera(random.Random(0))
        chance = random.Random(2)
        for _ in range(3):
            self.add_prop(chance)
        self.light(chance)
        if self.rays:
            self.rays.AddLight(self.lights[0])
            self.rays.Attach(self.renderer)

    # Of both worlds.

    def new_window(self, chance):
        if hasattr(self, "window"):
            self.window.RemoveRenderer(self.backdrop)
            self.window.RemoveRenderer(self.renderer)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(chance.choice((0, 0, 4)))
        self.window.SetAlphaBitPlanes(chance.choice((0, 1)))
        self.window.SetSize(chance.randrange(20, 70), chance.randrange(20, 50))
        self.window.AddRenderer(self.backdrop)
        self.window.AddRenderer(self.renderer)

    def add_prop(self, chance):
        self.props.append(make_prop(chance))
        self.renderer.AddViewProp(self.props[-1])

    def remove_prop(self, chance):
        if self.props:
            self.renderer.RemoveViewProp(self.props.pop(chance.randrange(len(self.props))))

    def show_prop(self, chance):
        if self.props:
            chance.choice(self.props).SetVisibility(chance.random() < 0.7)

    def light(self, chance):
        self.lights.append(make_light(chance))
        self.renderer.AddLight(self.lights[-1])

    def camera(self, chance):
        camera = vtkCamera()
        camera.SetPosition(chance.uniform(-3, 3), chance.uniform(-3, 3), chance.uniform(6, 12))
        camera.SetViewAngle(chance.choice((1, 30, 60, 120)))
        camera.SetParallelProjection(chance.random() < 0.3)
        camera.SetParallelScale(chance.choice((0.1, 4)))
        camera.SetClippingRange(*chance.choice(((1, 100), (0.01, 1e4), (5, 9))))
        camera.SetWindowCenter(chance.choice((0, 0.3)), 0)
        self.renderer.SetActiveCamera(camera)

    def bad_camera(self, chance):
        camera = self.renderer.GetActiveCamera()
        chance.choice((lambda: camera.SetPosition(float("nan"), 0, 0), lambda: camera.SetViewUp(0, 0, 0),
                       lambda: camera.SetClippingRange(1, float("inf"))))()
        self.window.Render()
        self.camera(chance)

    def size(self, chance):
        self.window.SetSize(chance.randrange(1, 90), chance.randrange(1, 60))

    def samples(self, chance):
        self.window.SetMultiSamples(chance.choice((0, 4)))

    def effects(self, chance):
        getattr(self.renderer, chance.choice(("SetUseFXAA", "SetUseDepthPeeling", "SetUseHiddenLineRemoval",
                                              "SetGradientBackground")))(chance.random() < 0.5)

    def viewport(self, chance):
        self.renderer.SetViewport(*chance.choice(((0, 0, 1, 1), (0.3, 0.2, 0.9, 1), (0, 0, 0.5, 0.5))))

    def finalize(self, chance):
        self.window.Finalize()

    def tiles(self, chance):
        shot = vtkWindowToImageFilter()
        shot.SetInput(self.window)
        shot.SetScale(chance.choice((1, 2)))
        shot.Update()

    def select(self, chance):
        self.window.Render()
        selector = vtkHardwareSelector()
        selector.SetRenderer(self.renderer)
        selector.SetArea(0, 0, 5, 5)
        if min(self.window.GetSize()) > 20:
            selector.Select()

    def compare(self, chance):
        self.window.Render()
        width, height = self.window.GetSize()
        pixels, depths = vtkUnsignedCharArray(), vtkFloatArray()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 1, pixels)  # as it is shown
        self.window.GetZbufferData(0, 0, width - 1, height - 1, depths)
        is_look = all(each.GetOutput() == 0 and each.GetModel().IsA("vtkGodRaysRadialModel")
                      for each in self.passes if each)
        self.pictures.append((vtk_to_numpy(pixels).astype(int), vtk_to_numpy(depths).copy(), is_look))

    # Of the world with rays.

    def rays_attach(self, chance):
        self.rays.Attach(self.renderer)

    def rays_detach(self, chance):
        self.rays.Detach(self.renderer)

    def rays_pass(self, chance):
        if chance.random() < 0.5:
            self.rays.Detach(self.renderer)
        self.rays = godrays.vtkGodRaysPass()
        self.passes.append(self.rays)
        self.rays.AddLight(self.lights[0])
        self.rays.Attach(self.renderer)

    def rays_light(self, chance):
        (self.rays.AddLight if chance.random() < 0.7 else self.rays.RemoveLight)(chance.choice(self.lights))

    def rays_model(self, chance):
        self.rays.SetModel(getattr(godrays, chance.choice(MODELS))())

    def rays_integrator(self, chance):
        integrator = getattr(godrays, chance.choice(INTEGRATORS))()
        self.rays.SetIntegrator(integrator if chance.random() < 0.6 else None)

    def rays_preset(self, chance):
        self.rays.ApplyPreset(chance.choice(("fog", "haze", "low-sun", "published:three.js", "published:mitchell", "none of them")))

    def rays_set(self, chance):
        value = chance.choice((0, 0.3, 1, 1e9, -1, float("nan")))
        getattr(self.rays, "Set" + chance.choice((
            "Intensity", "BackgroundGlow", "BackgroundGlowRadius", "SourceRadius", "LayerMargin", "ErrorTolerance",
            "SunAngularRadius")))(value)

    def rays_mode(self, chance):
        getattr(self.rays, "Set" + chance.choice(("Output", "Precision", "Blend", "UntaggedPropsOcclude",
                                                  "SunPlacement")))(chance.randrange(2))

    def rays_role(self, chance):
        if self.props:
            godrays.vtkGodRaysPass.SetRole(chance.choice(self.props), chance.choice((0, 1, 2, 3)))

    def rays_release(self, chance):
        self.window.MakeCurrent()
        (self.rays if chance.random() < 0.5 else self.rays.GetIntegrator()).ReleaseGraphicsResources(self.window)

    def rays_sky(self, chance):
        if chance.random() < 0.4:
            godrays.vtkGodRaysSkyPass.Attach(self.renderer).SetMultipleScattering(False)
            self.window.Render()
        godrays.vtkGodRaysSkyPass.Detach(self.renderer)

    def rays_read(self, chance):
        image = vtkImageData()
        for read in (self.rays.GetScatteringImage, self.rays.GetOcclusionImage):
            if read(image):
                values = vtk_to_numpy(image.GetPointData().GetScalars())
                if not numpy.isfinite(values).all() or values.min() < 0:
                    self.problems.append("what is read back is no light: " + self.rays.GetPlan())
            elif image.GetNumberOfPoints():
                self.problems.append("an image that is not read has points")


def find_error(world):
    """OpenGL's error that stands, 0 if none does."""
    world.window.MakeCurrent()
    return OPENGL.glGetError() if world.window.IsCurrent() else 0  # a window that was not drawn yet has none


def compare(with_rays, without):
    """The problems of two worlds' pictures, of which the last is after Detach()."""
    for (drawn, depths, is_look), (plain, plain_depths, _) in zip(with_rays.pictures, without.pictures):
        if not numpy.array_equal(depths, plain_depths):
            yield f"depth differs at {(depths != plain_depths).sum()} pixels"
        if (drawn[:, 3] != plain[:, 3]).any():
            yield "alpha differs"
        if is_look and (drawn - plain).min() < -1:
            yield f"darker by {-(drawn - plain).min()}"
    if (with_rays.pictures[-1][0] != without.pictures[-1][0]).any():
        yield "after Detach() the picture is another"


def run(seed, left_out=()):
    """The problems of a sequence, of which some steps may be left out, and its steps."""
    messages = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(messages)
    worlds = World(True), World(False)
    chance = random.Random(seed)
    common = [name for name in vars(World) if name[0] != "_" and "rays_" not in name] + ["compare"] * 4
    own = [name for name in vars(World) if name.startswith("rays_")]
    problems, steps = [], []
    for number in range(STEPS):
        name = chance.choice(common if chance.random() < 0.6 else own)
        of_step = chance.getrandbits(32)
        if number in left_out:
            continue
        steps.append(name)
        for world in worlds[:1 if name in own else 2]:
            getattr(world, name)(random.Random(of_step))
        if name in own:
            # VTK has errors of its own, e.g. of FXAA with multisampling. Both, as in VTK 9.6 the picture after
            # tiles is another one where it was rendered twice before.
            for world in worlds:
                world.window.Render()
        errors = [find_error(world) for world in worlds]
        if errors[0] and not errors[1]:  # else VTK's own
            problems.append(f"OpenGL's error {errors[0]:#x} after {name}")
    for each in worlds[0].passes:
        each.Detach(worlds[0].renderer)
    for world in worlds:
        world.compare(None)
    ours = [text for text in re.split(r"\n(?=ERROR:|Warning:)", "\n" + messages.GetOutput())
            if re.search(r"^vtkGodRays\w+ \(0x", text, re.M)]
    problems += ["no remedy: " + text for text in ours if not re.search(REMEDY, text)]
    return [*worlds[0].problems, *problems, *compare(*worlds)], steps


def try_sequence(seed, left_out=()):
    """run() in a process of its own, whose crash is a problem."""
    to_read, to_write = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(to_read)
        with os.fdopen(to_write, "wb") as pipe:
            pickle.dump(run(seed, left_out), pipe)
        os._exit(0)
    os.close(to_write)
    with os.fdopen(to_read, "rb") as pipe:
        told = pipe.read()
    status = os.waitpid(child, 0)[1]
    return pickle.loads(told) if status == 0 and told else ([f"the process ended with {status}"], [])


class Fuzz(unittest.TestCase):
    def test_sequences(self):
        for seed in range(FIRST, FIRST + SEQUENCES):
            problems, steps = try_sequence(seed)
            if not problems:
                continue
            left_out = set()
            for number in range(STEPS):
                if try_sequence(seed, left_out | {number})[0]:
                    left_out.add(number)
            problems, steps = try_sequence(seed, left_out)
            with self.subTest(seed=seed, without_steps=sorted(left_out)):
                self.fail(f"{steps}: {problems}")


if __name__ == "__main__":
    unittest.main()
