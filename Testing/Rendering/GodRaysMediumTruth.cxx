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
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>
#include <cmath>

namespace GodRaysTesting
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> GetTrueScattering(
  vtkRenderer* renderer, const SetMedium& setMedium, std::array<double, 4> light, const int size[2])
{
  vtkNew<vtkAppendPolyData> occluders;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal();
  while (vtkProp* prop = props->GetNextProp())
  {
    auto actor = vtkActor::SafeDownCast(prop);
    if (actor && actor->GetVisibility())
    {
      actor->GetMapper()->Update();
      vtkNew<vtkTransform> toWorld;
      toWorld->SetMatrix(actor->GetMatrix());
      vtkNew<vtkTransformPolyDataFilter> placed;
      placed->SetInputData(actor->GetMapper()->GetInput());
      placed->SetTransform(toWorld);
      occluders->AddInputConnection(placed->GetOutputPort());
    }
  }
  vtkNew<vtkGodRaysSingleScatteringReference> truth;
  if (occluders->GetNumberOfInputConnections(0) > 0)
  {
    truth->SetInputConnection(occluders->GetOutputPort());
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
