# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is written in a scene blocks the same light with a margin about the picture and without one, and what lies over
the picture is in its order."""

import unittest

import godrays
import numpy
import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingAnnotation import vtkAxesActor, vtkCaptionActor2D, vtkLegendScaleActor
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkBillboardTextActor3D,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
)
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkDepthOfFieldPass,
    vtkEDLShading,
    vtkOpenGLFXAAPass,
    vtkRenderPassCollection,
    vtkRenderStepsPass,
    vtkSequencePass,
    vtkShadowMapPass,
    vtkSSAOPass,
    vtkToneMappingPass,
)

WIDTH, HEIGHT = 160, 120
MARGIN = 0.25


class Labels(unittest.TestCase):
    def setUp(self):
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(WIDTH, HEIGHT)
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, 0, 10)
        camera.SetViewAngle(40)
        camera.SetClippingRange(1, 100)
        self.rays = godrays.vtkGodRaysPass()
        self.rays.SetBackgroundGlow(1)  # wherever nothing blocks it
        self.rays.SetBackgroundGlowFalloff(120)
        sun = vtkLight()
        sun.SetPosition(0.1, 0.1, -1)
        self.rays.AddLight(sun)
        self.rays.Attach(self.renderer)

    def blocked(self, margin):
        """In which pixels of the picture no light is."""
        self.rays.SetLayerMargin(margin)
        self.window.Render()
        image = vtkImageData()
        self.assertTrue(self.rays.GetOcclusionImage(image), self.rays.GetPlan())
        columns, rows, _ = image.GetDimensions()
        layer = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[..., 0]
        left, low = (columns - WIDTH) // 2, (rows - HEIGHT) // 2
        return layer[low:low + HEIGHT, left:left + WIDTH] == 0

    def test_billboards(self):
        text = vtkBillboardTextActor3D()
        text.SetInput("HH")
        text.GetTextProperty().SetFontSize(40)
        text.GetTextProperty().SetBold(True)
        text.SetForceOpaque(True)
        text.SetPosition(-1, 0, 0)
        self.renderer.AddViewProp(text)
        for turn in range(3):  # the second and third with another camera, and another margin before
            self.renderer.GetActiveCamera().Azimuth(5 * turn)
            without = self.blocked(0)
            wide = self.blocked(MARGIN)
            print("billboard, pixels that block:", without.sum(), wide.sum(), "differ", (without != wide).sum())
            self.assertGreater(without.sum(), 500)
            self.assertLess((without != wide).sum(), 0.02 * without.sum())

    def test_billboards_that_vtk_does_not_draw(self):
        text = vtkBillboardTextActor3D()
        text.SetInput("outside")
        text.GetTextProperty().SetFontSize(40)
        text.SetPosition(-5, 0, 0)  # left of the picture, into which the text reaches
        self.renderer.AddViewProp(text)
        self.rays.Detach(self.renderer)
        without = self.shown()
        self.rays.Attach(self.renderer)
        for margin in 0, 0, MARGIN, 0:
            self.assertFalse(self.blocked(margin).any())
            numpy.testing.assert_array_equal(self.shown()[..., 3], without[..., 3])

    def test_axes(self):
        axes = vtkAxesActor()
        axes.SetTotalLength(2, 2, 2)
        axes.SetNormalizedLabelPosition(1.5, 1.5, 1.5)  # not before the axes
        axes.SetVisibility(False)
        self.renderer.AddViewProp(axes)
        nothing = self.blocked(0)
        axes.SetVisibility(True)
        layers = []
        for labels, margin in (True, 0), (False, 0), (True, MARGIN), (False, MARGIN):
            axes.SetAxisLabels(labels)
            layers.append(self.blocked(margin))
        print("axes, pixels that block:", [layer.sum() for layer in layers])
        self.assertEqual(nothing.sum(), 0)
        self.assertGreater(layers[1].sum(), 100)  # axes block
        numpy.testing.assert_array_equal(layers[0], layers[1])  # labels do not
        numpy.testing.assert_array_equal(layers[2], layers[3])

    def shown(self):
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, WIDTH - 1, HEIGHT - 1, 1, pixels)
        return vtk_to_numpy(pixels).reshape(HEIGHT, WIDTH, 4).copy()

    def test_scales_are_drawn_after_the_light(self):
        pictures = []
        scale = vtkLegendScaleActor()
        for background in 0, 1, 0:
            self.renderer.SetBackground(background, background, background)
            pictures.append(self.shown())
            self.renderer.AddViewProp(scale)
            pictures.append(self.shown())
            self.renderer.RemoveViewProp(scale)
            if background == 0:
                self.rays.Detach(self.renderer)
        lit, lit_scale, _, over_white, black, over_black = pictures
        self.assertGreater((lit != black).any(axis=2).sum(), 1000)
        covered = (over_white == over_black).all(axis=2)  # by what is opaque
        self.assertGreater(covered.sum(), 300)
        numpy.testing.assert_array_equal(lit_scale[covered], over_black[covered])

    def test_text_in_a_subplot_under_each_effect(self):
        """Its box is that without the effect; some of VTK's leave the viewport of the window."""
        self.renderer.SetViewport(0.5, 0, 1, 1)
        other = vtkRenderer()
        other.SetViewport(0, 0, 0.5, 1)
        self.window.AddRenderer(other)
        cube = vtkCubeSource()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(cube.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.5, 0.3, 0.2)
        self.renderer.AddActor(actor)
        lamp = vtkLight()
        lamp.SetPosition(3, 4, 6)
        lamp.SetPositional(True)
        lamp.SetConeAngle(40)
        self.renderer.AddLight(lamp)
        text = vtkTextActor()
        text.SetInput("HIH")
        text.GetTextProperty().SetColor(0, 1, 0)
        text.GetTextProperty().SetFontSize(20)
        text.SetPosition(8, 5)
        self.renderer.AddViewProp(text)

        def written():
            picture = self.shown()
            green = picture[..., 1].astype(int)
            rows, columns = numpy.nonzero((green > picture[..., 0] + 60) & (green > picture[..., 2] + 60))
            self.assertGreater(len(rows), 30)
            return numpy.array([rows.min(), rows.max(), columns.min(), columns.max()])

        expected = written()
        self.assertGreater(expected[2], WIDTH // 2)

        def over(kind, delegate=None):
            effect = kind()
            effect.SetDelegatePass(delegate or vtkRenderStepsPass())
            self.renderer.SetPass(effect)

        def shadows():
            passes = vtkRenderPassCollection()
            shadow = vtkShadowMapPass()
            for each in (shadow.GetShadowMapBakerPass(), shadow):
                passes.AddItem(each)
            sequence = vtkSequencePass()
            sequence.SetPasses(passes)
            camera = vtkCameraPass()
            camera.SetDelegatePass(sequence)
            self.renderer.SetPass(camera)

        for name, put in {
            "enable_shadows": lambda: self.renderer.SetUseShadows(True),
            "ambient occlusion": lambda: self.renderer.SetUseSSAO(True),
            "shadow maps": shadows,
            "vtkSSAOPass": lambda: over(vtkSSAOPass),
            "vtkEDLShading": lambda: over(vtkEDLShading),
            "vtkDepthOfFieldPass": lambda: over(vtkDepthOfFieldPass),
            "vtkToneMappingPass": lambda: over(vtkToneMappingPass),
            "vtkOpenGLFXAAPass": lambda: over(vtkOpenGLFXAAPass),
        }.items():
            with self.subTest(name):
                self.rays.Detach(self.renderer)
                self.renderer.SetPass(None)
                put()
                self.rays.Attach(self.renderer)
                found = written()
                self.assertIn("scattering:", self.rays.GetPlan())
                self.assertLessEqual(abs(found - expected).max(), 1, (found, expected))
                self.renderer.SetUseShadows(False)
                self.renderer.SetUseSSAO(False)

    def test_captions_keep_their_leaders_beside_text(self):
        text = vtkTextActor()
        text.SetInput("O O O")
        text.GetTextProperty().SetFontSize(40)
        text.SetPosition(40, 40)
        caption = vtkCaptionActor2D()
        caption.SetCaption("caption")
        caption.SetAttachmentPoint(-2, -2, 0)
        caption.SetPosition(60, 60)
        self.renderer.AddViewProp(text)
        alone = self.shown()
        self.renderer.AddViewProp(caption)
        alpha = self.shown()[..., 3]
        self.assertGreater((alpha != alone[..., 3]).sum(), 200)
        self.rays.Detach(self.renderer)
        numpy.testing.assert_array_equal(alpha, self.shown()[..., 3])


if __name__ == "__main__":
    unittest.main()
