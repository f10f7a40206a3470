// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysViewDepths.h"

#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysViewDepthsFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <atomic>

//------------------------------------------------------------------------------
vtkGodRaysViewDepths::vtkGodRaysViewDepths()
  : Quad("vtkGodRaysViewDepthsFS", vtkGodRaysViewDepthsFS)
{
}

//------------------------------------------------------------------------------
vtkGodRaysViewDepths::~vtkGodRaysViewDepths() = default;

//------------------------------------------------------------------------------
void vtkGodRaysViewDepths::Begin(vtkOpenGLRenderWindow* window, const vtkGodRaysView& view,
  vtkTextureObject* occluders, vtkTextureObject* seen)
{
  this->Window = window;
  this->View = &view;
  this->Sources[0] = occluders;
  this->Sources[1] = seen;
  this->Drawn[0] = false;
  this->Drawn[1] = false;
  static std::atomic<unsigned int> frames{ 0 };
  this->Frame = ++frames;
}

//------------------------------------------------------------------------------
void vtkGodRaysViewDepths::End()
{
  this->Window = nullptr;
  this->View = nullptr;
  this->Sources[0] = nullptr;
  this->Sources[1] = nullptr;
}

//------------------------------------------------------------------------------
vtkGodRaysTarget* vtkGodRaysViewDepths::GetOccluders()
{
  return this->Get(0);
}

//------------------------------------------------------------------------------
vtkGodRaysTarget* vtkGodRaysViewDepths::GetEnds()
{
  return this->Get(this->HasEnds() ? 1 : 0);
}

//------------------------------------------------------------------------------
vtkGodRaysTarget* vtkGodRaysViewDepths::Get(int which)
{
  vtkGodRaysTarget& target = this->Depths[which];
  if (this->Drawn[which])
  {
    return &target;
  }
  const int size[2] = { static_cast<int>(this->Sources[0]->GetWidth()),
    static_cast<int>(this->Sources[0]->GetHeight()) };
  vtkGodRaysView::Pinhole pinhole;
  target.Prepare(this->Window, size[0], size[1], { GL_R32F, 0 });
  if (!this->View->GetPinhole(size, pinhole) || !target.Bind())
  {
    return nullptr;
  }
  this->Window->GetState()->vtkglDisable(GL_BLEND);
  vtkShaderProgram* program = this->Quad.Begin(this->Window, { { "fromPicture", which == 1 } });
  if (!program)
  {
    return nullptr;
  }
  const float terms[4] = { static_cast<float>(pinhole.Depth[0]),
    static_cast<float>(pinhole.Depth[1]), static_cast<float>(pinhole.Depth[2]),
    static_cast<float>(pinhole.Depth[3]) };
  program->SetUniform4f("depthTerms", terms);
  program->SetUniformf("openSky", OpenSky);
  program->SetUniformf("viewScale", static_cast<float>(this->View->ViewScale));
  this->Quad.SetTexture("occluders", this->Sources[0]);
  if (which == 1)
  {
    this->Quad.SetTexture("seen", this->Sources[1]);
  }
  this->Quad.End();
  this->Drawn[which] = true;
  return &target;
}

//------------------------------------------------------------------------------
void vtkGodRaysViewDepths::Release(vtkWindow* window)
{
  this->Quad.Release();
  for (vtkGodRaysTarget& target : this->Depths)
  {
    target.Release(window);
  }
}
