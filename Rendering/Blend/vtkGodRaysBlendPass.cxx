// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysBlendPass.h"

#include "vtkGodRaysBlendFS.h"
#include "vtkGodRaysMedium.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysView.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

vtkStandardNewMacro(vtkGodRaysBlendPass);

namespace
{
void SetMedium(vtkShaderProgram* program, const vtkGodRaysBlendPass::Request& request)
{
  const vtkGodRaysMedium& medium = *request.Medium;
  double extinction[2][3] = {};
  double scattering[3] = {};
  float scaleHeight[2] = { 0.0f, 0.0f };
  for (int i = 0; i < medium.NumberOfComponents; ++i)
  {
    const vtkGodRaysMedium::Component& component = medium.Components[i];
    for (int c = 0; c < 3; ++c)
    {
      extinction[i][c] = component.Scattering[c] + component.Absorption[c];
      scattering[c] += component.Scattering[c];
    }
    scaleHeight[i] = static_cast<float>(component.ScaleHeight);
  }
  vtkGodRaysQuad::SetVector(program, "extinction", extinction[0]);
  vtkGodRaysQuad::SetVector(program, "secondExtinction", extinction[1]);
  double sky[3];
  for (int c = 0; c < 3; ++c)
  {
    const double both = extinction[0][c] + extinction[1][c];
    sky[c] = both > 0.0 ? request.SkyLight[c] * scattering[c] / both : 0.0;
  }
  vtkGodRaysQuad::SetVector(program, "skyLight", sky);
  program->SetUniform2f("scaleHeight", scaleHeight);
  vtkGodRaysQuad::SetVector(program, "mediumUp", medium.Up);
  program->SetUniformf("eyeHeight", static_cast<float>(medium.EyeHeight));
  program->SetUniformf("planetRadius", static_cast<float>(medium.PlanetRadius));
  program->SetUniformf("farLimit", static_cast<float>(medium.FarLimit));

  double origin[3];
  double right[3];
  double up[3];
  request.View->GetPicture(request.View->Parallel, origin, right, up);
  vtkGodRaysQuad::SetVector(program, "pictureOrigin", origin);
  vtkGodRaysQuad::SetVector(program, "pictureRight", right);
  vtkGodRaysQuad::SetVector(program, "pictureUp", up);
  const int size[2] = { static_cast<int>(request.Depth->GetWidth()),
    static_cast<int>(request.Depth->GetHeight()) };
  vtkGodRaysView::Pinhole pinhole;
  request.View->GetPinhole(size, pinhole);
  const float terms[4] = { static_cast<float>(pinhole.Depth[0]),
    static_cast<float>(pinhole.Depth[1]), static_cast<float>(pinhole.Depth[2]),
    static_cast<float>(pinhole.Depth[3]) };
  program->SetUniform4f("depthTerms", terms);
  program->SetUniformf("pictureScale", static_cast<float>(request.View->ViewScale));
}
}

struct vtkGodRaysBlendPass::Internals
{
  vtkGodRaysQuad Quad{ "vtkGodRaysBlendFS", vtkGodRaysBlendFS };
};

vtkGodRaysBlendPass::vtkGodRaysBlendPass()
  : Internal(new Internals)
{
}

vtkGodRaysBlendPass::~vtkGodRaysBlendPass() = default;

bool vtkGodRaysBlendPass::Draw(const Request& request)
{
  const bool resized = request.Rays && request.Cells[0] == 0 &&
    (static_cast<int>(request.Rays->GetWidth()) != request.Viewport[2] ||
      static_cast<int>(request.Rays->GetHeight()) != request.Viewport[3]);
  const bool metered = request.Cells[0] > 0;
  const bool sparesData =
    (request.CapsData || std::min(request.DataExposure, request.DarkExposure) < 1.0) &&
    !request.ShowRays && !metered;
  const bool gainsData = request.Medium && request.DataGain > 1.0 && !request.ShowRays && !metered;
  const bool surround = request.Around && !request.ShowRays && !metered;
  const bool lightnessAlone = request.MostLightness >= 0.0 && !request.ShowRays && !metered;
  const bool showsData = metered || surround || sparesData || gainsData || lightnessAlone;
  const bool hasOpacity = request.Opacity && showsData;
  const bool hasCoverage = request.Coverage && showsData;
  vtkShaderProgram* program = this->Internal->Quad.Begin(request.Window,
    { { "linearLight", request.Transfer != vtkGodRaysTransfer::NONE }, { "bytes", request.Bytes },
      { "isPower", request.Transfer == vtkGodRaysTransfer::POWER },
      { "screen", request.Screen && !request.ShowRays }, { "showRays", request.ShowRays },
      { "resized", resized }, { "hasBackdrop", request.Backdrop != nullptr },
      { "oneChannel", request.Tint != nullptr }, { "hasRays", request.Rays != nullptr },
      { "dimmed", request.Medium != nullptr }, { "veiled", request.Veil != nullptr },
      { "parallel", request.View && request.View->Parallel },
      { "exponential", request.Medium && request.Medium->HasExponentialDensity() },
      { "hasSecond", request.Medium && request.Medium->NumberOfComponents > 1 },
      { "grey", request.Medium && request.Medium->IsGrey() },
      { "skyLit",
        request.Medium &&
          std::any_of(request.SkyLight, request.SkyLight + 3, [](double c) { return c > 0.0; }) },
      { "shoulder", request.Shoulder && !request.Screen }, { "lightnessAlone", lightnessAlone },
      { "surround", surround }, { "sparesData", sparesData }, { "gainsData", gainsData },
      { "responds", request.Rays && request.Response != nullptr },
      { "dithered",
        request.Bytes && request.Transfer != vtkGodRaysTransfer::NONE && !request.ShowRays },
      { "capsData", request.CapsData }, { "hasOpacity", hasOpacity },
      { "hasCoverage", hasCoverage }, { "metered", metered } });
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = request.Window->GetState();
  vtkOpenGLState::ScopedglColorMask mask(state);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE,
    metered || (request.Backdrop && (request.ShowRays || request.Medium || surround)) ? GL_TRUE
                                                                                      : GL_FALSE);
  if (request.Accumulate)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  }
  else
  {
    state->vtkglDisable(GL_BLEND);
  }
  state->vtkglViewport(
    request.Viewport[0], request.Viewport[1], request.Viewport[2], request.Viewport[3]);
  state->vtkglScissor(
    request.Viewport[0], request.Viewport[1], request.Viewport[2], request.Viewport[3]);

  program->SetUniformf("intensity", static_cast<float>(request.Intensity));
  program->SetUniformf("sceneGain", static_cast<float>(request.SceneGain));
  program->SetUniformf("viewScale", static_cast<float>(request.ViewScale));
  program->SetUniform2i("tile", request.Tile);
  if (request.Tint)
  {
    vtkGodRaysQuad::SetVector(program, "tint", request.Tint);
  }
  if (request.Rays)
  {
    this->Internal->Quad.SetTexture("rays", request.Rays);
  }
  if (request.Rays && request.Response)
  {
    const LightResponse& response = *request.Response;
    const float place[4] = { static_cast<float>(response.Light[0]),
      static_cast<float>(response.Light[1]), static_cast<float>(response.Heights[0]),
      static_cast<float>(response.Heights[1]) };
    program->SetUniform4f("responsePlace", place);
    const double numbers[3] = { response.Nearest, response.Reach, response.Streaks };
    vtkGodRaysQuad::SetVector(program, "responseNumbers", numbers);
  }
  if (request.Medium)
  {
    SetMedium(program, request);
  }
  if (request.Veil)
  {
    this->Internal->Quad.SetTexture("veil", request.Veil);
  }
  if (request.Medium || surround || sparesData || lightnessAlone || metered)
  {
    this->Internal->Quad.SetTexture("depth", request.Depth);
  }
  if (surround || sparesData || gainsData || lightnessAlone)
  {
    program->SetUniformf("dataExposure", static_cast<float>(request.DataExposure));
    program->SetUniformf("darkExposure", static_cast<float>(request.DarkExposure));
    program->SetUniformf("dataGain", static_cast<float>(request.DataGain));
    program->SetUniformf("mostLightness", static_cast<float>(request.MostLightness));
    program->SetUniformi("alphaShowsData", request.AlphaShowsData ? 1 : 0);
  }
  if (surround)
  {
    const Surround& about = *request.Around;
    const double place[3] = { about.Place[0], about.Place[1], 1.0 / request.PictureHeight };
    vtkGodRaysQuad::SetVector(program, "surroundPlace", place);
    vtkGodRaysQuad::SetVector(program, "surroundLight", about.Light);
    program->SetUniformf("surroundPart", static_cast<float>(about.Part));
    program->SetUniformf("surroundRays", static_cast<float>(about.Rays));
  }
  if (request.Depth)
  {
    program->SetUniformf("alphaLayers", static_cast<float>(request.AlphaLayers));
  }
  if (hasCoverage)
  {
    this->Internal->Quad.SetTexture("coverage", request.Coverage);
  }
  if (hasOpacity)
  {
    this->Internal->Quad.SetTexture("opacity", request.Opacity);
  }
  if (hasCoverage || hasOpacity)
  {
    program->SetUniformf("opacityLayers", static_cast<float>(request.OpacityLayers));
  }
  if (metered)
  {
    const float cells[2] = { static_cast<float>(request.Cells[0]),
      static_cast<float>(request.Cells[1]) };
    program->SetUniform2f("cells", cells);
  }
  if (!request.ShowRays)
  {
    this->Internal->Quad.SetTexture("scene", request.Scene);
  }
  if (request.Backdrop)
  {
    this->Internal->Quad.SetTexture("backdrop", request.Backdrop);
  }
  this->Internal->Quad.End();
  return true;
}

void vtkGodRaysBlendPass::ReleaseGraphicsResources(vtkWindow*)
{
  this->Internal->Quad.Release();
}

void vtkGodRaysBlendPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
