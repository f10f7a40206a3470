// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMediumRays
 * @brief   medium, light and view rays of a request, as shaders see them; private to this module
 *
 * A shader has the terms parallel, infinite, closed and grey, and gets its numbers by Set().
 */

#ifndef vtkGodRaysMediumRays_h
#define vtkGodRaysMediumRays_h

#include "vtkGodRaysFroxels.h"          // For Picture
#include "vtkGodRaysLight.h"            // For IsInfinite
#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysSingleScattering.h" // For Parameters
#include "vtkGodRaysView.h"             // For Pinhole

class vtkShaderProgram;

class vtkGodRaysMediumRays
{
public:
  /**
   * Take a request of a vtkGodRaysMediumModel, which must outlive this, for a layer of this size
   * [pixels] that a pinhole can see.
   */
  vtkGodRaysMediumRays(const vtkGodRaysMediumIntegrator::Request& request, const int layerSize[2]);

  /**
   * A request for vtkGodRaysSingleScattering, in world coordinates: what is there stays as it is wherever the
   * eye is.
   */
  static vtkGodRaysSingleScattering::Parameters GetWorldParameters(
    const vtkGodRaysMediumIntegrator::Request& request);

  ///@{
  /**
   * The shader's terms: whether view rays are parallel, the light is infinitely far, airlight has a closed
   * form, and one channel serves a light of any colour.
   */
  bool IsParallel() const { return this->Request.View->Parallel; }
  bool IsInfinite() const { return this->Request.Light->IsInfinite(); }
  bool IsClosed() const;
  bool IsGrey() const { return this->Request.Medium->IsGrey(); }
  ///@}

  const vtkGodRaysView::Pinhole& GetPinhole() const { return this->Pinhole; }

  /**
   * Get the view rays of the result's pixels: of the layer the part without the margin.
   */
  vtkGodRaysFroxels::Picture GetPicture() const;

  /**
   * Give the shader its numbers.
   */
  void Set(vtkShaderProgram* program) const;

private:
  void SetComponents(vtkShaderProgram* program) const;

  const vtkGodRaysMediumIntegrator::Request& Request;
  vtkGodRaysView::Pinhole Pinhole;
  int LayerSize[2];
};

#endif
