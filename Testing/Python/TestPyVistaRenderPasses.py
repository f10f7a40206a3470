# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""The provider for the package pyvista-render-passes, with a component that uses it as that one does."""

import importlib.metadata

from pyvista_testing import *
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkDepthOfFieldPass,
    vtkLightsPass,
    vtkOpaquePass,
    vtkOpenGLFXAAPass,
    vtkOverlayPass,
    vtkRenderPassCollection,
    vtkSequencePass,
    vtkTranslucentPass,
)

import godrays


def sequence(*passes):
    collection = vtkRenderPassCollection()
    for each in passes:
        collection.AddItem(each)
    result = vtkSequencePass()
    result.SetPasses(collection)
    return result


class FakeComponent:
    """The passes of one renderer, built as it starts to render: the scene, effects, then texts."""

    def __init__(self, renderer):
        self.renderer = renderer
        self.dof = False
        self.seats = []
        points = importlib.metadata.entry_points(group="pyvista_render_passes.providers")
        self.provider = next(each for each in points if each.name == "god_rays").load()()
        assert not self.provider.stages and not self.provider.veto({})
        self.provider.set_state(self.provider.get_state())
        self.provider.bind(self.invalidate)
        self.dirty = False
        renderer.AddObserver("StartEvent", self.start)

    def GetDepthOfField(self):
        return self.dof

    def GetBlur(self):
        return False

    def invalidate(self):
        self.dirty = True

    def start(self, *_):
        if not self.dirty:
            return
        self.dirty = False
        for each in self.seats:
            each.ReleaseGraphicsResources(self.renderer.GetRenderWindow())
        self.renderer.SetPass(None)
        self.seats = []
        if "post" in self.provider.stages:
            seat = self.provider.build_pass("post", self.renderer, self, None)
            self.seats = [seat] if seat else []
        top = vtkCameraPass()
        top.SetDelegatePass(sequence(vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass()))
        effects = [vtkDepthOfFieldPass()] * self.dof + self.seats + [vtkOpenGLFXAAPass()]
        for effect in effects:
            effect.SetDelegatePass(top)
            top = effect
        self.effects = effects
        self.renderer.SetPass(sequence(top, vtkOverlayPass()))


class Provider(unittest.TestCase):
    def setUp(self):
        plotter = make_plotter()
        rays = godrays.enable(plotter, **SHAFTS)
        self.light = light_of(*with_and_without(plotter, rays))
        plotter.close()

        self.plotter = make_plotter()
        self.plotter.add_text("over it all", color="white", font_size=10)
        self.component = FakeComponent(self.plotter.renderer)

    def tearDown(self):
        self.plotter.close()

    def check(self, rays):
        for _ in range(2):
            picture, without = with_and_without(self.plotter, rays)
        light = levels(picture) - levels(without)
        self.assertGreater(correlation(light, self.light), 0.95)
        self.assertTrue(0.85 < light.mean() / self.light.mean() < 1.15)
        text = levels(without).min(2) == 255
        self.assertGreater(text.sum(), 20)
        self.assertLessEqual(numpy.abs(light[text]).max(), 1)  # drawn after the rays

    def test_rays_before_and_after_the_first_build(self):
        for before in (True, False):
            with self.subTest(before=before):
                if not before:
                    self.component.invalidate()
                    show(self.plotter)
                    self.assertEqual(self.component.seats, [])
                rays = godrays.enable(self.plotter, **SHAFTS)
                if before:
                    show(self.plotter)
                    self.component.invalidate()
                show(self.plotter)
                self.assertEqual(self.component.seats, [rays])
                self.assertIs(self.component.effects[-1].GetDelegatePass(), rays)
                self.check(rays)
                self.component.invalidate()  # again: the same pass
                self.check(rays)
                self.assertIs(godrays.enable(self.plotter.renderer), rays)
                godrays.disable(self.plotter.renderer)
                bare = show(self.plotter)
                self.assertEqual(self.component.seats, [])
                self.assertIsNone(godrays.vtkGodRaysPass.Find(self.plotter.renderer))
                self.assertEqual(difference(show(self.plotter), bare), (0, 0))

    def test_under_depth_of_field(self):
        for prop in list(self.plotter.renderer.GetViewProps()):
            if prop.IsA("vtkActor2D"):  # VTK blurs texts as well
                self.plotter.renderer.RemoveViewProp(prop)
        self.component.dof = True
        rays = godrays.enable(self.plotter, **SHAFTS)
        self.component.invalidate()
        show(self.plotter)
        self.assertEqual(self.component.seats, [])
        self.assertIs(self.component.effects[0].GetDelegatePass(), rays)
        picture, without = with_and_without(self.plotter, rays)
        self.assertGreater(correlation(levels(picture) - levels(without), self.light), 0.9)

    def test_the_seat_is_free_without_rays(self):
        provider = self.component.provider
        self.assertEqual(provider.stages, ())
        godrays.enable(self.plotter, **SHAFTS)
        self.assertEqual(provider.stages, ("post",))
        provider.bind(None)
        self.assertEqual(provider.stages, ())
        godrays.disable(self.plotter)


if __name__ == "__main__":
    unittest.main()
