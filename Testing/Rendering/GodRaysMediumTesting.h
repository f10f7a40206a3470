// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What the tests of models of a medium share: a scene.

#ifndef GodRaysMediumTesting_h
#define GodRaysMediumTesting_h

#include "GodRaysMediumTruth.h"
#include "GodRaysTesting.h"

#include "vtkGodRaysHomogeneousModel.h"

#include <array>
#include <vector>

namespace GodRaysTesting
{
/// A homogeneous medium of an optical depth of 1.5 from the eye to its end, without lights or props.
class MediumTest : public ::testing::Test
{
public:
  static constexpr int Width = 256;
  static constexpr int Height = 192;

protected:
  MediumTest();

  /// Media of tests are as deep as they are: that this is told does not count, other messages do.
  void TearDown() override;

  /// A row of them, as deep as this, from -3.6 to 3.6.
  void AddPillars(double depth = 0.5);

  vtkSmartPointer<vtkLight> AddSun(
    std::array<double, 3> towards, std::array<double, 3> color = { 1.0, 1.0, 1.0 });

  /// The one light of the pass, white: a direction (w = 0) or a position.
  void SetLight(std::array<double, 4> light);

  vtkSmartPointer<vtkImageData> GetScattering();

  /// GetErrorOfMedium() of what the pass draws for this one light.
  double GetError(std::array<double, 4> light);

  struct Case
  {
    const char* Name;
    std::array<double, 4> Light;
    double Bound; // of the error
  };

  /// That the error of each light is within its bound, and with the light a little off its place far
  /// beyond it.
  void CheckErrors(const std::vector<Case>& cases);

  Messages VTKMessages;
  Stage Scene{ Width, Height };
  vtkGodRaysPass* Rays = Scene.Rays;
  vtkRenderer* Renderer = Scene.Renderer;
  vtkNew<vtkGodRaysHomogeneousModel> Model;
};
}

#endif
