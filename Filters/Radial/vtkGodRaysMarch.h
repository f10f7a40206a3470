// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysMarch.h
 * @brief   the radial integral in pixels of its layer, and what planning asks of it
 *
 * With p in pixels of the layer, whole numbers being their centres, each point p of the picture gets
 *
 *     L(p) = Gain integral_0^1 e^(-K t)/phi(K) s(p + t (Constant - Slope p)) dt
 *
 * the limit of the invariant sum of vtkGodRaysScatteringFilter; phi is MeanExponential() in
 * vtkGodRaysRadialMath.glsl. Private; numbers are not checked.
 */

#ifndef vtkGodRaysMarch_h
#define vtkGodRaysMarch_h

#include "vtkGodRaysFiltersModule.h" // For export macro

/// What vtkGodRaysScatteringFilter's setters of the same names take, in their ranges.
struct vtkGodRaysMarchParameters
{
  double Density = 0.97;
  double Decay = 1.0;
  double Weight = 0.013;
  double Exposure = 1.0;
  int NumberOfSamples = 100;
  double LightClip[3] = { 0.0, 0.0, 1.0 };
  double MarchScale = 1.0;
};

struct VTKGODRAYSFILTERS_EXPORT vtkGodRaysMarch
{
  ///@{
  /// Below these, sums along lines are not faster, or not as accurate, as taps.
  static constexpr double ShortestSweep = 8.0; // [pixels]
  static constexpr int SmallestSweep = 32;     // [pixels], one way
  /// Of a small layer, but not of a long strip: there taps are as many as the square of its length.
  static constexpr double LongestOfSmall = 128.0; // [pixels], in the mean
  ///@}

  double Constant[2] = { 0.0, 0.0 };
  double Slope = 0.0; ///< fraction of the way to the light; negative: away from its mirror image
  double K = 0.0;
  double Gain = 0.0; ///< of a constant layer
  int LayerSize[2] = { 0, 0 };
  int PictureSize[2] = { 0, 0 };
  /// Where the centre of a pixel of the picture is in the layer: Origin + Step i.
  double Origin[2] = { 0.0, 0.0 };
  double Step[2] = { 1.0, 1.0 };

  vtkGodRaysMarch() = default;

  /**
   * The march of a layer, of which the picture covers the part viewScale of width and height, about the
   * centre. Decay 0 leaves the pixel itself: then K, Slope and Constant are 0.
   */
  vtkGodRaysMarch(const vtkGodRaysMarchParameters& parameters, const int layerSize[2],
    const int pictureSize[2], double viewScale);

  bool operator==(const vtkGodRaysMarch& other) const;

  /// The point i pixels from the picture's first one.
  double GetPoint(int axis, double i) const { return this->Origin[axis] + this->Step[axis] * i; }

  /// The largest distance between a pixel of the picture and where its march ends [pixels].
  double GetLongest() const;

  /// How long the marches are within the layer, in the mean [pixels].
  double GetLength() const;

  /// How long the parts of marches within the layer are, in the mean [pixels]: what taps pay for. Unlike
  /// GetLength(), also where the layer is a strip.
  double GetLengthWithin() const;

  /// Whether the layer is too small for sums along lines.
  bool IsSmall() const;

  /// How many pixels are summed, in the mean [pixels]. Steep kernels sum fewer.
  double GetSummedPixels() const;

  /// How much more the end of the march weighs where the kernel grows: errors there are as large [no
  /// unit].
  double GetGrowth() const;

  /// From 1 for a light in the picture to 4 for parallel rays, whose lines come no closer together
  /// away from where they are farthest apart.
  double GetParallelism() const;

  /// The error of lines whose error on noise from pixel to pixel, times the root of the number of
  /// pixels that are summed, is 1 [fraction of the peak].
  double GetErrorScale() const;

private:
  double GetMarchAt(double x, double y) const; // [pixels]
};

#endif
