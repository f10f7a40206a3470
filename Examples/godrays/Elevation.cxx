// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elevation.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtk_tiff.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
/**
 * The first directory of a TIFF file. What is wrong with it, VTK's reader says.
 */
class TiffTags
{
public:
  explicit TiffTags(const std::string& path)
    : Error(TIFFSetErrorHandler(nullptr))
    , Warning(TIFFSetWarningHandler(nullptr)) // which tells of tags that it does not know
    , File(TIFFOpen(path.c_str(), "rm"))
  {
  }
  ~TiffTags()
  {
    if (this->File)
    {
      TIFFClose(this->File);
    }
    TIFFSetErrorHandler(this->Error);
    TIFFSetWarningHandler(this->Warning);
  }
  TiffTags(const TiffTags&) = delete;
  void operator=(const TiffTags&) = delete;

  /// The values of a tag of GeoTIFF; empty when the tag is missing, or has values of another type. Of
  /// fractions the library has floats, whatever it says of their size.
  template <typename T>
  std::vector<T> Get(int tag, TIFFDataType type) const
  {
    const TIFFField* field = this->File ? TIFFFindField(this->File, tag, TIFF_ANY) : nullptr;
    std::uint32_t count = 0;
    const T* values = nullptr;
    const bool isList = field && TIFFFieldPassCount(field) &&
      TIFFFieldReadCount(field) == TIFF_VARIABLE2 && TIFFFieldDataType(field) == type;
    return isList && TIFFGetField(this->File, tag, &count, &values)
      ? std::vector<T>(values, values + count)
      : std::vector<T>();
  }

  std::uint32_t GetRows() const
  {
    std::uint32_t rows = 0;
    return this->File && TIFFGetField(this->File, TIFFTAG_IMAGELENGTH, &rows) ? rows : 0;
  }

private:
  TIFFErrorHandler Error;
  TIFFErrorHandler Warning;
  TIFF* File;
};

constexpr int PixelScaleTag = 33550;
constexpr int TiepointTag = 33922;
constexpr int GeoKeysTag = 34735;
constexpr int NoDataTag = 42113;
constexpr int ModelTypeKey = 1024;
constexpr int GeographicModel = 2;

//------------------------------------------------------------------------------
bool IsLength(double value)
{
  return value > 0.0 && value < 1e15;
}

//------------------------------------------------------------------------------
bool IsGeographic(const std::vector<std::uint16_t>& keys)
{
  for (std::size_t i = 4; i + 3 < keys.size(); i += 4)
  {
    if (keys[i] == ModelTypeKey)
    {
      return keys[i + 3] == GeographicModel;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
/**
 * Elevations of every stride-th row and column, with their coordinates.
 */
class Grid
{
public:
  Grid(vtkImageData* picture, vtkDataArray* elevations, const Georeference& place, double scale)
    : Elevations(elevations)
    , Place(place)
    , Scale(scale)
  {
    picture->GetDimensions(this->Samples);
    const double* bounds = picture->GetBounds();
    this->Origin[0] = bounds[0];
    this->Origin[1] = bounds[2];
    this->Origin[2] = bounds[4];
    if (!place.Known)
    {
      std::copy_n(picture->GetSpacing(), 2, this->Place.Spacing);
    }
    constexpr double most = 4e6;
    const double count = static_cast<double>(this->Samples[0]) * this->Samples[1];
    this->Stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(count / most))));
    this->Columns = (this->Samples[0] - 1) / this->Stride + 1;
    this->Rows = (this->Samples[1] - 1) / this->Stride + 1;
    this->FindLowest();
  }

  double GetValue(int column, int row) const
  {
    const vtkIdType sample =
      static_cast<vtkIdType>(row) * this->Stride * this->Samples[0] + column * this->Stride;
    const double value = this->Elevations->GetComponent(sample, 0);
    return this->Place.NoData && value == *this->Place.NoData ? vtkMath::Nan() : value;
  }

  double GetHeight(int column, int row) const
  {
    return this->Scale * this->Place.MetersPerUnit * this->GetValue(column, row);
  }

  void GetPoint(int column, int row, double point[3]) const
  {
    const double height = this->GetHeight(column, row);
    point[0] = this->Origin[0] + column * this->Stride * this->Place.Spacing[0];
    point[1] = this->Origin[1] + row * this->Stride * this->Place.Spacing[1];
    point[2] = this->Origin[2] + (std::isnan(height) ? this->Lowest : height);
  }

  void GetNormal(int column, int row, double normal[3]) const
  {
    normal[0] = -this->GetSlope(column, row, 1, 0);
    normal[1] = -this->GetSlope(column, row, 0, 1);
    normal[2] = 1.0;
    vtkMath::Normalize(normal);
  }

  bool IsCell(int column, int row) const
  {
    return !std::isnan(this->GetValue(column, row) + this->GetValue(column + 1, row) +
      this->GetValue(column, row + 1) + this->GetValue(column + 1, row + 1));
  }

  int Columns;
  int Rows;

private:
  double GetSlope(int column, int row, int stepX, int stepY) const
  {
    const int column0 = std::max(column - stepX, 0);
    const int column1 = std::min(column + stepX, this->Columns - 1);
    const int row0 = std::max(row - stepY, 0);
    const int row1 = std::min(row + stepY, this->Rows - 1);
    const double run = stepX ? (column1 - column0) * this->Stride * this->Place.Spacing[0]
                             : (row1 - row0) * this->Stride * this->Place.Spacing[1];
    const double slope = (this->GetHeight(column1, row1) - this->GetHeight(column0, row0)) / run;
    return std::isnan(slope) ? 0.0 : slope;
  }

  /// Where samples without a value are put: no cell uses them, but bounds count them.
  void FindLowest()
  {
    double lowest = VTK_DOUBLE_MAX;
    for (int row = 0; row < this->Rows; ++row)
    {
      for (int column = 0; column < this->Columns; ++column)
      {
        const double height = this->GetHeight(column, row);
        lowest = height < lowest ? height : lowest;
      }
    }
    this->Lowest = lowest < VTK_DOUBLE_MAX ? lowest : 0.0;
  }

  vtkDataArray* Elevations;
  Georeference Place;
  double Scale;
  double Lowest = 0.0;
  int Samples[3];
  double Origin[3];
  int Stride;
};
}

//------------------------------------------------------------------------------
Georeference ReadGeoTiffTags(const std::string& path)
{
  Georeference place;
  TiffTags tags(path);
  const auto noData = tags.Get<char>(NoDataTag, TIFF_ASCII);
  if (!noData.empty())
  {
    const std::string text(noData.begin(), noData.end());
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str())
    {
      place.NoData = value;
    }
  }
  const auto scale = tags.Get<double>(PixelScaleTag, TIFF_DOUBLE);
  if (scale.size() < 2 || !IsLength(scale[0]) || !IsLength(scale[1]))
  {
    return place;
  }
  double spacing[2] = { scale[0], scale[1] };
  if (IsGeographic(tags.Get<std::uint16_t>(GeoKeysTag, TIFF_SHORT)))
  {
    const auto tiepoint = tags.Get<double>(TiepointTag, TIFF_DOUBLE);
    const double north = tiepoint.size() >= 6 ? tiepoint[4] + tiepoint[1] * scale[1] : 0.0;
    const double latitude = north - 0.5 * scale[1] * tags.GetRows();
    if (!(std::fabs(latitude) < 90.0))
    {
      return place; // these are no degrees
    }
    double lengths[2];
    GetDegreeLengths(latitude, lengths);
    spacing[0] *= lengths[0];
    spacing[1] *= lengths[1];
  }
  place.Known = true;
  std::copy_n(spacing, 2, place.Spacing);
  return place;
}

//------------------------------------------------------------------------------
void GetDegreeLengths(double latitude, double lengths[2])
{
  // The WGS 84 ellipsoid.
  constexpr double equatorialRadius = 6378137.0;
  constexpr double eccentricity2 = 0.00669437999014;
  const double angle = vtkMath::RadiansFromDegrees(latitude);
  const double sine = std::sin(angle);
  const double root = std::sqrt(1.0 - eccentricity2 * sine * sine);
  lengths[0] = vtkMath::RadiansFromDegrees(equatorialRadius / root * std::cos(angle));
  lengths[1] =
    vtkMath::RadiansFromDegrees(equatorialRadius * (1.0 - eccentricity2) / (root * root * root));
}

//------------------------------------------------------------------------------
double ChooseElevationScale(double relief, double extent, bool lengths)
{
  constexpr double flat = 0.08;
  constexpr double wanted = 0.14;
  constexpr double steep = 0.6;
  if (!(relief > 0.0) || !(extent > 0.0) ||
    (lengths && relief >= flat * extent && relief <= steep * extent))
  {
    return 1.0;
  }
  const double exact = wanted * extent / relief;
  if (!lengths || exact < 1.0)
  {
    return exact;
  }
  const double decade = std::pow(10.0, std::floor(std::log10(exact)));
  for (const double step : { 5.0, 3.0, 2.0 })
  {
    if (step * decade <= exact)
    {
      return step * decade;
    }
  }
  return decade;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeElevationSurface(
  vtkImageData* picture, vtkDataArray* elevations, const Georeference& place, double scale)
{
  const Grid grid(picture, elevations, place, scale);
  const vtkIdType count = static_cast<vtkIdType>(grid.Columns) * grid.Rows;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(count);
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName(elevations->GetName() ? elevations->GetName() : "Elevation");
  scalars->SetNumberOfTuples(count);
  vtkNew<vtkCellArray> cells;
  for (int row = 0; row < grid.Rows; ++row)
  {
    for (int column = 0; column < grid.Columns; ++column)
    {
      const vtkIdType id = static_cast<vtkIdType>(row) * grid.Columns + column;
      double vector[3];
      grid.GetPoint(column, row, vector);
      points->SetPoint(id, vector);
      grid.GetNormal(column, row, vector);
      normals->SetTuple(id, vector);
      scalars->SetTuple1(id, grid.GetValue(column, row));
      if (row + 1 < grid.Rows && column + 1 < grid.Columns && grid.IsCell(column, row))
      {
        const vtkIdType corners[4] = { id, id + 1, id + grid.Columns + 1, id + grid.Columns };
        cells->InsertNextCell(4, corners);
      }
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->SetNormals(normals);
  surface->GetPointData()->SetScalars(scalars);
  return surface;
}
