// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVolumeGrid.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkGodRaysVolumeHaze.h"
#include "vtkGodRaysVolumeImage.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace
{
using vtkGodRays::Vec3;

using Cut = vtkGodRaysVolumeGrid::Cut;

/// What transfer functions make of a table's numbers, evenly.
struct Functions
{
  std::vector<double> Opacities;
  std::vector<float> Tint; // red, green and blue of linear light
  bool Even = true;        // all tints are alike
  bool Grey = true;        // each has equal channels

  Functions(vtkVolumeProperty* property, double first, double last, int count)
    : Opacities(count)
    , Tint(3 * static_cast<std::size_t>(count))
  {
    property->GetScalarOpacity(0)->GetTable(first, last, count, this->Opacities.data());
    std::vector<double> colors(this->Tint.size());
    if (property->GetColorChannels(0) == 3)
    {
      property->GetRGBTransferFunction(0)->GetTable(first, last, count, colors.data());
    }
    else
    {
      std::vector<double> greys(count);
      property->GetGrayTransferFunction(0)->GetTable(first, last, count, greys.data());
      for (std::size_t i = 0; i < colors.size(); ++i)
      {
        colors[i] = greys[i / 3];
      }
    }
    for (std::size_t i = 0; i < colors.size(); i += 3)
    {
      float* tint = this->Tint.data() + i;
      for (int c = 0; c < 3; ++c)
      {
        tint[c] = static_cast<float>(
          vtkGodRays::DecodeDisplay(vtkMath::ClampValue(colors[i + c], 0.0, 1.0)));
        this->Even = this->Even && tint[c] == this->Tint[c];
      }
      this->Grey = this->Grey && tint[0] == tint[1] && tint[1] == tint[2];
    }
  }

  /// With scattering of so many bands.
  void Fill(vtkGodRaysGridTable& table, double unit, const Vec3& albedo, int bands) const
  {
    table.Components = 1 + bands;
    for (std::size_t i = 0; i < this->Opacities.size(); ++i)
    {
      const auto extinction = static_cast<float>(
        vtkGodRays::OpacityExtinction(vtkMath::ClampValue(this->Opacities[i], 0.0, 1.0), unit));
      table.Coefficients.push_back(extinction);
      for (int c = 0; c < bands; ++c)
      {
        table.Coefficients.push_back(
          static_cast<float>(albedo[c]) * extinction * this->Tint[3 * i + c]);
      }
    }
  }
};

/// Show no points that are cut off.
void Apply(const Cut& cut, vtkImageData* image, vtkGodRaysGridBits& shown)
{
  if (cut.IsNone())
  {
    return;
  }
  const int* extent = image->GetExtent();
  const int* size = image->GetDimensions();
  const vtkIdType slice = static_cast<vtkIdType>(size[0]) * size[1];
  const vtkIdType count = image->GetNumberOfPoints();
  if (shown.IsEmpty())
  {
    shown.Resize(static_cast<std::size_t>(count), true);
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(shown.GetNumberOfWords()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = 64 * begin; i < std::min(64 * end, count); ++i)
      {
        const int at[3] = { extent[0] + static_cast<int>(i % size[0]),
          extent[2] + static_cast<int>(i / size[0] % size[1]),
          extent[4] + static_cast<int>(i / slice) };
        double place[3];
        image->TransformIndexToPhysicalPoint(at, place);
        if (cut.Takes(place))
        {
          shown.Set(i, false);
        }
      }
    });
}

bool IsComposite(vtkAbstractVolumeMapper* mapper)
{
  auto images = vtkVolumeMapper::SafeDownCast(mapper);
  auto cells = vtkUnstructuredGridVolumeMapper::SafeDownCast(mapper);
  return images
    ? images->GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND
    : !cells || cells->GetBlendMode() == vtkUnstructuredGridVolumeMapper::COMPOSITE_BLEND;
}

/// Why a property or a blend mode tells no medium; empty if it does.
std::string FindFault(vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property)
{
  if (!IsComposite(mapper) || !vtkGodRaysVolumeHaze::HasScalarOpacityAlone(property))
  {
    return "has gradient opacity, a 2-D transfer function or another blend mode than composite. "
           "Give it a scalar opacity alone";
  }
  const double unit = property->GetScalarOpacityUnitDistance(0);
  return unit > 1e-30 && std::isfinite(unit)
    ? ""
    : "has a ScalarOpacityUnitDistance that is not above 0. Set it to the length on which its "
      "opacity is taken";
}

/// The length on which an opacity is taken [scene units]. VTK counts it in the data's own coordinates, along
/// each ray; of data that are not scaled alike along all axes, that of a cube of the same volume is taken.
double GetUnitDistance(vtkVolume* volume)
{
  return volume->GetProperty()->GetScalarOpacityUnitDistance(0) *
    vtkGodRaysVolumeGrid::GetScale(volume);
}

/// How far what a grid tells is from what the data are, where these are known. They may be outside of the
/// range of the image's values, for which there is a table.
vtkGodRaysVolumeGrid::Error FindError(const std::vector<vtkGodRaysVolumeImage::Sample>& samples,
  vtkImageData* image, vtkVolume* volume, const Cut& cut, const vtkGodRaysGrid& grid)
{
  vtkPiecewiseFunction* opacities = volume->GetProperty()->GetScalarOpacity(0);
  const double unit = GetUnitDistance(volume);
  vtkGodRaysVolumeGrid::Error error;
  double peak = 0.0;
  double squares = 0.0;
  std::size_t count = 0;
  for (const auto& sample : samples)
  {
    if (!std::isfinite(sample.Value) || (!cut.IsNone() && cut.Takes(sample.Place.data())))
    {
      continue;
    }
    double place[3];
    image->TransformPhysicalPointToContinuousIndex(sample.Place.data(), place);
    for (int i = 0; i < 3; ++i)
    {
      place[i] -= image->GetExtent()[2 * i];
    }
    const double opacity = vtkMath::ClampValue(opacities->GetValue(sample.Value), 0.0, 1.0);
    const double known = grid.Scale * vtkGodRays::OpacityExtinction(opacity, unit);
    const double told = grid.Sample(Vec3(place[0], place[1], place[2])).Extinction.x;
    peak = std::max(peak, known);
    squares += (told - known) * (told - known);
    error.Largest = std::max(error.Largest, std::abs(told - known));
    ++count;
  }
  if (peak > 0.0)
  {
    error.Mean = std::sqrt(squares / static_cast<double>(count)) / peak;
    error.Largest /= peak;
    error.Whole = peak;
  }
  return error;
}
}

double vtkGodRaysVolumeGrid::GetScale(vtkVolume* volume)
{
  return std::cbrt(std::abs(volume->GetMatrix()->Determinant()));
}

vtkGodRaysVolumeGrid::Cut::Cut(vtkAbstractVolumeMapper* mapper, vtkMatrix4x4* toWorld)
{
  if (auto cropping = vtkVolumeMapper::SafeDownCast(mapper))
  {
    this->Cropped = cropping->GetCropping() != 0;
    this->Flags = cropping->GetCroppingRegionFlags();
    std::copy_n(cropping->GetCroppingRegionPlanes(), 6, this->Crop);
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    const double* normal = planes->GetItem(i)->GetNormal();
    std::array<double, 4> plane = { 0.0, 0.0, 0.0,
      -vtkMath::Dot(normal, planes->GetItem(i)->GetOrigin()) };
    for (int column = 0; column < 4; ++column)
    {
      for (int k = 0; k < 3; ++k)
      {
        plane[column] += normal[k] * toWorld->GetElement(k, column);
      }
    }
    this->Planes.push_back(plane);
  }
}

bool vtkGodRaysVolumeGrid::Cut::Takes(const double place[3]) const
{
  for (const auto& plane : this->Planes)
  {
    if (vtkMath::Dot(plane.data(), place) + plane[3] < 0.0)
    {
      return true;
    }
  }
  int region = 0;
  for (int i = 2; this->Cropped && i >= 0; --i)
  {
    region = 3 * region +
      (place[i] < this->Crop[2 * i]          ? 0
          : place[i] > this->Crop[2 * i + 1] ? 2
                                             : 1);
  }
  return this->Cropped && (this->Flags >> region & 1) == 0;
}

std::vector<std::array<double, 2>> vtkGodRaysVolumeGrid::Cut::GetParts(
  const Vec3& start, const Vec3& change, double begin, double end) const
{
  std::vector<double> ends = { begin, end };
  const auto add = [&](double at, double rate)
  {
    const double s = rate != 0.0 ? -at / rate : begin;
    if (s > begin && s < end)
    {
      ends.push_back(s);
    }
  };
  for (const auto& plane : this->Planes)
  {
    const Vec3 normal(plane[0], plane[1], plane[2]);
    add(vtkGodRays::dot(normal, start) + plane[3], vtkGodRays::dot(normal, change));
  }
  for (int i = 0; i < 6 && this->Cropped; ++i)
  {
    add(start[i / 2] - this->Crop[i], change[i / 2]);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::array<double, 2>> parts;
  for (std::size_t i = 1; i < ends.size(); ++i)
  {
    const Vec3 middle = start + 0.5 * (ends[i - 1] + ends[i]) * change;
    const double place[3] = { middle.x, middle.y, middle.z };
    if (ends[i] > ends[i - 1] && !this->Takes(place))
    {
      parts.push_back({ ends[i - 1], ends[i] });
    }
  }
  return parts;
}

std::string vtkGodRaysVolumeGrid::Read(vtkProp* prop, const Numbers& numbers,
  vtkGodRaysVolumeImage& data, vtkGodRaysGrid& grid, Error& error, bool isWhole)
{
  auto volume = vtkVolume::SafeDownCast(prop);
  if (!volume || prop->IsA("vtkMultiVolume"))
  {
    return std::string("is a ") + prop->GetClassName() +
      ". Tag each vtkVolume, and give other props another role";
  }
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  vtkVolumeProperty* property = volume->GetProperty();
  std::string fault = FindFault(mapper, property);
  const auto component = !isWhole          ? vtkGodRaysVolumeImage::ONLY
    : property->GetIndependentComponents() ? vtkGodRaysVolumeImage::FIRST
                                           : vtkGodRaysVolumeImage::LAST;
  fault = fault.empty() ? data.Update(mapper, numbers.Resolution, component) : fault;
  if (!fault.empty())
  {
    return fault;
  }
  vtkImageData* image = data.GetImage();
  vtkDataArray* scalars = data.GetScalars();

  std::copy_n(image->GetDimensions(), 3, grid.Points);
  const int* extent = image->GetExtent();
  double toWorld[16];
  vtkMatrix4x4::Multiply4x4(
    volume->GetMatrix()->GetData(), image->GetIndexToPhysicalMatrix()->GetData(), toWorld);
  for (int i = 0; i < 3; ++i)
  {
    grid.Origin[i] = toWorld[4 * i + 3];
    for (int axis = 0; axis < 3; ++axis)
    {
      grid.Axes[axis][i] = toWorld[4 * i + axis];
      grid.Origin[i] += extent[2 * axis] * toWorld[4 * i + axis];
    }
  }
  if (!std::all_of(toWorld, toWorld + 16, [](double v) { return std::isfinite(v); }) ||
    !grid.Invert())
  {
    return "has no volume in the world. Set its matrix, and the image's spacing, to finite numbers "
           "that span one";
  }

  auto table = std::make_shared<vtkGodRaysGridTable>();
  table->Shown = data.GetMask();
  if (!table->SetValues(scalars))
  {
    return "has values that are not finite. Replace them with numbers";
  }
  const Functions functions(property, table->First, table->Last, table->Entries);
  const Vec3 albedo(numbers.Albedo[0], numbers.Albedo[1], numbers.Albedo[2]);
  const bool alike = albedo.x == albedo.y && albedo.y == albedo.z;
  functions.Fill(*table, GetUnitDistance(volume), albedo,
    functions.Even              ? 0
      : functions.Grey && alike ? 1
                                : 3);
  const Cut cut(mapper, volume->GetMatrix());
  if (!isWhole)
  {
    Apply(cut, image, table->Shown);
  }
  table->Finish();
  grid.ScatteringBands = table->Components - 1;
  grid.Table = table;
  grid.Scale = numbers.Scale;
  for (int c = 0; c < 3; ++c)
  {
    grid.Albedo[c] = albedo[c] * functions.Tint[c];
  }
  grid.PhaseFunction = numbers.PhaseFunction;
  grid.Asymmetry = numbers.Asymmetry;
  error = FindError(data.GetSamples(), image, volume, cut, grid);
  return "";
}
