// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The parts of a picture that a scene covers, on a coarse grid, and the place in it where a sun
 * behind the scene would make the best shafts. Computed without a graphics card.
 */

#ifndef Silhouette_h
#define Silhouette_h

#include "Scene.h"

#include <vector> // For std::vector

class vtkCamera;
class vtkMatrix4x4;
class vtkPolyData;
class vtkVolume;

class Silhouette
{
public:
  /**
   * Of a scene that is seen by a camera, in a picture of this ratio of width to height.
   */
  Silhouette(const Scene& scene, vtkCamera* camera, double aspect);

  /// A place in the picture, from (-1, -1) at the lower left to (1, 1), and how good it is.
  struct Place
  {
    double X = -0.3;
    double Y = 0.5;
    double Score = 0.0;
  };

  /**
   * The best place for a sun: partly covered, with gaps about it. Places below lowest, a Y, are
   * left out. Score is 0 when no place is partly covered.
   */
  Place FindSun(double lowest) const;

  /**
   * The fraction of the picture that is covered.
   */
  double GetCoveredFraction() const;

private:
  void DrawSurface(vtkPolyData* surface, vtkMatrix4x4* toWorld);
  void DrawVolume(vtkVolume* volume);
  bool Project(const double* point, vtkMatrix4x4* matrix, double pixel[2]) const;
  void DrawPoint(const double pixel[2], int radius);
  void DrawTriangle(const double a[2], const double b[2], const double c[2]);
  void SumUp();

  bool IsCovered(double column, double row) const;
  double GetCoveredFraction(int column, int row, int radius) const;
  int CountEdges(int column, int row, double radius) const;
  double GetScore(int column, int row) const;

  int Rows = 128;
  int Columns;
  vtkMatrix4x4* ToClip;
  std::vector<unsigned char> Covered;
  std::vector<int> Sums; ///< of Covered, over all to the lower left
};

#endif
