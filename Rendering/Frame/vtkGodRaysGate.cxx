// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGate.h"

#include "vtkCamera.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysView.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>

namespace
{
const double MostProjected =
  1e30;                        // scene units for one of clip coordinates: of a near plane at 1e-30
const double Thinnest = 1e-12; // of what has a width, in parts of its length
const double BrightestColor = 1e9;
const double BrightestPower = 1e30;

bool AreWithin(const double* values, int count, double largest)
{
  return std::all_of(
    values, values + count, [=](double value) { return std::abs(value) <= largest; }); // not NaN
}

/// A member of a camera or a light.
struct Member
{
  const char* Name;
  const double* Values;
  int Count;
};

std::string FindMember(const char* whose, std::initializer_list<Member> members, double largest)
{
  for (const Member& member : members)
  {
    if (!AreWithin(member.Values, member.Count, largest))
    {
      std::ostringstream text;
      text << whose << member.Name << " is not finite, or beyond " << largest
           << ". Set one that is within that";
      return text.str();
    }
  }
  return "";
}

/// Whether a world has three directions in a view, and a picture a width and a height.
bool IsUsable(const vtkGodRaysView& view)
{
  const double* toView = view.WorldToView;
  if (!AreWithin(toView, 16, vtkGodRaysGate::Largest) ||
    !AreWithin(view.CameraToView, 16, vtkGodRaysGate::Largest) ||
    !AreWithin(view.ViewToClip, 16, vtkGodRaysGate::Largest) ||
    !AreWithin(view.ClipToView, 16, MostProjected) || !(view.Aspect > 0.0))
  {
    return false;
  }
  const double lengths[3] = { vtkMath::Norm(toView), vtkMath::Norm(toView + 4),
    vtkMath::Norm(toView + 8) };
  const double volume = vtkMath::Determinant3x3(toView, toView + 4, toView + 8);
  if (!(std::min({ lengths[0], lengths[1], lengths[2] }) > Thinnest) ||
    !(std::abs(volume) > Thinnest * lengths[0] * lengths[1] * lengths[2]))
  {
    return false;
  }
  double origin[3];
  double right[3];
  double up[3];
  double across[3];
  view.GetPicture(view.Parallel, origin, right, up);
  vtkMath::Cross(right, up, across);
  const double most = vtkMath::Norm(right) * vtkMath::Norm(up);
  double ray[3];
  view.GetRay(0.0, 0.0, ray);
  return vtkMath::Norm(across) > Thinnest * most && vtkMath::Norm(ray) > 0.5;
}

/// Of a picture in pixels, so much enlarged by a margin, where textures have so many pixels at most.
std::string FindFaultOfSize(const int size[2], double enlarged, int largest)
{
  if (std::max(size[0], size[1]) * enlarged < largest + 0.5)
  {
    return "";
  }
  // Without its size, so that it is told once of a window that is resized.
  std::ostringstream text;
  text << "the picture" << (enlarged > 1.0 ? ", with its LayerMargin," : "") << " is beyond the "
       << largest << " pixels of a texture here. Set a smaller "
       << (enlarged > 1.0 ? "LayerMargin or window" : "window");
  return text.str();
}
}

std::string vtkGodRaysGate::FindFault(
  vtkRenderer* renderer, const vtkGodRaysView& view, const int size[2])
{
  if (::IsUsable(view))
  {
    auto window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    return FindFaultOfSize(
      size, 1.0 / view.ViewScale, vtkTextureObject::GetMaximumTextureSize(window));
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* range = camera->GetClippingRange();
  const double angle = camera->GetViewAngle();
  const double parallelScale = camera->GetParallelScale();
  const std::string fault = FindMember("the camera's ",
    { { "Position", camera->GetPosition(), 3 }, { "FocalPoint", camera->GetFocalPoint(), 3 },
      { "ViewUp", camera->GetViewUp(), 3 }, { "ViewAngle", &angle, 1 },
      { "ClippingRange", range, 2 }, { "ParallelScale", &parallelScale, 1 },
      { "WindowCenter", camera->GetWindowCenter(), 2 }, { "ViewShear", camera->GetViewShear(), 3 },
      { "ModelTransformMatrix", camera->GetModelTransformMatrix()->GetData(), 16 } },
    Largest);
  if (!fault.empty())
  {
    return fault;
  }
  if (!(range[0] < range[1]))
  {
    return "the camera's ClippingRange is empty. Set one whose end is beyond its beginning, as "
           "ResetCameraClippingRange() does";
  }
  if (!(camera->GetDistance() > 1e-20)) // to which vtkCamera makes it from less
  {
    return "the camera's Position is its FocalPoint. Move one of them";
  }
  double sideways[3];
  vtkMath::Cross(camera->GetDirectionOfProjection(), camera->GetViewUp(), sideways);
  if (!(vtkMath::Norm(sideways) > 0.0))
  {
    return "the camera's ViewUp is along its direction of view. Set another";
  }
  return "the camera's picture has no width, or one of its matrices cannot be inverted. Set "
         "another ViewAngle, "
         "ParallelScale or matrix";
}

std::string vtkGodRaysGate::FindFault(
  vtkLight* light, const double position[3], const double focalPoint[3])
{
  const double intensity = light->GetIntensity();
  const double cone = light->GetConeAngle();
  const double exponent = light->GetExponent();
  const std::string fault = FindMember("its ",
    { { "Position", position, 3 }, { "FocalPoint", focalPoint, 3 }, { "Intensity", &intensity, 1 },
      { "DiffuseColor", light->GetDiffuseColor(), 3 }, { "ConeAngle", &cone, 1 },
      { "Exponent", &exponent, 1 }, { "AttenuationValues", light->GetAttenuationValues(), 3 } },
    VTK_DOUBLE_MAX);
  return !fault.empty() || !light->GetPositional()
    ? fault
    : FindMember("its ", { { "Position", position, 3 } }, Largest);
}

std::string vtkGodRaysGate::FindFault(const vtkGodRaysMedium& medium, const vtkGodRaysView& view)
{
  if (!(medium.FarLimit > 0.0 && medium.FarLimit <= Largest))
  {
    return "the medium ends at the eye, or nowhere. Set a FarLimit, or the camera's ClippingRange";
  }
  if (view.Parallel && !(view.GetPictureHeight() > Thinnest * medium.FarLimit))
  {
    return "the picture is too small for the depth of the medium. Set a larger ParallelScale, or a "
           "smaller "
           "FarLimit";
  }
  bool isWithin = AreWithin(medium.Up, 3, 2.0) && std::abs(medium.EyeHeight) <= Largest &&
    medium.PlanetRadius <= Largest;
  for (int k = 0; k < medium.NumberOfComponents; ++k)
  {
    isWithin = isWithin && medium.Components[k].ScaleHeight <= Largest;
  }
  return isWithin
    ? ""
    : "the medium's heights are beyond 1e15 scene units. Set WorldUnitInMeters, GroundLevel, "
      "PlanetRadius or the scale heights for the size of the scene";
}

std::string vtkGodRaysGate::FindBounds(
  vtkRenderer* renderer, vtkGodRaysCompositor* compositor, double bounds[6])
{
  renderer->ComputeVisiblePropBounds(bounds);
  vtkGodRaysCompositor::JoinBounds(compositor, bounds);
  if (!vtkMath::AreBoundsInitialized(bounds) || IsUsable(bounds))
  {
    return "";
  }
  std::string name = "prop";
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    const double* own = prop->GetVisibility() && prop->GetUseBounds() ? prop->GetBounds() : nullptr;
    if (own && vtkMath::AreBoundsInitialized(own) && !IsUsable(own))
    {
      name = prop->GetClassName();
    }
  }
  return "the bounds of a " + name +
    " are not finite, or beyond 1e15. Move, scale or hide it, or switch its UseBounds off";
}

bool vtkGodRaysGate::IsUsable(const double bounds[6])
{
  return AreWithin(bounds, 6, Largest);
}

void vtkGodRaysGate::Limit(vtkGodRaysLight& light)
{
  light.Power = std::min(light.Power, BrightestPower);
  for (double& color : light.Color)
  {
    color = std::min(color, BrightestColor);
  }
}
