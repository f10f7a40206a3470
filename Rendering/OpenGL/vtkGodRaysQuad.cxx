// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysQuad.h"

#include "vtkGodRaysAirlightMath.h"
#include "vtkGodRaysColourMath.h"
#include "vtkGodRaysCommonMath.h"
#include "vtkGodRaysLightMath.h"
#include "vtkGodRaysMediumMath.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysPhaseFunction.h"
#include "vtkGodRaysPhaseMath.h"
#include "vtkGodRaysPlanetMath.h"
#include "vtkGodRaysRadialMath.h"
#include "vtkGodRaysSkyMath.h"
#include "vtkGodRaysTypes.h"
#include "vtkGodRaysWalkMath.h"
#include "vtkObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace
{
int NumberOfFailures = 0;

const std::string TopicMark = "//VTK::GodRays::";

/// What shaders have of vtkGodRaysPhaseFunction.h: a constant for each, and which have an asymmetry.
std::string MakePhaseFunctions()
{
  std::string constants;
  std::string asymmetric = "false";
  for (const vtkGodRaysPhaseFunction& phase : vtkGodRaysPhaseFunctions)
  {
    const std::string name = std::string("PHASE_") + phase.Constant;
    constants += "const int " + name + " = " + std::to_string(phase.Number) + ";\n";
    asymmetric += phase.HasAsymmetry ? " || kind == " + name : "";
  }
  return constants + "bool PhaseHasAsymmetry(in int kind)\n{\n  return " + asymmetric + ";\n}\n";
}

/// The formulas of a topic; null if the mark is not a topic's.
const char* FindTopic(const std::string& name)
{
  static const std::string phaseFunctions = MakePhaseFunctions();
  static const std::map<std::string, const char*> topics = { { "Types", vtkGodRaysTypes },
    { "PhaseFunctions", phaseFunctions.c_str() }, { "Airlight", vtkGodRaysAirlightMath },
    { "Colour", vtkGodRaysColourMath }, { "Common", vtkGodRaysCommonMath },
    { "Light", vtkGodRaysLightMath }, { "Medium", vtkGodRaysMediumMath },
    { "Phase", vtkGodRaysPhaseMath }, { "Planet", vtkGodRaysPlanetMath },
    { "Radial", vtkGodRaysRadialMath }, { "Sky", vtkGodRaysSkyMath },
    { "Walk", vtkGodRaysWalkMath } };
  const auto found = topics.find(name);
  return found == topics.end() ? nullptr : found->second;
}

/// The text with the topics that it names and those that they need, each once, before its first use.
std::string IncludeTopics(const std::string& text, std::set<std::string>& included)
{
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.find("GODRAYS_EXPECT(") != std::string::npos)
    {
      continue; // the domain of a formula, which is for C++
    }
    const bool marked = line.compare(0, TopicMark.size(), TopicMark) == 0;
    const std::string name = marked ? line.substr(TopicMark.size()) : "";
    const char* topic = FindTopic(name);
    if (!topic)
    {
      result += line + "\n";
    }
    else if (included.insert(name).second)
    {
      result += IncludeTopics(topic, included);
    }
  }
  return result;
}
}

vtkGodRaysQuad::vtkGodRaysQuad(const char* name, const std::string& source)
  : Name(name)
  , Source(source)
{
}

vtkGodRaysQuad::~vtkGodRaysQuad() = default;

vtkShaderProgram* vtkGodRaysQuad::Begin(
  vtkOpenGLRenderWindow* window, std::initializer_list<Term> terms)
{
  if (this->Window && this->Window != window) // whose shaders are of another context
  {
    this->Release();
    window->MakeCurrent(); // see vtkGodRaysPass::Render()
  }
  if (this->Failed)
  {
    ++NumberOfFailures;
    return nullptr;
  }
  this->Window = window;
  unsigned int key = 1;
  for (const Term& term : terms)
  {
    key = 2 * key + (term.Value ? 1 : 0);
  }
  auto& helper = this->Helpers[key];
  if (!helper)
  {
    std::string constants;
    for (const Term& term : terms)
    {
      constants +=
        std::string("const bool ") + term.Name + (term.Value ? " = true;\n" : " = false;\n");
    }
    std::set<std::string> included;
    std::string source = IncludeTopics(this->Source, included);
    vtkShaderProgram::Substitute(source, TopicMark + "Terms", constants);
    helper = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, source.c_str(), nullptr);
  }
  else if (helper->Program)
  {
    window->GetShaderCache()->ReadyShaderProgram(helper->Program);
  }
  this->Helper = helper.get();
  if (!this->Helper->Program || !this->Helper->Program->GetCompiled())
  {
    this->Release();
    this->Failed = true;
    ++NumberOfFailures;
    vtkGenericWarningMacro("The shader " << this->Name
                                         << " does not compile on this OpenGL driver, so the scene "
                                            "is drawn without what it makes. Use a driver with "
                                            "OpenGL 3.2 or later, or report the compiler's message "
                                            "above.");
    return nullptr;
  }
  return this->Helper->Program;
}

int vtkGodRaysQuad::GetNumberOfFailures()
{
  return NumberOfFailures;
}

void vtkGodRaysQuad::SetVector(vtkShaderProgram* program, const char* name, const double value[3])
{
  const float values[3] = { static_cast<float>(value[0]), static_cast<float>(value[1]),
    static_cast<float>(value[2]) };
  program->SetUniform3f(name, values);
}

void vtkGodRaysQuad::SetTexture(const char* sampler, vtkTextureObject* texture)
{
  // one that serves two samplers is activated once: a second time would lose its unit
  if (std::find(this->Textures.begin(), this->Textures.end(), texture) == this->Textures.end())
  {
    texture->Activate();
    this->Textures.emplace_back(texture);
  }
  this->Helper->Program->SetUniformi(sampler, texture->GetTextureUnit());
}

void vtkGodRaysQuad::End(Place place)
{
  vtkOpenGLState* state = this->Window->GetState();
  if (place == EVERYWHERE)
  {
    state->vtkglDisable(GL_DEPTH_TEST);
    this->Helper->Render();
  }
  else
  {
    // the quad is as far away as nothing is
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglDepthFunc(place == BEHIND ? GL_LEQUAL : GL_GREATER);
    double range[2];
    glGetDoublev(GL_DEPTH_RANGE, range);
    glDepthRange(1.0, 1.0); // which vtkOpenGLState does not know
    this->Helper->Render();
    glDepthRange(range[0], range[1]);
  }
  for (const auto& texture : this->Textures)
  {
    texture->Deactivate();
  }
  this->Textures.clear();
}

void vtkGodRaysQuad::Release()
{
  this->Helper = nullptr;
  this->Helpers.clear();
  this->Failed = false;
  this->Window = nullptr;
}
