// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysProjection.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

//------------------------------------------------------------------------------
vtkGodRaysProjection::vtkGodRaysProjection(
  vtkRenderer* renderer, const double viewToClip[16], vtkSmartPointer<vtkCamera>& standIn)
  : Renderer(renderer)
  , Camera(renderer->GetActiveCamera())
{
  if (!standIn)
  {
    standIn = vtkSmartPointer<vtkCamera>::New();
  }
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(viewToClip);
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
