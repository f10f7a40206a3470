// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVolumeHaze.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkDataArray.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysVolumeGrid.h"
#include "vtkGodRaysVolumeImage.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkSMPTools.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
using Haze = vtkGodRaysShadowLayers::Haze;
using vtkGodRays::Vec3;

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

/// Transforms a place (w = 1) or a direction (w = 0).
Vec3 Transform(const double matrix[16], const Vec3& v, double w)
{
  const double in[4] = { v.x, v.y, v.z, w };
  double out[4];
  vtkMatrix4x4::MultiplyPoint(matrix, in, out);
  return Vec3(out[0], out[1], out[2]);
}

/// A volume in numbers.
struct Field
{
  vtkGodRaysGrid Grid; // in the world
  vtkGodRaysVolumeGrid::Cut Cut;
  double ToData[16]; // from there
  double Scale;      // of lengths, by the volume's matrix

  Field(vtkVolume* volume, vtkGodRaysGrid&& grid)
    : Grid(std::move(grid))
    , Cut(volume->GetMapper(), volume->GetMatrix())
    , Scale(vtkGodRaysVolumeGrid::GetScale(volume))
  {
    vtkMatrix4x4::Invert(volume->GetMatrix()->GetData(), this->ToData);
  }

  /// Adds the optical depths of a line, start + s change, from the first to the ends of slices. VTK's mappers
  /// count lengths in the data's coordinates.
  void AddDepths(const Vec3& start, const Vec3& change, const double range[2], double* depths) const
  {
    const Vec3 from = Transform(this->ToData, start, 1.0);
    const Vec3 along = Transform(this->ToData, change, 0.0);
    const double length = this->Scale * vtkGodRays::length(along);
    const Vec3 place = this->Grid.GetPlace(start);
    const Vec3 steps = this->Grid.GetSteps(change);
    double ends[2] = { range[0], range[1] };
    if (!this->Grid.Clip(place, steps, ends[0], ends[1]))
    {
      return;
    }
    const auto parts = this->Cut.GetParts(from, along, ends[0], ends[1]);
    const double slice = (range[1] - range[0]) / Haze::Slices;
    Vec3 sum(0.0);
    for (int k = 0; k < Haze::Slices; ++k)
    {
      for (const auto& part : parts)
      {
        this->Grid.AddDepth(place, steps, std::max(range[0] + k * slice, part[0]),
          std::min(range[0] + (k + 1) * slice, part[1]), sum);
      }
      depths[k + 1] += sum.x * length;
    }
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
  void Find(
    const vtkGodRaysShadowGrids::Grid& grid, double i, double j, Vec3& start, Vec3& change) const
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
    (ofCells == 0 || scalars->GetNumberOfComponents() == 1) && image->GetDataDimension() == 3 &&
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

int vtkGodRaysVolumeHaze::Make(const vtkGodRaysMediumIntegrator::Request& request,
  const std::vector<vtkVolume*>& volumes, const vtkGodRaysShadowGrids& grids, int size, Haze& haze)
{
  Rays rays = { grids, {}, {} };
  std::copy_n(request.Light->Position, 3, rays.Light);
  std::copy_n(request.Light->Direction, 3, rays.Towards);
  double range[2] = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  std::vector<Field> fields;
  int leftOut = 0;
  double toWorld[16];
  vtkMatrix4x4::Invert(request.View->WorldToView, toWorld);
  for (vtkVolume* volume : volumes)
  {
    vtkGodRaysVolumeImage image;
    vtkGodRaysVolumeGrid::Error unused;
    vtkGodRaysGrid grid;
    if (!vtkGodRaysVolumeGrid::Read(volume, {}, image, grid, unused, true).empty())
    {
      ++leftOut;
      continue;
    }
    fields.emplace_back(volume, std::move(grid));
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
          Vec3 start;
          Vec3 change;
          rays.Find(grid, i, j, start, change);
          start = Transform(toWorld, start, 1.0);
          change = Transform(toWorld, change, 0.0);
          for (const Field& field : fields)
          {
            field.AddDepths(start, change, range, depths);
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
  return leftOut;
}
