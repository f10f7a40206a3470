// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelScene.h"

#include "vtkGodRaysSingleScattering.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyDataMapper.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace ModelError
{
//------------------------------------------------------------------------------
Stage::Stage(Device& device, const Scene& scene, int width, int height)
  : OpenGL(device)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(scene.Occluders);
  this->Actor->SetMapper(mapper);
  this->Renderer->AddActor(this->Actor);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.0);
  camera->SetFocalPoint(0.0, 0.0, -1.0);
  camera->SetViewAngle(ViewAngle);
  camera->SetClippingRange(0.05, 5000.0);
  this->Light->SetLightTypeToSceneLight();
  this->Light->SetFocalPoint(0.0, 0.0, 0.0);
  this->Medium->SetScatteringCoefficient(Scattering);
  this->Medium->SetFarLimit(FarLimit);
  this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  this->Rays->AddLight(this->Light);
  device.GetWindow()->SetSize(width, height);
  device.GetWindow()->AddRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
Stage::~Stage()
{
  this->Rays->Detach(this->Renderer);
  this->OpenGL.GetWindow()->RemoveRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
void Stage::Set(const NamedLight& light, double asymmetry)
{
  this->Light->SetPosition(light.Direction);
  this->Medium->SetAsymmetry(asymmetry);
}

//------------------------------------------------------------------------------
void Stage::Set(const ModelMethod& method)
{
  this->Rays->SetModel(method.IsMedium ? this->Medium.Get() : nullptr);
  this->Rays->SetIntegrator(method.Integrator);
  this->Rays->SetErrorTolerance(method.Tolerance);
  this->Rays->Attach(this->Renderer);
}

//------------------------------------------------------------------------------
void Stage::SetColors(bool grey)
{
  this->Medium->SetScatteringCoefficient(
    Scattering[grey ? 1 : 0], Scattering[1], Scattering[grey ? 1 : 2]);
}

//------------------------------------------------------------------------------
double Stage::Draw()
{
  return this->OpenGL.Measure([this] { this->OpenGL.GetWindow()->Render(); });
}

//------------------------------------------------------------------------------
double Stage::DrawWithoutRays()
{
  this->Rays->Detach(this->Renderer);
  return this->Draw();
}

//------------------------------------------------------------------------------
Picture Stage::GetLight()
{
  this->OpenGL.GetWindow()->Render();
  vtkNew<vtkImageData> image;
  if (!this->Rays->GetScatteringImage(image)) // a radial sum of a light that is nowhere near
  {
    const int* size = this->OpenGL.GetWindow()->GetSize();
    return Picture(3 * static_cast<std::size_t>(size[0]) * size[1], 0.0f);
  }
  const auto* values = static_cast<const float*>(image->GetScalarPointer());
  return Picture(values, values + 3 * image->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
Truth::Truth(
  vtkPolyData* occluders, const NamedLight& light, double asymmetry, int width, int height)
  : Light(3 * static_cast<std::size_t>(width) * height)
  , Other(this->Light.size())
{
  vtkGodRaysSingleScattering::Parameters parameters;
  parameters.Forward[2] = -1.0;
  std::copy_n(light.Direction, 3, parameters.Light);
  std::fill_n(parameters.LightColor, 3, vtkMath::Pi());
  parameters.Medium.FarLimit = FarLimit;
  vtkGodRaysMedium::Component& component = parameters.Medium.Components[0];
  std::copy_n(Scattering, 3, component.Scattering);
  component.PhaseFunction = vtkGodRaysMediumModel::HENYEY_GREENSTEIN;
  component.Asymmetry = asymmetry;
  vtkGodRaysSingleScattering exact;
  exact.SetParameters(parameters);
  exact.SetOccluders(occluders);
  const double pixel = 2.0 * std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle)) / height;
  std::atomic<int> onEdges{ 0 };
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < width; ++column)
        {
          const double x = (column + 0.5 - 0.5 * width) * pixel;
          const double y = (row + 0.5 - 0.5 * height) * pixel;
          vtkGodRaysSingleScattering::Result ray;
          exact.Evaluate(x, y, ray);
          const std::size_t at = 3 * (static_cast<std::size_t>(row) * width + column);
          std::copy_n(ray.Radiance, 3, this->Light.begin() + at);
          std::copy_n(ray.Radiance, 3, this->Other.begin() + at);
          const double sight = std::min(ray.Sight, FarLimit);
          for (int corner = 0; corner < 4; ++corner)
          {
            const double away = pixel / 256.0;
            const double place[2] = { x + (corner & 1 ? away : -away),
              y + (corner & 2 ? away : -away) };
            const double seen = std::min(exact.FindSight(place[0], place[1]), FarLimit);
            if (std::abs(seen - sight) > 0.01 * sight)
            {
              exact.Evaluate(place[0], place[1], ray);
              std::copy_n(ray.Radiance, 3, this->Other.begin() + at);
              ++onEdges;
              break;
            }
          }
        }
      }
    });
  this->PixelsOnEdges = onEdges;
}

//------------------------------------------------------------------------------
std::array<double, 3> Truth::Compare(const Picture& picture) const
{
  std::array<double, 3> errors;
  for (int c = 0; c < 3; ++c)
  {
    double squares = 0.0;
    double peak = 0.0;
    for (std::size_t i = c; i < picture.size(); i += 3)
    {
      const double value = picture[i];
      squares +=
        std::pow(std::min(std::abs(value - this->Light[i]), std::abs(value - this->Other[i])), 2);
      peak = std::max<double>(peak, this->Light[i]);
    }
    errors[c] = std::sqrt(squares / (picture.size() / 3.0)) / peak;
  }
  return errors;
}

//------------------------------------------------------------------------------
void Fit(Picture& picture, const Picture& truth)
{
  for (int c = 0; c < 3; ++c)
  {
    double product = 0.0;
    double square = 0.0;
    for (std::size_t i = c; i < truth.size(); i += 3)
    {
      product += static_cast<double>(picture[i]) * truth[i];
      square += static_cast<double>(picture[i]) * picture[i];
    }
    for (std::size_t i = c; i < truth.size() && square > 0.0; i += 3)
    {
      picture[i] *= static_cast<float>(product / square);
    }
  }
}
}
