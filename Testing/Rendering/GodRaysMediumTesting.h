// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What the tests of models of a medium share: the ground truth of what a renderer shows.

#ifndef GodRaysMediumTesting_h
#define GodRaysMediumTesting_h

#include "GodRaysTesting.h"

class vtkGodRaysHomogeneousModel;

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
}

#endif
