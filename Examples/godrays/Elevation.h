// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Pictures whose values are elevations.
 */

#ifndef Elevation_h
#define Elevation_h

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <optional> // For std::optional
#include <string>   // For std::string

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

/// How the samples of a picture lie on the earth.
struct Georeference
{
  bool Known = false; ///< whether the steps were read from the file
  double Column[2] = { 1.,
    0. }; ///< the step to the next column, to the east and to the north [metres]
  double Row[2] = { 0., 1. }; ///< the step to the next row
  double Scale = 1.0;         ///< of the samples; Scale * sample + Offset is an elevation
  double Offset = 0.0;
  double MetersPerUnit = 1.0;   ///< of the elevations
  std::optional<double> NoData; ///< the value of samples that were not measured
  std::string Unread;           ///< a field of the file that is not known, and how it is taken
};

/**
 * The georeference in the tags of a GeoTIFF; not Known for any other file.
 */
Georeference ReadGeoTiffTags(const std::string& path);

/**
 * The length of a degree to the east and to the north, at a latitude in degrees [metres].
 */
void GetDegreeLengths(double latitude, double lengths[2]);

/**
 * A factor for elevations that range over relief, on ground that is extent wide, with which they
 * are neither flat nor steep. When both are lengths it is 1, 2, 3, 5, 10, ...
 */
double ChooseElevationScale(double relief, double extent, bool lengths);

/**
 * The surface over a picture in the plane of X and Y, with normals and with the elevations as
 * scalars. Samples without a value are left out, and of more than four million, some rows and
 * columns. Impossible elevations are left out, too, which sets hasOutliers: those beyond 100 km, or beyond
 * 1e30 where the unit is not known, and those that FindUsualRange() leaves out.
 */
vtkSmartPointer<vtkPolyData> MakeElevationSurface(vtkImageData* picture, vtkDataArray* elevations,
  const Georeference& place, double scale, bool& hasOutliers);

#endif
