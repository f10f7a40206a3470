// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GodRaysMediumTruth.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace GodRaysTesting
{
namespace
{
using Actors = std::vector<vtkActor*>;

/// What actors show, in the world.
vtkSmartPointer<vtkAppendPolyData> Append(const Actors& actors)
{
  auto all = vtkSmartPointer<vtkAppendPolyData>::New();
  for (vtkActor* actor : actors)
  {
    actor->GetMapper()->Update();
    vtkNew<vtkTransform> toWorld;
    toWorld->SetMatrix(actor->GetMatrix());
    vtkNew<vtkTransformFilter> placed;
    placed->SetInputData(actor->GetMapper()->GetInput());
    placed->SetTransform(toWorld);
    all->AddInputConnection(placed->GetOutputPort());
  }
  return all;
}

/// What it lets through of a colour: see vtkGodRaysLightLayers.
double GetThrough(vtkActor* actor, int channel)
{
  const double* color = actor->GetProperty()->GetColor();
  const double largest = std::max({ color[0], color[1], color[2] });
  const double hue = largest > 0.0 ? color[channel] / largest : 1.0;
  return std::pow(1.0 - actor->GetProperty()->GetOpacity(), 3.0 - 2.0 * hue);
}

/// The light where these actors alone cast shadows, and others alone are seen, if there are such.
vtkSmartPointer<vtkImageData> GetTrueScattering(vtkRenderer* renderer, const SetMedium& setMedium,
  std::array<double, 4> light, const int size[2], const Actors& blocking, const Actors* seen)
{
  auto occluders = Append(blocking);
  vtkNew<vtkGodRaysSingleScatteringReference> truth;
  if (occluders->GetNumberOfInputConnections(0) > 0)
  {
    truth->SetInputConnection(occluders->GetOutputPort());
  }
  if (seen)
  {
    auto ends = Append(*seen);
    vtkNew<vtkPolyData> nothing;
    seen->empty() ? truth->SetInputData(1, nothing)
                  : truth->SetInputConnection(1, ends->GetOutputPort());
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  truth->SetCameraPosition(camera->GetPosition());
  truth->SetCameraFocalPoint(camera->GetFocalPoint());
  truth->SetCameraViewUp(camera->GetViewUp());
  truth->SetViewAngle(camera->GetViewAngle());
  truth->SetParallelProjection(camera->GetParallelProjection());
  truth->SetParallelScale(camera->GetParallelScale());
  truth->SetFarLimit(camera->GetClippingRange()[1]);
  setMedium(truth);
  truth->SetLight(light.data());
  double power = vtkMath::Pi();
  if (light[3] != 0.0)
  {
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    power *= vtkMath::AreBoundsInitialized(bounds) ? 0.25 *
        (std::pow(bounds[1] - bounds[0], 2) + std::pow(bounds[3] - bounds[2], 2) +
          std::pow(bounds[5] - bounds[4], 2))
                                                   : 625.0;
  }
  truth->SetLightColor(power, power, power);
  truth->SetSize(size[0], size[1]);
  truth->SetTolerance(1e-5);
  truth->Update();
  return truth->GetOutput();
}
}

//------------------------------------------------------------------------------
// Light through translucent sheets is, by linearity, the mean of that among opaque and missing ones.
vtkSmartPointer<vtkImageData> GetTrueScattering(
  vtkRenderer* renderer, const SetMedium& setMedium, std::array<double, 4> light, const int size[2])
{
  Actors opaque;
  Actors translucent;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal();
  while (vtkProp* prop = props->GetNextProp())
  {
    auto actor = vtkActor::SafeDownCast(prop);
    if (actor && actor->GetVisibility())
    {
      (actor->GetProperty()->GetOpacity() < 1.0 ? translucent : opaque).push_back(actor);
    }
  }
  if (translucent.empty())
  {
    return GetTrueScattering(renderer, setMedium, light, size, opaque, nullptr);
  }
  vtkSmartPointer<vtkImageData> sum;
  for (unsigned int subset = 0; subset < 1u << translucent.size(); ++subset)
  {
    Actors blocking = opaque;
    double weights[3] = { 1.0, 1.0, 1.0 };
    for (std::size_t i = 0; i < translucent.size(); ++i)
    {
      const bool blocks = (subset >> i & 1u) != 0;
      for (int c = 0; c < 3; ++c)
      {
        const double through = GetThrough(translucent[i], c);
        weights[c] *= blocks ? 1.0 - through : through;
      }
      if (blocks)
      {
        blocking.push_back(translucent[i]);
      }
    }
    auto part = GetTrueScattering(renderer, setMedium, light, size, blocking, &opaque);
    vtkDataArray* values = part->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double before = sum ? sum->GetPointData()->GetScalars()->GetComponent(i, c) : 0.0;
        values->SetComponent(i, c, before + weights[c] * values->GetComponent(i, c));
      }
    }
    sum = part;
  }
  return sum;
}

//------------------------------------------------------------------------------
double GetErrorOfScattering(vtkImageData* truth, vtkImageData* image, std::array<double, 3> tint)
{
  const int* size = image->GetDimensions();
  vtkDataArray* exact = truth->GetPointData()->GetScalars();
  const auto* values = static_cast<const float*>(image->GetScalarPointer());
  double squares = 0.0;
  double peak = 0.0;
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double expected = tint[c] * exact->GetComponent(i, c);
      squares += std::pow(values[3 * i + c] - expected, 2);
      peak = std::max(peak, expected);
    }
  }
  return std::sqrt(squares / (3.0 * size[0] * size[1])) / peak;
}

//------------------------------------------------------------------------------
double GetErrorOfMedium(vtkRenderer* renderer, vtkGodRaysHomogeneousModel* model,
  std::array<double, 4> light, vtkImageData* image, std::array<double, 3> tint)
{
  const auto setMedium = [model](vtkGodRaysSingleScatteringReference* truth)
  {
    truth->SetScatteringCoefficient(model->GetScatteringCoefficient());
    truth->SetAbsorptionCoefficient(model->GetAbsorptionCoefficient());
    truth->SetPhaseFunction(model->GetPhaseFunction());
    truth->SetAsymmetry(model->GetAsymmetry());
    if (model->GetFarLimit() > 0.0)
    {
      truth->SetFarLimit(model->GetFarLimit());
    }
  };
  const auto truth = GetTrueScattering(renderer, setMedium, light, image->GetDimensions());
  return GetErrorOfScattering(truth, image, tint);
}
}
