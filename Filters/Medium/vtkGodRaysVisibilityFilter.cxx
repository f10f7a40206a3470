// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVisibilityFilter.h"

#include "vtkBoundingBox.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysSetGet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkGodRaysVisibilityFilter);

vtkGodRaysSetFiniteMacro(vtkGodRaysVisibilityFilter, WorldUnitInMeters, 1e-12, 1e12);
vtkGodRaysSetFiniteMacro(vtkGodRaysVisibilityFilter, InherentContrast, 0.0, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysVisibilityFilter, ContrastThreshold, 1e-6, 0.999);

namespace
{
using vtkGodRays::Vec3;

// Bounds that Testing/Filters/TestGodRaysVisibilityFilter.cxx holds.
constexpr double PlaneError = 1e-9; // of an optical depth, relative; of a planet, next
constexpr double PlanetError = 1e-4;
constexpr double Nearness = 1e-6; // of the size of everything: nearer, nothing is in the way

Vec3 ToVector(const double* v)
{
  return { v[0], v[1], v[2] };
}

// An array of the output, and its error in the field data.
template <typename Array>
vtkSmartPointer<Array> AddArray(
  vtkPointSet* data, const char* name, int components, const char* unit)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
  data->GetPointData()->AddArray(array);
  return array;
}

void AddError(vtkPointSet* data, const char* name, double error, const char* of)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName((std::string(name) + "_Error").c_str());
  array->InsertNextValue(error);
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), of);
  data->GetFieldData()->AddArray(array);
}

// Why points cannot be computed with, and what to do; empty if they can.
std::string FindFaultOfPoints(vtkPointSet* data, const std::string& what)
{
  const vtkIdType count = data ? data->GetNumberOfPoints() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    if (!(vtkMath::Norm(point) <= 1e15)) // false for NaN
    {
      return what + " " + std::to_string(i) +
        " is not finite. Take it out of the input, or move it to within 1e15.";
    }
  }
  return {};
}

// What is between two points, both sides.
class Occluders
{
public:
  explicit Occluders(vtkPolyData* data)
  {
    if (data && data->GetNumberOfCells() > 0)
    {
      data->GetBounds(this->Bounds);
      this->Locator = vtkSmartPointer<vtkStaticCellLocator>::New();
      this->Locator->SetDataSet(data);
      this->Locator->BuildLocator();
    }
  }

  const double* GetBounds() const { return this->Locator ? this->Bounds : nullptr; }

  // Whether anything is between a and b, farther than gap from both.
  bool Block(const Vec3& a, const Vec3& b, double gap, vtkGenericCell* cell) const
  {
    const double length = vtkGodRays::length(b - a);
    if (!this->Locator || !(length > 2.0 * gap))
    {
      return false;
    }
    const Vec3 step = (b - a) * (gap / length);
    const Vec3 from = a + step;
    const Vec3 to = b - step;
    double t;
    double place[3];
    double parameters[3];
    int part;
    vtkIdType id;
    return this->Locator->IntersectWithLine(
             &from[0], &to[0], 1e-3 * gap, t, place, parameters, part, id, cell) != 0;
  }

private:
  vtkSmartPointer<vtkStaticCellLocator> Locator;
  double Bounds[6];
};
}

class vtkGodRaysVisibilityFilter::vtkInternals
{
public:
  vtkInternals(const vtkGodRaysVisibilityFilter* self, vtkPointSet* targets, vtkPolyData* occluders)
    : Self(self)
    , Blockers(occluders)
  {
    // The world's axes, from the observer; forwards is that of the filter's default.
    View view{};
    view.Right[0] = 1.0;
    view.Up[1] = 1.0;
    view.Forward[2] = -1.0;
    std::copy_n(self->CameraPosition, 3, view.Position);
    const vtkGodRaysMedium medium = self->GetMedium(view);
    const vtkGodRaysSpot spot = self->GetSpot(view);
    const auto toWorld = [](const double* v) { return Vec3(v[0], v[1], -v[2]); };
    this->Observer = ToVector(self->CameraPosition);
    this->Upwards = toWorld(medium.Up);
    this->EyeHeight = medium.EyeHeight;
    this->PlanetRadius = medium.PlanetRadius;
    for (int c = 0; c < 3; ++c)
    {
      for (int k = 0; k < 2; ++k)
      {
        const bool has = k < medium.NumberOfComponents;
        const vtkGodRaysMedium::Component part =
          has ? medium.Components[k] : vtkGodRaysMedium::Component();
        this->Components[c][k] = { part.Scattering[c], part.Scattering[c] + part.Absorption[c],
          part.ScaleHeight, { part.PhaseFunction, part.Asymmetry },
          { part.SecondPhaseFunction, part.SecondAsymmetry }, part.SecondWeight };
      }
    }
    this->Infinite = self->Light[3] == 0.0;
    this->Light = ToVector(self->Light);
    this->Light = this->Light / (this->Infinite ? vtkGodRays::length(this->Light) : self->Light[3]);
    this->SpotAxis = toWorld(spot.Axis);
    this->Spot = spot;
    for (int c = 0; c < 3; ++c)
    {
      this->LightColor[c] = self->LightColor[c];
    }

    vtkBoundingBox box(targets->GetBounds());
    box.AddPoint(this->Observer.x, this->Observer.y, this->Observer.z);
    if (const double* bounds = this->Blockers.GetBounds())
    {
      box.AddBounds(bounds);
    }
    this->Size = box.GetDiagonalLength();
    double center[3];
    box.GetCenter(center);
    // A coordinate of single precision is no better than this.
    this->Gap = Nearness * (this->Size + vtkMath::Norm(center));
  }

  // What the way to a target leaves.
  struct Sight
  {
    double Distance;
    double Depth[3]; // optical
    bool IsHidden;
  };

  Sight Look(const Vec3& target, vtkGenericCell* cell) const
  {
    Sight sight;
    const Vec3 way = target - this->Observer;
    sight.Distance = vtkGodRays::length(way);
    const Vec3 direction = sight.Distance > 0.0 ? way / sight.Distance : this->Upwards;
    const double slope = vtkGodRays::clamp(vtkGodRays::dot(direction, this->Upwards), -1.0, 1.0);
    for (int c = 0; c < 3; ++c)
    {
      sight.Depth[c] = vtkGodRays::WayDepth(this->Components[c][0], this->Components[c][1],
        this->PlanetRadius, this->EyeHeight, slope, sight.Distance);
    }
    sight.IsHidden = this->Blockers.Block(this->Observer, target, this->Gap, cell);
    if (this->PlanetRadius > 0.0)
    {
      const double ground =
        vtkGodRays::SkyGroundDistance(this->PlanetRadius, this->EyeHeight, slope);
      sight.IsHidden = sight.IsHidden || (ground >= 0.0 && ground < sight.Distance - this->Gap);
    }
    return sight;
  }

  // What is left of the light at a target [unit of LightColor, or, of a point light, over m^2].
  Vec3 GetIrradiance(const Vec3& target, vtkGenericCell* cell) const
  {
    Vec3 irradiance(0.0);
    const Vec3 way = this->Infinite ? this->Light : this->Light - target;
    const double r = this->Infinite ? 1.0 : vtkGodRays::length(way);
    if ((!this->Infinite && !(r > this->Gap)) || this->IsInShadow(target, cell))
    {
      return irradiance;
    }
    const auto start = [this](const Vec3& place, const Vec3& toward)
    {
      return vtkGodRays::MediumStart(
        this->PlanetRadius, this->EyeHeight, this->Upwards, place - this->Observer, toward);
    };
    const auto here = start(target, way / r);
    vtkGodRays::LitRay ray{};
    ray.Infinite = this->Infinite ? 1 : 0;
    ray.Height = here.x;
    ray.Slope = here.y;
    ray.LightHeight = this->Infinite ? here.y : start(this->Light, way / r).x;
    ray.PlanetRadius = this->PlanetRadius;
    ray.AxisStart = this->Infinite ? 0.0 : -vtkGodRays::dot(this->SpotAxis, way);
    this->Spot.SetShape(ray);
    double factor = 1.0;
    if (!this->Infinite)
    {
      if (!vtkGodRays::IsInSpot(ray, 0.0, r))
      {
        return irradiance;
      }
      const double meters = r * this->Self->WorldUnitInMeters;
      factor = vtkGodRays::SpotFactor(ray, 0.0, r) / (meters * meters);
    }
    for (int c = 0; c < 3; ++c)
    {
      irradiance[c] = factor * this->LightColor[c] *
        vtkGodRays::LightTransmittance(this->Components[c][0], this->Components[c][1], ray, r);
    }
    return irradiance;
  }

private:
  bool IsInShadow(const Vec3& target, vtkGenericCell* cell) const
  {
    const Vec3 end =
      this->Infinite ? target + (2.0 * (this->Size + this->Gap)) * this->Light : this->Light;
    return this->Blockers.Block(target, end, this->Gap, cell);
  }

  const vtkGodRaysVisibilityFilter* Self;
  Occluders Blockers;
  Vec3 Observer;
  Vec3 Upwards; // at the observer
  double EyeHeight;
  double PlanetRadius;
  vtkGodRays::MediumComponent Components[3][2]; // of colours
  bool Infinite;
  Vec3 Light; // position, or direction of length 1
  Vec3 SpotAxis;
  vtkGodRaysSpot Spot;
  double LightColor[3];
  double Size; // of everything
  double Gap;
};

vtkGodRaysVisibilityFilter::vtkGodRaysVisibilityFilter()
{
  this->SetNumberOfInputPorts(2);
}

void vtkGodRaysVisibilityFilter::SetOccludersData(vtkPolyData* occluders)
{
  this->SetInputDataInternal(1, occluders);
}

vtkPointSet* vtkGodRaysVisibilityFilter::GetOutput()
{
  return vtkPointSet::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkGodRaysVisibilityFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkGodRaysVisibilityFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPointSet");
  return 1;
}

// The output is of the input's class, which is not that of an image filter.
vtkTypeBool vtkGodRaysVisibilityFilter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, input, output);
  }
  vtkPointSet* targets = vtkPointSet::GetData(input[0]);
  vtkInformation* info = output->GetInformationObject(0);
  vtkDataObject* made = info->Get(vtkDataObject::DATA_OBJECT());
  if (targets && (!made || !made->IsA(targets->GetClassName())))
  {
    const auto result = vtk::TakeSmartPointer(targets->NewInstance());
    info->Set(vtkDataObject::DATA_OBJECT(), result);
  }
  return targets ? 1 : 0;
}

int vtkGodRaysVisibilityFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1;
}

int vtkGodRaysVisibilityFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // all of both
}

std::string vtkGodRaysVisibilityFilter::FindFaultOfAll() const
{
  if (!(std::abs(this->CameraPosition[0]) <= 1e15 && std::abs(this->CameraPosition[1]) <= 1e15 &&
        std::abs(this->CameraPosition[2]) <= 1e15)) // false for NaN
  {
    return "the observer is not finite. Set CameraPosition to numbers within 1e15.";
  }
  return this->FindMediumFault();
}

int vtkGodRaysVisibilityFilter::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkPointSet* targets = vtkPointSet::GetData(input[0]);
  vtkPointSet* result = vtkPointSet::GetData(output);
  std::string fault = this->FindFaultOfAll();
  const vtkIdType count = targets->GetNumberOfPoints();
  vtkPolyData* occluders =
    input[1]->GetNumberOfInformationObjects() > 0 ? vtkPolyData::GetData(input[1]) : nullptr;
  fault = fault.empty() ? FindFaultOfPoints(targets, "point") : fault;
  fault = fault.empty() ? FindFaultOfPoints(occluders, "point of the occluders") : fault;
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute what is seen: " << fault);
    result->Initialize();
    return 1; // the executive would only add that something failed
  }
  result->ShallowCopy(targets);

  const bool isPlanet = this->PlanetRadius > 0.0;
  const double error = isPlanet ? PlanetError : PlaneError;
  const auto distances = AddArray<vtkDoubleArray>(result, "Distance_m", 1, "m");
  const auto depths = AddArray<vtkDoubleArray>(result, "OpticalDepth", 3, "1");
  const auto transmittances = AddArray<vtkDoubleArray>(result, "Transmittance", 3, "1");
  const auto contrasts = AddArray<vtkDoubleArray>(result, "Contrast", 1, "1");
  const auto ranges = AddArray<vtkDoubleArray>(result, "MeteorologicalRange_m", 1, "m");
  const auto hidden = AddArray<vtkUnsignedCharArray>(result, "Hidden", 1, "1");
  const auto visible = AddArray<vtkUnsignedCharArray>(result, "Visible", 1, "1");
  vtkSmartPointer<vtkDoubleArray> irradiances;
  AddError(result, "Distance_m", PlaneError, "fraction of the distance");
  AddError(result, "OpticalDepth", error, "fraction of the optical depth");
  AddError(result, "Transmittance", error * std::exp(-1.0), "1"); // the most of tau e^-tau
  AddError(result, "MeteorologicalRange_m", error, "fraction of the range");
  if (this->ComputeIrradiance)
  {
    irradiances = AddArray<vtkDoubleArray>(result, "Irradiance", 3, "W m-2");
    AddError(
      result, "Irradiance", error * std::exp(-1.0), "fraction of the irradiance without a medium");
  }
  AddError(result, "Contrast", this->InherentContrast * error * std::exp(-1.0), "1");

  const vtkInternals ways(this, targets, occluders);
  vtkSMPThreadLocalObject<vtkGenericCell> cells;
  const auto evaluate = [&](vtkIdType i, vtkGenericCell* cell)
  {
    double point[3];
    targets->GetPoint(i, point);
    const auto sight = ways.Look(ToVector(point), cell);
    distances->SetValue(i, sight.Distance * this->WorldUnitInMeters);
    depths->SetTypedTuple(i, sight.Depth);
    for (int c = 0; c < 3; ++c)
    {
      transmittances->SetTypedComponent(i, c, std::exp(-sight.Depth[c]));
    }
    constexpr int green = 1;
    const double contrast =
      vtkGodRays::KoschmiederContrast(this->InherentContrast, sight.Depth[green]);
    contrasts->SetValue(i, contrast);
    ranges->SetValue(i,
      sight.Depth[green] > 0.0 ? vtkGodRays::MeteorologicalRange(this->ContrastThreshold,
                                   sight.Depth[green], sight.Distance * this->WorldUnitInMeters)
                               : vtkMath::Inf());
    hidden->SetValue(i, sight.IsHidden ? 1 : 0);
    visible->SetValue(i, !sight.IsHidden && contrast >= this->ContrastThreshold ? 1 : 0);
    if (irradiances)
    {
      const Vec3 irradiance = ways.GetIrradiance(ToVector(point), cell);
      irradiances->SetTypedTuple(i, &irradiance[0]);
    }
  };
  constexpr int steps = 20;
  for (int step = 0; step < steps; ++step)
  {
    vtkSMPTools::For(count * step / steps, count * (step + 1) / steps,
      [&](vtkIdType begin, vtkIdType end)
      {
        vtkGenericCell* cell = cells.Local();
        for (vtkIdType i = begin; i < end; ++i)
        {
          evaluate(i, cell);
        }
      });
    if (!this->TellProgress((step + 1.0) / steps))
    {
      result->Initialize();
      return 1;
    }
  }
  return 1;
}

void vtkGodRaysVisibilityFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WorldUnitInMeters: " << this->WorldUnitInMeters << "\n";
  os << indent << "InherentContrast: " << this->InherentContrast << "\n";
  os << indent << "ContrastThreshold: " << this->ContrastThreshold << "\n";
  os << indent << "ComputeIrradiance: " << (this->ComputeIrradiance ? "on" : "off") << "\n";
}
