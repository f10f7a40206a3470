// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSilhouette
 * @brief   what of a picture props cover, on a coarse grid; private to this module
 */

#ifndef vtkGodRaysSilhouette_h
#define vtkGodRaysSilhouette_h

#include <vector>

class vtkActor;
class vtkCamera;
class vtkDataSet;
class vtkMatrix4x4;
class vtkPolyData;
class vtkPropCollection;
class vtkVolume;

class vtkGodRaysSilhouette
{
public:
  /**
   * Of props that are seen by a camera, in a picture of this ratio of width to height.
   */
  vtkGodRaysSilhouette(vtkPropCollection* props, vtkCamera* camera, double aspect);

  /// A place in the picture, from (0, 0) at the lower left to (1, 1), and how good it is.
  struct Place
  {
    double X = 0.35;
    double Y = 0.75;
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
  void DrawActor(vtkActor* actor, vtkMatrix4x4* toWorld);
  void DrawSurface(vtkPolyData* surface, vtkMatrix4x4* toWorld);
  void DrawPoints(vtkDataSet* data, vtkMatrix4x4* toWorld);
  void DrawVolume(vtkVolume* volume, vtkMatrix4x4* toWorld);
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
  std::vector<int> Sums; // of Covered, over all to the lower left
};

#endif
