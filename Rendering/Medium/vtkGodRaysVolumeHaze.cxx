// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVolumeHaze.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkDataArray.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysVolumeImage.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkSMPTools.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace
{
using Haze = vtkGodRaysShadowLayers::Haze;

constexpr int TableSize = 1024;
constexpr int MostSteps = 512; // along a ray, in all

vtkImageData* GetImage(vtkVolumeMapper* mapper)
{
  return mapper && mapper->GetNumberOfInputConnections(0) > 0
    ? vtkImageData::SafeDownCast(mapper->GetInputDataObject(0, 0))
    : nullptr;
}

vtkDataArray* GetScalars(vtkVolumeMapper* mapper, int& ofCells)
{
  return vtkAbstractMapper::GetScalars(GetImage(mapper), mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), ofCells);
}

/// A volume in numbers.
struct Field
{
  double ToIndex[16]; // from view coordinates
  double ToData[16];  // of the volume's own coordinates
  int Dimensions[3];
  vtkDataArray* Scalars;
  const void* Values; // found once: arrays of other layouts make a copy for it
  int Components;
  int Component; // that has the opacity
  bool OfCells;
  bool Nearest;
  double Extinctions[TableSize]; // [1/unit of the data's coordinates]
  double Range[2];
  bool Cropped;
  double Crop[6];
  int CropFlags;
  std::vector<std::array<double, 4>>
    Planes;    // a x + b y + c z + d >= 0 is kept, in view coordinates
  double Step; // the least width of a cell [scene units]

  Field(vtkVolume* volume, const vtkGodRaysView& view)
  {
    auto mapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
    vtkImageData* image = GetImage(mapper);
    int ofCells = 0;
    this->Scalars = GetScalars(mapper, ofCells);
    this->Values = this->Scalars->GetVoidPointer(0);
    double toWorld[16];
    vtkMatrix4x4::Invert(view.WorldToView, toWorld);
    double fromWorld[16];
    vtkMatrix4x4::Invert(volume->GetMatrix()->GetData(), fromWorld);
    vtkMatrix4x4::Multiply4x4(fromWorld, toWorld, this->ToData);
    vtkMatrix4x4::Multiply4x4(
      image->GetPhysicalToIndexMatrix()->GetData(), this->ToData, this->ToIndex);
    const int* extent = image->GetExtent();
    for (int i = 0; i < 3; ++i)
    {
      this->Dimensions[i] = extent[2 * i + 1] - extent[2 * i] + 1 - (ofCells ? 1 : 0);
      this->ToIndex[4 * i + 3] -= extent[2 * i] + (ofCells ? 0.5 : 0.0);
    }
    // A cell's width along the index i is one over the change of i.
    this->Step = VTK_DOUBLE_MAX;
    for (int i = 0; i < 3; ++i)
    {
      this->Step =
        std::min(this->Step, 1.0 / std::max(vtkMath::Norm(this->ToIndex + 4 * i), 1e-30));
    }
    vtkVolumeProperty* property = volume->GetProperty();
    this->Components = this->Scalars->GetNumberOfComponents();
    this->Component = property->GetIndependentComponents() ? 0 : this->Components - 1;
    this->OfCells = ofCells != 0;
    this->Nearest = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION || this->OfCells;
    this->Scalars->GetRange(this->Range, this->Component);
    this->Range[1] = std::max(this->Range[1], this->Range[0] + 1e-30);
    property->GetScalarOpacity(0)->GetTable(
      this->Range[0], this->Range[1], TableSize, this->Extinctions);
    const double unit = std::max(property->GetScalarOpacityUnitDistance(0), 1e-30);
    for (double& value : this->Extinctions)
    {
      value = vtkGodRays::OpacityExtinction(vtkMath::ClampValue(value, 0.0, 1.0), unit);
    }
    this->Cropped = mapper->GetCropping() != 0;
    std::copy_n(mapper->GetCroppingRegionPlanes(), 6, this->Crop);
    this->CropFlags = mapper->GetCroppingRegionFlags();
    vtkPlaneCollection* planes = mapper->GetClippingPlanes();
    for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
    {
      const double* normal = planes->GetItem(i)->GetNormal();
      const double* origin = planes->GetItem(i)->GetOrigin();
      std::array<double, 4> plane = { 0.0, 0.0, 0.0, -vtkMath::Dot(normal, origin) };
      for (int column = 0; column < 4; ++column)
      {
        for (int k = 0; k < 3; ++k)
        {
          plane[column] += normal[k] * toWorld[4 * k + column];
        }
      }
      this->Planes.push_back(plane);
    }
  }

  /// How far data reach beyond the places of their first and last values along an index [cells].
  double GetMargin(int i) const { return this->OfCells || this->Dimensions[i] == 1 ? 0.5 : 0.0; }

  /// Leave of a range of distances along a ray what is in the data's box.
  void Clip(const double start[3], const double change[3], double ends[2]) const
  {
    for (int i = 0; i < 3; ++i)
    {
      const double at = Apply(this->ToIndex + 4 * i, start);
      const double rate = vtkMath::Dot(this->ToIndex + 4 * i, change);
      const double low = -this->GetMargin(i) - at;
      const double high = this->Dimensions[i] - 1 + this->GetMargin(i) - at;
      if (std::abs(rate) < 1e-300)
      {
        ends[1] = low <= 0.0 && high >= 0.0 ? ends[1] : ends[0];
        continue;
      }
      ends[0] = std::max(ends[0], std::min(low / rate, high / rate));
      ends[1] = std::min(ends[1], std::max(low / rate, high / rate));
    }
  }

  /// Returns the length of a vector of view coordinates in those of the data, which VTK's mappers count.
  double GetLength(const double change[3]) const
  {
    double inData[3];
    for (int i = 0; i < 3; ++i)
    {
      inData[i] = vtkMath::Dot(this->ToData + 4 * i, change);
    }
    return vtkMath::Norm(inData);
  }

  static double Apply(const double row[4], const double place[3])
  {
    return row[0] * place[0] + row[1] * place[1] + row[2] * place[2] + row[3];
  }

  bool IsCut(const double place[3]) const
  {
    for (const auto& plane : this->Planes)
    {
      if (Apply(plane.data(), place) < 0.0)
      {
        return true;
      }
    }
    if (!this->Cropped)
    {
      return false;
    }
    int region = 0;
    for (int i = 2; i >= 0; --i)
    {
      const double x = Apply(this->ToData + 4 * i, place);
      region = 3 * region + (x < this->Crop[2 * i] ? 0 : x > this->Crop[2 * i + 1] ? 2 : 1);
    }
    return (this->CropFlags >> region & 1) == 0;
  }

  double Look(double value) const
  {
    const double at = (value - this->Range[0]) / (this->Range[1] - this->Range[0]);
    const double inside = at > 0.0 ? std::min(at, 1.0) : 0.0; // of NaN, too
    return this->Extinctions[static_cast<int>(inside * (TableSize - 1) + 0.5)];
  }

  /// The extinction at a place in view coordinates.
  template <typename T>
  double GetExtinction(const T* values, const double place[3]) const
  {
    std::ptrdiff_t low[3];
    std::ptrdiff_t next[3];
    double part[3];
    std::ptrdiff_t stride = 1;
    for (int i = 0; i < 3; ++i)
    {
      const double x = Apply(this->ToIndex + 4 * i, place);
      const double margin = this->GetMargin(i) + 1e-9;
      const int last = this->Dimensions[i] - 1;
      if (!(x >= -margin && x <= last + margin))
      {
        return 0.0;
      }
      const double inside = std::min(std::max(x, 0.0), static_cast<double>(last));
      const int at = this->Nearest ? static_cast<int>(inside + 0.5)
                                   : std::min(static_cast<int>(inside), std::max(last - 1, 0));
      part[i] = this->Nearest ? 0.0 : inside - at;
      low[i] = at * stride;
      next[i] = at < last ? stride : 0;
      stride *= this->Dimensions[i];
    }
    if (this->IsCut(place))
    {
      return 0.0;
    }
    const T* base = values + this->Component;
    const std::ptrdiff_t first = low[0] + low[1] + low[2];
    if (this->Nearest)
    {
      return this->Look(static_cast<double>(base[first * this->Components]));
    }
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      std::ptrdiff_t index = first;
      for (int i = 0; i < 3; ++i)
      {
        const bool high = (corner >> i & 1) != 0;
        weight *= high ? part[i] : 1.0 - part[i];
        index += high ? next[i] : 0;
      }
      sum += weight * static_cast<double>(base[index * this->Components]);
    }
    return this->Look(sum);
  }
};

/// A map's rays of light: by the distance from the light along an axis, or, of a directional light, by the
/// height along the way to it from the greatest one down.
struct Rays
{
  const vtkGodRaysShadowGrids& Grids;
  double Light[3];   // a position
  double Towards[3]; // of a directional light

  // At distances 0 and 1 [scene units].
  void Find(const vtkGodRaysShadowGrids::Grid& grid, double i, double j, double start[3],
    double change[3]) const
  {
    const double a = grid.Low[0] + i * grid.Texel[0];
    const double b = grid.Low[1] + j * grid.Texel[1];
    for (int k = 0; k < 3; ++k)
    {
      const double across = a * grid.Axes[0][k] + b * grid.Axes[1][k];
      start[k] = this->Grids.Point ? this->Light[k] : across;
      change[k] = this->Grids.Point ? across + grid.Axes[2][k] : -this->Towards[k];
    }
  }

  // Of corners of bounds: least and greatest distance.
  void Reach(const double place[3], double range[2]) const
  {
    double at = 0.0;
    if (!this->Grids.Point)
    {
      at = -vtkMath::Dot(this->Towards, place);
      range[0] = std::min(range[0], at);
      range[1] = std::max(range[1], at);
      return;
    }
    // Along the axis of any face: between a part of the way, and all of it.
    at = std::sqrt(vtkMath::Distance2BetweenPoints(this->Light, place));
    range[0] = 0.0;
    range[1] = std::max(range[1], at);
  }

  float GetDepth(double at) const
  {
    const vtkGodRaysShadowGrids& g = this->Grids;
    const double depth = g.Point
      ? (1.0 / std::max(at, 1e-30) - g.GetNearness(0.0)) / (g.GetNearness(1.0) - g.GetNearness(0.0))
      : (at - g.Range[0]) / (g.Range[1] - g.Range[0]);
    return static_cast<float>(std::min(std::max(depth, 0.0), 0.9999999));
  }
};

/// Add a texel's depths of matter at the ends of slices, in steps of so many units of distance at most,
/// which end where the data do.
template <typename T>
void March(const Field& field, const T* values, const Rays& rays,
  const vtkGodRaysShadowGrids::Grid& grid, double i, double j, const double range[2], double most,
  double* depths)
{
  double start[3];
  double change[3];
  rays.Find(grid, i, j, start, change);
  const double length = field.GetLength(change);
  double ends[2] = { range[0], range[1] };
  field.Clip(start, change, ends);
  const double slice = (range[1] - range[0]) / Haze::Slices;
  double sum = 0.0;
  for (int k = 0; k < Haze::Slices; ++k)
  {
    const double first = std::max(range[0] + k * slice, ends[0]);
    const double last = std::min(range[0] + (k + 1) * slice, ends[1]);
    if (last > first)
    {
      const int steps = static_cast<int>(std::ceil((last - first) / most));
      const double step = (last - first) / steps;
      for (int n = 0; n < steps; ++n)
      {
        const double at = first + (n + 0.5) * step;
        const double place[3] = { start[0] + at * change[0], start[1] + at * change[1],
          start[2] + at * change[2] };
        sum += field.GetExtinction(values, place) * step;
      }
    }
    depths[k + 1] += sum * length;
  }
}
}

vtkVolume* vtkGodRaysVolumeHaze::GetVolume(vtkProp* prop)
{
  auto volume = vtkVolume::SafeDownCast(prop);
  auto mapper = volume ? vtkVolumeMapper::SafeDownCast(volume->GetMapper()) : nullptr;
  int ofCells = 0;
  // A vtkMultiVolume has a property of its own, and places several images.
  vtkImageData* image = prop->IsA("vtkMultiVolume") ? nullptr : GetImage(mapper);
  vtkDataArray* scalars = image ? GetScalars(mapper, ofCells) : nullptr;
  vtkVolumeProperty* property = volume ? volume->GetProperty() : nullptr;
  const bool fits = scalars && ofCells < 2 && scalars->GetDataType() != VTK_BIT &&
    scalars->GetNumberOfTuples() ==
      (ofCells ? image->GetNumberOfCells() : image->GetNumberOfPoints()) &&
    property && mapper->GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND &&
    HasScalarOpacityAlone(property);
  return fits ? volume : nullptr;
}

bool vtkGodRaysVolumeHaze::HasScalarOpacityAlone(vtkVolumeProperty* property)
{
  const bool isPlain = property->GetTransferFunctionMode() == vtkVolumeProperty::TF_1D;
  if (!isPlain || !property->HasGradientOpacity(0) || property->GetDisableGradientOpacity(0))
  {
    return isPlain;
  }
  vtkPiecewiseFunction* factors = property->GetGradientOpacity(0);
  bool areOne = factors->GetSize() > 0 && factors->GetClamping() != 0;
  for (int i = 0; i < factors->GetSize(); ++i)
  {
    areOne = areOne && factors->GetDataPointer()[2 * i + 1] == 1.0; // of pairs
  }
  return areOne;
}

void vtkGodRaysVolumeHaze::AddState(
  vtkVolume* volume, std::vector<const void*>& objects, std::vector<double>& numbers)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  objects.insert(objects.end(), { volume, mapper, data });
  for (const vtkMTimeType time :
    { volume->GetMTime(), volume->GetUserTransformMatrixMTime(), mapper->GetMTime(),
      vtkGodRaysVolumeImage::GetTime(data), volume->GetProperty()->GetMTime() })
  {
    numbers.push_back(static_cast<double>(time));
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    objects.push_back(planes->GetItem(i));
    numbers.push_back(static_cast<double>(planes->GetItem(i)->GetMTime()));
  }
}

void vtkGodRaysVolumeHaze::Make(const vtkGodRaysMediumIntegrator::Request& request,
  const std::vector<vtkVolume*>& volumes, const vtkGodRaysShadowGrids& grids, int size, Haze& haze)
{
  Rays rays = { grids, {}, {} };
  std::copy_n(request.Light->Position, 3, rays.Light);
  std::copy_n(request.Light->Direction, 3, rays.Towards);
  double range[2] = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  std::vector<Field> fields;
  double least = VTK_DOUBLE_MAX;
  for (vtkVolume* volume : volumes)
  {
    fields.emplace_back(volume, *request.View);
    least = std::min(least, fields.back().Step);
    const double* bounds = volume->GetBounds();
    for (int i = 0; i < 8; ++i)
    {
      const double world[4] = { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)],
        1.0 };
      double view[4];
      vtkMatrix4x4::MultiplyPoint(request.View->WorldToView, world, view);
      rays.Reach(view, range);
    }
  }
  const bool distributed = request.Compositor && request.Compositor->IsDistributed();
  if (distributed)
  {
    request.Compositor->Reduce(&range[0], 1, vtkGodRaysCompositor::LEAST);
    request.Compositor->Reduce(&range[1], 1, vtkGodRaysCompositor::GREATEST);
  }
  if (grids.Point)
  {
    range[0] = std::max(range[0], grids.Range[0]);
  }
  haze.FaceSize = size;
  haze.Size = (size + Haze::Scale - 1) / Haze::Scale;
  for (int slice = 0; slice <= Haze::Slices; ++slice)
  {
    haze.Depths[slice] = rays.GetDepth(range[0] + (range[1] - range[0]) * slice / Haze::Slices);
  }
  constexpr int values = Haze::Slices + 1;
  haze.Dark.assign(static_cast<std::size_t>(grids.Levels) * haze.Size * haze.Size * values, 1.0f);
  // Two steps a cell, of what is nearest to a point light's axes.
  const double most = std::max(0.5 * least, (range[1] - range[0]) / MostSteps);
  vtkSMPTools::For(0, static_cast<vtkIdType>(grids.Levels) * haze.Size, 4,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const vtkGodRaysShadowGrids::Grid& grid = grids.Grids[row / haze.Size];
        for (int x = 0; x < haze.Size; ++x)
        {
          double depths[values] = {};
          const double i = std::min((x + 0.5) * Haze::Scale, size - 0.5);
          const double j = std::min((row % haze.Size + 0.5) * Haze::Scale, size - 0.5);
          for (const Field& field : fields)
          {
            switch (field.Scalars->GetDataType())
            {
              vtkTemplateMacro(March(field, static_cast<const VTK_TT*>(field.Values), rays, grid, i,
                j, range, most, depths));
            }
          }
          float* through = haze.Dark.data() + (row * haze.Size + x) * values;
          for (int slice = 0; slice < values; ++slice)
          {
            through[slice] = static_cast<float>(std::exp(-depths[slice]));
          }
        }
      }
    });
  if (distributed)
  {
    request.Compositor->Reduce(haze.Dark.data(), haze.Dark.size(), vtkGodRaysCompositor::PRODUCT);
  }
  for (float& value : haze.Dark)
  {
    value = 1.0f - value;
  }
}
