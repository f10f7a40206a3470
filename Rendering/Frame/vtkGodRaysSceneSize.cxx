// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSceneSize.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysGate.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
bool HasBounds(vtkProp* prop)
{
  const double* bounds =
    prop->GetVisibility() && prop->GetUseBounds() ? prop->GetBounds() : nullptr;
  return bounds && vtkMath::AreBoundsInitialized(bounds);
}

double GetDiagonalOf(const double bounds[6])
{
  const vtkBoundingBox box(bounds);
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}

double FindFarDepth(vtkRenderer* renderer, const double bounds[6])
{
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(renderer->GetActiveCamera());
  vtkNew<vtkRenderer> scratch;
  scratch->SetActiveCamera(camera);
  scratch->SetClippingRangeExpansion(renderer->GetClippingRangeExpansion());
  scratch->ResetCameraClippingRange(bounds);
  return camera->GetClippingRange()[1];
}
}

void vtkGodRaysSceneSize::Find(vtkRenderer* renderer, vtkGodRaysCompositor* compositor)
{
  this->Fault = vtkGodRaysGate::FindBounds(renderer, compositor, this->Bounds);
  const bool isThere = std::any_of(this->Props.begin(), this->Props.end(),
    [renderer](vtkProp* prop) { return prop && HasBounds(prop) && renderer->HasViewProp(prop); });
  if (vtkGodRaysCompositor::Any(compositor, isThere) || !this->Fault.empty())
  {
    return;
  }
  std::copy_n(this->Bounds, 6, this->Held);
  this->Props.clear();
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (HasBounds(prop))
    {
      this->Props.emplace_back(prop);
    }
  }
}

double vtkGodRaysSceneSize::GetDiagonal() const
{
  return vtkMath::AreBoundsInitialized(this->Bounds) ? GetDiagonalOf(this->Held) : 0.0;
}

double vtkGodRaysSceneSize::GetFarDepth(vtkRenderer* renderer) const
{
  constexpr double alike = 1e-3; // as a part: nearer than anybody's own plane is by chance
  const double depth = renderer->GetActiveCamera()->GetClippingRange()[1];
  if (!this->Fault.empty() || std::equal(this->Held, this->Held + 6, this->Bounds) ||
    !(std::abs(FindFarDepth(renderer, this->Bounds) - depth) < alike * depth))
  {
    return depth;
  }
  return FindFarDepth(renderer, this->Held);
}

std::string vtkGodRaysSceneSize::Describe() const
{
  constexpr double alike = 0.01;
  const double now = GetDiagonalOf(this->Bounds);
  if (!(std::abs(now - this->GetDiagonal()) > alike * this->GetDiagonal()))
  {
    return "";
  }
  std::ostringstream text;
  text << "size: " << this->GetDiagonal() << " across when brightness was found for it, and " << now
       << " now. ResetSceneSize() finds it anew\n";
  return text.str();
}
