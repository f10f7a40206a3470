// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSource.h
 * @brief   the camera and the lights as one frame sees them; private to this module
 *
 * Made anew every frame, from the matrices that the mappers use: nothing here outlives it, so
 * props need not be kept alive, and stereo, tiles and off-axis projections come out right.
 */

#ifndef vtkGodRaysSource_h
#define vtkGodRaysSource_h

#include <string>

class vtkLight;
class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;

/// The camera of a renderer, with a picture that is enlarged by the layer's margin.
struct vtkGodRaysView
{
  double WorldToView[16] = {}; ///< row-major, as vtkMatrix4x4
  double ViewToClip[16] = {};  ///< of the layer
  double ClipToView[16] = {};
  double Eye[3] = {}; ///< centre of projection, view coordinates; unused where Parallel
  bool Parallel = false;
  double Aspect = 1.0;    ///< width over height
  double ViewScale = 1.0; ///< fraction of the layer's width that the picture covers
  double Pixel[2] = {};   ///< width and height of a pixel, as the layer's are 2

  /**
   * Take the renderer's camera, for a picture of this width and height [pixels].
   */
  void Set(vtkRenderer* renderer, const int size[2], double margin);

  /**
   * The unit vector, in view coordinates, along which the layer's point (x, y) is seen.
   */
  void GetRay(double x, double y, double ray[3]) const;

  /// A camera without distortion, as the medium's integrators see it.
  struct Pinhole
  {
    double PixelSize; ///< at depth 1, or of a parallel view [scene units]
    double Center[2]; ///< where the axis of view is [pixels from the lower left corner]
    double Depth[4];  ///< view depth = (D[0] + D[1] e)/(D[2] + D[3] e), e = 1 - window depth
  };

  /**
   * The camera, for a layer of this size [pixels]. False if pixels are not square, to 2 percent, or
   * the picture is tilted against the axis of view, as only projection matrices made by hand do.
   */
  bool GetPinhole(const int size[2], Pinhole& pinhole) const;

  /**
   * Vectors such that origin + x right + y up is, for the layer's point (x, y), its place in view
   * coordinates (planar, of parallel views only), or else a vector of any length along which it is
   * seen.
   */
  void GetPicture(bool planar, double origin[3], double right[3], double up[3]) const;
};

/// One light.
struct vtkGodRaysSource
{
  std::string Name;                    ///< for the plan
  vtkProp* Prop = nullptr;             ///< the emitter, or null for a disc
  double Color[3] = { 0.0, 0.0, 0.0 }; ///< of the disc and, times BackgroundGlow, of the glow
  double Power = 1.0; ///< irradiance, or intensity of a light at a finite distance, over Color
  double SpotAxis[3] = { 0.0, 0.0, -1.0 }; ///< of a spotlight, unit vector, view coordinates
  double CosCone = 0.0;      ///< cosine of half its cone's angle; 0: it shines everywhere alike
  double SpotExponent = 0.0; ///< as of vtkLight
  double Position[3] = { 0.0, 0.0,
    0.0 };               ///< in view coordinates; of an infinitely far light the direction to it
  bool Infinite = false; ///< whether it is infinitely far
  double Direction[3] = { 0.0, 0.0,
    -1.0 };                           ///< unit vector from the eye to the light, view coordinates
  double Clip[3] = { 0.0, 0.0, 1.0 }; ///< X, Y and w in the layer's clip coordinates
  double Radius = 0.0;      ///< of the disc or prop: an angle [radians], or a length where Planar
  double GlowRadius = 0.0;  ///< as Radius
  double GlowFalloff = 0.0; ///< as Radius
  double LeastPixel =
    0.0;               ///< a pixel's angle where all rays are parallel and so have none [radians]
  double Depth = 1.0;  ///< window depth, 1 when it is infinitely far
  bool Planar = false; ///< distances are lengths in the picture's plane, not angles
  double MarchScale = 1.0; ///< see MarchVector() in vtkGodRaysRadialMath.glsl
  double Fade = 1.0;       ///< 1; less for a light that is passing behind the camera

  /**
   * Place a light at a world position (w = 1), or in a direction (w = 0), with a radius in world
   * units or radians respectively.
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

  /**
   * The part of a layer of this size that the disc and its soft edge are within: first and past the
   * last column, first and past the last row; nothing is between them if it is not seen.
   */
  void GetDiscBounds(const vtkGodRaysView& view, const int size[2], int bounds[4]) const;

  /**
   * Whether any of the light may fall into the layer: never false when some does.
   */
  bool Reaches(const vtkGodRaysView& view, bool glows) const;
};

#endif
