// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowState.h"

#include "vtkActor.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysShadowFaces.h"
#include "vtkGodRaysVolumeHaze.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProp.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace
{
/// Add what an actor's depths depend on. False if VTK does not tell: of parts, of pieces, of what turns
/// to the camera or has holes of its own.
bool AddState(vtkProp* prop, std::vector<const void*>& objects, std::vector<double>& numbers)
{
  auto actor = vtkActor::SafeDownCast(prop);
  if (!actor || std::strcmp(actor->GetClassName(), "vtkOpenGLActor") != 0 || actor->GetTexture() ||
    !actor->GetMapper() ||
    std::strcmp(actor->GetMapper()->GetClassName(), "vtkOpenGLPolyDataMapper") != 0)
  {
    return false;
  }
  vtkShaderProperty* shader = actor->GetShaderProperty();
  objects.push_back(actor);
  const vtkMTimeType times[] = { actor->GetRedrawMTime(), actor->GetUserTransformMatrixMTime(),
    shader->GetShaderMTime(), shader->GetVertexCustomUniforms()->GetMTime(),
    shader->GetGeometryCustomUniforms()->GetMTime(),
    shader->GetFragmentCustomUniforms()->GetMTime() };
  numbers.insert(numbers.end(), std::begin(times), std::end(times));
  vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    objects.push_back(planes->GetItem(i)); // whose changes the actor's time does not tell
    numbers.push_back(static_cast<double>(planes->GetItem(i)->GetMTime()));
  }
  return true;
}
}

// Nothing, if another frame cannot be told to be the same.
void vtkGodRaysShadowState::Find(const vtkGodRaysMediumIntegrator::Request& request,
  const vtkGodRaysShadowFaces& faces, const void* map, bool translucent)
{
  this->Clear();
  if (request.Compositor && request.Compositor->IsDistributed())
  {
    return; // the others would have to agree
  }
  this->Objects = { request.Window, request.Renderer, map };
  this->Numbers = { faces.Size + 0.0, faces.Count + 0.0, translucent + 0.0 };
  for (int face = 0; face < faces.Count; ++face)
  {
    for (const double* corner : faces.Corners)
    {
      const double view[4] = { corner[0], corner[1], corner[2], 1.0 };
      double place[4];
      vtkMatrix4x4::MultiplyPoint(faces.ViewToMap[face], view, place);
      this->Places.insert(this->Places.end(), place, place + 4);
    }
  }
  this->End();
  for (vtkProp* prop : *request.Occluders)
  {
    if (vtkVolume* volume = vtkGodRaysVolumeHaze::GetVolume(prop))
    {
      vtkGodRaysVolumeHaze::AddState(volume, this->Objects, this->Numbers);
    }
    else if (!AddState(prop, this->Objects, this->Numbers))
    {
      this->Clear();
      return;
    }
    this->End();
  }
}

void vtkGodRaysShadowState::Clear()
{
  this->Objects.clear();
  this->Numbers.clear();
  this->Places.clear();
  this->Ends.clear();
}

bool vtkGodRaysShadowState::IsSame(const vtkGodRaysShadowState& other) const
{
  return this->Objects == other.Objects && this->Numbers == other.Numbers &&
    this->HasSameFaces(other);
}

// And as many props.
bool vtkGodRaysShadowState::HasSameFaces(const vtkGodRaysShadowState& other) const
{
  if (this->Ends.empty() || this->Ends.size() != other.Ends.size() ||
    this->Ends[0] != other.Ends[0])
  {
    return false;
  }
  double largest = 0.0;
  for (const double place : this->Places)
  {
    largest = std::max(largest, std::abs(place));
  }
  return std::equal(this->Objects.begin(), this->Objects.begin() + this->Ends[0][0],
           other.Objects.begin()) &&
    std::equal(
      this->Numbers.begin(), this->Numbers.begin() + this->Ends[0][1], other.Numbers.begin()) &&
    std::equal(this->Places.begin(), this->Places.end(), other.Places.begin(), other.Places.end(),
      [=](double one, double two) { return std::abs(one - two) <= 1e-9 * largest; });
}

bool vtkGodRaysShadowState::HasSameProp(const vtkGodRaysShadowState& other, std::size_t prop) const
{
  const auto isSame = [&](const auto& own, const auto& others, int kind)
  {
    return std::equal(own.begin() + this->Ends[prop][kind],
      own.begin() + this->Ends[prop + 1][kind], others.begin() + other.Ends[prop][kind],
      others.begin() + other.Ends[prop + 1][kind]);
  };
  return isSame(this->Objects, other.Objects, 0) && isSame(this->Numbers, other.Numbers, 1);
}
