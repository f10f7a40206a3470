// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysShadowFaces
 * @brief   where the faces of a shadow map are; private to this module
 *
 * One face, fitted to the occluders, for a light that is infinitely far or sees all of it within 60
 * degrees of one direction; else the six faces of a cube about the light. A light that is infinitely far may
 * have up to four nested faces instead, each half as wide as the one before. They lie side by side in one
 * texture.
 */

#ifndef vtkGodRaysShadowFaces_h
#define vtkGodRaysShadowFaces_h

#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysShadowGrids.h"

class vtkShaderProgram;

class vtkGodRaysShadowFaces
{
public:
  int Count = 0;               // 0 if nothing blocks
  int Size = 0;                // of a face [pixels]
  double Corners[8][3];        // of the occluders' bounds, in view coordinates
  double ViewToMap[6][16];     // view coordinates to clip coordinates of a face
  vtkGodRaysShadowGrids Grids; // with no depths as yet

  /**
   * Fit them to the occluders, of so many pixels on each side, or as many as the driver takes. For a light
   * that is infinitely far, seen in perspective, there are up to so many levels; more than one are faces of
   * half as many pixels, nested about the axis through the eye, each as wide as the request's share of the
   * one before; see the request's focus. All processes of a compositor call it.
   */
  void Fit(const vtkGodRaysMediumIntegrator::Request& request, int size, int levels);

  int GetColumns() const { return this->Count == 1 ? 1 : this->Count == 6 ? 3 : 2; }
  int GetRows() const { return this->Count == 1 ? 1 : 2; }

  /**
   * Give a shader its numbers, where there are faces.
   */
  void Set(vtkShaderProgram* program) const;

private:
  void FitDirectional(const vtkGodRaysMediumIntegrator::Request& request);
  void FitPoint(const vtkGodRaysMediumIntegrator::Request& request);
  void Nest(const double axes[3][3], const double low[2], const double high[2],
    const vtkGodRaysMediumIntegrator::Request& request);
  void SetFace(int face, const double axes[3][3], const double origin[3], const double low[2],
    const double high[2]);
  void SetSize(int size);

  int Levels = 1; // at most, of a light that is infinitely far
};

#endif
