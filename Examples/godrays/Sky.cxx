// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sky.h"

#include "Values.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr Vector3 Zenith = { 0.020, 0.060, 0.170 };
constexpr Vector3 Horizon = { 0.150, 0.190, 0.290 };
constexpr Vector3 Below = { 0.045, 0.060, 0.100 };
constexpr double WideGlow = 0.42;      // of the light's colour, at the light
constexpr double WideGlowAngle = 14.0; // over which it falls to 1/e
constexpr double NarrowGlow = 0.30;
constexpr double NarrowGlowAngle = 2.5;
constexpr double HorizonHeight = 16.0;         // over which the sky gets dark
constexpr double ParallelPictureHeight = 30.0; // a parallel picture counts as so many degrees

//------------------------------------------------------------------------------
Vector3 Mix(const Vector3& a, const Vector3& b, double share)
{
  return { a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
    a[2] + share * (b[2] - a[2]) };
}

//------------------------------------------------------------------------------
/**
 * What is added to a level before it is cut to a whole one, from 0 to 1: all sixteenths in each four by
 * four pixels, so that a gradient has no bands.
 */
double GetDither(vtkIdType column, vtkIdType row)
{
  constexpr int order[4][4] = { { 0, 8, 2, 10 }, { 12, 4, 14, 6 }, { 3, 11, 1, 9 },
    { 15, 7, 13, 5 } };
  return (order[row % 4][column % 4] + 0.5) / 16.0;
}

//------------------------------------------------------------------------------
/**
 * The angles, in degrees, of what is seen at a place of the picture.
 */
class PictureAngles
{
public:
  PictureAngles(vtkRenderer* renderer, const Viewpoint& view, const Vector3& up)
    : Up(up)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->GetPosition(this->Position.data());
    vtkMatrix4x4* toView = camera->GetModelViewTransformMatrix();
    for (int i = 0; i < 3; ++i)
    {
      this->Right[i] = toView->GetElement(0, i);
      this->Top[i] = toView->GetElement(1, i);
      this->Back[i] = toView->GetElement(2, i);
    }
    const int* size = renderer->GetSize();
    this->Aspect = size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.0;
    this->Parallel = camera->GetParallelProjection() != 0;
    const double angle = this->Parallel ? ParallelPictureHeight : camera->GetViewAngle();
    this->Tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(angle));
    this->SetLight(view, camera);
  }

  double GetAngleFromLight(double x, double y) const
  {
    const Vector3 look = this->GetLook(x, y);
    const double cosine = vtkMath::Dot(look.data(), this->ToLight.data());
    return vtkMath::DegreesFromRadians(std::acos(std::clamp(cosine, -1.0, 1.0)));
  }

  double GetElevation(double x, double y) const
  {
    const Vector3 look = this->GetLook(x, y);
    const double sine = vtkMath::Dot(look.data(), this->Up.data());
    return vtkMath::DegreesFromRadians(std::asin(std::clamp(sine, -1.0, 1.0)));
  }

private:
  Vector3 GetLook(double x, double y) const
  {
    Vector3 look;
    for (int i = 0; i < 3; ++i)
    {
      look[i] = x * this->Aspect * this->Tangent * this->Right[i] +
        y * this->Tangent * this->Top[i] - this->Back[i];
    }
    vtkMath::Normalize(look.data());
    return look;
  }

  void SetLight(const Viewpoint& view, vtkCamera* camera)
  {
    this->ToLight = view.LightDirection;
    if (!view.LightIsLamp)
    {
      return;
    }
    vtkMath::Subtract(view.LightPosition.data(), this->Position.data(), this->ToLight.data());
    if (this->Parallel)
    {
      const double half = camera->GetParallelScale();
      Vector3 focus;
      camera->GetFocalPoint(focus.data());
      vtkMath::Subtract(view.LightPosition.data(), focus.data(), focus.data());
      this->ToLight =
        this->GetLook(vtkMath::Dot(focus.data(), this->Right.data()) / half / this->Aspect,
          vtkMath::Dot(focus.data(), this->Top.data()) / half);
    }
    vtkMath::Normalize(this->ToLight.data());
  }

  Vector3 Up;
  Vector3 Position;
  Vector3 Right;
  Vector3 Top;
  Vector3 Back;
  Vector3 ToLight;
  double Aspect;
  double Tangent;
  bool Parallel;
};
}

//------------------------------------------------------------------------------
Sky::Sky(vtkRenderer* renderer, const Scene& scene, const Viewpoint& view, double sunRadius,
  const Options& options)
  : Renderer(renderer)
  , View(view)
  , Up(scene.Up)
  , LightColor(options.LightColor)
  , SunRadius(view.LightIsLamp ? 0.0 : sunRadius)
{
  if (options.Background != "sky")
  {
    const auto colon = std::min(options.Background.find(':'), options.Background.size());
    const Vector3 bottom = ParseColor("--background", options.Background.substr(0, colon));
    renderer->SetBackground(bottom.data());
    if (colon == options.Background.size())
    {
      return;
    }
    this->Gradient = { bottom, ParseColor("--background", options.Background.substr(colon + 1)) };
  }
  this->Texture->SetInputData(this->Image);
  this->Texture->InterpolateOn();
  renderer->SetBackgroundTexture(this->Texture);
  renderer->TexturedBackgroundOn();
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<Sky*>(self)->Update(); });
  this->Observer = renderer->AddObserver(vtkCommand::StartEvent, command);
}

//------------------------------------------------------------------------------
Sky::~Sky()
{
  this->Renderer->RemoveObserver(this->Observer);
}

//------------------------------------------------------------------------------
void Sky::SetView(const Viewpoint& view)
{
  this->View = view;
  this->CameraTime = 0;
}

//------------------------------------------------------------------------------
Vector3 Sky::GetColor(double angleFromLight, double elevation) const
{
  Vector3 color = elevation >= 0.0 ? Mix(Zenith, Horizon, std::exp(-elevation / HorizonHeight))
                                   : Mix(Below, Horizon, std::exp(elevation / HorizonHeight));
  const double glow = WideGlow * std::exp(-angleFromLight / WideGlowAngle) +
    NarrowGlow * std::exp(-angleFromLight / NarrowGlowAngle);
  // The disc's edge is as wide as a pixel or two, so that it is smooth.
  const double edge = std::max(0.04, 0.1 * this->SunRadius);
  const double disc =
    this->SunRadius > 0.0 ? std::clamp((this->SunRadius - angleFromLight) / edge, 0.0, 1.0) : 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double bright = 0.6 + 0.4 * this->LightColor[i];
    color[i] = 1.0 - (1.0 - color[i]) * (1.0 - std::min(glow * this->LightColor[i], 1.0));
    color[i] += disc * (bright - color[i]);
  }
  return color;
}

//------------------------------------------------------------------------------
void Sky::Update()
{
  const int* size = this->Renderer->GetSize();
  const vtkMTimeType time = this->Renderer->GetActiveCamera()->GetMTime();
  int former[3];
  this->Image->GetDimensions(former);
  if (size[0] < 1 || size[1] < 1 ||
    (former[0] == size[0] && former[1] == size[1] && time == this->CameraTime))
  {
    return;
  }
  this->CameraTime = time;
  this->Image->SetDimensions(size[0], size[1], 1);
  this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const PictureAngles angles(this->Renderer, this->View, this->Up);
  const int columns = size[0];
  const int rows = size[1];
  auto* bytes = static_cast<unsigned char*>(this->Image->GetScalarPointer());
  vtkSMPTools::For(0, rows,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        const double y = 2.0 * (row + 0.5) / rows - 1.0;
        for (int column = 0; column < columns; ++column)
        {
          const double x = 2.0 * (column + 0.5) / columns - 1.0;
          const Vector3 color = this->Gradient
            ? Mix((*this->Gradient)[0], (*this->Gradient)[1], 0.5 * (y + 1.0))
            : this->GetColor(angles.GetAngleFromLight(x, y), angles.GetElevation(x, y));
          unsigned char* pixel = bytes + 3 * (row * columns + column);
          const double rounding = GetDither(column, row);
          std::transform(color.begin(), color.end(), pixel,
            [rounding](double value)
            {
              return static_cast<unsigned char>(
                std::min(255.0 * std::clamp(value, 0.0, 1.0) + rounding, 255.0));
            });
        }
      }
    });
  this->Image->Modified();
}
