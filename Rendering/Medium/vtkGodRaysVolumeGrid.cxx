// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVolumeGrid.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkGodRaysGridBlocks.h"
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
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace
{
using vtkGodRays::Vec3;

constexpr int TableSize = 4096;

/// What transfer functions make of values from Range[0] to Range[1], evenly.
struct Table
{
  double Range[2] = { 0.0, 1.0 };
  std::vector<float> Extinction; // [1/scene unit]
  std::vector<float> Tint;       // red, green and blue of linear light
  bool Even = true;              // all tints are alike
  bool Grey = true;              // each has equal channels

  Table(vtkVolumeProperty* property, vtkDataArray* scalars, const char* mask)
    : Extinction(TableSize)
    , Tint(3 * static_cast<std::size_t>(TableSize))
  {
    if (mask)
    {
      this->FindRange(scalars, mask);
    }
    else
    {
      scalars->GetFiniteRange(this->Range, 0);
    }
    if (!(this->Range[1] > this->Range[0]))
    {
      this->Range[1] = this->Range[0] + 1.0;
    }
    std::vector<double> opacities(TableSize);
    property->GetScalarOpacity(0)->GetTable(
      this->Range[0], this->Range[1], TableSize, opacities.data());
    std::vector<double> colors(this->Tint.size());
    if (property->GetColorChannels(0) == 3)
    {
      property->GetRGBTransferFunction(0)->GetTable(
        this->Range[0], this->Range[1], TableSize, colors.data());
    }
    else
    {
      std::vector<double> greys(TableSize);
      property->GetGrayTransferFunction(0)->GetTable(
        this->Range[0], this->Range[1], TableSize, greys.data());
      for (std::size_t i = 0; i < colors.size(); ++i)
      {
        colors[i] = greys[i / 3];
      }
    }
    const double unit = property->GetScalarOpacityUnitDistance(0);
    for (int i = 0; i < TableSize; ++i)
    {
      this->Extinction[i] = static_cast<float>(
        vtkGodRays::OpacityExtinction(vtkMath::ClampValue(opacities[i], 0.0, 1.0), unit));
      float* tint = this->Tint.data() + 3 * i;
      for (int c = 0; c < 3; ++c)
      {
        tint[c] = static_cast<float>(
          vtkGodRays::DecodeDisplay(vtkMath::ClampValue(colors[3 * i + c], 0.0, 1.0)));
        this->Even = this->Even && tint[c] == this->Tint[c];
      }
      this->Grey = this->Grey && tint[0] == tint[1] && tint[1] == tint[2];
    }
  }

  /// The range of values that are in the data: outside of a grid they are 0.
  void FindRange(vtkDataArray* scalars, const char* mask)
  {
    bool known = false;
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      const double value = mask[i] ? scalars->GetComponent(i, 0) : vtkMath::Nan();
      if (std::isfinite(value))
      {
        this->Range[0] = known ? std::min(this->Range[0], value) : value;
        this->Range[1] = known ? std::max(this->Range[1], value) : value;
        known = true;
      }
    }
  }

  /// Between which entries a finite value is, and how far beyond the first.
  void Find(double value, int& low, float& part) const
  {
    const double at =
      (value - this->Range[0]) / (this->Range[1] - this->Range[0]) * (TableSize - 1);
    const double inside = at > 0.0 ? std::min(at, TableSize - 1.0) : 0.0; // also of NaN
    low = std::min(static_cast<int>(inside), TableSize - 2);
    part = static_cast<float>(inside - low);
  }
};

/// What cropping and clipping planes cut off of a volume, in coordinates of its data.
struct Cut
{
  bool Cropped = false;
  double Crop[6] = {};
  int Flags = 0;
  std::vector<std::array<double, 4>> Planes; // a x + b y + c z + d >= 0 is kept

  Cut(vtkAbstractVolumeMapper* mapper, vtkMatrix4x4* toWorld)
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

  bool IsNone() const { return !this->Cropped && this->Planes.empty(); }

  bool Takes(const double place[3]) const
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
};

/// Fill extinction, and scattering of so many bands, if any. False if a value is not finite.
template <typename T>
bool Fill(const T* values, const char* mask, vtkImageData* image, const Table& table,
  const Cut& cut, const Vec3& albedo, int bands, std::vector<float>& extinction,
  std::vector<float>& scattering)
{
  const int* extent = image->GetExtent();
  const int* size = image->GetDimensions();
  const vtkIdType slice = static_cast<vtkIdType>(size[0]) * size[1];
  const bool isCut = !cut.IsNone();
  std::atomic<bool> finite(true);
  vtkSMPTools::For(0, size[2],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin * slice; i < end * slice; ++i)
      {
        if (mask && !mask[i])
        {
          continue; // outside of the grid
        }
        const auto value = static_cast<double>(values[i]);
        if (!std::isfinite(value))
        {
          finite = false;
          return;
        }
        if (isCut)
        {
          const int at[3] = { extent[0] + static_cast<int>(i % size[0]),
            extent[2] + static_cast<int>(i / size[0] % size[1]),
            extent[4] + static_cast<int>(i / slice) };
          double place[3];
          image->TransformIndexToPhysicalPoint(at, place);
          if (cut.Takes(place))
          {
            continue;
          }
        }
        int low;
        float part;
        table.Find(value, low, part);
        const float* known = table.Extinction.data() + low;
        extinction[i] = known[0] + part * (known[1] - known[0]);
        for (int c = 0; c < bands; ++c)
        {
          const float* tint = table.Tint.data() + 3 * static_cast<std::size_t>(low) + c;
          scattering[bands * i + c] =
            static_cast<float>(albedo[c]) * extinction[i] * (tint[0] + part * (tint[3] - tint[0]));
        }
      }
    });
  return finite;
}

/// The pointer to what a shared vector holds.
const float* Own(std::vector<float>&& values, std::shared_ptr<const void>& owner)
{
  auto kept = std::make_shared<std::vector<float>>(std::move(values));
  owner = kept;
  return kept->data();
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
  if (!IsComposite(mapper) || property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D ||
    (property->HasGradientOpacity(0) && !property->GetDisableGradientOpacity(0)))
  {
    return "has gradient opacity, a 2-D transfer function or another blend mode than composite. "
           "Give it "
           "a scalar opacity alone";
  }
  const double unit = property->GetScalarOpacityUnitDistance(0);
  return unit > 1e-30 && std::isfinite(unit)
    ? ""
    : "has a ScalarOpacityUnitDistance that is not above 0. Set it to the length on which its "
      "opacity is taken";
}

/// How far what a grid tells is from what the data are, where these are known. They may be outside of the
/// range of the image's values, for which there is a table.
vtkGodRaysVolumeGrid::Error FindError(const std::vector<vtkGodRaysVolumeImage::Sample>& samples,
  vtkImageData* image, vtkVolumeProperty* property, const Cut& cut, const vtkGodRaysGrid& grid)
{
  vtkPiecewiseFunction* opacities = property->GetScalarOpacity(0);
  const double unit = property->GetScalarOpacityUnitDistance(0);
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
    const double known = vtkGodRays::OpacityExtinction(opacity, unit);
    const double told =
      vtkGodRaysGridPlace(grid, Vec3(place[0], place[1], place[2])).Read(grid.Extinction, 1, 0);
    peak = std::max(peak, known);
    squares += (told - known) * (told - known);
    error.Largest = std::max(error.Largest, std::abs(told - known));
    ++count;
  }
  if (peak > 0.0)
  {
    error.Mean = std::sqrt(squares / static_cast<double>(count)) / peak;
    error.Largest /= peak;
    error.Whole = peak * grid.Scale;
  }
  return error;
}
}

//------------------------------------------------------------------------------
std::string vtkGodRaysVolumeGrid::Read(vtkProp* prop, const Numbers& numbers,
  vtkGodRaysVolumeImage& data, vtkGodRaysGrid& grid, Error& error)
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
  fault = fault.empty() ? data.Update(mapper, numbers.Resolution) : fault;
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

  const Table table(property, scalars, data.GetMask());
  const Cut cut(mapper, volume->GetMatrix());
  const Vec3 albedo(numbers.Albedo[0], numbers.Albedo[1], numbers.Albedo[2]);
  const bool alike = albedo.x == albedo.y && albedo.y == albedo.z;
  const int bands = table.Even ? 0 : table.Grey && alike ? 1 : 3;
  const auto count = static_cast<std::size_t>(image->GetNumberOfPoints());
  std::vector<float> extinction(count, 0.0f);
  std::vector<float> scattering(bands * count, 0.0f);
  bool finite = true;
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(finite = Fill(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)),
                       data.GetMask(), image, table, cut, albedo, bands, extinction, scattering));
  }
  if (!finite)
  {
    return "has values that are not finite. Replace them with numbers";
  }
  grid.Extinction = Own(std::move(extinction), grid.Owners[0]);
  grid.ScatteringBands = bands;
  grid.Scattering = bands > 0 ? Own(std::move(scattering), grid.Owners[1]) : nullptr;
  grid.Scale = numbers.Scale;
  for (int c = 0; c < 3; ++c)
  {
    grid.Albedo[c] = albedo[c] * table.Tint[c];
  }
  grid.PhaseFunction = numbers.PhaseFunction;
  grid.Asymmetry = numbers.Asymmetry;
  error = FindError(data.GetSamples(), image, property, cut, grid);
  return "";
}
