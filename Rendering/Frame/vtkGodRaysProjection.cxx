// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysProjection.h"

#include "vtkGodRaysView.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
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
}

//------------------------------------------------------------------------------
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
  renderer->SetActiveCamera(standIn);
}

//------------------------------------------------------------------------------
vtkGodRaysProjection::~vtkGodRaysProjection()
{
  static_cast<StandIn*>(this->Renderer->GetActiveCamera())->Original = nullptr;
  this->Renderer->SetActiveCamera(this->Camera);
}
