// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysProjection.h"

#include "vtkCamera.h"
#include "vtkGodRaysView.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

//------------------------------------------------------------------------------
vtkGodRaysProjection::vtkGodRaysProjection(vtkRenderer* renderer, const vtkGodRaysView& view,
  const double viewToClip[16], vtkSmartPointer<vtkCamera>& standIn)
  : Renderer(renderer)
  , Camera(renderer->GetActiveCamera())
{
  if (!standIn)
  {
    standIn = vtkSmartPointer<vtkCamera>::New();
  }
  vtkNew<vtkMatrix4x4> projection;
  vtkMatrix4x4::Multiply4x4(viewToClip, view.CameraToView, projection->GetData());
  standIn->DeepCopy(this->Camera);
  standIn->SetUserTransform(nullptr); // the matrix has it
  standIn->SetExplicitProjectionTransformMatrix(projection);
  standIn->UseExplicitProjectionTransformMatrixOn();
  renderer->SetActiveCamera(standIn);
}

//------------------------------------------------------------------------------
vtkGodRaysProjection::~vtkGodRaysProjection()
{
  this->Renderer->SetActiveCamera(this->Camera);
}
