// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSmokeSource.h"

#include "vtkGodRaysMemory.h"
#include "vtkGodRaysProgress.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSmokeSolver.h"
#include "vtkGodRaysSourceTools.h"

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGodRaysSmokeSource);

vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, Spacing, 1e-6, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, TimeStep, 1e-6, 1e3);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, EndTime, 0.0, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, Diffusivity, 0.0, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, RiseSpeed, -1e6, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, SwaySpeed, 0.0, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, SwayPeriod, 1e-3, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, Turbulence, 0.0, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, TurbulenceSize, 1e-6, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, Dissipation, 0.0, 1e3);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, MinimumDensity, 1e-30, 1.0);
vtkGodRaysSetFinite3Macro(vtkGodRaysSmokeSource, SourceCenter, -1e9, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, SourceRadius, 0.0, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, SourceRate, 0.0, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysSmokeSource, SourceDuration, 0.0, 1e6);

namespace
{
constexpr double MostPoints = 268435456.0;
constexpr double MostTimeSteps = 100000.0; // that are listed; a range has no list
}

// The solver, and for which setup it has advanced.
class vtkGodRaysSmokeSource::vtkInternals
{
public:
  static vtkGodRaysSmokeSolver::Parameters GetParameters(const vtkGodRaysSmokeSource* source)
  {
    vtkGodRaysSmokeSolver::Parameters parameters;
    double origin[3];
    source->GetOrigin(origin);
    for (int i = 0; i < 3; ++i)
    {
      parameters.Dimensions[i] = source->Dimensions[i];
      parameters.SourceCenter[i] = source->SourceCenter[i] - origin[i];
    }
    parameters.Spacing = source->Spacing;
    parameters.TimeStep = source->TimeStep;
    parameters.Diffusivity = source->Diffusivity;
    parameters.RiseSpeed = source->RiseSpeed;
    parameters.SwaySpeed = source->SwaySpeed;
    parameters.SwayPeriod = source->SwayPeriod;
    parameters.Turbulence = source->Turbulence;
    parameters.TurbulenceSize = source->TurbulenceSize;
    parameters.Dissipation = source->Dissipation;
    parameters.MinimumDensity = source->MinimumDensity;
    parameters.SourceRadius = source->SourceRadius;
    parameters.SourceRate = source->SourceRate;
    parameters.SourceDuration = source->SourceDuration;
    parameters.ClosedBoundaries = source->ClosedBoundaries;
    parameters.Seed = static_cast<unsigned int>(source->Seed);
    return parameters;
  }

  // Begins again where the solver cannot go on to the step.
  void Prepare(vtkGodRaysSmokeSource* source, vtkIdType step)
  {
    if (this->SetupTime != source->GetMTime() || this->Solver.GetStep() > step)
    {
      this->Solver.Start(GetParameters(source));
      this->SetupTime = source->GetMTime();
    }
  }

  // Returns false if it was told to stop.
  bool Advance(vtkGodRaysSmokeSource* source, vtkIdType step)
  {
    const vtkIdType first = this->Solver.GetStep();
    while (this->Solver.GetStep() < step)
    {
      const auto done = static_cast<double>(this->Solver.GetStep() - first);
      if (!vtkGodRays::TellProgress(source, done / (step - first)))
      {
        return false;
      }
      this->Solver.Advance();
    }
    return vtkGodRays::TellProgress(source, 1.0);
  }

  vtkGodRaysSmokeSolver Solver;

private:
  vtkMTimeType SetupTime = 0;
};

vtkGodRaysSmokeSource::vtkGodRaysSmokeSource()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(0);
}

vtkGodRaysSmokeSource::~vtkGodRaysSmokeSource() = default;

void vtkGodRaysSmokeSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " "
     << this->Dimensions[2] << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "EndTime: " << this->EndTime << "\n";
  os << indent << "Diffusivity: " << this->Diffusivity << "\n";
  os << indent << "RiseSpeed: " << this->RiseSpeed << "\n";
  os << indent << "SwaySpeed: " << this->SwaySpeed << "\n";
  os << indent << "SwayPeriod: " << this->SwayPeriod << "\n";
  os << indent << "Turbulence: " << this->Turbulence << "\n";
  os << indent << "TurbulenceSize: " << this->TurbulenceSize << "\n";
  os << indent << "Dissipation: " << this->Dissipation << "\n";
  os << indent << "MinimumDensity: " << this->MinimumDensity << "\n";
  os << indent << "SourceCenter: " << this->SourceCenter[0] << " " << this->SourceCenter[1] << " "
     << this->SourceCenter[2] << "\n";
  os << indent << "SourceRadius: " << this->SourceRadius << "\n";
  os << indent << "SourceRate: " << this->SourceRate << "\n";
  os << indent << "SourceDuration: " << this->SourceDuration << "\n";
  os << indent << "ClosedBoundaries: " << this->ClosedBoundaries << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}

void vtkGodRaysSmokeSource::SetDimensions(int x, int y, int z)
{
  int dimensions[3] = { x, y, z };
  for (int& dimension : dimensions)
  {
    dimension = vtkMath::ClampValue(dimension, 1, 1024);
  }
  if (!std::equal(dimensions, dimensions + 3, this->Dimensions))
  {
    std::copy_n(dimensions, 3, this->Dimensions);
    this->Modified();
  }
}

double vtkGodRaysSmokeSource::GetLargestTimeStep() const
{
  return vtkGodRaysSmokeSolver::GetLargestTimeStep(vtkInternals::GetParameters(this));
}

void vtkGodRaysSmokeSource::GetOrigin(double origin[3]) const
{
  origin[0] = -0.5 * (this->Dimensions[0] - 1) * this->Spacing;
  origin[1] = -0.5 * (this->Dimensions[1] - 1) * this->Spacing;
  origin[2] = 0.0;
}

std::string vtkGodRaysSmokeSource::FindFault() const
{
  std::ostringstream fault;
  const double points =
    static_cast<double>(this->Dimensions[0]) * this->Dimensions[1] * this->Dimensions[2];
  if (points > MostPoints)
  {
    fault << "Dimensions " << this->Dimensions[0] << " " << this->Dimensions[1] << " "
          << this->Dimensions[2] << " are more than " << MostPoints << " points. Take fewer.";
  }
  else if (constexpr double bytes = 36.0; // of a point: two densities, six shares, the output
           !vtkGodRays::FindMemoryFault(bytes * points, "").empty())
  {
    fault << vtkGodRays::FindMemoryFault(bytes * points, "Dimensions");
  }
  else if (this->TimeStep > this->GetLargestTimeStep())
  {
    fault << "in a TimeStep of " << this->TimeStep
          << " s cells would give more smoke than they have. Take " << this->GetLargestTimeStep()
          << " s at most, a larger Spacing, or lower speeds and Diffusivity.";
  }
  return fault.str();
}

int vtkGodRaysSmokeSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* information = output->GetInformationObject(0);
  double origin[3];
  this->GetOrigin(origin);
  const double spacing[3] = { this->Spacing, this->Spacing, this->Spacing };
  const int extent[6] = { 0, this->Dimensions[0] - 1, 0, this->Dimensions[1] - 1, 0,
    this->Dimensions[2] - 1 };
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  information->Set(vtkDataObject::ORIGIN(), origin, 3);
  information->Set(vtkDataObject::SPACING(), spacing, 3);
  information->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);

  vtkGodRaysSourceTools::SetTimeRange(information, this->EndTime);
  const double steps = std::floor(this->EndTime / this->TimeStep + 1e-9);
  if (steps <= MostTimeSteps)
  {
    std::vector<double> times(static_cast<std::size_t>(steps) + 1);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      times[i] = i * this->TimeStep;
    }
    information->Set(
      vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  }
  else
  {
    information->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  }
  return 1;
}

int vtkGodRaysSmokeSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* information = output->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(output);
  const std::string fault = this->FindFault();
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute smoke: " << fault);
    image->Initialize();
    return 1; // the executive would only add that something failed
  }

  // A multiple of the time step may lie a rounding error below itself.
  const double time = vtkGodRaysSourceTools::GetTime(information, this->EndTime);
  const auto step = static_cast<vtkIdType>(std::floor(time / this->TimeStep + 1e-6));
  this->Internals->Prepare(this, step);
  const vtkGodRaysSmokeSolver& solver = this->Internals->Solver;
  if (!solver.HasSource())
  {
    vtkErrorMacro("Cannot compute smoke: no point of the box lies within the source. Move "
                  "SourceCenter into the box, or enlarge SourceRadius.");
    image->Initialize();
    return 1;
  }
  if (!this->Internals->Advance(this, step))
  {
    image->Initialize();
    return 1;
  }

  int extent[6];
  information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  double origin[3];
  this->GetOrigin(origin);
  image->SetExtent(extent);
  image->SetOrigin(origin);
  image->SetSpacing(this->Spacing, this->Spacing, this->Spacing);
  vtkNew<vtkFloatArray> density;
  density->SetName("Density");
  density->SetNumberOfTuples(image->GetNumberOfPoints());
  const vtkIdType width = extent[1] - extent[0] + 1;
  const vtkIdType height = extent[3] - extent[2] + 1;
  vtkSMPTools::For(0, density->GetNumberOfTuples() / width,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const vtkIdType y = extent[2] + row % height;
        const vtkIdType z = extent[4] + row / height;
        const float* from = solver.GetDensity().data() +
          (z * this->Dimensions[1] + y) * this->Dimensions[0] + extent[0];
        std::copy_n(from, width, density->GetPointer(row * width));
      }
    });
  image->GetPointData()->SetScalars(density);
  image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step * this->TimeStep);
  return 1;
}
