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
/// Returns how wide a face is at a level.
int GetSize(const vtkGodRaysShadowFaces& faces, int level)
{
  return (faces.Size + (1 << level) - 1) >> level;
}

/// Finds where levels begin in their textures. Returns the last level, of one node.
int FindLevels(const vtkGodRaysShadowFaces& faces, int offsets[16])
{
  int top = 0;
  for (; GetSize(faces, top) > 1; ++top)
  {
    const int below = top - 1; // of the next level, in the same texture
    offsets[top + 1] = below > 0 ? offsets[below] + faces.GetRows() * GetSize(faces, below) : 0;
  }
  return top;
}

void Bind(vtkGodRaysQuad& quad, vtkShaderProgram* program, const vtkGodRaysShadowMap& map,
  const vtkGodRaysTarget& even, const vtkGodRaysTarget& odd)
{
  const vtkGodRaysShadowFaces& faces = map.GetFaces();
  program->SetUniformi("mapSize", faces.Size);
  program->SetUniformi("mapColumns", faces.GetColumns());
  program->SetUniformi("mapRows", faces.GetRows());
  int offsets[16] = {};
  program->SetUniformi("mapTop", FindLevels(faces, offsets));
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
  int offsets[16] = {};
  const int top = FindLevels(faces, offsets);
  for (const int last : { top - 1, top })
  {
    this->Levels[last & 1].Prepare(window, faces.GetColumns() * GetSize(faces, 2 - (last & 1)),
      offsets[last] + faces.GetRows() * GetSize(faces, last), { GL_RG32F, 0 });
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglDisable(GL_BLEND);
  for (int level = 1; level <= top; ++level)
  {
    vtkGodRaysTarget& target = this->Levels[level & 1];
    vtkShaderProgram* program =
      target.Bind() ? this->Quad.Begin(window, { { "texels", level == 1 } }) : nullptr;
    if (!program)
    {
      return false;
    }
    const int width = faces.GetColumns() * GetSize(faces, level);
    const int height = faces.GetRows() * GetSize(faces, level);
    state->vtkglViewport(0, offsets[level], width, height);
    state->vtkglScissor(0, offsets[level], width, height);
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
