// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What ModelErrors.h compares pictures of: a scene that the pass draws, and the truth of it.

#ifndef ModelScene_h
#define ModelScene_h

#include "Device.h"
#include "MediumScenes.h"
#include "ModelMethods.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysPass.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <array>
#include <vector>

namespace ModelError
{
using GodRaysMediumScenes::Lights;
using GodRaysMediumScenes::NamedLight;
using GodRaysMediumScenes::Scene;

// Three media are three colours of one: optical depths of the far limit ahead of 0.4, 2 and 6.
const double Scattering[3] = { 0.02, 0.1, 0.3 };
const double FarLimit = 20.0;
const double ViewAngle = 60.0;
const double Asymmetries[] = { 0.6, 0.0, 0.85 }; // the last two before the light alone

/// Light of one picture, three colours a pixel.
using Picture = std::vector<float>;

//------------------------------------------------------------------------------
/// A scene, drawn by the pass.
class Stage
{
public:
  Stage(Device& device, const Scene& scene, int width, int height);
  ~Stage();
  Stage(const Stage&) = delete;
  void operator=(const Stage&) = delete;

  void Set(const NamedLight& light, double asymmetry);
  void Set(const ModelMethod& method);

  /// Make the medium one that dims all colours alike, or three.
  void SetColors(bool grey);

  /// The time of a frame, to its end [s].
  double Draw();
  double DrawWithoutRays();

  Picture GetLight();

private:
  Device& OpenGL;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkLight> Light;
  vtkNew<vtkGodRaysHomogeneousModel> Medium;
  vtkNew<vtkGodRaysPass> Rays;
};

//------------------------------------------------------------------------------
/// Single scattering. Where an edge is within 1/256 of a pixel from its centre, which is what OpenGL's
/// rasterizers resolve, what is seen there is one thing or the other: there are two truths.
class Truth
{
public:
  Truth(vtkPolyData* occluders, const NamedLight& light, double asymmetry, int width, int height);

  /// Root mean square over the peak, for each colour; of two truths the nearer one counts.
  std::array<double, 3> Compare(const Picture& picture) const;

  Picture Light;
  int PixelsOnEdges = 0;

private:
  Picture Other; // the same where there is one truth
};

/// For each colour the factor that brings a picture nearest to another.
void Fit(Picture& picture, const Picture& truth);
}

#endif
