// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Viewpoint.h"

#include "vtkCamera.h"
#include "vtkGodRaysSunPlacer.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double ViewAngle = 30.0;
constexpr double TerrainViewAngle = 42.0;
constexpr double LookAzimuth = 335.0; // a little from the right
constexpr double Pitch = -6.0;
constexpr double PitchOnFlat = -50.0;
constexpr double SunBesideCenter = 11.0;
constexpr double LowestSunOverTerrain = 0.5;
constexpr double TerrainPitch = -3.0;
constexpr double ParallelTerrainPitch = -15.0;
constexpr double LongestShareOfPicture = 0.74;

//------------------------------------------------------------------------------
Vector3 Add(const Vector3& a, double factor, const Vector3& b)
{
  return { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] };
}

//------------------------------------------------------------------------------
class ViewpointMaker
{
public:
  ViewpointMaker(const Scene& scene, const Options& options)
    : Data(scene)
    , Settings(options)
    , Aspect(static_cast<double>(options.Size[0]) / options.Size[1])
  {
    scene.Bounds.GetCenter(this->Center.data());
    this->Diagonal = scene.Bounds.GetDiagonalLength();
    this->Diagonal = this->Diagonal > 0.0 ? this->Diagonal : 1.0;
    this->Angle = options.ViewAngle.value_or(scene.IsTerrain() ? TerrainViewAngle : ViewAngle);
  }

  Viewpoint Make()
  {
    this->Result.LightIsLamp = this->Settings.Light.has_value();
    this->Result.LightPosition = this->Settings.Light.value_or(this->Center);
    if (this->Settings.Sun)
    {
      this->Result.LightDirection =
        this->Data.GetDirection((*this->Settings.Sun)[0], (*this->Settings.Sun)[1]);
    }
    this->PlaceCamera();
    if (!this->Settings.Sun && !this->Settings.Light)
    {
      this->ChooseLight(this->Result.Camera, true);
    }
    return this->Result;
  }

private:
  //----------------------------------------------------------------------------
  void PlaceCamera()
  {
    if (this->Settings.CameraPosition || this->Settings.FocalPoint)
    {
      this->Result.Camera = this->MakeCamera(this->GetLookAzimuth(), this->GetPitch());
    }
    else if (this->Settings.Sun || this->Settings.Light || !this->Data.IsTerrain())
    {
      this->Result.Camera = this->MakeCamera(this->GetLookAzimuth(), this->GetPitch());
    }
    else
    {
      this->ChooseLook();
    }
  }

  //----------------------------------------------------------------------------
  /**
   * Over terrain, look to where the horizon is best, from as high as it is best.
   */
  void ChooseLook()
  {
    const double middle = this->StandHeight;
    double azimuth = 0.0;
    double best = -VTK_DOUBLE_MAX;
    for (const double each :
      { 270.0, 250.0, 290.0, 90.0, 70.0, 110.0, 180.0, 160.0, 200.0, 0.0, 340.0, 20.0 })
    {
      if (this->TryLook(each, best))
      {
        azimuth = each;
      }
    }
    double height = middle;
    for (const double factor : { 0.4, 2.0, 3.5 })
    {
      this->StandHeight = factor * middle;
      if (this->TryLook(azimuth, best))
      {
        height = this->StandHeight;
      }
    }
    this->StandHeight = height;
  }

  //----------------------------------------------------------------------------
  bool TryLook(double azimuth, double& best)
  {
    auto camera = this->MakeCamera(azimuth, this->GetPitch());
    const double score = this->ChooseLight(camera, false);
    if (score <= best)
    {
      return false;
    }
    best = score;
    this->Result.Camera = camera;
    return true;
  }

  //----------------------------------------------------------------------------
  bool IsFlat() const { return this->Data.GetExtent(this->Data.Up) < 1e-3 * this->Diagonal; }

  //----------------------------------------------------------------------------
  /**
   * The direction to a given light, from the middle of the data.
   */
  bool GetLightAngles(double& azimuth, double& elevation) const
  {
    Vector3 direction = this->Result.LightDirection;
    if (this->Settings.Light)
    {
      direction = Add(*this->Settings.Light, -1.0, this->Center);
    }
    else if (!this->Settings.Sun)
    {
      return false;
    }
    this->Data.GetAngles(direction, azimuth, elevation);
    return std::abs(elevation) < 89.0;
  }

  //----------------------------------------------------------------------------
  double GetLookAzimuth() const
  {
    double azimuth = LookAzimuth;
    double elevation = 0.0;
    if (this->GetLightAngles(azimuth, elevation))
    {
      azimuth += SunBesideCenter;
    }
    return azimuth;
  }

  //----------------------------------------------------------------------------
  double GetPitch() const
  {
    if (this->IsFlat())
    {
      return PitchOnFlat;
    }
    double azimuth = 0.0;
    double elevation = 0.0;
    if (this->Settings.Sun && this->GetLightAngles(azimuth, elevation))
    {
      const double highest = this->Data.IsTerrain() ? 10.0 : 30.0;
      return std::clamp(elevation - 0.28 * this->Angle, Pitch, highest);
    }
    return !this->Data.IsTerrain() ? Pitch
      : this->Settings.Parallel    ? ParallelTerrainPitch
                                   : TerrainPitch;
  }

  //----------------------------------------------------------------------------
  vtkSmartPointer<vtkCamera> MakeCamera(double azimuth, double pitch) const
  {
    auto camera = vtkSmartPointer<vtkCamera>::New();
    const Vector3 look = this->Data.GetDirection(azimuth, pitch);
    camera->SetViewUp(this->Data.Up.data());
    camera->SetViewAngle(this->Angle);
    camera->SetParallelProjection(this->Settings.Parallel);
    if (this->Data.IsTerrain() && !this->Settings.Parallel)
    {
      this->StandOnTerrain(camera, azimuth, look);
    }
    else
    {
      this->ShowWhole(camera, look);
    }
    this->ApplySettings(camera);
    double bounds[6];
    this->Data.Bounds.GetBounds(bounds);
    this->SetClippingRange(camera, bounds);
    return camera;
  }

  //----------------------------------------------------------------------------
  void StandOnTerrain(vtkCamera* camera, double azimuth, const Vector3& look) const
  {
    const Vector3 ahead = this->Data.GetDirection(azimuth, 0.0);
    const double length = this->Data.GetExtent(ahead);
    Vector3 position = Add(this->Center, -0.45 * length, ahead);
    const double ground = this->Data.GetHighest(position, 0.12 * length);
    const double level = vtkMath::Dot(position.data(), this->Data.Up.data());
    const double clearance = this->StandHeight * this->Data.GetExtent(this->Data.Up);
    position = Add(position, ground + clearance - level, this->Data.Up);
    const Vector3 focus = Add(position, 0.5 * length, look);
    camera->SetPosition(position.data());
    camera->SetFocalPoint(focus.data());
  }

  //----------------------------------------------------------------------------
  void ShowWhole(vtkCamera* camera, const Vector3& look) const
  {
    Vector3 right;
    Vector3 up;
    vtkMath::Cross(look.data(), this->Data.Up.data(), right.data());
    if (vtkMath::Normalize(right.data()) == 0.0)
    {
      right = this->Data.East;
    }
    vtkMath::Cross(right.data(), look.data(), up.data());
    const double tangent =
      LongestShareOfPicture * std::tan(0.5 * vtkMath::RadiansFromDegrees(this->Angle));
    double distance = 0.0;
    double halfHeight = 0.0;
    for (int i = 0; i < 8; ++i)
    {
      Vector3 corner;
      this->Data.Bounds.GetCorner(i, corner.data());
      const Vector3 arm = Add(corner, -1.0, this->Center);
      const double x = std::abs(vtkMath::Dot(arm.data(), right.data())) / this->Aspect;
      const double y = std::abs(vtkMath::Dot(arm.data(), up.data()));
      const double depth = vtkMath::Dot(arm.data(), look.data());
      halfHeight = std::max(halfHeight, std::max(x, y) / LongestShareOfPicture);
      distance = std::max(distance, std::max(x, y) / tangent - depth);
    }
    distance = distance > 0.0 ? distance : this->Diagonal;
    const Vector3 position = Add(this->Center, -distance, look);
    camera->SetFocalPoint(this->Center.data());
    camera->SetPosition(position.data());
    camera->SetParallelScale(halfHeight > 0.0 ? halfHeight : this->Diagonal);
    if (std::abs(vtkMath::Dot(look.data(), this->Data.Up.data())) > 0.999)
    {
      camera->SetViewUp(this->Data.North.data());
    }
  }

  //----------------------------------------------------------------------------
  void ApplySettings(vtkCamera* camera) const
  {
    if (this->Settings.FocalPoint)
    {
      // Keep the direction in which the camera looks.
      const Vector3& focus = *this->Settings.FocalPoint;
      Vector3 position;
      camera->GetPosition(position.data());
      Vector3 former;
      camera->GetFocalPoint(former.data());
      position = Add(Add(position, -1.0, former), 1.0, focus);
      camera->SetFocalPoint(focus.data());
      camera->SetPosition(position.data());
    }
    if (this->Settings.CameraPosition)
    {
      const Vector3 focus = this->Settings.FocalPoint.value_or(this->Center);
      camera->SetFocalPoint(focus.data());
      camera->SetPosition(this->Settings.CameraPosition->data());
    }
    if (this->Settings.ViewUp)
    {
      camera->SetViewUp(this->Settings.ViewUp->data());
    }
    double look[3];
    double up[3];
    camera->GetDirectionOfProjection(look);
    camera->GetViewUp(up);
    vtkMath::Normalize(up);
    if (std::abs(vtkMath::Dot(look, up)) > 0.9999)
    {
      camera->SetViewUp(this->Data.North.data()); // straight up or down
    }
  }

  //----------------------------------------------------------------------------
  void SetClippingRange(vtkCamera* camera, const double bounds[6]) const
  {
    double position[3];
    double look[3];
    camera->GetPosition(position);
    camera->GetDirectionOfProjection(look);
    double far = 0.0;
    for (int i = 0; i < 8; ++i)
    {
      const double corner[3] = { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2)] };
      double arm[3];
      vtkMath::Subtract(corner, position, arm);
      far = std::max(far, vtkMath::Dot(arm, look));
    }
    far = far > 0.0 ? 1.01 * far : this->Diagonal;
    camera->SetClippingRange(1e-3 * far, far);
  }

  //----------------------------------------------------------------------------
  /**
   * Put the light where the silhouette of the scene has the best gaps. Returns how good that is.
   */
  double ChooseLight(vtkCamera* camera, bool use)
  {
    vtkNew<vtkPropCollection> props;
    for (const auto& prop : this->Data.Props)
    {
      props->AddItem(prop);
    }
    const double lowest =
      this->Data.IsTerrain() ? this->FindHeightInPicture(camera, LowestSunOverTerrain) : -1.0;
    vtkNew<vtkGodRaysSunPlacer> placer;
    placer->SetLowest(0.5 * (lowest + 1.0));
    placer->Find(props, camera, this->Aspect);
    if (use)
    {
      const double x = 2.0 * placer->GetPlace()[0] - 1.0;
      const double y = 2.0 * placer->GetPlace()[1] - 1.0;
      this->PlaceLight(camera, x, std::clamp(std::max(y, lowest), -0.9, 0.9));
      this->Result.LightWasChosen = true;
    }
    // The data should neither fill the picture nor be a strip at its foot.
    return placer->GetScore() - std::abs(placer->GetCoverage() - 0.6);
  }

  //----------------------------------------------------------------------------
  /**
   * How high in the picture an elevation in degrees is, straight ahead.
   */
  double FindHeightInPicture(vtkCamera* camera, double elevation) const
  {
    double azimuth = 0.0;
    double pitch = 0.0;
    Vector3 look;
    camera->GetDirectionOfProjection(look.data());
    this->Data.GetAngles(look, azimuth, pitch);
    const double above = vtkMath::RadiansFromDegrees(elevation - pitch);
    const double half = 0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle());
    return std::abs(above) < 1.5 ? std::tan(above) / std::tan(half) : -1.0;
  }

  //----------------------------------------------------------------------------
  /**
   * Put the sun behind a place in the picture. A parallel projection sees no sun that is not
   * straight ahead: there, put a lamp far behind the scene.
   */
  void PlaceLight(vtkCamera* camera, double x, double y)
  {
    vtkNew<vtkMatrix4x4> toWorld;
    vtkMatrix4x4::Invert(
      camera->GetCompositeProjectionTransformMatrix(this->Aspect, -1.0, 1.0), toWorld);
    Vector3 ends[2];
    for (int i = 0; i < 2; ++i)
    {
      double point[4] = { x, y, i == 0 ? -1.0 : 1.0, 1.0 };
      toWorld->MultiplyPoint(point, point);
      ends[i] = { point[0] / point[3], point[1] / point[3], point[2] / point[3] };
    }
    Vector3 direction = Add(ends[1], -1.0, ends[0]);
    vtkMath::Normalize(direction.data());
    this->Result.LightDirection = direction;
    this->Result.LightIsLamp = camera->GetParallelProjection() != 0;
    this->Result.LightPosition = Add(ends[1], this->Diagonal, direction);
  }

  const Scene& Data;
  const Options& Settings;
  double Aspect;
  double Angle;
  double Diagonal;
  double StandHeight = 0.2; ///< above the ground, as a fraction of the relief
  Vector3 Center;
  Viewpoint Result;
};
}

//------------------------------------------------------------------------------
Viewpoint MakeViewpoint(const Scene& scene, const Options& options)
{
  return ViewpointMaker(scene, options).Make();
}
