// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Where the scene is drawn: viewports, layers, transparent backgrounds, windows that are resized,
// take turns or hand the pass on, and hardware selection.

#include "GodRaysTesting.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataObject.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPropCollection.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace GodRaysTesting;

namespace
{
using Pixels = std::vector<unsigned char>;

/// A rectangle of a picture.
Pixels Cut(const Pixels& picture, int width, int x, int y, int w, int h)
{
  Pixels part;
  for (int row = y; row < y + h; ++row)
  {
    const auto first = picture.begin() + 4 * (static_cast<std::size_t>(row) * width + x);
    part.insert(part.end(), first, first + 4 * w);
  }
  return part;
}

/// A fog in a cube of 2 about the origin.
vtkSmartPointer<vtkVolume> MakeFog()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 9, 9);
  image->SetSpacing(0.25, 0.25, 0.25);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 729, 200);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.2);
  mapper->UseJitteringOff();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(255.0, 0.3);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.9, 0.9, 0.9);
  auto fog = vtkSmartPointer<vtkVolume>::New();
  fog->SetMapper(mapper);
  fog->GetProperty()->SetScalarOpacity(opacity);
  fog->GetProperty()->SetColor(color);
  fog->SetPosition(1.0, 2.0, 1.0);
  return fog;
}

/// What the scene has besides pillars and a sun.
enum Content
{
  PLAIN,
  TAGGED, // an ignored prop, and a layer with a margin
  LAMP,   // a prop that shines
  FOG,    // a volume
  GLASS,  // a translucent prop
  NUMBER_OF_CONTENTS
};

void Fill(vtkRenderer* renderer, vtkGodRaysPass* rays, int content, bool attach = true)
{
  Stage model; // for its camera and background
  renderer->GetActiveCamera()->DeepCopy(model.Renderer->GetActiveCamera());
  renderer->SetBackground(model.Renderer->GetBackground());
  for (int i = -2; i <= 2; ++i)
  {
    renderer->AddActor(MakeBox({ 1.5 * i, 0.3 * i, 0.0 }, { 0.6, 4.0, 0.6 }));
  }
  auto sun = MakeSun({ 0.3, 0.2, -1.0 }, { 1.0, 0.9, 0.7 });
  renderer->AddLight(sun);
  rays->AddLight(sun);
  if (content == TAGGED)
  {
    auto ignored = MakeBox({ 1.0, 0.0, 2.0 }, { 2.0, 1.0, 0.1 });
    vtkGodRaysPass::SetRole(ignored, vtkGodRaysPass::IGNORED);
    renderer->AddActor(ignored);
    rays->SetLayerMargin(0.25);
  }
  else if (content == LAMP)
  {
    auto lamp = MakeLamp({ 2.0, -1.0, -2.0 }, 0.7, { 0.3, 0.6, 1.0 });
    vtkGodRaysPass::SetRole(lamp, vtkGodRaysPass::LIGHT);
    renderer->AddActor(lamp);
  }
  else if (content == FOG)
  {
    renderer->AddVolume(MakeFog());
  }
  else if (content == GLASS)
  {
    auto glass = MakeBox({ 1.0, 0.5, 1.5 }, { 3.0, 2.0, 0.2 }, { 0.2, 0.7, 0.9 });
    glass->GetProperty()->SetOpacity(0.4);
    renderer->AddActor(glass);
  }
  if (attach)
  {
    rays->Attach(renderer);
  }
}

/// A window with one renderer.
struct View
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkGodRaysPass> Rays;

  View(int width, int height, int content, bool attach = true)
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetAlphaBitPlanes(true);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    AddPlainly(this->Rays);
    Fill(this->Renderer, this->Rays, content, attach);
  }
};
}

TEST(GodRaysViewports, OneOfFourHasThePixelsOfAWindowAndTheOthersKeepTheirs)
{
  Messages messages;
  const int w = 64;
  const int h = 48;
  for (int content = PLAIN; content < NUMBER_OF_CONTENTS; ++content)
  {
    View single(w, h, content);
    const Pixels expected = GetPixels(single.Window);
    single.Rays->Detach(single.Renderer);
    const Pixels bare = GetPixels(single.Window);
    ASSERT_GT(CountDifferentPixels(expected, bare), w * h / 2) << content;

    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(true);
    window->SetMultiSamples(0);
    window->SetAlphaBitPlanes(true);
    window->SetSize(2 * w, 2 * h);
    std::array<vtkNew<vtkRenderer>, 4> renderers;
    std::array<vtkNew<vtkGodRaysPass>, 4> passes;
    for (int i = 0; i < 4; ++i)
    {
      const double x = 0.5 * (i % 2);
      const double y = 0.5 * (i / 2);
      renderers[i]->SetViewport(x, y, x + 0.5, y + 0.5);
      window->AddRenderer(renderers[i]);
      AddPlainly(passes[i]);
      Fill(renderers[i], passes[i], content, false);
    }
    for (int on = 0; on < 4; ++on)
    {
      passes[on]->Attach(renderers[on]);
      const Pixels picture = GetPixels(window);
      for (int i = 0; i < 4; ++i)
      {
        const Pixels part = Cut(picture, 2 * w, w * (i % 2), h * (i / 2), w, h);
        EXPECT_EQ(part, i == on ? expected : bare)
          << "viewport " << i << ", rays in " << on << ", content " << content << ", "
          << CountDifferentPixels(part, i == on ? expected : bare) << " pixels";
      }
      passes[on]->Detach(renderers[on]);
    }
    // and all at once
    for (int i = 0; i < 4; ++i)
    {
      passes[i]->Attach(renderers[i]);
    }
    const Pixels picture = GetPixels(window);
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_EQ(Cut(picture, 2 * w, w * (i % 2), h * (i / 2), w, h), expected) << i;
    }
  }
}

TEST(GodRaysViewports, WithEdgesBetweenPixelsAreAsWindowsOfTheirSize)
{
  Messages messages;
  View whole(131, 101, TAGGED);
  whole.Renderer->SetViewport(0.137, 0.281, 0.693, 0.952);
  const Pixels picture = GetPixels(whole.Window);
  const int* size = whole.Renderer->GetSize();
  const int* origin = whole.Renderer->GetOrigin();
  ASSERT_GT(origin[0], 0);
  View single(size[0], size[1], TAGGED);
  const Pixels part = Cut(picture, 131, origin[0], origin[1], size[0], size[1]);
  const Pixels expected = GetPixels(single.Window);
  EXPECT_EQ(part, expected) << CountDifferentPixels(part, expected) << " pixels, by "
                            << GetLargestDifference(part, expected) << " levels";
}

TEST(GodRaysViewports, MayShareTheirProps)
{
  Messages messages;
  const int w = 64;
  const int h = 48;
  for (int content = PLAIN; content < NUMBER_OF_CONTENTS; ++content)
  {
    View single(w, h, content);
    const Pixels expected = GetPixels(single.Window);

    View left(2 * w, h, content);
    left.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
    vtkNew<vtkRenderer> right;
    right->SetViewport(0.5, 0.0, 1.0, 1.0);
    right->SetActiveCamera(left.Renderer->GetActiveCamera());
    right->SetBackground(left.Renderer->GetBackground());
    for (int i = 0; i < left.Renderer->GetViewProps()->GetNumberOfItems(); ++i)
    {
      right->AddViewProp(vtkProp::SafeDownCast(left.Renderer->GetViewProps()->GetItemAsObject(i)));
    }
    right->AddLight(left.Rays->GetLight(0));
    vtkNew<vtkGodRaysPass> rays;
    AddPlainly(rays);
    rays->SetLayerMargin(left.Rays->GetLayerMargin());
    rays->AddLight(left.Rays->GetLight(0));
    left.Window->AddRenderer(right);
    rays->Attach(right);
    for (int frame = 0; frame < 2; ++frame)
    {
      const Pixels picture = GetPixels(left.Window);
      EXPECT_EQ(Cut(picture, 2 * w, 0, 0, w, h), expected) << content << ", frame " << frame;
      EXPECT_EQ(Cut(picture, 2 * w, w, 0, w, h), expected) << content << ", frame " << frame;
    }
    rays->Detach(right);
    const Pixels picture = GetPixels(left.Window);
    EXPECT_EQ(Cut(picture, 2 * w, 0, 0, w, h), expected) << content;
    EXPECT_NE(Cut(picture, 2 * w, w, 0, w, h), expected) << content;
  }
}

TEST(GodRaysViewports, ForgetALampThatIsGone)
{
  Messages messages;
  View never(64, 48, PLAIN);
  View view(64, 48, LAMP);
  const Pixels expected = GetPixels(never.Window);
  EXPECT_NE(GetPixels(view.Window), expected);
  vtkWeakPointer<vtkProp> lamp = view.Renderer->GetViewProps()->GetLastProp();
  view.Renderer->RemoveViewProp(lamp);
  EXPECT_FALSE(lamp) << "it is kept";
  EXPECT_EQ(GetPixels(view.Window), expected);
}

TEST(GodRaysLayers, ATopLayerCoversRaysAndRaysOfATopLayerCoverTheBottom)
{
  Messages messages;
  for (const bool raysOnTop : { false, true })
  {
    const int w = 96;
    const int h = 72;
    View bottom(w, h, PLAIN, false);
    vtkNew<vtkRenderer> top;
    vtkNew<vtkGodRaysPass> topRays;
    AddPlainly(topRays);
    bottom.Window->SetNumberOfLayers(2);
    top->SetLayer(1);
    bottom.Window->AddRenderer(top);
    top->GetActiveCamera()->DeepCopy(bottom.Renderer->GetActiveCamera());
    auto box = MakeBox({ 1.0, 1.0, 2.0 }, { 2.0, 0.5, 0.5 }, { 0.1, 0.6, 0.1 });
    box->GetProperty()->LightingOff();
    top->AddActor(box);
    topRays->AddLight(MakeSun({ -0.2, 0.1, -1.0 }));

    const Pixels bare = GetPixels(bottom.Window);
    const auto depths = GetDepths(bottom.Window, false);
    vtkGodRaysPass* rays = raysOnTop ? topRays : bottom.Rays;
    rays->Attach(raysOnTop ? top : bottom.Renderer);
    const Pixels lit = GetPixels(bottom.Window);
    EXPECT_EQ(depths, GetDepths(bottom.Window, false));
    EXPECT_GT(CountDifferentPixels(bare, lit), 1000);
    vtkNew<vtkImageData> scattered;
    ASSERT_TRUE(rays->GetScatteringImage(scattered));
    if (raysOnTop)
    {
      EXPECT_LE(GetErrorOfSum(lit, bare, w, scattered), 1.0);
      continue;
    }
    int covered = 0;
    for (std::size_t i = 0; i < lit.size(); i += 4)
    {
      const bool box = bare[i + 1] == 153 && bare[i] == 26;
      covered += box;
      EXPECT_TRUE(!box || std::equal(&lit[i], &lit[i] + 4, &bare[i])) << i / 4;
    }
    EXPECT_GT(covered, 50);
  }
}

TEST(GodRaysLayers, PreservedBuffersAndTransparentBackgroundsKeepTheirAlpha)
{
  Messages messages;
  const int w = 96;
  const int h = 72;
  for (const int kind : { 0, 1, 2 })
  {
    View view(w, h, kind == 2 ? GLASS : PLAIN, false);
    vtkNew<vtkRenderer> under;
    if (kind == 0)
    {
      view.Renderer->SetBackgroundAlpha(0.0);
    }
    else
    {
      // a second renderer that keeps what the first one drew, colour and depth
      view.Window->RemoveRenderer(view.Renderer);
      view.Window->AddRenderer(under);
      view.Window->AddRenderer(view.Renderer);
      under->SetBackground(0.3, 0.1, 0.1);
      under->SetBackgroundAlpha(0.5);
      under->AddActor(MakeBox({ -2.0, 1.0, 2.0 }, { 2.0, 1.0, 1.0 }));
      under->SetActiveCamera(view.Renderer->GetActiveCamera());
      view.Renderer->PreserveColorBufferOn();
      view.Renderer->PreserveDepthBufferOn();
    }
    const Pixels bare = GetPixels(view.Window);
    const auto depths = GetDepths(view.Window, false);
    view.Rays->Attach(view.Renderer);
    const Pixels lit = GetPixels(view.Window);
    EXPECT_EQ(depths, GetDepths(view.Window, false)) << kind;
    vtkNew<vtkImageData> scattered;
    ASSERT_TRUE(view.Rays->GetScatteringImage(scattered));
    EXPECT_LE(GetErrorOfSum(lit, bare, w, scattered), 1.0) << kind;
    EXPECT_GT(CountDifferentPixels(bare, lit), 1000) << kind;
    int transparent = 0;
    for (std::size_t i = 3; i < lit.size(); i += 4)
    {
      EXPECT_EQ(lit[i], bare[i]) << kind;
      transparent += bare[i] == 0;
    }
    EXPECT_EQ(transparent > 1000, kind == 0);
  }
}

TEST(GodRaysWindows, GiveTheFirstPictureAgainAfterAResize)
{
  Messages messages;
  const int sizes[][2] = { { 96, 72 }, { 1, 1 }, { 3, 5 }, { 129, 97 }, { 2, 200 }, { 64, 64 } };
  for (const int content : { PLAIN, TAGGED, LAMP })
  {
    View resized(96, 72, content);
    resized.Window->Render();
    for (const auto& size : sizes)
    {
      resized.Window->SetSize(size[0], size[1]);
      View fresh(size[0], size[1], content);
      const Pixels expected = GetPixels(fresh.Window);
      EXPECT_EQ(expected, GetPixels(resized.Window)) << size[0] << " x " << size[1];
      vtkNew<vtkImageData> scattered;
      ASSERT_TRUE(resized.Rays->GetScatteringImage(scattered)) << resized.Rays->GetPlan();
      EXPECT_EQ(scattered->GetDimensions()[0], size[0]);
      EXPECT_EQ(scattered->GetDimensions()[1], size[1]);
      fresh.Rays->Detach(fresh.Renderer);
      EXPECT_LE(GetErrorOfSum(expected, GetPixels(fresh.Window), size[0], scattered), 1.0);
      EXPECT_TRUE(size[0] < 64 || GetMean(scattered) > 0.0); // small ones may see a pillar only
    }
  }
}

TEST(GodRaysWindows, MayTakeTurns)
{
  Messages messages;
  View a(96, 72, TAGGED);
  View b(64, 80, LAMP);
  const Pixels pictureA = GetPixels(a.Window);
  const Pixels pictureB = GetPixels(b.Window);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(pictureA, GetPixels(a.Window));
    EXPECT_EQ(pictureB, GetPixels(b.Window));
  }
  vtkNew<vtkImageData> ofA;
  vtkNew<vtkImageData> ofB;
  EXPECT_TRUE(a.Rays->GetScatteringImage(ofA)); // the current context is that of b
  EXPECT_TRUE(b.Rays->GetScatteringImage(ofB));
  EXPECT_EQ(ofA->GetDimensions()[0], 96);
  EXPECT_EQ(ofB->GetDimensions()[0], 64);
  EXPECT_GT(GetMean(ofA), 0.0);
  EXPECT_GT(GetMean(ofB), 0.0);
}

TEST(GodRaysWindows, MayHandThePassOn)
{
  Messages messages;
  // textured, so that a texture deleted in the wrong window is seen
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 192; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = (i * 37) % 256;
  }
  const auto addTextured = [&image](View& view)
  {
    for (int i = 0; i < 8; ++i)
    {
      auto box = MakeBox({ -3.0 + i, -1.0, 2.0 }, { 0.5, 1.0, 0.1 });
      vtkNew<vtkTexture> texture;
      texture->SetInputData(image);
      box->SetTexture(texture);
      view.Renderer->AddActor(box);
    }
  };
  View a(96, 72, TAGGED);
  View b(64, 80, TAGGED, false);
  addTextured(a);
  addTextured(b);
  const Pixels litA = GetPixels(a.Window);
  const Pixels bareB = GetPixels(b.Window);
  b.Rays->Attach(b.Renderer);
  const Pixels litB = GetPixels(b.Window);
  b.Rays->Detach(b.Renderer);
  EXPECT_EQ(bareB, GetPixels(b.Window));
  a.Rays->Detach(a.Renderer);
  const Pixels bareA = GetPixels(a.Window);
  a.Rays->Attach(a.Renderer);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(litA, GetPixels(a.Window));
    EXPECT_EQ(bareB, GetPixels(b.Window));
    a.Rays->Attach(b.Renderer);
    a.Rays->RemoveAllLights();
    a.Rays->AddLight(b.Rays->GetLight(0));
    EXPECT_EQ(litB, GetPixels(b.Window)) << "round " << i;
    EXPECT_EQ(bareA, GetPixels(a.Window)) << "round " << i;
    a.Rays->Attach(a.Renderer);
  }

  // the same without Attach(), which would have released: the pass finds out by itself
  a.Rays->Detach(a.Renderer);
  for (int i = 0; i < 2; ++i)
  {
    a.Renderer->SetPass(a.Rays);
    b.Renderer->SetPass(a.Rays);
    EXPECT_EQ(litA, GetPixels(a.Window)) << "round " << i;
    EXPECT_EQ(litB, GetPixels(b.Window)) << "round " << i;
  }
  a.Renderer->SetPass(nullptr);
  b.Renderer->SetPass(nullptr);
  EXPECT_EQ(bareA, GetPixels(a.Window));
  EXPECT_EQ(bareB, GetPixels(b.Window));
}

TEST(GodRaysSelection, FindsTheSameProps)
{
  Messages messages;
  View view(96, 72, TAGGED);
  const Pixels lit = GetPixels(view.Window);
  const auto select = [&view]
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(view.Renderer);
    selector->SetArea(0, 0, 95, 71);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    std::map<vtkProp*, int> counts;
    for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
    {
      vtkSelectionNode* node = selection->GetNode(i);
      auto prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
      counts[prop] += node->GetProperties()->Get(vtkSelectionNode::PIXEL_COUNT());
    }
    return counts;
  };
  const auto with = select();
  EXPECT_NE(view.Rays->GetPlan().find("hardware selection"), std::string::npos);
  EXPECT_EQ(lit, GetPixels(view.Window));
  view.Rays->Detach(view.Renderer);
  const auto without = select();
  EXPECT_EQ(with, without);
  EXPECT_EQ(without.size(), 6u);
}

TEST(GodRaysSelection, PickersFindTheSameProps)
{
  Messages messages;
  View view(96, 72, TAGGED);
  const Pixels lit = GetPixels(view.Window);
  vtkNew<vtkPropPicker> picker;
  const auto pick = [&view, &picker]
  {
    std::vector<vtkProp*> props;
    std::vector<double> places;
    for (int x = 5; x < 96; x += 12)
    {
      picker->PickProp(x, 36, view.Renderer);
      props.push_back(picker->GetViewProp());
      places.insert(places.end(), picker->GetPickPosition(), picker->GetPickPosition() + 3);
    }
    return std::make_pair(props, places);
  };
  const auto with = pick();
  EXPECT_EQ(lit, GetPixels(view.Window));
  view.Rays->Detach(view.Renderer);
  EXPECT_EQ(with, pick());
  EXPECT_GT(std::set<vtkProp*>(with.first.begin(), with.first.end()).size(), 3u);
}
