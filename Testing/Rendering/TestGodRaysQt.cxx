// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// In Qt's widget, which owns the framebuffer that VTK draws into, and whose context goes and comes with its
// place among other widgets.

#include "GodRaysTesting.h"

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkNew.h"

#include <QApplication>
#include <QImage>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <array>
#include <cstddef>
#include <vector>

using namespace GodRaysTesting;

namespace
{
/// What the widget shows after a frame, as GetPixels() has it; alpha is what Qt takes it for, 255.
std::vector<unsigned char> GetShown(QVTKOpenGLNativeWidget& widget)
{
  widget.renderWindow()->Render();
  QCoreApplication::processEvents();
  const QImage image = widget.grabFramebuffer().convertToFormat(QImage::Format_RGBX8888);
  std::vector<unsigned char> pixels;
  for (int y = image.height() - 1; y >= 0; --y)
  {
    const unsigned char* line = image.constScanLine(y);
    pixels.insert(pixels.end(), line, line + std::ptrdiff_t{ 4 } * image.width());
  }
  return pixels;
}

void Show(QWidget& widget, int width, int height)
{
  widget.setMinimumSize(1, 1);
  widget.resize(width, height);
  widget.show();
  QCoreApplication::processEvents();
}

/// A widget that shows the renderer of a scene, which leaves its own window.
struct Shown
{
  Stage Scene;
  vtkNew<vtkGenericOpenGLRenderWindow> Window;
  QVTKOpenGLNativeWidget Widget;

  Shown(int width, int height)
  {
    this->Scene.Window->RemoveRenderer(this->Scene.Renderer);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Scene.Renderer);
    this->Widget.setRenderWindow(this->Window);
    this->Scene.AddPillarsAndSun();
    Show(this->Widget, width, height);
  }
};

/// The same in a window of VTK's of that size.
std::vector<unsigned char> GetExpected(int width, int height, bool rays = true)
{
  Stage scene(width, height);
  scene.AddPillarsAndSun();
  if (!rays)
  {
    scene.Rays->Detach(scene.Renderer);
  }
  return GetPixels(scene.Window);
}
}

TEST(GodRaysQt, AWidgetShowsWhatAWindowDoes)
{
  Messages messages;
  Shown shown(128, 96);
  for (const auto& size : { std::array<int, 2>{ 128, 96 }, { 97, 61 }, { 200, 150 }, { 128, 96 } })
  {
    shown.Widget.resize(size[0], size[1]);
    QCoreApplication::processEvents();
    const auto pixels = GetShown(shown.Widget);
    const auto expected = GetExpected(size[0], size[1]);
    ASSERT_EQ(pixels.size(), expected.size());
    EXPECT_LE(GetLargestDifference(pixels, expected), 1) << size[0];
    // the control: without rays it is another picture
    EXPECT_GT(GetLargestDifference(pixels, GetExpected(size[0], size[1], false)), 20) << size[0];
  }
  shown.Scene.Rays->Detach(shown.Scene.Renderer);
  EXPECT_LE(GetLargestDifference(GetShown(shown.Widget), GetExpected(128, 96, false)), 1);
  shown.Scene.Rays->Attach(shown.Scene.Renderer);
  EXPECT_LE(GetLargestDifference(GetShown(shown.Widget), GetExpected(128, 96)), 1);
}

TEST(GodRaysQt, AWidgetThatIsPutElsewhereShowsTheSame)
{
  Messages messages;
  Shown shown(128, 96);
  const auto expected = GetExpected(128, 96);
  EXPECT_LE(GetLargestDifference(GetShown(shown.Widget), expected), 1);

  // among others, in another window of the screen: Qt makes a new context
  QWidget other;
  Show(other, 300, 200);
  QOpenGLContext* former = shown.Widget.context();
  ASSERT_NE(former, nullptr);
  shown.Widget.setParent(&other);
  Show(shown.Widget, 128, 96);
  EXPECT_NE(shown.Widget.context(), former) << "Qt kept the context: nothing is tested";
  EXPECT_LE(GetLargestDifference(GetShown(shown.Widget), expected), 1);

  shown.Widget.hide();
  shown.Widget.setParent(nullptr);
  Show(shown.Widget, 128, 96);
  EXPECT_LE(GetLargestDifference(GetShown(shown.Widget), expected), 1);
}

TEST(GodRaysQt, AWidgetMayGoBeforeThePass)
{
  Messages messages;
  Stage kept; // its pass, which outlives the widgets
  vtkGodRaysPass* rays = kept.Rays;
  for (int i = 0; i < 3; ++i)
  {
    Stage scene;
    scene.Window->RemoveRenderer(scene.Renderer);
    auto sun = scene.AddPillarsAndSun();
    scene.Rays->Detach(scene.Renderer);
    rays->RemoveAllLights();
    rays->AddLight(sun);
    rays->Attach(scene.Renderer);
    QVTKOpenGLNativeWidget widget;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    window->SetMultiSamples(0);
    window->AddRenderer(scene.Renderer);
    widget.setRenderWindow(window);
    Show(widget, 128, 96);
    EXPECT_LE(GetLargestDifference(GetShown(widget), GetExpected(128, 96)), 1) << i;
  }
}

int main(int argc, char* argv[])
{
  ::testing::InitGoogleTest(&argc, argv);
  if (::testing::GTEST_FLAG(list_tests)) // without a screen
  {
    return RUN_ALL_TESTS();
  }
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
