// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMediumNumbers
 * @brief   what the medium of a frame is in numbers, for each pixel; private to this module
 *
 * What vtkGodRaysPass::GetMediumImage() gives, from depths that were read back, by the formulas of
 * vtkGodRaysVisibilityMath.glsl in double precision.
 */

#ifndef vtkGodRaysMediumNumbers_h
#define vtkGodRaysMediumNumbers_h

#include "vtkGodRaysEffect.h" // For Reading

class vtkImageData;
struct vtkGodRaysMedium;
struct vtkGodRaysView;

class vtkGodRaysMediumNumbers
{
public:
  /**
   * Fill the image with the arrays, their units and their errors. unit is how long the scene's unit is [m], 0
   * if nobody knows. veil is what media of data leave of what is behind them, for each pixel and colour, to
   * veilError; null for none.
   */
  static void Fill(const vtkGodRaysEffect::Reading& reading, const vtkGodRaysView& view,
    const vtkGodRaysMedium& medium, double unit, const float* veil, double veilError,
    vtkImageData* image);

  /**
   * Add how far the extinction of data is off by resampling [1/scene unit]: root mean square, and at most.
   */
  static void AddDataErrors(double mean, double largest, double unit, vtkImageData* image);

  /**
   * Add how often the light was scattered: once, to Radiance_Error, or, with all orders, any number of times.
   */
  static void AddOrders(bool all, vtkImageData* image);
};

#endif
