// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSilhouette
 * @brief   what of a picture props cover, on a coarse grid; private to this module
 */

#ifndef vtkGodRaysSilhouette_h
#define vtkGodRaysSilhouette_h

#include <array>
#include <cstddef>
#include <vector>

class vtkActor;
class vtkCamera;
class vtkDataSet;
class vtkGodRaysCompositor;
class vtkGraph;
class vtkImageSlice;
class vtkMatrix4x4;
class vtkPolyData;
class vtkPropCollection;
class vtkVolume;

class vtkGodRaysSilhouette
{
public:
  /**
   * Of props that are seen by a camera, in a picture of this ratio of width to height; with a compositor,
   * of those of all processes.
   */
  vtkGodRaysSilhouette(vtkPropCollection* props, vtkCamera* camera, double aspect,
    vtkGodRaysCompositor* compositor = nullptr);

  /// A place in the picture, from (0, 0) at the lower left to (1, 1), and how good it is.
  struct Place
  {
    double X = 0.35;
    double Y = 0.75;
    double Score = 0.0;
  };

  /**
   * The best place for a sun: with much light and shadow about it that the picture has room for, and
   * with little of the props in its glare. Places below lowest, a Y, are left out. Score is 0 when
   * there is no place at which something is covered, and something is not; then the place is the usual one,
   * or, where that is hidden, the one that is least so.
   */
  Place FindSun(double lowest) const;

  /**
   * The fraction of the picture that is covered, and the box of that: left, right, lower and upper, from
   * 0 to 1; the whole picture if nothing is covered.
   */
  double GetCoveredFraction() const;
  void GetCoveredBounds(double bounds[4]) const;

private:
  void Join(vtkGodRaysCompositor* compositor);
  void DrawActor(vtkActor* actor, vtkMatrix4x4* toWorld);
  void DrawSurface(vtkPolyData* surface, vtkMatrix4x4* toWorld);
  void DrawPoints(vtkDataSet* data, vtkMatrix4x4* toWorld, double radius);
  void DrawGraph(vtkGraph* graph, vtkMatrix4x4* toWorld);
  void DrawVolume(vtkVolume* volume, vtkMatrix4x4* toWorld);
  void DrawSlice(vtkImageSlice* slice, vtkMatrix4x4* toWorld);
  bool Project(const double* point, vtkMatrix4x4* matrix, double pixel[2]) const;
  void DrawBall(const double* center, double radius, vtkMatrix4x4* matrix);
  void DrawPoint(const double pixel[2], int radius);
  void DrawLine(const double a[2], const double b[2]);
  void DrawTriangle(const double a[2], const double b[2], const double c[2]);

  /// What light that leaves a place in one direction meets.
  struct Way
  {
    double Light = 0.0; // of the glow about the place, from 0, all covered, to 1
    double Data =
      0.0; // [cells, over an angle] what is covered of the picture, less if it is far away
    double Room = 0.0; // [the picture's height, at most 1] what is not covered beyond the glow
  };
  bool IsCovered(double column, double row) const;
  Way Follow(double column, double row, const double direction[2]) const;
  double GetScore(int column, int row) const;
  double GetOpenness(double column, double row) const; ///< seen part of the light about it
  void MoveIntoTheOpen(Place& place, double lowest) const;

  int Rows = 128;
  int Columns;
  vtkMatrix4x4* ToClip;
  std::vector<unsigned char> Covered;
  std::ptrdiff_t CoveredCount = 0;
  std::vector<std::array<double, 2>> Directions;
};

#endif
