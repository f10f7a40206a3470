// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMediumRays
 * @brief   medium, light and view rays of a request, as shaders see them; private to this module
 *
 * A shader that is completed by Complete() has the terms parallel, infinite, uniformly and grey, and gets
 * its numbers by Set().
 */

#ifndef vtkGodRaysMediumRays_h
#define vtkGodRaysMediumRays_h

#include "vtkGodRaysMedium.h"           // For vtkGodRaysSpot
#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysSource.h"           // For vtkGodRaysView::Pinhole

#include <string>

class vtkShaderProgram;

class vtkGodRaysMediumRays
{
public:
  /**
   * A shader's text with vtkGodRaysMediumRaysFS.glsl in the place of its tag //VTK::GodRays::MediumRays.
   */
  static std::string Complete(const char* shader);

  /**
   * Take a request of a vtkGodRaysMediumModel, which must outlive this, for a layer of this size
   * [pixels] that a pinhole can see.
   */
  vtkGodRaysMediumRays(const vtkGodRaysMediumIntegrator::Request& request, const int layerSize[2]);

  ///@{
  /**
   * The shader's terms: whether view rays are parallel, the light is infinitely far, it is and the
   * medium homogeneous, and one channel serves a light of any colour.
   */
  bool IsParallel() const;
  bool IsInfinite() const { return this->Light[3] == 0.0; }
  bool IsUniform() const;
  bool IsGrey() const;
  ///@}

  /**
   * The light in view coordinates, x to the right, y up, z forwards from the eye: (x, y, z)/w, or with
   * w = 0 the direction to it.
   */
  const double* GetLight() const { return this->Light; }

  /**
   * Its cone, in these coordinates.
   */
  const vtkGodRaysSpot& GetSpot() const { return this->Spot; }

  const vtkGodRaysView::Pinhole& GetPinhole() const { return this->Pinhole; }

  /**
   * Give the shader its numbers.
   */
  void Set(vtkShaderProgram* program) const;

private:
  void SetComponents(vtkShaderProgram* program) const;

  const vtkGodRaysMediumIntegrator::Request& Request;
  vtkGodRaysView::Pinhole Pinhole;
  int LayerSize[2];
  double Light[4];
  vtkGodRaysSpot Spot;
};

#endif
