// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSortedProps.h"

#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysProjection.h"
#include "vtkGodRaysRole.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

namespace
{
/// Call a function with each prop that is drawn with the scene, and its role.
template <typename Visit>
void ForEachDrawn(const vtkGodRaysOcclusionPass::Request& request, const Visit& visit)
{
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = request.Renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (!prop->GetVisibility() || vtkGodRaysIsOverlay(prop) ||
      vtkGodRaysProjection::IsUndrawnBillboard(prop))
    {
      continue;
    }
    vtkGodRaysRole role = vtkGodRaysGetRole(prop);
    if (role == vtkGodRaysRole::MEDIUM)
    {
      if (!request.Dims)
      {
        continue; // it is not drawn among the props
      }
      role = vtkGodRaysRole::AUTOMATIC;
    }
    visit(prop, role);
  }
}

bool IsTranslucent(vtkProp* prop)
{
  return prop->HasTranslucentPolygonalGeometry() || vtkGodRaysHasVolume(prop);
}
}

void vtkGodRaysSortedProps::Sort(const vtkGodRaysOcclusionPass::Request& request)
{
  this->OccludingProps.clear();
  this->Dimming.clear();
  this->NotOccluding = 0;
  this->Emitters = 0;
  this->Labels = false;
  ForEachDrawn(request,
    [&](vtkProp* prop, vtkGodRaysRole role)
    {
      if (role == vtkGodRaysRole::IGNORED ||
        (role == vtkGodRaysRole::LIGHT && !request.LampsOcclude) ||
        (role == vtkGodRaysRole::AUTOMATIC && !request.UntaggedPropsOcclude))
      {
        ++this->NotOccluding;
        return;
      }
      this->OccludingProps.push_back(prop);
      this->Labels = this->Labels || prop->IsA("vtkAxesActor"); // of a module that we do not need
      this->Emitters += role == vtkGodRaysRole::LIGHT ? 1 : 0;
      if (request.Dims && role != vtkGodRaysRole::LIGHT && IsTranslucent(prop))
      {
        this->Dimming.push_back(prop);
      }
    });
}

bool vtkGodRaysSortedProps::SceneDepthServes(const vtkGodRaysOcclusionPass::Request& request) const
{
  vtkGodRaysCompositor* compositor = request.Compositor;
  if (compositor && compositor->IsDistributed())
  {
    // It does on one process alone; translucent parts and emitters need it on all of them.
    const bool own =
      this->NotOccluding > 0 || this->Emitters > 0 || this->Labels || !this->Dimming.empty();
    return !vtkGodRaysCompositor::Any(compositor, own || !compositor->HasDepth()) &&
      request.Margin == 0.0;
  }
  return request.Margin == 0.0 && this->NotOccluding == 0 && !this->Labels;
}

void vtkGodRaysSortedProps::FindShown(
  const vtkGodRaysOcclusionPass::Request& request, std::vector<vtkProp*>& shown)
{
  shown.clear();
  ForEachDrawn(request,
    [&](vtkProp* prop, vtkGodRaysRole)
    {
      if (IsTranslucent(prop))
      {
        shown.push_back(prop);
      }
    });
}
