// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysShadowTextures.h"

#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysShadowMap.h"
#include "vtkGodRaysShadowMapTexelsFS.h"
#include "vtkGodRaysShadowPyramidFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
void Bind(vtkGodRaysQuad& quad, vtkShaderProgram* program, const vtkGodRaysShadowMap& map,
  const vtkGodRaysTarget& even, const vtkGodRaysTarget& odd)
{
  const vtkGodRaysShadowFaces& faces = map.GetFaces();
  program->SetUniformi("mapSize", faces.Size);
  program->SetUniformi("mapColumns", faces.GetColumns());
  program->SetUniformi("mapRows", faces.GetRows());
  int offsets[16] = {};
  for (int level = 3; level < 16; ++level)
  {
    const int below = level - 2;
    offsets[level] = offsets[below] + faces.GetRows() * ((faces.Size + (1 << below) - 1) >> below);
  }
  program->SetUniform1iv("mapOffsets", 16, offsets);
  quad.SetTexture("map", map.GetDepth());
  quad.SetTexture("evenLevels", even.GetColor());
  quad.SetTexture("oddLevels", odd.GetColor());
}
}

vtkGodRaysShadowTextures::vtkGodRaysShadowTextures()
  : Quad("vtkGodRaysShadowPyramidFS", Complete(vtkGodRaysShadowPyramidFS))
{
}

std::string vtkGodRaysShadowTextures::Complete(const std::string& shader)
{
  std::string text = shader;
  vtkShaderProgram::Substitute(
    text, "//VTK::GodRays::ShadowMapTexels", vtkGodRaysShadowMapTexelsFS);
  return text;
}

bool vtkGodRaysShadowTextures::Draw(vtkOpenGLRenderWindow* window, const vtkGodRaysShadowMap& map)
{
  const vtkGodRaysShadowFaces& faces = map.GetFaces();
  if (faces.Grids.Version == this->Version)
  {
    return true;
  }
  this->Version = 0;
  const auto getSize = [&](int level) { return (faces.Size + (1 << level) - 1) >> level; };
  int top = 0;
  int heights[2] = { 0, 0 }; // of the textures
  while (getSize(top) > 1)
  {
    ++top;
    heights[top & 1] += faces.GetRows() * getSize(top);
  }
  for (int odd = 0; odd < 2; ++odd)
  {
    this->Levels[odd].Prepare(
      window, faces.GetColumns() * getSize(2 - odd), heights[odd], { GL_RG32F, 0 });
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_BLEND);
  int offsets[2] = { 0, 0 };
  for (int level = 1; level <= top; ++level)
  {
    vtkGodRaysTarget& target = this->Levels[level & 1];
    vtkShaderProgram* program =
      target.Bind() ? this->Quad.Begin(window, { { "texels", level == 1 } }) : nullptr;
    if (!program)
    {
      return false;
    }
    const int corner[2] = { 0, offsets[level & 1] };
    const int size[2] = { faces.GetColumns() * getSize(level), faces.GetRows() * getSize(level) };
    offsets[level & 1] += size[1];
    state->vtkglViewport(corner[0], corner[1], size[0], size[1]);
    state->vtkglScissor(corner[0], corner[1], size[0], size[1]);
    program->SetUniformi("level", level);
    const vtkGodRaysTarget& below = this->Levels[1 - (level & 1)];
    Bind(this->Quad, program, map, below, below); // what is drawn into is no texture meanwhile
    this->Quad.End();
  }
  this->Version = faces.Grids.Version;
  return true;
}

void vtkGodRaysShadowTextures::Set(
  vtkGodRaysQuad& quad, vtkShaderProgram* program, const vtkGodRaysShadowMap& map)
{
  Bind(quad, program, map, this->Levels[0], this->Levels[1]);
}

void vtkGodRaysShadowTextures::Release(vtkWindow* window)
{
  this->Quad.Release();
  this->Levels[0].Release(window);
  this->Levels[1].Release(window);
  this->Version = 0;
}
