// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysProjection.h"

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysView.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

namespace
{
/// A camera that is as old as the one that it stands in for: props that lay themselves out for a camera, when
/// that is newer than their layout, stay as the scene has them.
class StandIn : public vtkOpenGLCamera
{
public:
  static StandIn* New();
  vtkTypeMacro(StandIn, vtkOpenGLCamera);
  vtkCamera* Original = nullptr;
  vtkMTimeType GetMTime() override
  {
    return this->Original ? this->Original->GetMTime() : this->Superclass::GetMTime();
  }
};
vtkStandardNewMacro(StandIn);

/// What a billboard keeps to itself. It lays itself out anew when its renderer has changed, as that does with
/// its camera: for pixels of the picture, which are not those of what the stand-in projects to.
class Billboard : public vtkBillboardTextActor3D
{
public:
  /// As the scene has it.
  static void LayOut(vtkBillboardTextActor3D* text, vtkRenderer* renderer)
  {
    if ((text->*&Billboard::IsValid)() && (text->*&Billboard::QuadIsStale)(renderer))
    {
      (text->*&Billboard::GenerateQuad)(renderer);
    }
  }
  static bool IsUndrawn(vtkBillboardTextActor3D* text) { return !(text->*&Billboard::IsValid)(); }
  /// It stays as it is for the renderer as that is now.
  static void Keep(vtkBillboardTextActor3D* text) { (text->*&Billboard::Quad)->Modified(); }
};

template <typename Do>
void ForBillboards(vtkRenderer* renderer, Do&& act)
{
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (auto text = vtkBillboardTextActor3D::SafeDownCast(prop))
    {
      act(text);
    }
  }
}
}

vtkGodRaysProjection::vtkGodRaysProjection(vtkRenderer* renderer, const vtkGodRaysView& view,
  const double viewToClip[16], vtkSmartPointer<vtkCamera>& standIn)
  : Renderer(renderer)
  , Camera(renderer->GetActiveCamera())
{
  if (!standIn)
  {
    standIn = vtkSmartPointer<StandIn>::New();
  }
  vtkNew<vtkMatrix4x4> projection;
  vtkMatrix4x4::Multiply4x4(viewToClip, view.CameraToView, projection->GetData());
  standIn->DeepCopy(this->Camera);
  standIn->SetUserTransform(nullptr); // the matrix has it
  standIn->SetExplicitProjectionTransformMatrix(projection);
  standIn->UseExplicitProjectionTransformMatrixOn();
  static_cast<StandIn*>(standIn.Get())->Original = this->Camera;
  ForBillboards(
    renderer, [renderer](vtkBillboardTextActor3D* text) { Billboard::LayOut(text, renderer); });
  renderer->SetActiveCamera(standIn);
  ForBillboards(renderer, Billboard::Keep);
}

std::vector<vtkProp*> vtkGodRaysProjection::FindSeen(std::vector<vtkProp*> props) const
{
  vtkNew<vtkFrustumCoverageCuller> culler;
  int count = static_cast<int>(props.size());
  int initialized = 0;
  static_cast<vtkCuller*>(culler)->Cull(this->Renderer, props.data(), count, initialized);
  props.resize(count);
  return props;
}

// Drawn twice, each time with the other faces culled: a change of the property would be one of the scene.
void vtkGodRaysProjection::DrawBothSides(vtkProp* prop, vtkRenderer* renderer)
{
  prop->RenderOpaqueGeometry(renderer);
  auto actor = vtkActor::SafeDownCast(prop);
  if (actor &&
    (actor->GetProperty()->GetBackfaceCulling() || actor->GetProperty()->GetFrontfaceCulling()))
  {
    glFrontFace(GL_CW);
    prop->RenderOpaqueGeometry(renderer);
    glFrontFace(GL_CCW);
  }
}

bool vtkGodRaysProjection::IsUndrawnBillboard(vtkProp* prop)
{
  auto text = vtkBillboardTextActor3D::SafeDownCast(prop);
  return text && Billboard::IsUndrawn(text);
}

vtkGodRaysProjection::~vtkGodRaysProjection()
{
  static_cast<StandIn*>(this->Renderer->GetActiveCamera())->Original = nullptr;
  this->Renderer->SetActiveCamera(this->Camera);
}
