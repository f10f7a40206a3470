// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AmbientOcclusion.h"

#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkOverlayPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <string>

vtkStandardNewMacro(AmbientOcclusion);

namespace
{
// Fractions of the scene's diagonal. A radius of 0.05 shows folds and the feet of buildings; 0.1 is nearly
// twice as dark, and blurs them. With a bias of 0.002 smooth surfaces do not occlude themselves.
constexpr double RadiusOfDiagonal = 0.05;
constexpr double BiasOfDiagonal = 0.002;
constexpr unsigned int Samples = 32;
// With 0.9 plain surfaces change by a mean CIELAB difference of 10. On colours 0.35 keeps that below 4,
// with the rim light.
constexpr double StrengthOnPlain = 0.45;
constexpr double StrengthOnColors = 0.35;

// OpenGL's names
constexpr unsigned int Zero = 0;
constexpr unsigned int One = 1;
constexpr unsigned int SourceColor = 0x0300;
constexpr unsigned int DepthTest = 0x0B71;
constexpr unsigned int Blending = 0x0BE2;
constexpr unsigned int ColorBuffers = 0x4000;

//------------------------------------------------------------------------------
/**
 * The factor on the scene: a part of the darkening that was found, averaged over 4 x 4 pixels since each
 * pixel's samples are turned by another angle. The background has none.
 */
const std::string Factor = R"(
  ivec2 size = textureSize(visible, 0);
  ivec2 pixel = ivec2(texCoord * vec2(size));
  float open = 0.0;
  for (int i = -2; i < 2; ++i)
  {
    for (int j = -2; j < 2; ++j)
    {
      open += texelFetch(visible, clamp(pixel + ivec2(i, j), ivec2(0), size - 1), 0).r;
    }
  }
  float isData = texelFetch(depths, pixel, 0).r < 1.0 ? 1.0 : 0.0;
  gl_FragData[0] = vec4(vec3(1.0 - strength * isData * (1.0 - open / 16.0)), 1.0);
)";

//------------------------------------------------------------------------------
/**
 * Clears colours, positions and normals: pictures and gradients in the background, which VTK draws, leave
 * the last two undefined.
 */
class ClearPass : public vtkRenderPass
{
public:
  static ClearPass* New();
  vtkTypeMacro(ClearPass, vtkRenderPass);
  void Render(const vtkRenderState* s) override
  {
    auto* window = static_cast<vtkOpenGLRenderWindow*>(s->GetRenderer()->GetRenderWindow());
    const vtkOpenGLState::ScopedglClearColor color(window->GetState());
    window->GetState()->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    window->GetState()->vtkglClear(ColorBuffers);
  }
};
vtkStandardNewMacro(ClearPass);
}

//------------------------------------------------------------------------------
AmbientOcclusion::AmbientOcclusion()
{
  this->SetKernelSize(Samples);
  this->Steps->SetOverlayPass(nullptr); // they are drawn last, over the occlusion
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<ClearPass>());
  passes->AddItem(vtkNew<vtkLightsPass>()); // without lights, mappers make no normals
  passes->AddItem(vtkNew<vtkOpaquePass>());
  vtkNew<vtkSequencePass> surfaces;
  surfaces->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(surfaces);
  this->SetDelegatePass(camera);
}

//------------------------------------------------------------------------------
AmbientOcclusion::~AmbientOcclusion() = default;

//------------------------------------------------------------------------------
void AmbientOcclusion::SetUp(double diagonal, bool isColored)
{
  this->Strength = isColored ? StrengthOnColors : StrengthOnPlain;
  this->SetRadius(RadiusOfDiagonal * diagonal);
  this->SetBias(BiasOfDiagonal * diagonal);
}

//------------------------------------------------------------------------------
void AmbientOcclusion::Render(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const bool isStill = !renderer->GetSelector() && window->GetDesiredUpdateRate() < 1.0;
  if (isStill)
  {
    this->Superclass::Render(s); // for its textures: what it draws is drawn over
  }
  this->Steps->Render(s);
  this->NumberOfRenderedProps = this->Steps->GetNumberOfRenderedProps();
  if (isStill && this->SSAOTexture)
  {
    vtkOpenGLState* state = window->GetState();
    const vtkOpenGLState::ScopedglEnableDisable blending(state, Blending);
    const vtkOpenGLState::ScopedglEnableDisable depthTest(state, DepthTest);
    const vtkOpenGLState::ScopedglBlendFuncSeparate factors(state);
    state->vtkglDisable(DepthTest);
    state->vtkglEnable(Blending);
    state->vtkglBlendFuncSeparate(Zero, SourceColor, Zero, One);
    this->Darken(window);
  }
  this->Overlays->Render(s);
}

//------------------------------------------------------------------------------
/**
 * Multiply the colours of the framebuffer that is bound.
 */
void AmbientOcclusion::Darken(vtkOpenGLRenderWindow* window)
{
  if (!this->Quad)
  {
    std::string shader = vtkOpenGLRenderUtilities::GetFullScreenQuadFragmentShaderTemplate();
    vtkShaderProgram::Substitute(shader, "//VTK::FSQ::Decl",
      "uniform sampler2D visible;\nuniform sampler2D depths;\n"
      "uniform float strength;\n");
    vtkShaderProgram::Substitute(shader, "//VTK::FSQ::Impl", Factor);
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window,
      vtkOpenGLRenderUtilities::GetFullScreenQuadVertexShader().c_str(), shader.c_str(), "");
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkShaderProgram* program = this->Quad->Program;
  if (!program || !program->GetCompiled())
  {
    return;
  }
  this->SSAOTexture->Activate();
  this->DepthTexture->Activate();
  program->SetUniformi("visible", this->SSAOTexture->GetTextureUnit());
  program->SetUniformi("depths", this->DepthTexture->GetTextureUnit());
  program->SetUniformf("strength", static_cast<float>(this->Strength));
  this->Quad->Render();
  this->DepthTexture->Deactivate();
  this->SSAOTexture->Deactivate();
}

//------------------------------------------------------------------------------
void AmbientOcclusion::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Steps->ReleaseGraphicsResources(window);
  this->Quad.reset();
}
