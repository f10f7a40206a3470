# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The outdoor scene: rays blur nothing, smoke is a body from every side, and time runs; shafts that are baked into
the sky stay behind the scene, and are those that are drawn live; and smoke in haze is the truth, in clouds' shafts.

Usage: TestOutdoor.py example.py program
"""

import os
import runpy
import subprocess
import sys

import godrays
import numpy
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy


def shown():
    """What the window shows, as rows of levels from the bottom up."""
    window.Render()
    grabber = vtk.vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    grabber.Update()
    return pixels(grabber.GetOutput()).astype(int)


def pixels(image):
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1).copy()


def layer(get):
    image = vtk.vtkImageData()
    assert get(image), rays.GetPlan()
    return pixels(image)


def linear(level):
    value = level / 255
    return numpy.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def encoded(light):
    light = numpy.minimum(light, 1)
    curve = 1.055 * numpy.maximum(light, 0.0031308) ** (1 / 2.4) - 0.055
    return 255 * numpy.where(light <= 0.0031308, 12.92 * light, curve)


def check(what, condition, figures):
    print(f"{'good' if condition else 'BAD'}: {what}: {figures}")
    failures.extend([] if condition else [what])


def with_and_without_rays():
    """The picture with rays, their light in it, and the picture without them."""
    intensity = rays.GetIntensity()
    with_rays = shown()
    light = intensity * layer(rays.GetScatteringImage)
    rays.SetIntensity(0)
    without = shown()
    rays.SetIntensity(intensity)
    return with_rays, light, without


def check_nothing_is_blurred():
    """With rays, each pixel is its own light and the rays', but for rounding and noise of half a level each,
    and nothing of its neighbours'."""
    rays.HighlightShoulderOff()  # the plain sum
    with_rays, light, without = with_and_without_rays()
    rays.HighlightShoulderOn()
    error = numpy.abs(encoded(linear(without) + light) - with_rays).max()
    check("the picture is the scene and the rays", error <= 1.01, f"{error:.2f} levels")
    blurred = (without + numpy.roll(without, 1, axis=1)) // 2
    error = numpy.abs(encoded(linear(blurred) + light) - with_rays).max()
    check("a blur over two pixels would be seen", error > 10, f"{error:.2f} levels")
    model = rays.GetModel()
    density = model.GetDensity()
    model.SetDensity(density / 2)  # shorter shafts, so that there are places without any
    with_rays, light, without = with_and_without_rays()
    model.SetDensity(density)
    away = light.max(axis=2) == 0
    same = (with_rays == without).all(axis=2)
    part = f"{away.mean():.0%} of the picture"
    check("away from shafts bytes stay", same[away].all() and away.mean() > 0.2, part)
    check("in shafts they do not", same.mean() < 0.95, f"{same.mean():.0%} are the same")


def opacity_of_smoke(side):
    """What the smoke takes from the light behind it, as seen along x or y: rendered, and expected."""
    camera = renderer.GetActiveCamera()
    bounds = smoke.GetBounds()
    center = numpy.array(smoke.GetCenter())
    view = numpy.array((0, 1, 0) if side == "y" else (1, 0, 0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale((bounds[5] - bounds[4]) / 2)
    camera.SetPosition(center - 20 * view)
    camera.SetFocalPoint(center)
    camera.SetClippingRange(1, 100)
    sun.SetPosition(100 * view)
    layers = []
    for visible in False, True:
        smoke.SetVisibility(visible)
        window.Render()
        layers.append(layer(rays.GetOcclusionImage)[..., 0])
    rendered = 1 - layers[1] / layers[0]

    density = plume.GetOutput()
    nx, ny, nz = density.GetDimensions()
    grid = vtk_to_numpy(density.GetPointData().GetScalars()).reshape(nz, ny, nx)
    alpha = numpy.minimum(0.6 * grid, 0.6)  # the transfer function of the example
    unit = smoke.GetProperty().GetScalarOpacityUnitDistance()
    depth = -numpy.log1p(-alpha).sum(axis=1 if side == "y" else 2) * plume.GetSpacing() / unit
    if side == "x":
        depth = depth[:, ::-1]  # from the west, y goes to the left
    height, width = rendered.shape
    z = (numpy.arange(height) + 0.5) / height * (nz - 1)
    x = ((numpy.arange(width) + 0.5) - width / 2) / height * (nz - 1) + (depth.shape[1] - 1) / 2
    inside = (x >= 0) & (x <= depth.shape[1] - 1)
    columns = numpy.array([numpy.interp(x[inside], numpy.arange(depth.shape[1]), row) for row in depth])
    expected = numpy.array([numpy.interp(z, numpy.arange(nz), column) for column in columns.T]).T
    return rendered[:, inside], 1 - numpy.exp(-expected)


def check_smoke_is_a_body():
    for prop in ground, clouds, flames:
        prop.VisibilityOff()
    renderer.SetPass(rays)
    silhouettes = {}
    for side in "y", "x":
        rendered, expected = opacity_of_smoke(side)
        silhouettes[side] = rendered
        error = numpy.sqrt(numpy.mean((rendered - expected) ** 2))
        check(
            f"smoke along {side} takes what its density says",
            error < 0.02 and expected.max() > 0.8,
            f"{error:.4f} root mean square, {expected.max():.2f} at most",
        )
    # A plane that turns to the camera would show the same from both.
    difference = numpy.sqrt(numpy.mean((silhouettes["y"] - silhouettes["x"]) ** 2))
    check("the two sides differ", difference > 0.1, f"{difference:.3f} root mean square")


def check_time_runs():
    first = shown()
    for _ in range(10):
        advance()
    later = shown()
    moved = (numpy.abs(first - later) > 5).any(axis=2).mean()
    check("a fifth of a second of the sources moves the picture", moved > 0.05, f"{moved:.2%} of it")


def covered():
    """Where the scene is opaque."""
    window.Render()
    grabber = vtk.vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.SetInputBufferTypeToZBuffer()
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    grabber.Update()
    return pixels(grabber.GetOutput())[..., 0] < 1


def check_baked_shafts_are_behind():
    """Before the baked sky, each pixel of the scene is what it is without any rays."""
    baked = shown()
    ground_seen = covered()
    box.VisibilityOff()
    without = shown()
    rays.Attach(renderer)
    with_rays = shown()
    rays.Detach(renderer)
    box.VisibilityOn()
    error = numpy.abs(baked - without)[ground_seen].max()
    part = f"{ground_seen.mean():.0%} of the picture"
    check("the baked sky is behind", error == 0 and ground_seen.mean() > 0.3, f"{error} levels in {part}")
    veil = numpy.abs(with_rays - without)[ground_seen].max(axis=1)
    check("a veil would be seen", numpy.median(veil) > 5, f"{numpy.median(veil)} levels in the median")


def show_only(*props):
    """Let nothing be seen but these."""
    for prop in ground, clouds, smoke, flames, box:
        prop.SetVisibility(prop in props)


def difference_of_blocks(picture, other):
    """Root mean square, over blocks of 5 x 5 pixels: the sky's texels are as large as a pixel, so that
    edges of clouds are softer in it."""
    rows, columns, _ = picture.shape
    blocks = (picture - other).reshape(rows // 5, 5, columns // 5, 5, -1).mean(axis=(1, 3))
    return numpy.sqrt(numpy.mean(blocks**2))


def check_baked_sky_is_the_live_one():
    """In whatever direction one looks, the box shows what sky, clouds and rays are when drawn now."""
    camera = renderer.GetActiveCamera()
    for angle in 0, 100, 180:
        camera.Yaw(angle)
        show_only(box)
        sky_pass = renderer.GetPass()
        godrays.vtkGodRaysSkyPass.Detach(renderer)
        baked = shown()
        renderer.SetPass(sky_pass)
        show_only(clouds)
        rays.Attach(renderer)
        live = shown()
        rays.Detach(renderer)
        camera.Yaw(-angle)

        where = f"at {angle} degrees"
        found = difference_of_blocks(baked, live)
        check(f"the baked sky is the live one {where}", found < 3, f"{found:.2f} levels")
        beside = difference_of_blocks(numpy.roll(baked, (2, 2), axis=(0, 1)), live)
        check(f"two pixels beside it is not {where}", beside > 4, f"{beside:.2f} levels")
        twice = difference_of_blocks(encoded(baked / 255), live)
        check(f"encoded twice it is not {where}", twice > 40, f"{twice:.2f} levels")


def jump_across_edges(panorama):
    """How much more levels change across an edge of the cube than beside it, at the worst of all edges."""
    height, width, _ = panorama.shape

    def level(x, y, z):
        column = (numpy.arctan2(x, z) / (2 * numpy.pi) + 0.5) * width
        row = (numpy.arctan2(y, numpy.hypot(x, z)) / numpy.pi + 0.5) * height
        return panorama[row.astype(int), column.astype(int) % width]

    def jump(axis, a, b):
        along = numpy.roll(numpy.eye(3), axis, axis=1)
        edge = (a * along[1] + b * along[2])[:, None] + along[0][:, None] * numpy.linspace(-0.9, 0.9, 400)
        step = 0.006 * (a * along[1] - b * along[2])[:, None]  # a texel or two
        levels = [level(*(edge + i * step)) for i in (-1.5, -0.5, 0.5, 1.5)]
        before, across, after = numpy.abs(numpy.diff(levels, axis=0)).mean(axis=(1, 2))
        return across - max(before, after)

    signs = (-1, 1)
    return max(jump(axis, a, b) for axis in range(3) for a in signs for b in signs)


def check_faces_meet():
    from bake_sky import take_panorama  # beside the example

    show_only(clouds)
    rays.Attach(renderer)
    window.RemoveRenderer(renderer)
    model = rays.GetModel()
    density = model.GetDensity()
    jumps = []
    for each in density, 0.98:  # the baked shafts, and those that are drawn live
        model.SetDensity(each)
        jumps.append(jump_across_edges(pixels(take_panorama(renderer)).astype(int)))
    model.SetDensity(density)
    window.AddRenderer(renderer)
    rays.Detach(renderer)
    check("the faces of the sky meet", jumps[0] < 0.5, f"{jumps[0]:.2f} levels")
    check("long shafts would end at an edge", jumps[1] > 5, f"{jumps[1]:.2f} levels")


def check_both_programs_agree():
    picture = os.path.join(folder, "Outdoor-medium_program.png")
    subprocess.run([program, picture, "400x300", "medium"], check=True)
    reader = vtk.vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    error = numpy.abs(pixels(reader.GetOutput()).astype(int) - shown()).max()
    check("C++ and Python draw the same medium", error <= 2, f"{error} levels")


def check_clouds_make_shafts():
    shown()
    light = layer(rays.GetScatteringImage)
    godrays.vtkGodRaysPass.SetRole(clouds, godrays.vtkGodRaysPass.IGNORED)
    shown()
    without = layer(rays.GetScatteringImage)
    godrays.vtkGodRaysPass.SetRole(clouds, godrays.vtkGodRaysPass.OCCLUDER)
    shadow = (1 - light.sum(axis=2) / without.sum(axis=2))[covered()]
    low, high = numpy.percentile(shadow, (5, 95))
    check("below the clouds light is in shafts", high - low > 0.2, f"from {low:.2f} to {high:.2f} of it are taken")


def check_smoke_in_haze_is_the_truth():
    """Of what the exact reference has: no clouds, which are translucent, and no flames, which are points."""
    clouds.VisibilityOff()
    flames.VisibilityOff()
    rays.GetIntegrator().SetVerifyPixels(300)
    shown()
    error = rays.GetIntegrator().GetErrorEstimate()
    check("smoke and haze are within the tolerance", 0 < error < 1 / 255, f"{error:.4f}")
    smoky = layer(rays.GetScatteringImage)
    smoke.VisibilityOff()
    shown()
    change = numpy.abs(smoky - layer(rays.GetScatteringImage)).max() / smoky.max()
    check("without the smoke they would not be", change > 0.05, f"{change:.2f}")


folder = os.getcwd()
example, program = sys.argv[1:]
sys.path.insert(0, os.path.dirname(example))
failures = []


def run(*variant):
    """Run the example, and take over what it has by these names."""
    sys.argv = [example, os.path.join(folder, "Outdoor_checks.png"), "400x300", *variant]
    scene = runpy.run_path(example)
    names = "renderer window rays sun smoke plume advance ground clouds flames"
    globals().update((name, scene[name]) for name in names.split())


run()
check_nothing_is_blurred()
check_time_runs()
check_smoke_is_a_body()
run("baked")
box = next(prop for prop in renderer.GetViewProps() if prop.IsA("vtkSkybox"))
check_baked_shafts_are_behind()
check_baked_sky_is_the_live_one()
check_faces_meet()
run("medium")
check_both_programs_agree()
check_clouds_make_shafts()
check_smoke_in_haze_is_the_truth()
sys.exit(f"{len(failures)} checks failed" if failures else 0)
