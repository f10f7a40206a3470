# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Media of data against single_scattering.py, which shares no code with them, in random scenes.

Densities, transfer functions, matrices, cropping, clipping planes, lights and views are drawn at random, some of
them to be hard: spikes of opacity between neighbours, noise from point to point, phase functions of 0.9, a camera or a
lamp in the smoke. GODRAYS_SEED is the first seed; GODRAYS_LONG takes more scenes and more pixels, and prints a table.
"""

import math
import os
import pathlib
import sys
import unittest

import godrays
import numpy
import vtkmodules.vtkRenderingVolumeOpenGL2  # the mapper behind vtkGPUVolumeRayCastMapper
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkLight, vtkRenderer, vtkRenderWindow, vtkVolume)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import single_scattering as truth

LONG = "GODRAYS_LONG" in os.environ
SEED = int(os.environ.get("GODRAYS_SEED", 1))
STRIDE = 3 if LONG else 7  # every so many-th pixel of each axis is compared, an odd number
SIZE = (96, 72) if LONG else (77, 56)
FAR = 40.0


def decode(shown):
    """Linear light of a shown value, as IEC 61966-2-1 has it."""
    shown = numpy.clip(shown, 0.0, 1.0)
    return numpy.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055)**2.4)


def draw_rotation(rng):
    turn, _ = numpy.linalg.qr(rng.normal(size=(3, 3)))
    return turn * numpy.sign(numpy.linalg.det(turn))


def draw_field(rng, size, noise):
    """Numbers from 0 to 1 at points, in the order (z, y, x): a few bells, and noise from point to point."""
    z, y, x = numpy.meshgrid(*(numpy.linspace(-1, 1, n) for n in size[::-1]), indexing="ij")
    total = numpy.zeros(x.shape)
    for _ in range(rng.integers(2, 6)):
        place, width = rng.uniform(-0.7, 0.7, 3), rng.uniform(0.35, 0.7)
        square = (x - place[0])**2 + (y - place[1])**2 + (z - place[2])**2
        total += rng.uniform(0.4, 1.0) * numpy.exp(-square / (2 * width**2))
    total /= total.max()
    return (1 - noise) * total + noise * rng.uniform(size=x.shape)


def make_image(values, spacing, origin=(0.0, 0.0, 0.0), cells=False, turn=None):
    """values: (z, y, x), or (3, z, y, x) for three components."""
    image = vtkImageData()
    image.SetDimensions(*(numpy.array(values.shape[: -4 : -1]) + (1 if cells else 0)).tolist())
    image.SetSpacing(*spacing)
    image.SetOrigin(*origin)
    if turn is not None:
        image.SetDirectionMatrix(*turn.ravel())
    flat = values.reshape(-1) if values.ndim == 3 else numpy.moveaxis(values, 0, -1).reshape(-1, 3)
    array = numpy_to_vtk(numpy.ascontiguousarray(flat), deep=1)
    array.SetName("density")
    (image.GetCellData() if cells else image.GetPointData()).SetScalars(array)
    return image


def to_points(cells):
    """The means of the cells that meet at each point."""
    total = numpy.zeros([n + 1 for n in cells.shape])
    count = numpy.zeros(total.shape)
    for corner in range(8):
        part = tuple(slice(corner >> axis & 1, (corner >> axis & 1) + n) for axis, n in enumerate(cells.shape))
        total[part] += cells
        count[part] += 1
    return total / count


class Volume:
    """A vtkVolume with the role MEDIUM, and what it is by the documented rules, worked out anew."""

    def __init__(self, rng, spread, affine=True):
        size = rng.integers(6, 15, 3)
        cells = rng.random() < 0.25
        self.noise = rng.choice([0.0, 0.0, 0.0, 0.3])
        values = draw_field(rng, size, self.noise)
        kind = rng.choice(["float32", "float64", "uint8", "int16", "uint16"])
        low, high = {"uint8": (0, 255), "int16": (-1000, 3000), "uint16": (0, 60000)}.get(kind, (-0.3, 2.5))
        values = (low + (high - low) * values).astype(kind)
        lengths = rng.uniform(1.2, 2.6, 3)
        spacing = lengths / (size - (0 if cells else 1))
        origin = -0.5 * lengths + rng.uniform(-0.2, 0.2, 3)
        self.image = make_image(values, spacing, origin, cells)
        points = to_points(values.astype(float)) if cells else values.astype(float)
        first, last = points.min(), points.max()

        # Opacity: a ramp, or spikes whose width is from a fortieth of the range on.
        nodes = {first: 0.0, last: rng.uniform(0.1, 0.5)}
        if rng.random() < 0.7:
            nodes = {first: 0.0, last: rng.choice([0.0, 0.2])}
            for place in numpy.cumsum(rng.uniform(0.15, 0.4, 3))[: rng.integers(1, 4)]:
                width = rng.uniform(0.0125, 0.09)
                for at, height in ((-width, 0.02), (0, rng.uniform(0.3, 0.95)), (width, 0.02)):
                    nodes[first + (last - first) * float(min(place + at, 0.99))] = float(height)
        xs = numpy.array(sorted(nodes))
        ys = numpy.array([nodes[x] for x in xs])
        unit = float(-math.log(1 - ys.max()) / rng.uniform(1.0, 4.0))
        opacities = vtkPiecewiseFunction()
        for x, y in zip(xs, ys):
            opacities.AddPoint(x, y)
        extinction = -numpy.log1p(-numpy.minimum(numpy.interp(points, xs, ys), 0.999999)) / unit

        colors = vtkColorTransferFunction()
        tints = rng.uniform(0.3, 1.0, (3, 3)) if rng.random() < 0.6 else numpy.ones((3, 3))
        for x, tint in zip(numpy.linspace(first, last, 3), tints):
            colors.AddRGBPoint(x, *tint)
        tint = numpy.stack([numpy.interp(points, numpy.linspace(first, last, 3), tints[:, c]) for c in range(3)])

        # The matrix: turned, and scaled along axes that are its own or others.
        matrix = numpy.eye(4)
        self.turn, self.scale = draw_rotation(rng), rng.uniform(0.7, 1.4, 3)
        self.affine = affine and rng.random() < 0.5
        matrix[:3, :3] = self.turn @ numpy.diag(self.scale) @ (draw_rotation(rng) if self.affine else numpy.eye(3))
        matrix[:3, 3] = rng.uniform(-spread, spread, 3)
        # VTK counts the length on which an opacity is taken in the data's own coordinates. Of data that are not
        # scaled alike along all axes, the medium's is that of a cube of the same volume.
        extinction = extinction / numpy.cbrt(abs(numpy.linalg.det(matrix[:3, :3])))
        grid_matrix = numpy.eye(4)
        grid_matrix[:3, :3] = numpy.diag(spacing)
        grid_matrix[:3, 3] = origin
        to_world = matrix @ grid_matrix

        mapper = vtkGPUVolumeRayCastMapper()
        mapper.SetInputData(self.image)
        k, j, i = numpy.meshgrid(*(numpy.arange(n) for n in points.shape), indexing="ij")
        index = numpy.stack([i, j, k, numpy.ones(i.shape)], -1)
        kept = numpy.ones(points.shape, dtype=bool)
        self.cuts = rng.choice(["", "", "crop", "clip", "both"])
        if self.cuts in ("crop", "both"):
            bounds = numpy.sort(rng.uniform(-0.9, 0.9, (3, 2)), 1) * 0.5 * lengths[:, None]
            flags = int(rng.choice([0x2000, 0x7EBFBF5, 0x2FBEFA]) if rng.random() < 0.5 else rng.integers(1, 1 << 27))
            mapper.SetCropping(True)
            mapper.SetCroppingRegionPlanes(*bounds.ravel())
            mapper.SetCroppingRegionFlags(flags)
            place = index @ grid_matrix.T
            region = numpy.zeros(points.shape, dtype=int)
            for axis in range(3):
                region += 3**axis * ((place[..., axis] >= bounds[axis, 0]).astype(int)
                                     + (place[..., axis] > bounds[axis, 1]))
            kept &= (flags >> region & 1) == 1
        if self.cuts in ("clip", "both"):
            place = index @ to_world.T
            for _ in range(rng.integers(1, 3)):
                plane = vtkPlane()
                normal = rng.normal(size=3)
                origin = matrix[:3, 3] + rng.uniform(-0.4, 0.4, 3)
                plane.SetNormal(*normal)
                plane.SetOrigin(*origin)
                mapper.AddClippingPlane(plane)
                kept &= (place[..., :3] - origin) @ normal >= 0
        extinction = numpy.where(kept, extinction, 0.0)

        self.prop = vtkVolume()
        self.prop.SetMapper(mapper)
        self.prop.GetProperty().SetScalarOpacity(opacities)
        self.prop.GetProperty().SetColor(colors)
        self.prop.GetProperty().SetScalarOpacityUnitDistance(unit)
        user = vtkMatrix4x4()
        user.DeepCopy(matrix.ravel())
        self.prop.SetUserMatrix(user)
        self.extinction, self.tint, self.to_world = extinction, decode(tint), to_world
        self.matrix, self.spacing, self.origin = matrix, spacing, grid_matrix[:3, 3]
        self.text = " ".join(filter(None, (
            "x".join(map(str, points.shape[::-1])), kind, "cells" if cells else "",
            f"{len(xs)} nodes", self.cuts, "affine" if self.affine else "", "noise" if self.noise else "")))

    def get_extinction(self, bands):
        """An image of it in the world, for filters, of one or of three components."""
        extinction = numpy.stack([factor * self.extinction for factor in bands])
        origin = (self.matrix @ numpy.append(self.origin, 1))[:3]
        values = extinction.astype(numpy.float32)
        return make_image(values[0] if len(bands) == 1 else values, self.scale * self.spacing, origin, False, self.turn)

    def get_grid(self, scale, albedo, g):
        extinction = scale * self.extinction[None]
        return truth.Grid(extinction, extinction * self.tint * numpy.reshape(albedo, (3, 1, 1, 1)), self.to_world, g)


class Scene:
    """Volumes, lights, a view and, in a third of them, haze."""

    def __init__(self, seed, most_volumes=4, most_lights=3, affine=True):
        rng = numpy.random.default_rng(seed)
        self.seed = seed
        number = rng.integers(1, most_volumes + 1)
        self.volumes = [Volume(rng, 0.5 if number > 1 else 0.0, affine) for _ in range(number)]
        self.g = float(rng.choice([-0.9, 0.9, 0.0, rng.uniform(-0.8, 0.8)]))
        self.scale = float(rng.choice([1.0, rng.uniform(0.4, 2.0)]))
        self.albedo = rng.uniform(0.4, 1.0, 3)
        self.haze = None
        if rng.random() < 0.33:
            self.haze = truth.Haze(rng.uniform(0.01, 0.06, 3), rng.uniform(0.0, 0.03, 3), rng.uniform(-0.5, 0.7))
        self.lights, self.shown = [], []
        for _ in range(rng.integers(1, most_lights + 1)):
            self.draw_light(rng)
        self.parallel = rng.random() < 0.3
        self.inside = not self.parallel and rng.random() < 0.15
        away = rng.normal(size=3)
        self.position = away / numpy.linalg.norm(away) * (0.5 if self.inside else rng.uniform(4.0, 6.0))
        self.focus = rng.uniform(-0.2, 0.2, 3)
        self.up = numpy.cross(away, rng.normal(size=3))
        self.angle, self.half = rng.uniform(25, 50), rng.uniform(1.4, 2.2)

    def draw_light(self, rng):
        kind = rng.choice(["sun", "lamp", "spot"])
        color = rng.uniform(0.4, 1.0, 3)
        linear = decode(color)
        away = rng.normal(size=3)
        away /= numpy.linalg.norm(away)
        light = vtkLight()
        light.SetColor(*color)
        light.SetLightTypeToSceneLight()
        if kind == "sun":
            light.SetPositional(False)
            light.SetPosition(*away)
            light.SetFocalPoint(0, 0, 0)
            self.lights.append(truth.Light(linear, direction=away))
        else:
            place = away * rng.uniform(0.3 if kind == "lamp" else 1.5, 3.5)
            strength = rng.uniform(2.0, 8.0)
            light.SetPositional(True)
            light.SetPosition(*place)
            light.SetAttenuationValues(0, 0, 1.0 / strength)
            light.SetConeAngle(180)
            axis, cone, exponent = None, 180.0, 0.0
            if kind == "spot":
                target = rng.uniform(-0.4, 0.4, 3)
                axis, cone, exponent = target - place, float(rng.uniform(10, 40)), float(rng.choice([0, 2, 10]))
                light.SetFocalPoint(*target)
                light.SetConeAngle(cone)
                light.SetExponent(exponent)
            self.lights.append(truth.Light(linear * strength, place=place, axis=axis, cone=cone, exponent=exponent))
        self.shown.append((kind, light))

    def get_rays(self, size):
        view = {"scale": self.half} if self.parallel else {"angle": self.angle}
        start, along, length = truth.view_rays(size, self.position, self.focus, self.up, **view)
        return start, along, FAR * length

    def integrate(self, size, **how):
        grids = [volume.get_grid(self.scale, self.albedo, self.g) for volume in self.volumes]
        start, along, end = self.get_rays(size)
        result = truth.integrate(start, along, end, grids, self.lights, self.haze, **how)
        return [each.reshape(size[1], size[0], 3) for each in result]

    def place_camera(self, renderer):
        camera = renderer.GetActiveCamera()
        camera.SetPosition(*self.position)
        camera.SetFocalPoint(*self.focus)
        camera.SetViewUp(*self.up)
        camera.SetViewAngle(self.angle)
        camera.SetParallelProjection(self.parallel)
        camera.SetParallelScale(self.half)
        camera.SetClippingRange(0.05, 60)

    def render(self, **parameters):
        renderer = vtkRenderer()
        for volume in self.volumes:
            renderer.AddVolume(volume.prop)
        self.place_camera(renderer)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(*SIZE)
        window.AddRenderer(renderer)
        model = godrays.vtkGodRaysHomogeneousModel() if self.haze else godrays.vtkGodRaysVolumeModel()
        if self.haze:
            model.SetScatteringCoefficient(*self.haze.scattering)
            model.SetAbsorptionCoefficient(*(self.haze.extinction - self.haze.scattering))
            model.SetAsymmetry(self.haze.g)
        model.SetDataScale(self.scale)
        model.SetDataAlbedo(*self.albedo)
        model.SetDataAsymmetry(self.g)
        model.SetFarLimit(FAR)
        rays = godrays.enable(renderer, light=[light for _, light in self.shown],
                              medium=[volume.prop for volume in self.volumes], model=model,
                              display_transfer="srgb_transfer", precision="single", **parameters)
        window.Render()
        found = godrays.measure(renderer)
        image = vtkImageData()
        rays.GetScatteringImage(image)
        return found, vtk_to_numpy(image.GetPointData().GetScalars()).reshape(SIZE[1], SIZE[0], -1), rays

    def __str__(self):
        return (f"{self.seed}: {'; '.join(volume.text for volume in self.volumes)}; g {self.g:.2f}; "
                f"{', '.join(kind for kind, _ in self.shown)}{'; haze' if self.haze else ''}"
                f"{'; parallel' if self.parallel else ''}{'; inside' if self.inside else ''}")


def pick(picture):
    """The pixels of a picture that has STRIDE times as many along each axis as the truth's."""
    return picture[STRIDE // 2 :: STRIDE, STRIDE // 2 :: STRIDE]


def get_error(found, expected):
    """Root mean square, and largest, as a fraction of the peak; where a spotlight lights nothing, that is 1."""
    difference = abs(found - expected) / (expected.max() or 1.0)
    return math.sqrt((difference**2).mean()), difference.max()


class FilterScene(Scene):
    """The same for filters, which take one light, images of extinction, and one albedo."""

    def __init__(self, seed):
        super().__init__(seed, most_lights=1, affine=False)
        rng = numpy.random.default_rng(seed + 1000)
        self.bands = [[1.0] if rng.random() < 0.5 else rng.uniform(0.5, 1.5, 3) for _ in self.volumes]

    def integrate(self, size, **how):
        grids = []
        for volume, bands in zip(self.volumes, self.bands):
            extinction = numpy.stack([self.scale * factor * volume.extinction for factor in bands])
            scattering = extinction * numpy.reshape(self.albedo, (3, 1, 1, 1))
            grids.append(truth.Grid(extinction, scattering, volume.to_world, self.g))
        start, along, end = self.get_rays(size)
        both = [truth.integrate(start, along, end, each, self.lights, self.haze, **how) for each in (grids, [])]
        radiance, left = (each.reshape(size[1], size[0], 3) for each in both[0])
        return radiance, left, radiance - both[1][0].reshape(radiance.shape)

    def execute(self, filter, port, size):
        light = self.lights[0]
        for volume, bands in zip(self.volumes, self.bands):
            filter.AddInputData(port, volume.get_extinction(bands))
        filter.SetSize(*size)
        filter.SetCameraPosition(*self.position)
        filter.SetCameraFocalPoint(*self.focus)
        filter.SetCameraViewUp(*self.up)
        filter.SetViewAngle(self.angle)
        filter.SetParallelProjection(self.parallel)
        filter.SetParallelScale(self.half)
        filter.SetFarLimit(FAR)
        filter.SetLight(*(light.direction if light.place is None else light.place), 0 if light.place is None else 1)
        filter.SetLightColor(*light.color)
        if light.axis is not None:
            filter.SetConeAngle(math.degrees(math.acos(light.cosine)))
            filter.SetSpotDirection(*light.axis)
            filter.SetSpotExponent(light.exponent)
        filter.SetDataScale(self.scale)
        filter.SetDataAlbedo(*self.albedo)
        filter.SetDataAsymmetry(self.g)
        haze = self.haze or truth.Haze((0, 0, 0), (0, 0, 0), 0.0)
        filter.SetScatteringCoefficient(*haze.scattering)
        filter.SetAbsorptionCoefficient(*(haze.extinction - haze.scattering))
        filter.SetAsymmetry(haze.g)
        filter.Update()
        arrays = filter.GetOutput().GetPointData()
        return [vtk_to_numpy(arrays.GetArray(name)).reshape(size[1], size[0], 3)
                for name in ("Radiance", "Transmittance")]


class HeldOut(unittest.TestCase):
    def setUp(self):
        self.messages = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.messages)
        self.addCleanup(vtkOutputWindow.SetInstance, None)
        self.size = tuple(number // STRIDE for number in SIZE)

    def tearDown(self):
        self.assertEqual(self.messages.GetOutput(), "")

    def test_the_integrator_itself(self):
        """A uniform box in a sun, whose light is a closed form; and with fewer points it is the same."""
        sigma, width = 0.7, 3.0
        points = numpy.full((1, 5, 4, 6), sigma)
        to_world = numpy.diag([width / 5, width / 3, width / 4, 1.0])
        grid = truth.Grid(points, 0.5 * points, to_world, 0.4)
        start, along = numpy.array([[1.4, 1.7, -2.0]]), numpy.array([[0.0, 0.0, 1.0]])
        for height, side in ((1.0, 0), (-1.0, 0), (0.0, 1.0)):
            sun = truth.Light((1, 2, 3), direction=(side, 0, height))
            phase = truth.henyey_greenstein(0.4, height)
            back = {1.0: width * math.exp(-sigma * width), 0.0: math.exp(-sigma * (width - 1.4)) * -math.expm1(
                -sigma * width) / sigma, -1.0: -math.expm1(-2 * sigma * width) / (2 * sigma)}[height]
            radiance, left = truth.integrate(start, along, numpy.array([9.0]), [grid], [sun])
            numpy.testing.assert_allclose(radiance[0], 0.5 * sigma * phase * back * numpy.array([1, 2, 3]), 1e-7)
            numpy.testing.assert_allclose(left, math.exp(-sigma * width), 1e-12)
        lamp = truth.Light((1, 1, 1), place=(1.4, 1.7, -1.0))  # on the ray, where 1/r^2 is 1/(s - 1)^2
        haze = truth.Haze((0.1, 0.1, 0.1), (0.2, 0.2, 0.2), 0.3)
        radiance, left = truth.integrate(start + [[0.0, 2.0, 0.0]], along, numpy.array([5.0]), [], [lamp], haze)
        steps = (numpy.arange(200000) + 0.5) / 40000
        away = numpy.hypot(2.0, steps - 1.0)
        light = 0.1 * truth.henyey_greenstein(0.3, (1.0 - steps) / away) * numpy.exp(-0.3 * (steps + away)) / away**2
        numpy.testing.assert_allclose(radiance[0], light.sum() / 40000, 1e-6)
        numpy.testing.assert_allclose(left, math.exp(-1.5), 1e-12)

    def test_scenes(self):
        """Pictures of the pass, as godrays.measure() and GetScatteringImage() have them."""
        errors = []
        for seed in range(SEED, SEED + (40 if LONG else 2)):
            scene = Scene(seed)
            radiance, left = scene.integrate(self.size)
            found, image, _ = scene.render()
            of_light, largest = get_error(pick(found["Radiance"]), radiance)
            of_sight, _ = get_error(pick(found["Transmittance"]), left)
            errors.append((of_light, of_sight))
            print(f"radiance {of_light:.5f}, at most {largest:.4f}; transmittance {of_sight:.5f}; scene {scene}")
            with self.subTest(scene=str(scene)):
                self.assertLess(of_light, 1 / 255)
                self.assertLess(of_sight, 4 / 255)  # as Documentation/Numbers.md says
                # rays are those of the numbers, of lights that make a white surface white
                largest = abs(image[..., :3] - math.pi * found["Radiance"]).max()
                self.assertLess(largest, 1e-5 * image.max())
                if not LONG:  # the control: without the shadow of data, and with light that is turned back
                    dark, _ = scene.integrate(self.size, shadows=False)
                    self.assertGreater(get_error(pick(found["Radiance"]), dark)[0], max(2 / 255, 3 * of_light))
                    scene.g = -0.7 if scene.g > 0 else 0.7
                    turned, _ = scene.integrate(self.size)
                    self.assertGreater(get_error(pick(found["Radiance"]), turned)[0], max(2 / 255, 3 * of_light))
        report("pass", errors)

    def test_filters(self):
        """The reference and the fast way, without OpenGL."""
        errors = []
        for seed in range(SEED, SEED + (40 if LONG else 2)):
            scene = FilterScene(seed)
            radiance, left, own = scene.integrate(self.size, points=12 if LONG else 4)
            exact = godrays.vtkGodRaysSingleScatteringReference()
            exact.SetTolerance(1e-7)
            light, sight = scene.execute(exact, 2, self.size)
            of_exact, largest = get_error(light, radiance)
            of_sight = abs(sight - left).max()
            fast, _ = scene.execute(godrays.vtkGodRaysGridFilter(), 0, SIZE)
            of_fast = math.sqrt(((pick(fast) - own)**2).mean()) / (radiance.max() or 1.0)
            errors.append((of_exact, of_sight, of_fast))
            print(f"reference {of_exact:.1e}, at most {largest:.1e}; transmittance {of_sight:.1e}; "
                  f"fast {of_fast:.5f}; scene {scene}")
            with self.subTest(scene=str(scene)):
                self.assertLess(of_exact, 1e-4)  # what the quadrature here is off by
                self.assertLess(of_sight, 1e-6)
                self.assertLess(of_fast, 1 / 255)
        report("filters", errors)


def report(name, errors):
    each = numpy.array(errors)
    print(f"{name}: {len(each)} scenes from seed {SEED} on; medians", numpy.median(each, 0), "at most", each.max(0))


if __name__ == "__main__":
    unittest.main()
