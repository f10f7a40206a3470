# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests with PyVista and vedo share: numbers for the light that rays add to a picture."""

import sys
import unittest


def skip(needed, reason):
    """End the program as a test that CTest counts as skipped."""
    print(f"SKIPPED: these tests need {needed}: {reason}")
    sys.exit(77)


try:
    import numpy
except ImportError as error:
    skip("NumPy", error)

SIZE = (320, 240)
BEHIND = (0.08, 0.12, -1)  # a sun behind the scene, seen from the positive z axis
SHAFTS = {"light": BEHIND, "background_glow_radius": 5.0, "exposure": 0.25}


def levels(picture):
    """A picture's colours as numbers that can be subtracted."""
    return numpy.asarray(picture)[..., :3].astype(float)


def correlation(a, b):
    """How alike two pictures' structure is, 1 at most."""
    return float(numpy.corrcoef(a.ravel(), b.ravel())[0, 1])


def difference(a, b):
    """The mean and the largest difference of two pictures' levels."""
    off = numpy.abs(levels(a) - levels(b))
    return float(off.mean()), float(off.max())


def reduced(picture, factor):
    """The picture with each block of pixels as one, its mean."""
    rows, columns = (n // factor for n in picture.shape[:2])
    blocks = levels(picture)[: rows * factor, : columns * factor]
    return blocks.reshape(rows, factor, columns, factor, 3).mean((1, 3))


def with_and_without(show, plotter, rays):
    """The picture that show() returns, and the same with rays of no intensity."""
    rays.SetIntensity(0)
    show(plotter)  # depth of field finds its focus in a frame before
    without = show(plotter)
    rays.SetIntensity(1)
    picture = show(plotter)
    return picture, without


def light_of(picture, without):
    """What rays add to a picture."""
    return levels(picture) - levels(without)


def check_effects(case, effects):
    """check_effect() for each of several, by name."""
    case.assertGreater(case.light.mean(), 3)
    for name, effect in effects.items():
        with case.subTest(name):
            check_effect(case, name, effect)


def check_effect(case, name, effect):
    """Rays are the same before and after an effect, much as without it, and leave the effect as it is.

    case.light is what rays add to the picture without the effect; case.pictures(effect, rays_first) gives
    the picture with rays, without, and the plan, or for None the effect's picture alone.
    """
    alone = case.pictures(effect, None)
    pictures = []
    # Of the same scene without rays, VTK 9.1 has two pictures with depth of field, 0.18 apart, by chance.
    limit = 0.3 if "depth of field" in name else 0.05
    for rays_first in (True, False):
        with case.subTest(rays_first=rays_first):
            picture, without, plan = case.pictures(effect, rays_first)
            pictures.append(picture)
            light = light_of(picture, without)
            alike = correlation(light, case.light)
            share = light.mean() / case.light.mean()
            kept = difference(without, alone)
            print(f"{name}, rays {'first' if rays_first else 'last'}: light {share:.3f} of that without, "
                f"correlation {alike:.4f}; the effect off by {kept[0]:.4f}", flush=True)
            case.assertIn("light: directional", plan)
            case.assertGreater(alike, 0.93)
            case.assertTrue(0.8 < share < 1.2, share)
            case.assertLess(kept[0], limit)
    off = difference(*pictures)
    print(f"{name}: the orders differ by {off[0]:.4f}, at most {off[1]:.0f}", flush=True)
    case.assertLess(off[0], limit)
    case.assertLessEqual(off[1], 8)
