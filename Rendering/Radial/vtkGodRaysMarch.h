// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysMarch.h
 * @brief   the radial integral of a request in pixels of its layer; private to this module
 *
 * With p in pixels of the layer, whole numbers being their centres, each point p of the picture gets
 *
 *     L(p) = Gain integral_0^1 e^(-K t)/phi(K) s(p + t (Constant - Slope p)) dt
 *
 * the limit of vtkGodRaysRadialModel's INVARIANT formulation; phi is MeanExponential() in
 * vtkGodRaysRadialMath.glsl.
 */

#ifndef vtkGodRaysMarch_h
#define vtkGodRaysMarch_h

#include "vtkGodRaysRadialIntegrator.h" // For Request

struct vtkGodRaysMarch
{
  double Constant[2] = { 0.0, 0.0 };
  double Slope = 0.0; ///< fraction of the way to the light; negative: away from its mirror image
  double K = 0.0;
  double Gain = 0.0; ///< of a constant layer
  int LayerSize[2] = { 0, 0 };
  int PictureSize[2] = { 0, 0 };
  /// Where the centre of a pixel of the picture is in the layer: Origin + Step i.
  double Origin[2] = { 0.0, 0.0 };
  double Step[2] = { 1.0, 1.0 };

  explicit vtkGodRaysMarch(const vtkGodRaysRadialIntegrator::Request& request);

  bool operator==(const vtkGodRaysMarch& other) const;

  /// The point i pixels from the picture's first one.
  double GetPoint(int axis, double i) const { return this->Origin[axis] + this->Step[axis] * i; }

  /// The largest distance between a pixel of the picture and where its march ends [pixels].
  double GetLongest() const;

  /// How many pixels are summed, in the mean [pixels]. Steep kernels sum fewer.
  double GetSummedPixels() const;

  /// From 1 for a light in the picture to 4 for parallel rays, whose lines come no closer together
  /// away from where they are farthest apart.
  double GetParallelism() const;
};

#endif
