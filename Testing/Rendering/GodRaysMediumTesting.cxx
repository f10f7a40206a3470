// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GodRaysMediumTesting.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"

#include <algorithm>
#include <cmath>

namespace GodRaysTesting
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> GetTrueScattering(vtkRenderer* renderer,
  vtkGodRaysHomogeneousModel* model, std::array<double, 4> light, const int size[2])
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
      occluders->AddInputData(vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()));
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
  truth->SetScatteringCoefficient(model->GetScatteringCoefficient());
  truth->SetAbsorptionCoefficient(model->GetAbsorptionCoefficient());
  truth->SetPhaseFunction(model->GetPhaseFunction());
  truth->SetAsymmetry(model->GetAsymmetry());
  truth->SetFarLimit(model->GetFarLimit());
  truth->SetLight(light.data());
  double power = vtkMath::Pi();
  if (light[3] != 0.0)
  {
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    power *= 0.25 *
      (std::pow(bounds[1] - bounds[0], 2) + std::pow(bounds[3] - bounds[2], 2) +
        std::pow(bounds[5] - bounds[4], 2));
  }
  truth->SetLightColor(power, power, power);
  truth->SetSize(size[0], size[1]);
  truth->SetTolerance(1e-6);
  truth->Update();
  return truth->GetOutput();
}

//------------------------------------------------------------------------------
double GetErrorOfMedium(vtkRenderer* renderer, vtkGodRaysHomogeneousModel* model,
  std::array<double, 4> light, vtkImageData* image)
{
  const int* size = image->GetDimensions();
  auto truth = GetTrueScattering(renderer, model, light, size);
  vtkDataArray* values = truth->GetPointData()->GetScalars();
  double squares = 0.0;
  double peak = 0.0;
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double expected = values->GetComponent(i, c);
      squares += std::pow(GetValue(image, i % size[0], i / size[0], c) - expected, 2);
      peak = std::max(peak, expected);
    }
  }
  return std::sqrt(squares / (3.0 * size[0] * size[1])) / peak;
}
}
