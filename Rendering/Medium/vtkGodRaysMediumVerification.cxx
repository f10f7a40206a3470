// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysMediumVerification.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAppendPolyData.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkClipPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkGodRaysLightLayers.h"
#include "vtkGodRaysMediumRays.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysVerification.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkMatrix4x4.h"
#include "vtkMatrixToLinearTransform.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTransformFilter.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace
{
/// The surfaces that a mapper draws; empty if it draws others, or nothing.
std::vector<vtkPolyData*> GetSurfaces(vtkMapper* mapper)
{
  std::vector<vtkPolyData*> surfaces;
  const auto add = [&surfaces](vtkDataObject* data)
  {
    if (auto surface = vtkPolyData::SafeDownCast(data))
    {
      surfaces.push_back(surface);
    }
  };
  vtkDataObject* input =
    mapper && mapper->GetNumberOfInputPorts() > 0 && mapper->GetNumberOfInputConnections(0) > 0
    ? mapper->GetInputDataObject(0, 0)
    : nullptr;
  auto composite = vtkCompositeDataSet::SafeDownCast(input);
  if (composite &&
    (mapper->IsA("vtkCompositePolyDataMapper") || mapper->IsA("vtkCompositePolyDataMapper2")))
  {
    auto blocks = vtk::TakeSmartPointer(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      add(blocks->GetCurrentDataObject());
    }
  }
  // Not glyphs or splats, whose class is another one.
  else if (std::string(vtkPolyDataMapper::SafeDownCast(mapper) ? mapper->GetClassName() : "") ==
    "vtkOpenGLPolyDataMapper")
  {
    add(input);
  }
  return surfaces;
}

/// Add what an actor shows, in the world; false if that is no surface.
bool AddActor(vtkActor* actor, vtkMatrix4x4* matrix, vtkAppendPolyData* all)
{
  const auto surfaces = GetSurfaces(actor->GetMapper());
  if (surfaces.empty() || actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return false;
  }
  vtkNew<vtkMatrixToLinearTransform> toWorld;
  toWorld->SetInput(matrix);
  for (vtkPolyData* surface : surfaces)
  {
    vtkNew<vtkTransformFilter> moved;
    moved->SetTransform(toWorld);
    moved->SetInputData(surface);
    vtkSmartPointer<vtkAlgorithm> last = moved.Get();
    vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes();
    for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
    {
      vtkNew<vtkClipPolyData> clip;
      clip->SetClipFunction(planes->GetItem(i));
      clip->SetInputConnection(last->GetOutputPort());
      last = clip.Get();
    }
    last->Update();
    all->AddInputData(vtkPolyData::SafeDownCast(last->GetOutputDataObject(0)));
  }
  return true;
}

/// When what a prop shows changed last.
vtkMTimeType GetTime(vtkProp* prop)
{
  vtkMTimeType time = prop->GetRedrawMTime();
  if (auto prop3D = vtkProp3D::SafeDownCast(prop))
  {
    time = std::max(time, prop3D->GetUserTransformMatrixMTime());
  }
  auto actor = vtkActor::SafeDownCast(prop);
  vtkPlaneCollection* planes =
    actor && actor->GetMapper() ? actor->GetMapper()->GetClippingPlanes() : nullptr;
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    time = std::max(time, planes->GetItem(i)->GetMTime());
  }
  return time;
}
}

int vtkGodRaysMediumVerification::AddOpaque(const std::vector<vtkProp*>& props,
  vtkAppendPolyData* all, const std::function<bool(vtkActor*, vtkMatrix4x4*)>& translucent)
{
  int leftOut = 0;
  for (vtkProp* prop : props)
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      vtkProp* part = node->GetViewProp();
      auto actor = vtkActor::SafeDownCast(part);
      if (!part->GetVisibility())
      {
        continue;
      }
      if (translucent && part->HasTranslucentPolygonalGeometry())
      {
        leftOut += translucent(actor, node->GetMatrix()) ? 0 : 1;
      }
      if (!part->HasOpaqueGeometry())
      {
        leftOut += vtkVolume::SafeDownCast(part) ? 1 : 0;
        continue;
      }
      leftOut += actor && AddActor(actor, node->GetMatrix(), all) ? 0 : 1;
    }
  }
  return leftOut;
}

void vtkGodRaysMediumVerification::TakeOccluders(const std::vector<vtkProp*>& props)
{
  std::vector<std::pair<const void*, vtkMTimeType>> now;
  for (vtkProp* prop : props)
  {
    now.emplace_back(prop, GetTime(prop));
  }
  if (this->HasTaken && now == this->Taken)
  {
    return;
  }
  this->Taken = std::move(now);
  this->HasTaken = true;
  this->Exact.RemoveAllVeils();
  vtkNew<vtkAppendPolyData> all;
  this->LeftOut = AddOpaque(props, all,
    [this](vtkActor* actor, vtkMatrix4x4* matrix) { return this->AddVeil(actor, matrix); });
  if (all->GetNumberOfInputConnections(0) > 0)
  {
    all->Update();
  }
  this->Exact.SetOccluders(all->GetNumberOfInputConnections(0) > 0 ? all->GetOutput() : nullptr);
}

// Of one opacity and colour all over; false if it is not.
bool vtkGodRaysMediumVerification::AddVeil(vtkActor* actor, vtkMatrix4x4* matrix)
{
  vtkNew<vtkAppendPolyData> surface;
  if (!actor || actor->GetTexture() || actor->GetMapper()->IsA("vtkCompositePolyDataMapper") ||
    actor->GetMapper()->IsA("vtkCompositePolyDataMapper2") || !AddActor(actor, matrix, surface) ||
    (actor->GetMapper()->GetScalarVisibility() && actor->GetMapper()->MapScalars(1.0)))
  {
    return false;
  }
  double through[3];
  vtkGodRaysLightLayers::GetThrough(
    actor->GetProperty()->GetColor(), actor->GetProperty()->GetOpacity(), through);
  surface->Update();
  this->Exact.AddVeil(surface->GetOutput(), through);
  return true;
}

void vtkGodRaysMediumVerification::Measure(
  const vtkGodRaysMediumIntegrator::Request& request, vtkGodRaysVerification& verification)
{
  vtkGodRaysTarget* const ends = request.Depths->GetEnds();
  if (!ends)
  {
    return;
  }
  this->TakeOccluders(*request.Occluders);
  this->Exact.SetParameters(vtkGodRaysMediumRays::GetWorldParameters(request));
  const int size[2] = { ends->GetWidth(), ends->GetHeight() };
  std::vector<float> depths(static_cast<std::size_t>(size[0]) * size[1]);
  ends->Read(GL_RED, GL_FLOAT, depths.data(), size[0]);
  const vtkGodRaysMediumRays rays(request, size);
  const vtkGodRaysView::Pinhole pinhole = rays.GetPinhole();
  const int margin[2] = { (size[0] - request.Result->GetWidth()) / 2,
    (size[1] - request.Result->GetHeight()) / 2 };
  verification.Measure(
    [&](int x, int y)
    {
      const int column = x + margin[0];
      const int row = y + margin[1];
      vtkGodRaysSingleScattering::Result ray;
      this->Exact.Evaluate((column + 0.5 - pinhole.Center[0]) * pinhole.PixelSize,
        (row + 0.5 - pinhole.Center[1]) * pinhole.PixelSize, ray,
        depths[static_cast<std::size_t>(row) * size[0] + column]);
      return std::array<double, 3>{ ray.Radiance[0], ray.Radiance[1], ray.Radiance[2] };
    });
}

std::string vtkGodRaysMediumVerification::Describe() const
{
  return this->LeftOut > 0
    ? std::to_string(this->LeftOut) + " props that are no surfaces are left out"
    : "";
}
