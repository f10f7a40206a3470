// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysView.h
 * @brief   the camera as one frame sees it; private to this module
 *
 * View coordinates are x to the right, y up and z forwards [scene units]. Their origin is the centre of
 * projection, or, in a parallel projection, the camera's place. All of this project has them so, on the
 * processor and in shaders; VTK's own have z backwards, and are the camera's coordinates here.
 *
 * Made anew every frame, from the matrices that the mappers use: stereo, tiles and off-axis projections
 * come out right.
 */

#ifndef vtkGodRaysView_h
#define vtkGodRaysView_h

class vtkRenderer;

/// The camera of a renderer, with a picture that is enlarged by the layer's margin.
struct vtkGodRaysView
{
  double WorldToView[16] = {}; ///< row-major, as vtkMatrix4x4
  double ViewToClip[16] = {};  ///< of the layer
  double ClipToView[16] = {};
  double CameraToView[16] = {};
  bool Parallel = false;
  double Aspect = 1.0;    ///< width over height
  double ViewScale = 1.0; ///< fraction of the layer's width that the picture covers
  double Pixel[2] = {};   ///< width and height of a pixel, as the layer's are 2

  /**
   * Take the renderer's camera, for a picture of this width and height [pixels].
   */
  void Set(vtkRenderer* renderer, const int size[2], double margin);

  /**
   * The unit vector along which the layer's point (x, y) is seen.
   */
  void GetRay(double x, double y, double ray[3]) const;

  /**
   * The picture's height, in a parallel projection [scene units].
   */
  double GetPictureHeight() const;

  /// A camera without distortion, as the medium's integrators see it.
  struct Pinhole
  {
    double PixelSize; ///< at depth 1, or of a parallel view [scene units]
    double Center[2]; ///< where the axis of view is [pixels from the lower left corner]
    double Depth[4];  ///< view depth = (D[0] + D[1] e)/(D[2] + D[3] e), e = 1 - window depth
  };

  /**
   * The camera, for a layer of this size [pixels]. False if pixels are not square, to 2 percent, as in an
   * oblong window under a vtkDepthOfFieldPass, or the picture is tilted against the axis of view, as only
   * projection matrices made by hand do.
   */
  bool GetPinhole(const int size[2], Pinhole& pinhole) const;

  /**
   * Vectors such that origin + x right + y up is, for the layer's point (x, y), its place (planar, of
   * parallel views only), or else a vector of any length along which it is seen.
   */
  void GetPicture(bool planar, double origin[3], double right[3], double up[3]) const;

  /**
   * The part of a layer of this size that the convex hull of some points, in homogeneous view
   * coordinates, and a margin [pixels] about it are within: first and past the last column, first and
   * past the last row; nothing is between them if it is not seen. The whole layer, if a point is beside
   * or behind the camera.
   */
  void GetHullBounds(
    const double (*points)[4], int count, const int size[2], double margin, int bounds[4]) const;
};

#endif
