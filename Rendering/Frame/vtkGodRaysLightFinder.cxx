// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysLightFinder.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysGate.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysRole.h"
#include "vtkGodRaysSceneSize.h"
#include "vtkGodRaysView.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
vtkInformationDoubleVectorKey* GetAboveAirKey()
{
  static vtkInformationDoubleVectorKey* const key =
    vtkInformationDoubleVectorKey::MakeKey("ABOVE_AIR", "vtkGodRaysSkyPass", 10);
  return key;
}

/// A light is marched to from at most this many picture diagonals away; see MarchScale().
const double MarchCapDiagonals = 1.5;

/// Where a light stands in the world, and what it looks at.
void GetWorldPoints(vtkLight* light, vtkCamera* camera, double position[4], double focalPoint[4])
{
  position[3] = focalPoint[3] = 1.0;
  if (light->LightTypeIsHeadlight())
  {
    camera->GetPosition(position);
    camera->GetFocalPoint(focalPoint);
  }
  else if (light->LightTypeIsCameraLight())
  {
    // as vtkRenderer does for its own lights; this one may be none of them
    vtkMatrix4x4* matrix = camera->GetCameraLightTransformMatrix();
    light->GetPosition(position);
    light->GetFocalPoint(focalPoint);
    matrix->MultiplyPoint(position, position);
    matrix->MultiplyPoint(focalPoint, focalPoint);
  }
  else
  {
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focalPoint);
  }
}

/// Where a light stands in the world (w = 1), or in which direction it lies (w = 0): a vector of length 1, or
/// 0 if that is nowhere.
void GetWorldPlace(
  vtkLight* light, const double position[3], const double focalPoint[3], double place[4])
{
  std::copy_n(position, 3, place);
  place[3] = 1.0;
  if (!light->GetPositional())
  {
    // Halves and quotients: the squares of large numbers are not finite.
    double largest = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      place[i] = 0.5 * position[i] - 0.5 * focalPoint[i];
      largest = std::max(largest, std::abs(place[i]));
    }
    for (int i = 0; i < 3 && largest > 0.0; ++i)
    {
      place[i] /= largest;
    }
    vtkMath::Normalize(place);
    place[3] = 0.0;
  }
}
}

void vtkGodRaysSetLightAboveAir(vtkLight* light, const double above[3], const double sky[3])
{
  vtkNew<vtkInformation> note;
  if (vtkInformation* former = light->GetInformation())
  {
    note->Copy(former);
  }
  const double* color = light->GetDiffuseColor();
  const double values[10] = { above[0], above[1], above[2], color[0], color[1], color[2],
    light->GetIntensity(), sky[0], sky[1], sky[2] };
  note->Set(GetAboveAirKey(), values, 10);
  light->SetInformation(note);
}

bool vtkGodRaysGetLightAboveAir(vtkLight* light, double above[3], double sky[3])
{
  vtkInformation* note = light->GetInformation();
  const double* values = note ? note->Get(GetAboveAirKey()) : nullptr;
  if (!values || !std::equal(values + 3, values + 6, light->GetDiffuseColor()))
  {
    return false;
  }
  for (int c = 0; c < 3; ++c)
  {
    const double part = values[6] > 0.0 ? light->GetIntensity() / values[6] : 1.0;
    above[c] = part * values[c];
    if (sky)
    {
      sky[c] = part * values[7 + c];
    }
  }
  return true;
}

void vtkGodRaysLightFinder::Clear()
{
  this->Plan.clear();
  this->Faults.clear();
  this->FaultOfScene.clear();
}

void vtkGodRaysLightFinder::Find(const vtkGodRaysView& view,
  const std::vector<vtkSmartPointer<vtkLight>>& lights, std::vector<vtkGodRaysLight>& found)
{
  this->Clear();
  found.clear();
  int number = 0;
  for (vtkLight* light : lights)
  {
    vtkGodRaysLight seen;
    seen.Kind = light->GetPositional() ? "positional" : "directional";
    seen.Number = number++;
    double position[4];
    double focalPoint[4];
    GetWorldPoints(light, this->Renderer->GetActiveCamera(), position, focalPoint);
    const std::string fault = vtkGodRaysGate::FindFault(light, position, focalPoint);
    if (light->GetSwitch() && !fault.empty())
    {
      this->LeaveOut(seen, fault);
      continue;
    }
    double place[4];
    GetWorldPlace(light, position, focalPoint, place);
    if (light->GetSwitch() && !light->GetPositional() && !(vtkMath::Norm(place) > 0.0))
    {
      this->Tell(seen, ", skipped: its position is its focal point\n");
      continue;
    }
    double radius = vtkMath::RadiansFromDegrees(this->SunAngularRadius);
    if (light->GetPositional())
    {
      radius = this->SourceRadius > 0.0 ? this->SourceRadius : 0.02 * this->FindDiagonal();
    }
    seen.Place(view, place, radius);
    if (this->LightsMedium)
    {
      seen.Power = this->FindPower(light);
      this->SetSpot(seen, view, light);
    }
    vtkGodRays::Vec3 shown = this->Decode(light->GetDiffuseColor()) * light->GetIntensity();
    double above[3];
    if (this->AboveAir && vtkGodRaysGetLightAboveAir(light, above))
    {
      shown = vtkGodRays::Vec3(above[0], above[1], above[2]);
    }
    this->Add(seen, view, light->GetSwitch() ? shown : vtkGodRays::Vec3(0.0), found);
  }

  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = this->Renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (vtkGodRaysGetRole(prop) != vtkGodRaysRole::LIGHT)
    {
      continue;
    }
    vtkGodRaysLight seen;
    seen.Kind = "prop tagged LIGHT";
    seen.Prop = prop;
    double bounds[6];
    vtkMath::UninitializeBounds(bounds);
    if (const double* own = prop->GetVisibility() ? prop->GetBounds() : nullptr)
    {
      std::copy_n(own, 6, bounds);
    }
    vtkGodRaysCompositor::JoinBounds(this->Compositor, bounds);
    if (!vtkMath::AreBoundsInitialized(bounds))
    {
      this->Tell(seen, ", skipped: it is invisible or has no geometry\n");
      continue;
    }
    if (!vtkGodRaysGate::IsUsable(bounds))
    {
      this->LeaveOut(seen, "its bounds are not finite, or beyond 1e15. Move, scale or hide it");
      continue;
    }
    const vtkBoundingBox box(bounds);
    double place[4] = { 0.0, 0.0, 0.0, 1.0 };
    box.GetCenter(place);
    const double radius = 0.5 * box.GetDiagonalLength();
    seen.Place(view, place, radius);
    seen.Power = vtkMath::Pi() * radius * radius / 3.0; // of a sphere within its bounds
    double color[3] = { 1.0, 1.0, 1.0 };
    if (auto actor = vtkActor::SafeDownCast(prop))
    {
      actor->GetProperty()->GetColor(color);
    }
    this->Add(seen, view, this->Decode(color), found);
  }
  if (this->Plan.empty())
  {
    this->Plan = "light: none; add one with AddLight() or tag a prop LIGHT\n";
  }
}

void vtkGodRaysLightFinder::Tell(const vtkGodRaysLight& seen, const char* what)
{
  this->Plan += "light: ";
  seen.AppendName(this->Plan);
  this->Plan += what;
}

void vtkGodRaysLightFinder::LeaveOut(const vtkGodRaysLight& seen, const std::string& fault)
{
  this->Tell(seen, ", skipped: ");
  this->Plan.append(fault).append("\n");
  this->Faults.push_back("of a light, " + seen.GetName() + ": " + fault);
}

vtkGodRays::Vec3 vtkGodRaysLightFinder::Decode(const double color[3]) const
{
  const vtkGodRays::Vec3 shown(color[0], color[1], color[2]);
  return this->Transfer == vtkGodRaysTransfer::NONE
    ? shown
    : vtkGodRays::DecodeDisplay(shown, this->Transfer == vtkGodRaysTransfer::POWER);
}

void vtkGodRaysLightFinder::Add(vtkGodRaysLight& seen, const vtkGodRaysView& view,
  const vtkGodRays::Vec3& light, std::vector<vtkGodRaysLight>& found)
{
  if (this->LightsMedium)
  {
    seen.Fade = 1.0;
  }
  else
  {
    seen.SetGlow(view, this->BackgroundGlowRadius, this->BackgroundGlowFalloff);
    this->SetMarch(seen, view);
  }
  double greatest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    seen.Color[i] = vtkGodRays::Sanitize(seen.Fade * light[i], std::numeric_limits<float>::max());
    greatest = std::max(greatest, seen.Color[i]);
  }
  vtkGodRaysGate::Limit(seen);
  if (seen.Fade <= 0.0)
  {
    this->Tell(seen, ", skipped: behind the camera\n");
  }
  else if (!(greatest > 0.0) && !seen.Prop)
  {
    this->Tell(seen, ", skipped: off or black\n");
  }
  else if (!this->LightsMedium && !seen.Reaches(view, this->BackgroundGlow > 0.0))
  {
    this->Tell(seen, ", skipped: neither it nor its glow can be in the picture\n");
  }
  else
  {
    this->Tell(seen, seen.Fade < 1.0 ? ", fading behind the camera\n" : "\n");
    found.push_back(std::move(seen));
  }
}

// Where a light's shafts start, and how far they are marched.
void vtkGodRaysLightFinder::SetMarch(vtkGodRaysLight& seen, const vtkGodRaysView& view) const
{
  // Parallel rays have no point to lead to: they lead as far as to the point of a perspective
  // view, so that the shafts of a sun that crosses the direction of view shrink and grow again.
  const double distance =
    seen.Planar || !view.Parallel ? seen.Clip[2] : seen.GetPerspectiveDistance(view);
  const glm::dvec3 clip(seen.Clip[0], seen.Clip[1], distance);
  const double diagonal = 2.0 * std::hypot(view.Aspect, 1.0);
  const bool capped = this->CapsMarch || view.Parallel;
  const double cap = capped ? MarchCapDiagonals * diagonal * view.ViewScale * this->Tiles
                            : std::numeric_limits<float>::max();
  seen.MarchScale = vtkGodRays::MarchScale(clip, view.Aspect, cap);
  if (!capped && seen.Clip[2] <= 0.0)
  {
    seen.Fade = 0.0; // a published march ends where the light stops being before the camera
  }
}

// Of what is visible; 50 if nothing is, or it cannot be used.
double vtkGodRaysLightFinder::FindDiagonal()
{
  this->FaultOfScene = this->Scene->GetFault();
  return this->FaultOfScene.empty() && vtkMath::AreBoundsInitialized(this->Scene->GetBounds())
    ? this->Scene->GetDiagonal()
    : 50.0;
}

// As VTK shades: from 90 degrees on there is no cone.
void vtkGodRaysLightFinder::SetSpot(
  vtkGodRaysLight& seen, const vtkGodRaysView& view, vtkLight* light) const
{
  if (!light->GetPositional() || !(light->GetConeAngle() < 90.0))
  {
    return;
  }
  double position[4];
  double focalPoint[4];
  GetWorldPoints(light, this->Renderer->GetActiveCamera(), position, focalPoint);
  double axis[3];
  vtkMath::Subtract(focalPoint, position, axis);
  if (vtkMath::Normalize(axis) > 0.0)
  {
    for (int i = 0; i < 3; ++i)
    {
      seen.Spot.Axis[i] = vtkMath::Dot(view.WorldToView + 4 * i, axis);
    }
    seen.Spot.CosCone =
      std::cos(vtkMath::RadiansFromDegrees(std::max(light->GetConeAngle(), 1e-3)));
    seen.Spot.Exponent = light->GetExponent();
  }
}

// See vtkGodRaysMediumModel.
double vtkGodRaysLightFinder::FindPower(vtkLight* light)
{
  if (!light->GetPositional())
  {
    return vtkMath::Pi();
  }
  const double falloff = light->GetAttenuationValues()[2];
  const double reference = 0.5 * this->FindDiagonal();
  return vtkMath::Pi() * (falloff > 0.0 ? 1.0 / falloff : reference * reference);
}
