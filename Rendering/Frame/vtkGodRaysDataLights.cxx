// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysDataLights.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// Tuned on 23 data sets. Both lights on plain surfaces, over VTK's headlight at 0.96, keep the mean
// lightness within -3 and 6 L* of that under the whole headlight, and colours within a mean dE of 9.
constexpr double PlainKey = 0.11;
constexpr double PlainRim = 0.18;
constexpr double ColoredRim = 0.12; // 0.2 alone changes colours by dE 3 to 4
// The sun's colour (1, 0.89, 0.71), mixed with white, 0.3 to 0.7: its full colour would turn hues.
constexpr double Color[3] = { 1.0, 0.967, 0.913 };
constexpr double KeyTowardsEye = 0.55;  // cosines of the angles from the direction to the eye
constexpr double RimTowardsEye = -0.09; // 95 degrees
// The intensity of a copy is at most this: the renderer's own light adds to it, and 1 would bleach surfaces.
constexpr double MostOfSun = 0.6;
constexpr double UpBias = 0.02; // sun straight behind the middle of the picture: its side is up

/// Returns the intensity of the rim light that a prop bears. A volume bears none: with a second light VTK
/// shades it in another way, 4 L* darker. Composite data count as coloured if their mapper may colour them.
double GetRim(vtkProp* part)
{
  auto actor = vtkActor::SafeDownCast(part);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  if (!mapper)
  {
    return part->IsA("vtkVolume") ? 0.0 : PlainRim;
  }
  part->GetBounds(); // updates the mapper's input
  int ofCells = 0;
  const bool isColored = actor->GetTexture() || actor->GetProperty()->GetNumberOfTextures() > 0 ||
    (mapper->GetScalarVisibility() &&
      (!mapper->GetInput() ||
        vtkAbstractMapper::GetScalars(mapper->GetInput(), mapper->GetScalarMode(),
          mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), ofCells)));
  return isColored ? ColoredRim : PlainRim;
}

double FindRim(vtkRenderer* renderer)
{
  double rim = PlainRim;
  vtkCollectionSimpleIterator cookie;
  renderer->GetViewProps()->InitTraversal(cookie);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(cookie))
  {
    prop->InitPathTraversal();
    vtkAssemblyPath* path = prop->GetVisibility() ? prop->GetNextPath() : nullptr;
    for (; path; path = prop->GetNextPath())
    {
      vtkProp* part = path->GetLastNode()->GetViewProp();
      rim = part->GetVisibility() ? std::min(rim, GetRim(part)) : rim;
    }
  }
  return rim;
}

/// Moves a sun to an elevation of 25 degrees at least, where it is lower.
void Raise(const double viewUp[3], const double target[3], double place[3])
{
  const double least = 0.4226; // the sine
  double up[3] = { viewUp[0], viewUp[1], viewUp[2] };
  double toSun[3];
  vtkMath::Normalize(up);
  vtkMath::Subtract(place, target, toSun);
  vtkMath::Normalize(toSun);
  const double rise = vtkMath::Dot(toSun, up);
  const double across = std::sqrt(std::max(1.0 - rise * rise, 1e-12));
  for (int i = 0; i < 3 && rise < least; ++i)
  {
    const double level = (toSun[i] - rise * up[i]) / across;
    place[i] = target[i] + std::sqrt(1.0 - least * least) * level + least * up[i];
  }
}

/// Makes VTK's headlight, which it makes only for a renderer without lights.
void KeepHeadlight(vtkRenderer* renderer)
{
  if (renderer->GetLights()->GetNumberOfItems() == 0 && renderer->GetAutomaticLightCreation())
  {
    renderer->CreateLight();
  }
}

void Place(
  vtkLight* light, vtkMatrix4x4* toView, const double side[2], double towardsEye, double intensity)
{
  const double across = std::sqrt(1.0 - towardsEye * towardsEye);
  double world[3];
  for (int i = 0; i < 3; ++i)
  {
    world[i] = across * (side[0] * toView->GetElement(0, i) + side[1] * toView->GetElement(1, i)) +
      towardsEye * toView->GetElement(2, i);
  }
  light->SetPosition(world);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetDiffuseColor(Color[0], Color[1], Color[2]);
  light->SetSpecularColor(0.0, 0.0, 0.0); // highlights would bleach the colours of data
  light->SetIntensity(intensity);
}
}

void vtkGodRaysDataLights::Update(vtkRenderer* renderer, const double sunDirection[3])
{
  if (renderer != this->Renderer)
  {
    this->Remove();
    this->Renderer = renderer;
  }
  const double rim = FindRim(renderer);
  vtkMatrix4x4* toView = renderer->GetActiveCamera()->GetModelViewTransformMatrix();
  double sun[4] = { sunDirection[0], sunDirection[1], sunDirection[2], 0.0 };
  toView->MultiplyPoint(sun, sun);
  sun[1] += UpBias;
  const double length = std::max(std::hypot(sun[0], sun[1]), 1e-9);
  const double side[2] = { sun[0] / length, sun[1] / length };
  Place(this->Key, toView, side, KeyTowardsEye, rim < PlainRim ? 0.0 : PlainKey);
  Place(this->Rim, toView, side, RimTowardsEye, rim);
  KeepHeadlight(renderer);
  for (vtkLight* light : { this->Key.Get(), this->Rim.Get() })
  {
    // VTK 9.1 confuses lights in volumes if one of them is switched off.
    const bool isOn = light->GetIntensity() > 0.0;
    const bool isThere = renderer->GetLights()->IsItemPresent(light) != 0;
    if (isOn != isThere)
    {
      isOn ? renderer->AddLight(light) : renderer->RemoveLight(light);
    }
  }
}

void vtkGodRaysDataLights::Remove()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveLight(this->Key);
    this->Renderer->RemoveLight(this->Rim);
    this->Renderer = nullptr;
  }
}

void vtkGodRaysDataLights::Shine(
  vtkRenderer* renderer, const std::vector<vtkSmartPointer<vtkLight>>& lights, vtkLight* placed)
{
  std::vector<vtkLight*> lacking;
  for (vtkLight* light : lights)
  {
    if (!renderer->GetLights()->IsItemPresent(light))
    {
      lacking.push_back(light);
    }
  }
  while (
    !this->Suns.empty() && (this->Suns.size() > lacking.size() || this->SunsRenderer != renderer))
  {
    if (this->SunsRenderer)
    {
      this->SunsRenderer->RemoveLight(this->Suns.back());
    }
    this->Suns.pop_back();
  }
  this->SunsRenderer = renderer;
  for (std::size_t i = 0; i < lacking.size(); ++i)
  {
    if (i == this->Suns.size())
    {
      KeepHeadlight(renderer);
      this->Suns.push_back(vtkSmartPointer<vtkLight>::New());
      renderer->AddLight(this->Suns.back());
    }
    vtkLight* sun = this->Suns[i];
    double place[3];
    double target[3];
    lacking[i]->GetTransformedPosition(place);
    lacking[i]->GetTransformedFocalPoint(target);
    if (lacking[i] == placed && !placed->GetPositional())
    {
      Raise(renderer->GetActiveCamera()->GetViewUp(), target, place);
    }
    sun->SetPosition(place);
    sun->SetFocalPoint(target);
    sun->SetPositional(lacking[i]->GetPositional());
    sun->SetConeAngle(lacking[i]->GetConeAngle());
    sun->SetExponent(lacking[i]->GetExponent());
    sun->SetDiffuseColor(lacking[i]->GetDiffuseColor());
    sun->SetSpecularColor(0.0, 0.0, 0.0); // highlights would bleach the colours of data
    sun->SetSwitch(lacking[i]->GetSwitch());
    sun->SetIntensity(std::min(lacking[i]->GetIntensity(), MostOfSun));
  }
}
