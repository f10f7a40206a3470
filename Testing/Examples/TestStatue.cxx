// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The window of the example Statue, run by a user who is a program: the sliders are dragged with the
// mouse, the keys are pressed, and the light that is scattered is looked at after each. And the models
// that it reads.

#include "ExampleUser.h"

#include "vtkGodRaysPublishedModel.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPNGReader.h"
#include "vtkPropCollection.h"
#include "vtkSTLWriter.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

namespace
{
/// Milliseconds of an action.
double Measure(const std::function<void()>& action)
{
  const auto began = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began)
    .count();
}

vtkGodRaysRadialModel* GetModel(User* user)
{
  return vtkGodRaysRadialModel::SafeDownCast(user->GetRays()->GetModel());
}

/// The slider with this title; null if there is none.
vtkSliderRepresentation2D* FindSlider(User* user, const std::string& title)
{
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = user->GetRenderer()->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    auto slider = vtkSliderRepresentation2D::SafeDownCast(prop);
    if (slider && slider->GetTitleText() == title)
    {
      return slider;
    }
  }
  return nullptr;
}

/// Drag a slider from where it is to a value, in steps; returns the milliseconds of each.
double Drag(User* user, const std::string& title, double value)
{
  vtkSliderRepresentation2D* slider = FindSlider(user, title);
  const auto point = [&](double to)
  {
    const double part =
      (to - slider->GetMinimumValue()) / (slider->GetMaximumValue() - slider->GetMinimumValue());
    vtkRenderer* renderer = user->GetRenderer();
    const int left = slider->GetPoint1Coordinate()->GetComputedDisplayValue(renderer)[0];
    const int* right = slider->GetPoint2Coordinate()->GetComputedDisplayValue(renderer);
    const double inset = (slider->GetEndCapLength() + 0.5 * slider->GetSliderLength()) *
      renderer->GetSize()[0]; // from an end to the middle of the knob there
    user->SetEventInformation(
      std::lround(left + inset + part * (right[0] - left - 2.0 * inset)), right[1]);
  };
  const double start = slider->GetValue();
  point(start);
  user->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  const int steps = 5;
  const double time = Measure(
    [&]
    {
      for (int i = 1; i <= steps; ++i)
      {
        point(start + (value - start) * i / steps);
        user->InvokeEvent(vtkCommand::MouseMoveEvent);
      }
    });
  user->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  return time / steps;
}
}

#define main ExampleMain
#include "Statue/Statue.cxx"
#undef main

TEST(Statue, SlidersChangeTheLight)
{
  RunExample(
    [](User* user)
    {
      vtkGodRaysRadialModel* model = GetModel(user);
      std::vector<float> before;
      std::vector<float> after;
      const auto drag = [&](const char* title, double to)
      {
        before = user->GetLight();
        std::cout << title << ": " << Drag(user, title, to) << " ms for a frame\n";
        after = user->GetLight();
      };

      for (const char* factor : { "exposure", "weight" }) // the light is proportional to both
      {
        const double value = FindSlider(user, factor)->GetValue();
        drag(factor, 0.5 * value);
        const double ratio = FindSlider(user, factor)->GetValue() / value;
        EXPECT_NEAR(ratio, 0.5, 0.1);
        ASSERT_FALSE(before.empty());
        ASSERT_EQ(after.size(), before.size());
        double worst = 0.0;
        for (size_t i = 0; i < after.size(); ++i)
        {
          worst = std::max(worst, std::abs(after[i] - ratio * before[i]));
        }
        EXPECT_LT(worst, 2e-3 * *std::max_element(before.begin(), before.end())) << factor;
      }
      EXPECT_DOUBLE_EQ(model->GetExposure(), FindSlider(user, "exposure")->GetValue());
      EXPECT_DOUBLE_EQ(model->GetWeight(), FindSlider(user, "weight")->GetValue());

      drag("decay", 0.9);
      EXPECT_NEAR(model->GetDecay(), 0.9, 0.01);
      EXPECT_LT(GetSum(after), 0.5 * GetSum(before));
      drag("samples", 40.0);
      EXPECT_NEAR(model->GetNumberOfSamples(), 40, 5);
      EXPECT_GT(GetSum(after), 1.2 * GetSum(before)) << "fewer samples decay less on a long way";
      drag("density", 0.4);
      EXPECT_NEAR(model->GetDensity(), 0.4, 0.05);
      EXPECT_LT(GetSum(after), 0.8 * GetSum(before)) << "marches end before they reach the light";
      user->Write("Statue-sliders.png");
      drag("density", -0.2);
      EXPECT_TRUE(after.empty()) << "no density is no rays";
    });
}

TEST(Statue, LightMovesAndSumIsChanged)
{
  RunExample(
    [](User* user)
    {
      const std::vector<float> first = user->GetLight();
      user->InvokeEvent(vtkCommand::TimerEvent);
      EXPECT_EQ(user->GetLight(), first) << "the light stands still at first";
      user->Press("g");
      auto published = vtkGodRaysPublishedModel::SafeDownCast(user->GetRays()->GetModel());
      ASSERT_TRUE(published);
      EXPECT_EQ(published->GetFormulation(), vtkGodRaysPublishedModel::GIANASSI);
      EXPECT_EQ(published->GetDecay(), 0.98) << "the parameters are those of the sliders";
      EXPECT_NE(user->GetLight(), first);
      user->Press("g");
      EXPECT_EQ(user->GetLight(), first);

      user->Press(nullptr);
      user->Press("space");
      const int frames = 20;
      const double time = Measure(
        [&]
        {
          for (int i = 0; i < frames; ++i)
          {
            user->InvokeEvent(vtkCommand::TimerEvent);
          }
        });
      std::cout << "moving light: " << time / frames << " ms for a frame\n";
      user->Write("Statue-moved.png");
      const std::vector<float> moved = user->GetLight();
      EXPECT_NE(moved, first);
      user->Press("space");
      user->InvokeEvent(vtkCommand::TimerEvent);
      EXPECT_EQ(user->GetLight(), moved);
    });
}

namespace
{
/// Draw this model; returns the exit status.
int Draw(std::string model, std::string picture = "Statue-model.png")
{
  std::remove(picture.c_str());
  std::string name = "Statue";
  char* arguments[] = { &name[0], &picture[0], &model[0], nullptr };
  return ExampleMain(3, arguments);
}

/// The sum of all values of the picture.
double ReadSum(const char* picture)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(picture);
  reader->Update();
  auto values = static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer());
  return std::accumulate(values, values + 3 * reader->GetOutput()->GetNumberOfPoints(), 0.0);
}

template <typename Writer>
std::string Write(const char* file)
{
  vtkNew<vtkSphereSource> ball;
  vtkNew<Writer> writer;
  writer->SetInputConnection(ball->GetOutputPort());
  writer->SetFileName(file);
  writer->Write();
  return file;
}
}

TEST(Statue, ReadsModels)
{
  const std::string triangle = "Statue-triangle.gltf";
  std::ofstream(triangle) << R"({ "asset": { "version": "2.0" }, "scenes": [ { "nodes": [ 0 ] } ],
    "scene": 0, "nodes": [ { "mesh": 0 } ],
    "meshes": [ { "primitives": [ { "attributes": { "POSITION": 0 } } ] } ],
    "buffers": [ { "byteLength": 36, "uri": "data:application/octet-stream;base64,)"
                             "AAAAAAAAAAAAAAAAAAAAQAAAAAAAAAAAAAAAAAAAQEAAAIA/"
                             R"(" } ],
    "bufferViews": [ { "buffer": 0, "byteLength": 36 } ],
    "accessors": [ { "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
      "min": [ 0, 0, 0 ], "max": [ 2, 3, 1 ] } ] })";
  std::vector<double> sums; // the same ball, in three formats, then the triangle
  for (const std::string& model : { Write<vtkOBJWriter>("Statue-ball.obj"),
         Write<vtkPLYWriter>("Statue-ball.ply"), Write<vtkSTLWriter>("Statue-ball.STL"), triangle })
  {
    EXPECT_EQ(Draw(model), EXIT_SUCCESS) << model;
    sums.push_back(ReadSum("Statue-model.png"));
  }
  EXPECT_NEAR(sums[1], sums[0], 1e-3 * sums[0]);
  EXPECT_NEAR(sums[2], sums[0], 1e-3 * sums[0]);
  EXPECT_GT(std::abs(sums[3] - sums[0]), 1e-2 * sums[0]);
}

TEST(Statue, RefusesWhatIsNoModel)
{
  // VTK 9.3 does not survive one that ends before its header does.
  std::ofstream("Statue-damaged.ply") << "ply\nformat ascii 1.0\nend_header\n";
  std::ofstream("Statue-damaged.glb") << "glTF";
  std::ofstream("Statue-empty.obj") << "# nothing\n";
  std::ofstream("Statue-point.obj") << "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n";
  const char* faults[][2] = { { "Statue.txt", "give a .glb, .gltf, .obj, .ply or .stl file" },
    { "missing.stl", "check its name" }, { "Statue-damaged.ply", "write it again" },
    { "Statue-damaged.glb", "write it again" }, { "Statue-empty.obj", "write it again" },
    { "Statue-point.obj", "write it again" } };
  for (const auto& [model, remedy] : faults)
  {
    SCOPED_TRACE(model);
    testing::internal::CaptureStderr();
    EXPECT_EQ(Draw(model), EXIT_FAILURE);
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_NE(text.find(model), std::string::npos) << text;
    EXPECT_NE(text.find(remedy), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  }
}
