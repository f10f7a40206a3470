// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Viewpoint.h"

#include "CameraMaker.h"
#include "Output.h"

#include "vtkCamera.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysSunPlacer.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr double LookAzimuth = 335.0; // a little from the right
constexpr double Pitch = -6.0;
constexpr double LowestPitch = -15.0;
constexpr double HighestPitch = 30.0;
constexpr double HighestPitchOnTerrain = 10.0;
constexpr double HighestPitchOnLow = -2.0;
constexpr double PitchOnLow = -20.0;          // the data's ground is seen
constexpr double PitchOnLowBeforeSky = -10.0; // a horizon is, too
constexpr double PitchOnFlat = -50.0;
constexpr double SunBesideCenter = 11.0;
constexpr double LowestSun = 0.5;        // above the horizon
constexpr double HighestHorizon = 0.8;   // in the picture, if there is to be a sun above it
constexpr double SunAbovePicture = 10.0; // elevation
constexpr double TerrainPitch = -7.0;    // not edge-on
constexpr double ParallelTerrainPitch = -15.0;
constexpr double BestCoverage = 0.3; // of the picture by the data
constexpr double MostOfWidth = 0.84; // of the picture
constexpr double MostOfHeight = 0.8;
constexpr double LeastMargin = 0.07; // of half its width or height

//------------------------------------------------------------------------------
/**
 * Small pictures of the scene, by which cameras and places for the sun are compared.
 */
class Probe
{
public:
  Probe(const Scene& scene, double aspect)
  {
    constexpr int rows = 180; // three for each that the sun's placer looks at
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(std::max(8, static_cast<int>(rows * aspect)), rows);
    this->Window->AddRenderer(this->Renderer);
    for (const auto& prop : scene.Props)
    {
      this->Renderer->AddViewProp(prop);
    }
    this->Rays->SetOutput(vtkGodRaysPass::OCCLUSION);
    this->Rays->SetSunPlacement(vtkGodRaysPass::SUN_ONCE);
    this->Rays->Attach(this->Renderer);
  }

  ~Probe()
  {
    this->Rays->Detach(this->Renderer);
    this->Renderer->RemoveAllViewProps();
  }

  Probe(const Probe&) = delete;
  void operator=(const Probe&) = delete;

  vtkGodRaysSunPlacer* FindSun(vtkCamera* camera, double lowest)
  {
    this->Renderer->SetActiveCamera(camera);
    this->Rays->RemoveAllLights();
    this->Rays->GetSunPlacer()->SetLowest(lowest);
    this->Window->Render();
    return this->Rays->GetSunPlacer();
  }

  /// Closely behind the scene, seen at a place of the picture from (-1, -1) to (1, 1).
  Vector3 GetPlaceBehind(vtkCamera* camera, double x, double y)
  {
    Vector3 place;
    this->Renderer->SetActiveCamera(camera);
    vtkGodRaysSunPlacer::GetPosition(
      this->Renderer, 0.5 * (x + 1.0), 0.5 * (y + 1.0), place.data());
    return place;
  }

private:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkGodRaysPass> Rays;
};

//------------------------------------------------------------------------------
class ViewpointMaker
{
public:
  ViewpointMaker(const Scene& scene, const Options& options)
    : Data(scene)
    , Settings(options)
    , Cameras(scene, options)
    , Pictures(scene, Cameras.Aspect)
  {
  }

  Viewpoint Make()
  {
    this->Result.LightIsLamp = this->Settings.Light.has_value();
    this->Result.LightPosition = this->Settings.Light.value_or(this->Cameras.Center);
    if (this->Settings.Sun)
    {
      this->Result.LightDirection =
        this->Data.GetDirection((*this->Settings.Sun)[0], (*this->Settings.Sun)[1]);
    }
    this->PlaceCamera();
    const bool cameraIsFree = !this->Settings.CameraPosition && !this->Settings.FocalPoint &&
      !this->Settings.ViewUp && !this->Cameras.StandsOnTerrain();
    if (cameraIsFree)
    {
      this->FillPicture(this->Result.Camera);
      if (this->Settings.Sun)
      {
        this->GoToSunAtEdge();
      }
    }
    if (!this->Settings.Sun && !this->Settings.Light)
    {
      this->ChooseLight(this->Result.Camera, true);
    }
    if (cameraIsFree)
    {
      this->TurnToLight(this->Result.Camera);
    }
    return this->Result;
  }

private:
  //----------------------------------------------------------------------------
  void PlaceCamera()
  {
    if (this->Settings.CameraPosition || this->Settings.FocalPoint)
    {
      this->Result.Camera = this->Cameras.Make(this->GetLookAzimuth(), this->GetPitch());
    }
    else if (this->Settings.Sun || this->Settings.Light || !this->Data.IsTerrain())
    {
      this->Result.Camera = this->Cameras.Make(this->GetLookAzimuth(), this->GetPitch());
    }
    else
    {
      this->ChooseLook();
    }
    if (!this->Settings.CameraPosition && !this->Settings.FocalPoint && !this->Settings.ViewUp &&
      !this->Settings.Sun && !this->Settings.Light && !this->Data.IsTerrain() && !this->IsFlat())
    {
      this->ChooseSide();
    }
  }

  //----------------------------------------------------------------------------
  /**
   * Takes the view with the most shafts among some of a thing; not one that shows little of it, as of a
   * plate from its edge. Views from behind have to be better: letters are read from the front, and so are
   * plots and faces.
   */
  void ChooseSide()
  {
    constexpr double enough = 0.64; // of the largest part of the picture that a view covers
    constexpr double fromBehind = 0.975;
    struct View
    {
      vtkSmartPointer<vtkCamera> Camera;
      double Score;
      double Coverage;
    };
    std::vector<View> views;
    double largest = 0.0;
    for (const double turn : { 0.0, 50.0, -50.0, 100.0, -100.0, 180.0 })
    {
      for (const double tilt : { 0.0, -18.0 })
      {
        if (tilt != 0.0 && !this->Settings.Sky.empty())
        {
          continue; // the horizon stays in the picture, and the sun above it
        }
        auto camera = this->Cameras.Make(this->GetLookAzimuth() + turn, this->GetPitch() + tilt);
        vtkGodRaysSunPlacer* placer = this->FindSun(camera, this->FindLowest(camera));
        const bool isBehind =
          std::cos(vtkMath::RadiansFromDegrees(this->GetLookAzimuth() + turn)) < 0.0;
        const double score = placer->GetScore() * (isBehind ? fromBehind : 1.0);
        views.push_back({ camera, score, placer->GetCoverage() });
        largest = std::max(largest, placer->GetCoverage());
      }
    }
    double best = 0.0;
    for (const View& view : views)
    {
      const double score = view.Score * std::min(1.0, view.Coverage / (enough * largest));
      if (largest > 0.0 && score > best)
      {
        best = score;
        this->Result.Camera = view.Camera;
      }
    }
  }

  //----------------------------------------------------------------------------
  /**
   * Over terrain, look to where the horizon is best, from as high as it is best.
   */
  void ChooseLook()
  {
    const double middle = this->Cameras.StandHeight;
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
      this->Cameras.StandHeight = factor * middle;
      if (this->TryLook(azimuth, best))
      {
        height = this->Cameras.StandHeight;
      }
    }
    this->Cameras.StandHeight = height;
  }

  //----------------------------------------------------------------------------
  bool TryLook(double azimuth, double& best)
  {
    auto camera = this->Cameras.Make(azimuth, this->GetPitch());
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
  bool IsFlat() const
  {
    return this->Data.GetExtent(this->Data.Up) < 1e-3 * this->Cameras.Diagonal;
  }

  //----------------------------------------------------------------------------
  /**
   * The direction to a given light, from the middle of the data.
   */
  bool GetLightAngles(double& azimuth, double& elevation) const
  {
    Vector3 direction = this->Result.LightDirection;
    if (this->Settings.Light)
    {
      direction = Subtract(*this->Settings.Light, this->Cameras.Center);
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
  /**
   * From where a sun is still to be seen. Of low data, that is not from below.
   */
  double GetHighestPitch() const
  {
    return this->Data.IsTerrain() ? HighestPitchOnTerrain
      : this->Data.IsLow()        ? HighestPitchOnLow
                                  : HighestPitch;
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
      // A sun that is higher than such a view has it cannot be in the picture.
      const double highest = this->GetHighestPitch();
      const double pitch = elevation > highest + 0.5 * this->Cameras.Angle
        ? Pitch
        : elevation - 0.28 * this->Cameras.Angle;
      return std::clamp(pitch, Pitch, highest);
    }
    if (this->Data.IsTerrain())
    {
      return this->Settings.Parallel ? ParallelTerrainPitch : TerrainPitch;
    }
    return !this->Data.IsLow()     ? Pitch
      : this->Settings.Sky.empty() ? PitchOnLow
                                   : PitchOnLowBeforeSky;
  }

  //----------------------------------------------------------------------------
  vtkGodRaysSunPlacer* FindSun(vtkCamera* camera, double lowest) const
  {
    return this->Pictures.FindSun(camera, lowest);
  }

  //----------------------------------------------------------------------------
  /**
   * The lowest place in the picture for a sun, from 0 to 1: the horizon, where there is one to be seen.
   */
  double FindLowest(vtkCamera* camera) const
  {
    const bool hasHorizon = this->Data.IsTerrain() || !this->Settings.Sky.empty();
    const double horizon = hasHorizon ? this->FindHeightInPicture(camera, LowestSun) : -1.0;
    return horizon < HighestHorizon ? 0.5 * (horizon + 1.0) : 0.0;
  }

  //----------------------------------------------------------------------------
  /**
   * Go to where the data cover as much of the picture as is best, by their silhouette, and are in its
   * middle; with a given lamp, if that is not far away.
   */
  void FillPicture(vtkCamera* camera) const
  {
    constexpr int rounds = 2; // from near, things are larger than in proportion
    for (int i = 0; i < rounds; ++i)
    {
      const auto placer = this->FindSun(camera, 0.0);
      if (placer->GetCoverage() <= 0.0)
      {
        return;
      }
      double box[4];
      placer->GetCoveredBounds(box);
      double lamp[2];
      if (this->Settings.Light && this->FindLight(camera, lamp))
      {
        for (int j = 0; j < 2; ++j)
        {
          box[2 * j] = std::min(box[2 * j], 0.5 * (lamp[j] + 1.0));
          box[2 * j + 1] = std::max(box[2 * j + 1], 0.5 * (lamp[j] + 1.0));
        }
      }
      this->Cameras.Turn(camera, box[0] + box[1] - 1.0, box[2] + box[3] - 1.0);
      const double factor = std::min({ std::sqrt(BestCoverage / placer->GetCoverage()),
        MostOfWidth / (box[1] - box[0]), MostOfHeight / (box[3] - box[2]) });
      double position[3];
      double look[3];
      camera->GetPosition(position);
      camera->GetDirectionOfProjection(look);
      const double distance =
        std::sqrt(vtkMath::Distance2BetweenPoints(position, this->Cameras.Center.data()));
      const double way = distance * (1.0 - 1.0 / std::clamp(factor, 0.5, 2.5));
      if (camera->GetParallelProjection())
      {
        camera->SetParallelScale(camera->GetParallelScale() / factor);
      }
      else
      {
        Vector3 arm;
        vtkMath::Subtract(this->Cameras.Center.data(), position, arm.data());
        vtkMath::Normalize(arm.data());
        Vector3 focus;
        camera->GetFocalPoint(focus.data());
        camera->SetPosition(AddScaled({ position[0], position[1], position[2] }, way, arm).data());
        camera->SetFocalPoint(AddScaled(focus, way, arm).data());
      }
      this->Cameras.SetClippingRange(camera);
    }
  }

  //----------------------------------------------------------------------------
  /**
   * Where the light is in the picture, from -1 to 1. Returns whether it is there, or not far out.
   */
  bool FindLight(vtkCamera* camera, double place[2]) const
  {
    constexpr double farthest = 2.0;
    const bool isLamp = this->Result.LightIsLamp;
    const Vector3& light = isLamp ? this->Result.LightPosition : this->Result.LightDirection;
    double point[4] = { light[0], light[1], light[2], isLamp ? 1.0 : 0.0 };
    camera->GetCompositeProjectionTransformMatrix(this->Cameras.Aspect, -1.0, 1.0)
      ->MultiplyPoint(point, point);
    place[0] = point[0] / point[3];
    place[1] = point[1] / point[3];
    return point[3] > 0.0 && std::abs(place[0]) < farthest && std::abs(place[1]) < farthest;
  }

  //----------------------------------------------------------------------------
  /**
   * Look at the data from where a given sun is seen nearest to the place that is best for one. From
   * each place that is tried, the data have another edge.
   */
  void GoToSunAtEdge()
  {
    constexpr int rounds = 4;
    const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(this->Cameras.Angle));
    const double tangents[2] = { tangent * this->Cameras.Aspect, tangent };
    vtkSmartPointer<vtkCamera> camera = this->Result.Camera;
    double nearest = VTK_DOUBLE_MAX;
    double sun[2];
    for (int i = 0; i < rounds && this->FindLight(camera, sun); ++i)
    {
      const auto placer = this->FindSun(camera, 0.0);
      double turn[2];
      for (int j = 0; j < 2; ++j)
      {
        const double best = 2.0 * placer->GetPlace()[j] - 1.0;
        turn[j] = vtkMath::DegreesFromRadians(
          std::atan(tangents[j] * sun[j]) - std::atan(tangents[j] * best));
      }
      const double distance = std::hypot(turn[0], turn[1]);
      if (distance < nearest)
      {
        nearest = distance;
        this->Result.Camera = camera;
      }
      Vector3 look;
      camera->GetDirectionOfProjection(look.data());
      double azimuth = 0.0;
      double pitch = 0.0;
      this->Data.GetAngles(look, azimuth, pitch);
      pitch = std::clamp(pitch + turn[1], LowestPitch, this->GetHighestPitch());
      camera = this->Cameras.Make(azimuth + turn[0], pitch);
      this->FillPicture(camera);
    }
  }

  //----------------------------------------------------------------------------
  /**
   * Have the middle of the picture between the data and the light, so that there is room for the shafts
   * beside the data.
   */
  void TurnToLight(vtkCamera* camera) const
  {
    double light[2];
    if (!this->FindLight(camera, light))
    {
      return;
    }
    const auto placer = this->FindSun(camera, 0.0);
    const double* box = placer->GetCoveredBounds();
    double turn[2];
    for (int i = 0; i < 2; ++i)
    {
      const double low = 2.0 * box[2 * i] - 1.0;
      const double high = 2.0 * box[2 * i + 1] - 1.0;
      const double room = 1.0 - LeastMargin;
      const double middle = 0.5 * (0.5 * (low + high) + light[i]);
      turn[i] = std::clamp(middle, std::min(high - room, 0.0), std::max(low + room, 0.0));
    }
    this->Cameras.Turn(camera, turn[0], turn[1]);
    this->Cameras.SetClippingRange(camera);
  }

  //----------------------------------------------------------------------------
  /**
   * Put the light where the silhouette of the scene has the best gaps. Returns how good that is.
   */
  double ChooseLight(vtkCamera* camera, bool use)
  {
    const double lowest = this->FindLowest(camera);
    const auto placer = this->FindSun(camera, lowest);
    if (use)
    {
      const double x = 2.0 * placer->GetPlace()[0] - 1.0;
      const double y = 2.0 * placer->GetPlace()[1] - 1.0;
      this->PlaceLight(camera, x, std::clamp(std::max(y, 2.0 * lowest - 1.0), -0.9, 0.9));
      this->Result.LightWasChosen = true;
    }
    // The data should neither fill the picture nor be a strip at its foot.
    return placer->GetScore() * (1.0 - std::abs(placer->GetCoverage() - 0.6));
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
   * straight ahead, and who looks down sees none: there, put a lamp far behind the scene, or with a
   * physical sky, which has no lamps, a sun above the picture. A lamp closely behind the data makes more
   * shafts in a medium, but over terrain and in a scene of a known size the light is the sun's.
   */
  void PlaceLight(vtkCamera* camera, double x, double y)
  {
    vtkNew<vtkMatrix4x4> toWorld;
    vtkMatrix4x4::Invert(
      camera->GetCompositeProjectionTransformMatrix(this->Cameras.Aspect, -1.0, 1.0), toWorld);
    Vector3 ends[2];
    for (int i = 0; i < 2; ++i)
    {
      double point[4] = { x, y, i == 0 ? -1.0 : 1.0, 1.0 };
      toWorld->MultiplyPoint(point, point);
      ends[i] = { point[0] / point[3], point[1] / point[3], point[2] / point[3] };
    }
    Vector3 direction = Subtract(ends[1], ends[0]);
    vtkMath::Normalize(direction.data());
    this->Result.LightDirection = direction;
    double azimuth = 0.0;
    double elevation = 0.0;
    this->Data.GetAngles(direction, azimuth, elevation);
    this->Result.LightIsLamp = camera->GetParallelProjection() != 0 || elevation < 0.0;
    this->Result.LightPosition = AddScaled(ends[1], this->Cameras.Diagonal, direction);
    const Options& options = this->Settings;
    if (options.Sky.empty() && options.Hdri.empty() && !options.VolumeMedium &&
      !options.WorldUnit && !options.LightSize && options.Numbers.empty() &&
      options.Turntable == 0 && !this->Data.IsTerrain())
    {
      this->Result.LampInMedium = this->Pictures.GetPlaceBehind(camera, x, y);
    }
    if (this->Result.LightIsLamp && !this->Settings.Sky.empty())
    {
      this->Result.LightIsLamp = false;
      this->Result.LightDirection = this->Data.GetDirection(azimuth, SunAbovePicture);
    }
  }

  const Scene& Data;
  const Options& Settings;
  CameraMaker Cameras;
  mutable Probe Pictures;
  Viewpoint Result;
};
}

//------------------------------------------------------------------------------
Viewpoint MakeViewpoint(const Scene& scene, const Options& options)
{
  CheckDisplay(); // since VTK 9.6 a window looks for the display as it is made
  return ViewpointMaker(scene, options).Make();
}
