// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysViewDepths.h"

#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysViewDepthsFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>

namespace
{
/// As vtkGodRaysViewDepthsFS.glsl has it, of 1 - window depth: ViewDepth() of the shared formulas in single
/// precision, of which a vector holds twice as many.
inline float FindViewDepth(float rest, const float terms[4])
{
  const float view = (terms[0] + terms[1] * rest) / (terms[2] + terms[3] * rest);
  const float sky = vtkGodRaysViewDepths::OpenSky;
  return (rest > 0.0f) & (view > 0.0f) & (view < sky) ? view : sky;
}

/// In place, of floats, or of integers that are 2^32 - 1 where depth is 1. Compilers make vectors of loops
/// whose number they know.
void FindViewDepths(float* depths, vtkIdType count, bool isFixedPoint, const float terms[4])
{
  constexpr vtkIdType each = 64;
  float rests[each] = {};
  for (vtkIdType first = 0; first < count; first += each)
  {
    const vtkIdType number = std::min(each, count - first);
    std::uint32_t numbers[each] = {};
    std::memcpy(numbers, depths + first, number * sizeof(float));
    if (isFixedPoint)
    {
      for (vtkIdType i = 0; i < each; ++i) // 31 bits
      {
        rests[i] = static_cast<float>(static_cast<std::int32_t>(~numbers[i] >> 1)) / 2147483648.0f;
      }
    }
    else
    {
      std::memcpy(rests, numbers, sizeof(rests));
      for (vtkIdType i = 0; i < each; ++i)
      {
        rests[i] = 1.0f - rests[i];
      }
    }
    for (vtkIdType i = 0; i < each; ++i)
    {
      rests[i] = FindViewDepth(rests[i], terms);
    }
    std::memcpy(depths + first, rests, number * sizeof(float));
  }
}
}

vtkGodRaysViewDepths::vtkGodRaysViewDepths()
  : Quad("vtkGodRaysViewDepthsFS", vtkGodRaysViewDepthsFS)
{
}

vtkGodRaysViewDepths::~vtkGodRaysViewDepths() = default;

void vtkGodRaysViewDepths::Begin(vtkOpenGLRenderWindow* window, const vtkGodRaysView& view,
  vtkTextureObject* occluders, vtkTextureObject* seen)
{
  this->Window = window;
  this->View = &view;
  this->Sources[0] = occluders;
  this->Sources[1] = seen;
  this->Drawn = false;
  static std::atomic<unsigned int> frames{ 0 };
  this->Frame = ++frames;
}

void vtkGodRaysViewDepths::End()
{
  this->Window = nullptr;
  this->View = nullptr;
  this->Sources[0] = nullptr;
  this->Sources[1] = nullptr;
}

vtkGodRaysTarget* vtkGodRaysViewDepths::GetEnds()
{
  if (this->Drawn)
  {
    return &this->Ends;
  }
  int size[2];
  this->GetSize(size);
  vtkGodRaysView::Pinhole pinhole;
  this->Ends.Prepare(this->Window, size[0], size[1], { GL_R32F, 0 });
  if (!this->View->GetPinhole(size, pinhole) || !this->Ends.Bind())
  {
    return nullptr;
  }
  this->Window->GetState()->vtkglDisable(GL_BLEND);
  const bool fromPicture = this->Sources[1] != nullptr;
  vtkShaderProgram* program = this->Quad.Begin(this->Window, { { "fromPicture", fromPicture } });
  if (!program)
  {
    return nullptr;
  }
  float terms[4];
  std::copy_n(pinhole.Depth, 4, terms);
  program->SetUniform4f("depthTerms", terms);
  program->SetUniformf("openSky", OpenSky);
  program->SetUniformf("viewScale", static_cast<float>(this->View->ViewScale));
  this->Quad.SetTexture("occluders", this->Sources[0]);
  if (fromPicture)
  {
    this->Quad.SetTexture("seen", this->Sources[1]);
  }
  this->Quad.End();
  this->Drawn = true;
  return &this->Ends;
}

void vtkGodRaysViewDepths::GetSize(int size[2]) const
{
  size[0] = static_cast<int>(this->Sources[0]->GetWidth());
  size[1] = static_cast<int>(this->Sources[0]->GetHeight());
}

bool vtkGodRaysViewDepths::ReadEnds(float* depths)
{
  if (this->Sources[1] || this->Drawn)
  {
    vtkGodRaysTarget* const ends = this->GetEnds();
    if (ends)
    {
      ends->Read(GL_RED, GL_FLOAT, depths, 0);
    }
    return ends != nullptr;
  }
  int size[2];
  this->GetSize(size);
  vtkGodRaysView::Pinhole pinhole;
  if (!this->View->GetPinhole(size, pinhole))
  {
    return false;
  }
  this->Layer.Prepare(this->Window, 0, this->Sources[0]);
  GLint kind = GL_UNSIGNED_NORMALIZED;
  this->Sources[0]->Activate();
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_TYPE, &kind);
  this->Sources[0]->Deactivate();
  const bool isFixedPoint = kind != GL_FLOAT;
  this->Layer.Read(GL_DEPTH_COMPONENT, isFixedPoint ? GL_UNSIGNED_INT : GL_FLOAT, depths, 0);
  float terms[4];
  std::copy_n(pinhole.Depth, 4, terms);
  vtkSMPTools::For(0, static_cast<vtkIdType>(size[0]) * size[1], 65536,
    [&](vtkIdType begin, vtkIdType end)
    { FindViewDepths(depths + begin, end - begin, isFixedPoint, terms); });
  return true;
}

void vtkGodRaysViewDepths::Release(vtkWindow* window)
{
  this->Layer.Release(window); // before the depth that it borrows
  this->Quad.Release();
  this->Ends.Release(window);
}
