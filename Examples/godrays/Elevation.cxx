// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Elevation.h"

#include "Outliers.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"
#include "vtk_tiff.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>
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

  /// Returns the text of a tag, empty if there is none.
  std::string GetText(int tag) const
  {
    const auto letters = this->Get<char>(tag, TIFF_ASCII);
    return std::string(letters.begin(), std::find(letters.begin(), letters.end(), '\0'));
  }

  double GetSize(int tag) const
  {
    std::uint32_t size = 0;
    return this->File && TIFFGetField(this->File, tag, &size) ? size : 0.0;
  }

private:
  TIFFErrorHandler Error;
  TIFFErrorHandler Warning;
  TIFF* File;
};

constexpr int PixelScaleTag = 33550;
constexpr int TiepointTag = 33922;
constexpr int TransformationTag = 34264;
constexpr int GeoKeysTag = 34735;
constexpr int GeoDoublesTag = 34736;
constexpr int MetadataTag = 42112; // GDAL's
constexpr int NoDataTag = 42113;

//------------------------------------------------------------------------------
/// The keys of a GeoTIFF.
class GeoKeys
{
public:
  static constexpr int ModelType = 1024;
  static constexpr int AngularUnits = 2054;
  static constexpr int LinearUnits = 3076;
  static constexpr int LinearUnitSize = 3077;
  static constexpr int VerticalUnits = 4099;

  explicit GeoKeys(const TiffTags& tags)
    : Keys(tags.Get<std::uint16_t>(GeoKeysTag, TIFF_SHORT))
    , Doubles(tags.Get<double>(GeoDoublesTag, TIFF_DOUBLE))
  {
  }

  /// Returns the value of a key, 0 if there is none.
  double Get(int key) const
  {
    for (std::size_t i = 4; i + 3 < this->Keys.size(); i += 4)
    {
      const std::size_t value = this->Keys[i + 3];
      if (this->Keys[i] == key)
      {
        return this->Keys[i + 1] != GeoDoublesTag ? static_cast<double>(value)
          : value < this->Doubles.size()          ? this->Doubles[value]
                                                  : 0.0;
      }
    }
    return 0.0;
  }

  /// Returns how many metres or degrees the unit of a key has. An unknown unit has one, and is named.
  double GetUnit(int key, std::string& unread) const
  {
    // By EPSG's numbers, and by the text of GDAL's.
    static const std::map<int, double> units = { { 0, 1.0 }, { 9001, 1.0 }, { 9002, 0.3048 },
      { 9003, 1200.0 / 3937.0 }, { 9036, 1000.0 }, { 9101, vtkMath::DegreesFromRadians(1.0) },
      { 9102, 1.0 }, { 9105, 0.9 }, { 9122, 1.0 } };
    constexpr int userDefined = 32767;
    const int code = static_cast<int>(this->Get(key));
    const double size = this->Get(LinearUnitSize);
    if (key == LinearUnits && code == userDefined && size > 1e-6 && size < 1e6)
    {
      return size;
    }
    const auto found = units.find(code);
    if (found == units.end())
    {
      unread = "its unit " + std::to_string(code) + " is not known, and taken for " +
        (key == AngularUnits ? "degrees" : "metres");
    }
    return found != units.end() ? found->second : 1.0;
  }

private:
  std::vector<std::uint16_t> Keys;
  std::vector<double> Doubles;
};

//------------------------------------------------------------------------------
/// Reads the scale, offset and unit of the samples, which GDAL writes as XML.
void ReadMetadata(const std::string& text, Georeference& place)
{
  const auto root = vtk::TakeSmartPointer(vtkXMLUtilities::ReadElementFromString(text.c_str()));
  for (int i = 0; root && i < root->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* item = root->GetNestedElement(i);
    const char* words = item->GetAttribute("role");
    const char* contents = item->GetCharacterData();
    int sample = 0;
    item->GetScalarAttribute("sample", sample);
    if (!words || !contents || sample != 0)
    {
      continue;
    }
    const std::string role = words;
    const double number = std::strtod(contents, nullptr);
    if (role == "scale" && std::fabs(number) > 1e-9 && std::fabs(number) < 1e9)
    {
      place.Scale = number;
    }
    else if (role == "offset" && std::fabs(number) < 1e9)
    {
      place.Offset = number;
    }
    else if (role == "unittype")
    {
      const std::string unit = contents;
      const auto has = [&unit](const char* word) { return unit.find(word) != std::string::npos; };
      const bool isFeet = has("ft") || has("feet") || has("foot");
      const bool isMeters = unit == "m" || has("met");
      place.MetersPerUnit = !isFeet ? 1.0 : has("US") || has("us") ? 1200.0 / 3937.0 : 0.3048;
      place.Unread = isFeet || isMeters
        ? ""
        : "its unit of elevations " + unit + " is not known, and taken for metres";
    }
  }
}

//------------------------------------------------------------------------------
/**
 * Elevations of every stride-th row and column, with their coordinates.
 */
class Grid
{
public:
  Grid(vtkImageData* picture, vtkDataArray* samples, const Georeference& place, double scale)
    : Place(place)
    , Scale(scale)
  {
    int size[3];
    picture->GetDimensions(size);
    const double* bounds = picture->GetBounds();
    this->Origin[0] = bounds[0];
    this->Origin[1] = bounds[2];
    this->Origin[2] = bounds[4];
    constexpr double most = 4e6;
    const double count = static_cast<double>(size[0]) * size[1];
    const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(count / most))));
    this->Columns = (size[0] - 1) / stride + 1;
    this->Rows = (size[1] - 1) / stride + 1;
    for (int i = 0; i < 2; ++i)
    {
      this->Place.Column[i] = stride *
        (place.Known ? place.Column[i]
            : i      ? 0.
                     : picture->GetSpacing()[0]);
      this->Place.Row[i] = stride *
        (place.Known ? place.Row[i]
            : i      ? picture->GetSpacing()[1]
                     : 0.);
    }
    if (place.NoData && samples->GetDataType() == VTK_FLOAT)
    {
      constexpr double largest = std::numeric_limits<float>::max();
      this->Place.NoData =
        static_cast<float>(std::clamp(*place.NoData, -largest, largest)); // as samples are rounded
    }
    this->Values->SetNumberOfTuples(static_cast<vtkIdType>(this->Columns) * this->Rows);
    for (vtkIdType i = 0; i < this->Values->GetNumberOfTuples(); ++i)
    {
      const vtkIdType sample = i / this->Columns * stride * size[0] + i % this->Columns * stride;
      const double value = samples->GetComponent(sample, 0);
      this->Values->SetValue(i,
        this->Place.NoData && value == *this->Place.NoData ? vtkMath::Nan()
                                                           : place.Scale * value + place.Offset);
    }
    this->LeaveOutliersOut();
  }

  double GetValue(int column, int row) const
  {
    return this->Values->GetValue(static_cast<vtkIdType>(row) * this->Columns + column);
  }

  double GetHeight(int column, int row) const
  {
    return this->Scale * this->Place.MetersPerUnit * this->GetValue(column, row);
  }

  void GetPoint(int column, int row, double point[3]) const
  {
    const double height = this->GetHeight(column, row);
    for (int i = 0; i < 2; ++i)
    {
      point[i] = this->Origin[i] + column * this->Place.Column[i] + row * this->Place.Row[i];
    }
    point[2] = this->Origin[2] + (std::isnan(height) ? this->Lowest : height);
  }

  /// Returns the upward unit normal, from the differences of heights along columns and rows.
  void GetNormal(int column, int row, double normal[3]) const
  {
    const double* x = this->Place.Column;
    const double* y = this->Place.Row;
    const double alongX = this->GetStep(column, row, 1, 0);
    const double alongY = this->GetStep(column, row, 0, 1);
    const double area = this->GetArea();
    normal[0] = (-y[1] * alongX + x[1] * alongY) / area;
    normal[1] = (y[0] * alongX - x[0] * alongY) / area;
    normal[2] = 1.0;
    vtkMath::Normalize(normal);
  }

  /// Returns the area of a cell, negative if rows follow clockwise on columns.
  double GetArea() const
  {
    return this->Place.Column[0] * this->Place.Row[1] - this->Place.Column[1] * this->Place.Row[0];
  }

  bool IsCell(int column, int row) const
  {
    return !std::isnan(this->GetValue(column, row) + this->GetValue(column + 1, row) +
      this->GetValue(column, row + 1) + this->GetValue(column + 1, row + 1));
  }

  int Columns;
  int Rows;
  bool HasOutliers = false;

private:
  /// Returns the difference of heights a step farther, 0 where one is missing.
  double GetStep(int column, int row, int stepX, int stepY) const
  {
    const int column0 = std::max(column - stepX, 0);
    const int column1 = std::min(column + stepX, this->Columns - 1);
    const int row0 = std::max(row - stepY, 0);
    const int row1 = std::min(row + stepY, this->Rows - 1);
    const double step = (this->GetHeight(column1, row1) - this->GetHeight(column0, row0)) /
      (stepX ? column1 - column0 : row1 - row0);
    return std::isnan(step) ? 0.0 : step;
  }

  void LeaveOutliersOut()
  {
    const double most = this->Place.Known ? 1e5 / this->Place.MetersPerUnit : 1e30;
    double range[2] = { -most, most };
    const auto leaveOut = [&]
    {
      double lowest = VTK_DOUBLE_MAX;
      for (auto& value : vtk::DataArrayValueRange<1>(this->Values.Get()))
      {
        const bool isOutlier = std::isfinite(value) && !(value >= range[0] && value <= range[1]);
        this->HasOutliers = this->HasOutliers || isOutlier;
        value = isOutlier || !std::isfinite(value) ? vtkMath::Nan() : value;
        lowest = value < lowest ? value : lowest;
      }
      this->Lowest =
        lowest < VTK_DOUBLE_MAX ? this->Scale * this->Place.MetersPerUnit * lowest : 0.0;
    };
    leaveOut();
    this->Values->DataChanged();
    if (FindUsualRange(this->Values, 0, range))
    {
      leaveOut();
    }
  }

  vtkNew<vtkDoubleArray> Values;
  Georeference Place;
  double Scale;
  double Lowest =
    0.0; ///< where samples without a value are put: no cell uses them, but bounds count them
  double Origin[3];
};
}

//------------------------------------------------------------------------------
Georeference ReadGeoTiffTags(const std::string& path)
{
  Georeference place;
  const TiffTags tags(path);
  const std::string noData = tags.GetText(NoDataTag);
  char* end = nullptr;
  const double value = std::strtod(noData.c_str(), &end);
  if (end != noData.c_str())
  {
    place.NoData = value;
  }
  const GeoKeys keys(tags);
  place.MetersPerUnit = keys.GetUnit(GeoKeys::VerticalUnits, place.Unread);
  const std::string metadata = tags.GetText(MetadataTag);
  if (!metadata.empty())
  {
    ReadMetadata(metadata, place);
  }
  // The steps to the next column and row, and the place of the first sample, to the east and north.
  double column[2] = {};
  double row[2] = {};
  double north = 0.0;
  const auto matrix = tags.Get<double>(TransformationTag, TIFF_DOUBLE);
  const auto scale = tags.Get<double>(PixelScaleTag, TIFF_DOUBLE);
  const auto tiepoint = tags.Get<double>(TiepointTag, TIFF_DOUBLE);
  if (matrix.size() == 16)
  {
    for (int i = 0; i < 2; ++i)
    {
      column[i] = matrix[4 * i];
      row[i] = matrix[4 * i + 1];
    }
    north = matrix[7];
  }
  else if (scale.size() >= 2)
  {
    column[0] = scale[0];
    row[1] = -scale[1];
    north = tiepoint.size() >= 6 ? tiepoint[4] + tiepoint[1] * scale[1] : 0.0;
  }
  double units[2];
  constexpr int geographic = 2;
  if (keys.Get(GeoKeys::ModelType) == geographic)
  {
    const double degrees = keys.GetUnit(GeoKeys::AngularUnits, place.Unread);
    const double latitude = degrees *
      (north + 0.5 * column[1] * tags.GetSize(TIFFTAG_IMAGEWIDTH) +
        0.5 * row[1] * tags.GetSize(TIFFTAG_IMAGELENGTH));
    if (!(std::fabs(latitude) < 90.0))
    {
      return place; // these are no degrees
    }
    GetDegreeLengths(latitude, units);
    units[0] *= degrees;
    units[1] *= degrees;
  }
  else
  {
    units[0] = units[1] = keys.GetUnit(GeoKeys::LinearUnits, place.Unread);
  }
  for (int i = 0; i < 2; ++i)
  {
    place.Column[i] = units[i] * column[i];
    place.Row[i] = -units[i] * row[i]; // VTK's first row is the last one of the file
  }
  const double lengths[2] = { std::hypot(place.Column[0], place.Column[1]),
    std::hypot(place.Row[0], place.Row[1]) };
  const double area = place.Column[0] * place.Row[1] - place.Column[1] * place.Row[0];
  constexpr double most = 1e15;
  place.Known =
    lengths[0] < most && lengths[1] < most && std::fabs(area) > 1e-6 * lengths[0] * lengths[1];
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
vtkSmartPointer<vtkPolyData> MakeElevationSurface(vtkImageData* picture, vtkDataArray* elevations,
  const Georeference& place, double scale, bool& hasOutliers)
{
  const Grid grid(picture, elevations, place, scale);
  hasOutliers = grid.HasOutliers;
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
        vtkIdType corners[4] = { id, id + 1, id + grid.Columns + 1, id + grid.Columns };
        if (grid.GetArea() < 0.0)
        {
          std::swap(corners[1], corners[3]);
        }
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
