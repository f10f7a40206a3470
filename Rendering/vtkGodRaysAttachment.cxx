// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysAttachment.h"

#include "vtkImageProcessingPass.h"

//------------------------------------------------------------------------------
void vtkGodRaysAttachment::Attach(vtkImageProcessingPass* pass, vtkRenderer* renderer)
{
  if (this->FormerPass) // of a renderer that is gone
  {
    pass->SetDelegatePass(this->FormerDelegate);
  }
  this->Renderer = renderer;
  this->FormerDelegate = pass->GetDelegatePass();
  this->FormerPass = renderer->GetPass() == pass ? nullptr : renderer->GetPass();
  if (this->FormerPass)
  {
    pass->SetDelegatePass(this->FormerPass);
  }
  renderer->SetPass(pass);
}

//------------------------------------------------------------------------------
bool vtkGodRaysAttachment::Has(vtkImageProcessingPass* pass, vtkRenderer* renderer) const
{
  return renderer && (this->Renderer == renderer || renderer->GetPass() == pass);
}

//------------------------------------------------------------------------------
void vtkGodRaysAttachment::Detach(vtkImageProcessingPass* pass, vtkRenderer* renderer)
{
  const bool attached = this->Renderer == renderer;
  if (renderer->GetPass() == pass)
  {
    renderer->SetPass(attached ? this->FormerPass : nullptr);
  }
  if (!attached)
  {
    return;
  }
  pass->SetDelegatePass(this->FormerDelegate);
  this->FormerPass = nullptr;
  this->FormerDelegate = nullptr;
  this->Renderer = nullptr;
}
