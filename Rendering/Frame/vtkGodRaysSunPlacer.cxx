// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSunPlacer.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkGodRaysSilhouette.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkGodRaysSunPlacer);

namespace
{
/// Where a place of the picture is on the near and the far plane, in homogeneous world coordinates.
bool GetSight(vtkCamera* camera, double aspect, double x, double y, double ends[2][4])
{
  if (!(aspect > 0.0))
  {
    return false;
  }
  vtkNew<vtkMatrix4x4> toWorld;
  vtkMatrix4x4::Invert(camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0), toWorld);
  for (int i = 0; i < 2; ++i)
  {
    const double point[4] = { 2.0 * x - 1.0, 2.0 * y - 1.0, i == 0 ? -1.0 : 1.0, 1.0 };
    toWorld->MultiplyPoint(point, ends[i]);
  }
  return ends[0][3] != 0.0;
}

double GetAspect(vtkRenderer* renderer)
{
  const double aspect = renderer->GetTiledAspectRatio();
  return std::isfinite(aspect) && aspect > 0.0 ? aspect : 1.0;
}
}

//------------------------------------------------------------------------------
bool vtkGodRaysSunPlacer::Find(vtkRenderer* renderer, vtkGodRaysCompositor* compositor)
{
  if (!renderer)
  {
    vtkErrorMacro("Find needs a vtkRenderer, not null; nothing is changed.");
    return false;
  }
  return this->Find(vtkGodRaysSilhouette(
    renderer->GetViewProps(), renderer->GetActiveCamera(), GetAspect(renderer), compositor));
}

//------------------------------------------------------------------------------
bool vtkGodRaysSunPlacer::Find(vtkPropCollection* props, vtkCamera* camera, double aspect)
{
  if (!props || !camera || !(aspect > 0.0) || !std::isfinite(aspect))
  {
    vtkErrorMacro("Find needs props, a camera, and a ratio of width to height above 0; nothing is "
                  "changed.");
    return false;
  }
  return this->Find(vtkGodRaysSilhouette(props, camera, aspect));
}

//------------------------------------------------------------------------------
bool vtkGodRaysSunPlacer::Find(const vtkGodRaysSilhouette& silhouette)
{
  const vtkGodRaysSilhouette::Place best = silhouette.FindSun(this->Lowest);
  this->Place[0] = best.X;
  this->Place[1] = best.Y;
  this->Score = best.Score;
  this->Coverage = silhouette.GetCoveredFraction();
  silhouette.GetCoveredBounds(this->CoveredBounds);
  return best.Score > 0.0;
}

//------------------------------------------------------------------------------
bool vtkGodRaysSunPlacer::GetDirection(
  vtkRenderer* renderer, double x, double y, double direction[3])
{
  return renderer &&
    GetDirection(renderer->GetActiveCamera(), GetAspect(renderer), x, y, direction);
}

//------------------------------------------------------------------------------
bool vtkGodRaysSunPlacer::GetDirection(
  vtkCamera* camera, double aspect, double x, double y, double direction[3])
{
  double ends[2][4];
  if (!camera || !GetSight(camera, aspect, x, y, ends))
  {
    return false;
  }
  double way[3];
  for (int i = 0; i < 3; ++i)
  {
    way[i] = ends[1][i] * ends[0][3] - ends[0][i] * ends[1][3];
  }
  if (!std::isfinite(way[0] + way[1] + way[2]) || !(vtkMath::Normalize(way) > 0.0))
  {
    return false;
  }
  // Points in front of the eye have weights of one sign: a far plane beyond infinity turns it around.
  const double sign = ends[0][3] * ends[1][3] < 0.0 ? -1.0 : 1.0;
  std::transform(way, way + 3, direction, [sign](double value) { return sign * value; });
  return true;
}

//------------------------------------------------------------------------------
bool vtkGodRaysSunPlacer::GetPosition(vtkRenderer* renderer, double x, double y, double position[3])
{
  double direction[3];
  double ends[2][4];
  if (!GetDirection(renderer, x, y, direction) ||
    !GetSight(renderer->GetActiveCamera(), GetAspect(renderer), x, y, ends))
  {
    return false;
  }
  double bounds[6];
  renderer->ComputeVisiblePropBounds(bounds);
  vtkBoundingBox box(bounds);
  if (!box.IsValid())
  {
    box.SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  }
  double start[3];
  double farthest = -VTK_DOUBLE_MAX;
  for (int i = 0; i < 3; ++i)
  {
    start[i] = ends[0][i] / ends[0][3];
  }
  for (int i = 0; i < 8; ++i)
  {
    double corner[3];
    box.GetCorner(i, corner);
    vtkMath::Subtract(corner, start, corner);
    farthest = std::max(farthest, vtkMath::Dot(corner, direction));
  }
  for (int i = 0; i < 3; ++i)
  {
    position[i] = start[i] + (farthest + box.GetDiagonalLength()) * direction[i];
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkGodRaysSunPlacer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lowest: " << this->Lowest << "\n";
  os << indent << "Place: " << this->Place[0] << " " << this->Place[1] << "\n";
  os << indent << "Score: " << this->Score << "\n";
  os << indent << "Coverage: " << this->Coverage << "\n";
  os << indent << "CoveredBounds: " << this->CoveredBounds[0] << " " << this->CoveredBounds[1]
     << " " << this->CoveredBounds[2] << " " << this->CoveredBounds[3] << "\n";
}
