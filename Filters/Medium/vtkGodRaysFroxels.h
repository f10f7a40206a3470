// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysFroxels
 * @brief   light of a smooth source in a medium along all view rays of a picture
 *
 * Private. Froxels are voxels of the view frustum: columns of view rays, 16 pixels apart, divided into slices
 * of equal view depth. Each holds the light that the source adds between the eye and the end of its slice.
 * Between them light is linear, so that a view ray to any depth is one look-up.
 */

#ifndef vtkGodRaysFroxels_h
#define vtkGodRaysFroxels_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMultipleScattering.h"
#include "vtkGodRaysSingleScattering.h" // For Parameters

#include <vector>

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysFroxels
{
public:
  using Vec3 = vtkGodRays::Vec3;

  using Source = vtkGodRaysMultipleScattering::Texture; // of FindSource()

  /// A picture and its view rays; see vtkGodRaysGridPicture::Picture.
  struct Picture
  {
    int Size[2] = { 0, 0 };
    double PixelSize = 1.0;
    double Center[2] = { 0.0, 0.0 };
  };

  /**
   * Sum the source along view rays through the parameters' medium, whose light is not read.
   */
  void Build(const vtkGodRaysSingleScattering::Parameters& parameters, const Picture& picture,
    const Source& source);

  /**
   * Get the light that reaches the eye from nearer than a view depth along the ray through a place of the
   * plane at view depth 1, or of the plane of view if rays are parallel.
   */
  Vec3 Get(double x, double y, double depth) const { return this->Table.Sample(Vec3(x, y, depth)); }

  ///@{
  /// The numbers: columns side by side, rows from the bottom up, slice on slice.
  const std::vector<float>& GetValues() const { return this->Table.Values; }
  int GetColumns() const { return this->Table.Nodes[0]; }
  int GetRows() const { return this->Table.Nodes[1]; }
  static constexpr int Slices = 40;
  double GetFarthest() const { return this->Farthest; } // the view depth of the last slice
  ///@}

private:
  double Farthest = 1.0;
  vtkGodRaysMultipleScattering::Texture Table; // over the plane at view depth 1, and view depth
};

#endif
