// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The ground truth of what a renderer shows in a medium.

#ifndef GodRaysMediumTruth_h
#define GodRaysMediumTruth_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>

class vtkGodRaysHomogeneousModel;
class vtkGodRaysSingleScatteringReference;
class vtkRenderer;

namespace GodRaysTesting
{
/// Give the reference a medium, in scene units.
using SetMedium = std::function<void(vtkGodRaysSingleScatteringReference*)>;

/// The light that vtkGodRaysSingleScatteringReference finds in what a renderer shows; light is that of one
/// vtkLight, white and of intensity 1, in world coordinates. The power of a light at a finite distance is
/// that of vtkGodRaysMediumModel. Translucent actors are sheets that no ray of light meets twice: a sum over
/// which of them block, each picture among opaque things alone.
vtkSmartPointer<vtkImageData> GetTrueScattering(vtkRenderer* renderer, const SetMedium& setMedium,
  std::array<double, 4> light, const int size[2]);

/// How far an image of three 32-bit floats is from that, times the light's colour: root mean square over
/// the peak.
double GetErrorOfScattering(vtkImageData* truth, vtkImageData* image, std::array<double, 3> tint);

/// The same of a homogeneous medium.
double GetErrorOfMedium(vtkRenderer* renderer, vtkGodRaysHomogeneousModel* model,
  std::array<double, 4> light, vtkImageData* image, std::array<double, 3> tint = { 1.0, 1.0, 1.0 });
}

#endif
