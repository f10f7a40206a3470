// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The ground truth of what a renderer shows in a medium.

#ifndef GodRaysMediumTruth_h
#define GodRaysMediumTruth_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>

class vtkGodRaysHomogeneousModel;
class vtkRenderer;

namespace GodRaysTesting
{
/// The light that vtkGodRaysSingleScatteringReference finds in what a renderer shows, as an image of
/// three floats; light is that of one vtkLight, white and of intensity 1, in world coordinates. The
/// power of a light at a finite distance is that of vtkGodRaysMediumModel.
vtkSmartPointer<vtkImageData> GetTrueScattering(vtkRenderer* renderer,
  vtkGodRaysHomogeneousModel* model, std::array<double, 4> light, const int size[2]);

/// The difference of an image of three 32-bit floats from that times the light's colour, root mean
/// square over the peak.
double GetErrorOfMedium(vtkRenderer* renderer, vtkGodRaysHomogeneousModel* model,
  std::array<double, 4> light, vtkImageData* image, std::array<double, 3> tint = { 1.0, 1.0, 1.0 });
}

#endif
