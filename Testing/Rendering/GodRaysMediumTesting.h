// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What the tests of models of a medium share: a scene, and the ground truth of what a renderer shows.

#ifndef GodRaysMediumTesting_h
#define GodRaysMediumTesting_h

#include "GodRaysTesting.h"

#include "vtkGodRaysHomogeneousModel.h"

namespace GodRaysTesting
{
/// The light that vtkGodRaysSingleScatteringReference finds in what a renderer shows, as an image of
/// three floats; light is that of one vtkLight, white and of intensity 1, in world coordinates. The
/// power of a light at a finite distance is that of vtkGodRaysMediumModel.
vtkSmartPointer<vtkImageData> GetTrueScattering(vtkRenderer* renderer,
  vtkGodRaysHomogeneousModel* model, std::array<double, 4> light, const int size[2]);

/// The difference of an image from that, root mean square over the peak.
double GetErrorOfMedium(vtkRenderer* renderer, vtkGodRaysHomogeneousModel* model,
  std::array<double, 4> light, vtkImageData* image);

/// A homogeneous medium of an optical depth of 1.5 from the eye to its end, without lights or props.
class MediumTest : public ::testing::Test
{
public:
  static constexpr int Width = 256;
  static constexpr int Height = 192;

protected:
  MediumTest();

  /// A row of them, as deep as this, from -3.6 to 3.6.
  void AddPillars(double depth = 0.5);

  vtkSmartPointer<vtkLight> AddSun(
    std::array<double, 3> towards, std::array<double, 3> color = { 1.0, 1.0, 1.0 });

  /// The one light of the pass, white: a direction (w = 0) or a position.
  void SetLight(std::array<double, 4> light);

  vtkSmartPointer<vtkImageData> GetScattering();

  /// GetErrorOfMedium() of what the pass draws for this one light.
  double GetError(std::array<double, 4> light);

  Messages VTKMessages;
  Stage Scene{ Width, Height };
  vtkGodRaysPass* Rays = Scene.Rays;
  vtkRenderer* Renderer = Scene.Renderer;
  vtkNew<vtkGodRaysHomogeneousModel> Model;
};
}

#endif
