// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVolumeGrid.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
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

  Table(vtkVolumeProperty* property, vtkDataArray* scalars)
    : Extinction(TableSize)
    , Tint(3 * static_cast<std::size_t>(TableSize))
  {
    scalars->GetFiniteRange(this->Range, 0);
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
  bool Cropped;
  double Crop[6];
  int Flags;
  std::vector<std::array<double, 4>> Planes; // a x + b y + c z + d >= 0 is kept

  Cut(vtkVolumeMapper* mapper, vtkMatrix4x4* toWorld)
    : Cropped(mapper->GetCropping() != 0)
    , Flags(mapper->GetCroppingRegionFlags())
  {
    std::copy_n(mapper->GetCroppingRegionPlanes(), 6, this->Crop);
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
bool Fill(const T* values, vtkImageData* image, const Table& table, const Cut& cut,
  const Vec3& albedo, int bands, std::vector<float>& extinction, std::vector<float>& scattering)
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

/// Why a property or a blend mode tells no medium; empty if it does.
std::string FindFault(vtkVolumeMapper* mapper, vtkVolumeProperty* property)
{
  if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND ||
    property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D ||
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

/// Why an image with these scalars tells no medium; empty if it does.
std::string FindFault(vtkImageData* image, vtkDataArray* scalars, int ofCells)
{
  const int* size = image->GetDimensions();
  if (!scalars || ofCells != 0)
  {
    return "has no scalars at its points. Name an array that is there, or convert data of cells "
           "with "
           "vtkCellDataToPointData";
  }
  if (scalars->GetNumberOfComponents() != 1 || scalars->GetDataType() == VTK_BIT)
  {
    return "has scalars of " + std::to_string(scalars->GetNumberOfComponents()) +
      " components, or of bits. Make an image of one number a point, as by "
      "vtkImageExtractComponents";
  }
  if (size[0] < 2 || size[1] < 2 || size[2] < 2 ||
    scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    return "has " + std::to_string(scalars->GetNumberOfTuples()) + " values at " +
      std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) +
      " points. Give it a value at each of at least 2 points along each axis";
  }
  return static_cast<double>(image->GetNumberOfPoints()) <= vtkGodRaysVolumeGrid::MostPoints
    ? ""
    : "has more than 1024 x 1024 x 1024 points. Take fewer, as by vtkImageResample or "
      "vtkExtractVOI";
}
}

//------------------------------------------------------------------------------
std::string vtkGodRaysVolumeGrid::Read(vtkProp* prop, const Numbers& numbers, vtkGodRaysGrid& grid)
{
  auto volume = vtkVolume::SafeDownCast(prop);
  auto mapper = volume ? vtkVolumeMapper::SafeDownCast(volume->GetMapper()) : nullptr;
  if (!volume || prop->IsA("vtkMultiVolume"))
  {
    return std::string("is a ") + prop->GetClassName() +
      ". Tag each vtkVolume, and give other props another role";
  }
  vtkDataObject* input = mapper && mapper->GetNumberOfInputConnections(0) > 0
    ? mapper->GetInputDataObject(0, 0)
    : nullptr;
  auto image = vtkImageData::SafeDownCast(input);
  if (!image)
  {
    return input
      ? std::string("is a ") + input->GetClassName() +
        ". Make an image of it with vtkResampleToImage"
      : "has no data, or a mapper of other data. Give it a vtkVolumeMapper with an image";
  }
  int ofCells = 0;
  vtkDataArray* scalars = vtkAbstractMapper::GetScalars(image, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), ofCells);
  vtkVolumeProperty* property = volume->GetProperty();
  std::string fault = FindFault(image, scalars, ofCells);
  fault = fault.empty() ? FindFault(mapper, property) : fault;
  if (!fault.empty())
  {
    return fault;
  }

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

  const Table table(property, scalars);
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
    vtkTemplateMacro(finite = Fill(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)), image,
                       table, cut, albedo, bands, extinction, scattering));
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
  return "";
}
