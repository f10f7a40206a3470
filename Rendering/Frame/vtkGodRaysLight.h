// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysLight.h
 * @brief   a light or an emitter as one frame sees it; private to this module
 *
 * Projected once a frame, and taken whole by every integrator. Nothing here outlives the frame: props
 * need not be kept alive.
 */

#ifndef vtkGodRaysLight_h
#define vtkGodRaysLight_h

#include "vtkGodRaysMedium.h" // For vtkGodRaysSpot

#include <string>

class vtkProp;
struct vtkGodRaysView;

/// Places and directions are in the coordinates of vtkGodRaysView.
struct vtkGodRaysLight
{
  ///@{
  /// What it is, and which one of them [0, 1, ...]; props have none.
  const char* Kind = "";
  int Number = -1;
  ///@}
  vtkProp* Prop = nullptr;             ///< the emitter, or null for a disc
  double Color[3] = { 0.0, 0.0, 0.0 }; ///< of the disc and, times BackgroundGlow, of the glow

  ///@{
  /// (x, y, z)/w, or with w = 0 the direction to a light that is infinitely far; the unit vector to it
  /// from the eye; X, Y and w in the layer's clip coordinates; window depth, 1 when it is infinitely far.
  double Position[4] = { 0.0, 0.0, 0.0, 1.0 };
  double Direction[3] = { 0.0, 0.0, 1.0 };
  double Clip[3] = { 0.0, 0.0, 1.0 };
  double Depth = 1.0;
  ///@}

  ///@{
  /// Of the occlusion layer: angles [radians], or lengths in the picture's plane where Planar.
  /// LeastPixel is a pixel's angle where all rays are parallel and so have none. Fade is less than 1
  /// for a light that is passing behind the camera.
  bool Planar = false;
  double Radius = 0.0; ///< of the disc or prop
  double GlowRadius = 0.0;
  double GlowFalloff = 0.0;
  double LeastPixel = 0.0;
  double Fade = 1.0;
  double MarchScale = 1.0; ///< see MarchVector() in vtkGodRaysRadialMath.glsl
  ///@}

  ///@{
  /// In a medium: irradiance, or intensity of a light at a finite distance, over Color.
  double Power = 1.0;
  vtkGodRaysSpot Spot;
  ///@}

  ///@{
  /// What it is called in the plan and in messages.
  void AppendName(std::string& text) const;
  std::string GetName() const;
  ///@}

  bool IsInfinite() const { return this->Position[3] == 0.0; }

  /**
   * Place it at a world position (w = 1), or in a direction (w = 0), with a radius in world units or
   * radians respectively.
   */
  void Place(const vtkGodRaysView& view, const double world[4], double radius);

  /**
   * Set the glow [degrees].
   */
  void SetGlow(const vtkGodRaysView& view, double radius, double falloff);

  /**
   * The w that stands for the light's where a parallel view has it infinitely far: it puts the
   * light into the picture as a perspective view does whose height is 30 degrees.
   */
  double GetPerspectiveDistance(const vtkGodRaysView& view) const;

  ///@{
  /**
   * The part of a layer of this size that the disc and its soft edge, or the glow, are within: first and
   * past the last column, first and past the last row; nothing is between them if it is not seen.
   */
  void GetDiscBounds(const vtkGodRaysView& view, const int size[2], int bounds[4]) const;
  void GetGlowBounds(const vtkGodRaysView& view, const int size[2], int bounds[4]) const;
  ///@}

  /**
   * Whether any of the light may fall into the layer: never false when some does.
   */
  bool Reaches(const vtkGodRaysView& view, bool glows) const;

private:
  void GetBoundsAbout(
    const vtkGodRaysView& view, double radius, const int size[2], int bounds[4]) const;
};

#endif
