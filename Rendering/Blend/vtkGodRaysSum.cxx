// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSum.h"

#include "vtkGodRaysBlendPass.h"
#include "vtkGodRaysFramebuffer.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>

vtkGodRaysSum::vtkGodRaysSum()
  : Adding(vtkSmartPointer<vtkGodRaysBlendPass>::New())
{
}

vtkGodRaysSum::~vtkGodRaysSum() = default;

void vtkGodRaysSum::Begin(vtkOpenGLRenderWindow* window, int width, int height, unsigned int format)
{
  this->Window = window;
  this->Width = width;
  this->Height = height;
  this->Format = format;
  this->Drawn = false;
  this->Lent = nullptr;
  this->Response = {};
}

bool vtkGodRaysSum::BindToAdd()
{
  if (!this->Settle())
  {
    return false;
  }
  if (!this->Response.IsLinear())
  {
    this->Staging.Prepare(this->Window, this->Width, this->Height, { this->Format, 0 });
    this->Window->GetState()->vtkglDisable(GL_BLEND);
    const bool bound = this->Staging.Bind();
    const double white[3] = { 1.0, 1.0, 1.0 };
    return this->Lend(this->Staging, white, 1.0) && bound;
  }
  return this->BindTarget();
}

bool vtkGodRaysSum::BindTarget()
{
  this->Target.Prepare(this->Window, this->Width, this->Height, { this->Format, 0 });
  vtkOpenGLState* state = this->Window->GetState();
  if (this->Drawn)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  }
  else
  {
    state->vtkglDisable(GL_BLEND);
  }
  this->Drawn = true;
  return this->Target.Bind();
}

bool vtkGodRaysSum::Lend(vtkGodRaysTarget& colors, const double tint[3], double viewScale)
{
  if ((!this->IsEmpty() && this->Response.IsLinear()) || viewScale < 1.0)
  {
    return this->Add(colors, tint, viewScale);
  }
  if (!this->Settle())
  {
    return false;
  }
  this->Lent = &colors;
  this->LentResponse = this->Response;
  this->LentVersion = colors.GetVersion();
  std::copy_n(tint, 3, this->Tint);
  return true;
}

bool vtkGodRaysSum::Add(vtkGodRaysTarget& colors, const double tint[3], double viewScale)
{
  return this->Settle() && this->Draw(colors, tint, viewScale, this->Response);
}

bool vtkGodRaysSum::Draw(vtkGodRaysTarget& colors, const double tint[3], double viewScale,
  const vtkGodRaysBlendPass::LightResponse& response)
{
  vtkGodRaysBlendPass::Request request;
  request.Accumulate = this->Drawn;
  if (!this->BindTarget())
  {
    return false;
  }
  request.Response = response.IsLinear() ? nullptr : &response;
  request.Window = this->Window;
  request.Viewport[2] = this->Width;
  request.Viewport[3] = this->Height;
  request.Rays = colors.GetColor();
  request.Tint = colors.HasOneChannel() ? tint : nullptr;
  request.ViewScale = viewScale;
  request.Transfer = vtkGodRaysTransfer::NONE;
  request.ShowRays = true;
  return this->Adding->Draw(request);
}

bool vtkGodRaysSum::Settle()
{
  vtkGodRaysTarget* lent = this->Lent;
  this->Lent = nullptr;
  return !lent || this->Draw(*lent, this->Tint, 1.0, this->LentResponse);
}

vtkTextureObject* vtkGodRaysSum::GetTexture() const
{
  return this->Lent ? this->Lent->GetColor() : this->Drawn ? this->Target.GetColor() : nullptr;
}

const double* vtkGodRaysSum::GetTint() const
{
  return this->Lent && this->Lent->HasOneChannel() ? this->Tint : nullptr;
}

const vtkGodRaysBlendPass::LightResponse* vtkGodRaysSum::GetResponse() const
{
  return this->Lent && !this->LentResponse.IsLinear() ? &this->LentResponse : nullptr;
}

bool vtkGodRaysSum::Download(vtkImageData* image)
{
  if (this->GetResponse() && this->Lent->GetVersion() == this->LentVersion)
  {
    const vtkGodRaysStateKeeper keeper(this->Window->GetState());
    if (!this->Settle())
    {
      return false;
    }
  }
  return this->DownloadLinear(image);
}

bool vtkGodRaysSum::DownloadLinear(vtkImageData* image)
{
  if (this->IsEmpty() || (this->Lent && this->Lent->GetVersion() != this->LentVersion))
  {
    return false;
  }
  vtkGodRaysTarget& target = this->Lent ? *this->Lent : this->Target;
  if (!target.GetColor() ||
    target.GetColor()->GetHandle() == 0) // as of a window that was finalized
  {
    return false;
  }
  target.Download(image, this->Tint);
  return true;
}

void vtkGodRaysSum::Release(vtkWindow* window)
{
  this->Target.Release(window);
  this->Staging.Release(window);
  this->Adding->ReleaseGraphicsResources(window);
  this->Drawn = false;
  this->Lent = nullptr;
}
