// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysLightLayers.h"

#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

vtkStandardNewMacro(vtkGodRaysLightLayers);

namespace
{
using Surface = vtkGodRaysShadowLayers::Surface;

bool IsEmpty(const Surface& surface)
{
  for (std::size_t i = 3; i < surface.Through.size(); i += 4)
  {
    if (surface.Through[i] > 0.0f)
    {
      return false;
    }
  }
  return true;
}

/// Of the surfaces of all processes, the nearest; what is equally near lets through the product.
void Join(vtkGodRaysCompositor* compositor, Surface& surface)
{
  const std::vector<float> own = surface.Depths;
  std::vector<float>& depths = surface.Depths;
  compositor->Reduce(depths.data(), depths.size(), vtkGodRaysCompositor::LEAST);
  std::vector<float> is(depths.size());
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    float* through = surface.Through.data() + 4 * i;
    is[i] = own[i] == depths[i] ? through[3] : 0.0f;
    if (!(is[i] > 0.0f))
    {
      std::fill_n(through, 4, 1.0f);
    }
  }
  compositor->Reduce(is.data(), is.size(), vtkGodRaysCompositor::GREATEST);
  compositor->Reduce(surface.Through.data(), surface.Through.size(), vtkGodRaysCompositor::PRODUCT);
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    surface.Through[4 * i + 3] = is[i];
  }
}
}

vtkGodRaysLightLayers::vtkGodRaysLightLayers()
{
  this->SetActiveDrawBuffers(1);
}

void vtkGodRaysLightLayers::GetThrough(const double color[3], double opacity, double through[3])
{
  const double most = std::max({ color[0], color[1], color[2] });
  for (int c = 0; c < 3; ++c)
  {
    const double hue = most > 0.0 ? color[c] / most : 1.0;
    through[c] = std::pow(std::min(std::max(1.0 - opacity, 0.0), 1.0), 3.0 - 2.0 * hue);
  }
}

bool vtkGodRaysLightLayers::Draw(vtkOpenGLRenderWindow* window, vtkRenderer* renderer,
  std::vector<vtkProp*> props, vtkGodRaysTarget& opaque, vtkGodRaysCompositor* compositor,
  const DrawFaces& faces)
{
  const bool distributed = compositor && compositor->IsDistributed();
  this->Window = window;
  this->Surfaces.clear();
  this->More = false;
  vtkOpenGLState* state = window->GetState();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglClearDepth(1.0);
  state->vtkglClearColor(1.0f, 1.0f, 1.0f, 0.0f);
  state->vtkglDisable(GL_BLEND);
  vtkRenderState translucent(renderer);
  translucent.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  this->Opaque = opaque.GetDepth();
  this->Last = this->Opaque;
  this->PreRender(&translucent);
  bool drawn = true;
  for (int layer = 0; layer <= MaximumSurfaces && drawn; ++layer)
  {
    vtkGodRaysTarget& target = this->Planes[layer % 2];
    target.Prepare(
      window, opaque.GetWidth(), opaque.GetHeight(), { GL_RGBA16F, GL_DEPTH_COMPONENT32F });
    drawn = target.Bind();
    if (!drawn)
    {
      break;
    }
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    this->First = layer == 0;
    drawn = faces(
      [&](std::vector<vtkProp*>& seen)
      {
        vtkRenderState part(renderer);
        part.SetPropArrayAndCount(seen.data(), static_cast<int>(seen.size()));
        this->Render(&part);
      });
    if (!drawn)
    {
      break;
    }
    Surface surface = { target.ReadDepth(), target.ReadColor() };
    if (distributed)
    {
      Join(compositor, surface);
      target.WriteDepth(surface.Depths);
    }
    if (IsEmpty(surface))
    {
      break;
    }
    this->More = layer == MaximumSurfaces;
    if (!this->More)
    {
      this->Surfaces.push_back(std::move(surface));
    }
    this->Last = target.GetDepth();
  }
  this->PostRender(&translucent);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglEnable(GL_BLEND);
  return drawn;
}

void vtkGodRaysLightLayers::Render(const vtkRenderState* s)
{
  this->Opaque->Activate();
  if (this->Last != this->Opaque)
  {
    this->Last->Activate();
  }
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    s->GetPropArray()[i]->RenderTranslucentPolygonalGeometry(s->GetRenderer());
  }
  if (this->Last != this->Opaque)
  {
    this->Last->Deactivate();
  }
  this->Opaque->Deactivate();
}

// After the lights, whose code stays in place for what else it says, colours are those without lights;
// textures are times them.
bool vtkGodRaysLightLayers::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Dec",
    "uniform sampler2D lightOpaque;\n"
    "uniform sampler2D lightLast;\n"
    "uniform int lightFirst;\n"
    "//VTK::DepthPeeling::Dec");
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::PreColor",
    "//VTK::DepthPeeling::PreColor\n"
    "  if (gl_FragDepth >= texelFetch(lightOpaque, ivec2(gl_FragCoord.xy), 0).r ||\n"
    "    (lightFirst == 0 && gl_FragDepth <=\n"
    "      texelFetch(lightLast, ivec2(gl_FragCoord.xy), 0).r))\n"
    "  {\n"
    "    discard;\n"
    "  }\n");
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::Light::Impl",
    "//VTK::Light::Impl\n"
    "  gl_FragData[0].rgb = ambientColor + diffuseColor;\n");
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Impl",
    "//VTK::DepthPeeling::Impl\n"
    "  vec3 lightHue = max(gl_FragData[0].rgb, vec3(0.0));\n"
    "  float lightMost = max(lightHue.r, max(lightHue.g, lightHue.b));\n"
    "  lightHue = lightMost > 0.0 ? lightHue / lightMost : vec3(1.0);\n"
    "  float lightThrough = clamp(1.0 - gl_FragData[0].a, 0.0, 1.0);\n"
    "  gl_FragData[0] = vec4(pow(vec3(lightThrough), vec3(3.0) - 2.0 * lightHue), 1.0);\n");
  return true;
}

// Depth is compared as it is stored; where the mapper does not set it, this does.
bool vtkGodRaysLightLayers::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  vtkShaderProgram::Substitute(
    fragmentShader, "//VTK::Depth::Impl", "gl_FragDepth = gl_FragCoord.z;");
  return true;
}

// Called between the actor, which keeps what is translucent from writing depth, and the drawing.
bool vtkGodRaysLightLayers::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  program->SetUniformi("lightOpaque", this->Opaque->GetTextureUnit());
  program->SetUniformi("lightLast", this->Last->GetTextureUnit());
  program->SetUniformi("lightFirst", this->First);
  this->Window->GetState()->vtkglDepthMask(GL_TRUE);
  this->Window->GetState()->vtkglDisable(GL_BLEND);
  return true;
}

void vtkGodRaysLightLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  for (vtkGodRaysTarget& plane : this->Planes)
  {
    plane.Release(window);
  }
}
