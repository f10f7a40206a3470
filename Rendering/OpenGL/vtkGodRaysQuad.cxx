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
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysTypes.h"
#include "vtkGodRaysVisibilityMath.h"
#include "vtkGodRaysWalkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <sstream>

namespace
{
int NumberOfFailures = 0;

const std::string TopicMark = "//VTK::GodRays::";
const std::string TypesName = "Types";

const char* const SystemTag = "//VTK::System::Dec";
const char* const MainTag = "//VTK::GodRays::Main";

const char* const FragmentEnding = R"(in vec2 texCoord; // which VTK's quad must have
void main()
{
  gl_FragData[0] = GetColor(ivec2(texCoord * pictureSize));
}
)";

// VTK's EGL windows ask for OpenGL before 4.3, which drivers may give these.
const char* const ComputeExtensions = R"(#version 150
#extension GL_ARB_compute_shader : require
#extension GL_ARB_shader_image_load_store : require
#extension GL_ARB_shader_image_size : require
)";

const char* const ComputeHeading = R"(
layout(local_size_x = 8, local_size_y = 8) in;
uniform writeonly image2D result; // number 0
)";

const char* const ComputeEnding = R"(void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(pixel, imageSize(result))))
  {
    imageStore(result, pixel, GetColor(pixel));
  }
}
)";

unsigned int MakeKey(std::initializer_list<vtkGodRaysQuad::Term> terms)
{
  unsigned int key = 1;
  for (const vtkGodRaysQuad::Term& term : terms)
  {
    key = 2 * key + (term.Value ? 1 : 0);
  }
  return key;
}

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
    { "Visibility", vtkGodRaysVisibilityMath }, { "Walk", vtkGodRaysWalkMath } };
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
      // Passes that take part in a mapper's shader may both need a topic.
      const std::string guard = "GODRAYS_HAS_" + name + "\n";
      const std::string formulas = IncludeTopics(topic, included);
      result += name == TypesName ? formulas
                                  : "#ifndef " + guard + "#define " + guard + formulas + "#endif\n";
    }
  }
  return result;
}
}

/// A program of one compute shader, which VTK has in later versions alone.
class vtkGodRaysQuad::Kernel : public vtkShaderProgram
{
public:
  static Kernel* New();
  vtkTypeMacro(Kernel, vtkShaderProgram);

  std::string Source;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkMTimeType ContextTime = 0;

  bool IsOf(vtkOpenGLRenderWindow* window) const
  {
    return window && this->ContextTime == window->GetContextCreationTime();
  }

protected:
  // In its own context alone: in another one, its number may be that of another program. A context takes with
  // it what is left.
  ~Kernel() override
  {
    if (this->IsOf(this->Window) && this->Window->IsCurrent())
    {
      // it leaves OpenGL without a program, which the cache must know
      this->Window->GetShaderCache()->ReleaseCurrentShader();
      this->ReleaseGraphicsResources(this->Window);
    }
  }

  int CompileShader() override
  {
    const unsigned int shader = glCreateShader(GL_COMPUTE_SHADER);
    const char* const text = this->Source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    this->Handle = static_cast<int>(glCreateProgram());
    glAttachShader(this->Handle, shader);
    glLinkProgram(this->Handle);
    int linked = GL_FALSE;
    glGetProgramiv(this->Handle, GL_LINK_STATUS, &linked);
    this->Linked = this->Compiled = linked == GL_TRUE;
    if (!this->Linked)
    {
      char log[4096] = "";
      glGetShaderInfoLog(shader, sizeof(log), nullptr, log);
      vtkErrorMacro(<< log);
    }
    glDeleteShader(shader);
    return linked;
  }
};

vtkStandardNewMacro(vtkGodRaysQuad::Kernel);

vtkGodRaysQuad::vtkGodRaysQuad(const char* name, const std::string& source)
  : Name(name)
  , Source(source)
{
}

vtkGodRaysQuad::~vtkGodRaysQuad() = default;

// False, after the first failure; shaders of another window are of another context.
bool vtkGodRaysQuad::IsReady(vtkOpenGLRenderWindow* window)
{
  if (this->Window && this->Window != window)
  {
    this->Release();
    window->MakeCurrent(); // see vtkGodRaysPass::Render()
  }
  NumberOfFailures += this->Failed ? 1 : 0;
  this->Window = window;
  return !this->Failed;
}

std::string vtkGodRaysQuad::Complete(
  std::initializer_list<Term> terms, const std::string& heading, const char* ending)
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
  vtkShaderProgram::Substitute(source, SystemTag, heading);
  vtkShaderProgram::Substitute(source, MainTag, ending);
  return source;
}

// As the program that is current; null, after an error, if it did not compile.
vtkShaderProgram* vtkGodRaysQuad::Take(vtkShaderProgram* program)
{
  if (!program || !program->GetCompiled())
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
  this->Program = program;
  return program;
}

vtkShaderProgram* vtkGodRaysQuad::Begin(
  vtkOpenGLRenderWindow* window, std::initializer_list<Term> terms)
{
  if (!this->IsReady(window))
  {
    return nullptr;
  }
  auto& helper = this->Helpers[MakeKey(terms)];
  if (!helper)
  {
    const std::string source = this->Complete(terms, SystemTag, FragmentEnding);
    helper = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, source.c_str(), nullptr);
  }
  else if (helper->Program)
  {
    window->GetShaderCache()->ReadyShaderProgram(helper->Program);
  }
  this->Helper = helper.get();
  return this->Take(helper->Program);
}

bool vtkGodRaysQuad::CanCompute(vtkOpenGLRenderWindow* window)
{
  if (this->AskedTime != window->GetContextCreationTime()) // once a context
  {
    this->AskedTime = window->GetContextCreationTime();
    this->Computes = false;
    int count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (int i = 0; i < count && !this->Computes; ++i)
    {
      const auto name = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i));
      this->Computes = name && std::strcmp(name, "GL_ARB_compute_shader") == 0;
    }
  }
  return this->Computes;
}

vtkShaderProgram* vtkGodRaysQuad::BeginCompute(
  vtkOpenGLRenderWindow* window, std::initializer_list<Term> terms)
{
  if (!this->IsReady(window))
  {
    return nullptr;
  }
  auto& kernel = this->Kernels[MakeKey(terms)];
  if (!kernel || !kernel->IsOf(window))
  {
    kernel = vtkSmartPointer<Kernel>::New();
    kernel->Window = window;
    kernel->ContextTime = window->GetContextCreationTime();
    int major = 0;
    int minor = 0;
    window->GetOpenGLVersion(major, minor);
    const char* version = 10 * major + minor >= 43 ? "#version 430\n" : ComputeExtensions;
    kernel->Source = this->Complete(terms, std::string(version) + ComputeHeading, ComputeEnding);
  }
  return this->Take(window->GetShaderCache()->ReadyShaderProgram(kernel));
}

void vtkGodRaysQuad::EndCompute(vtkGodRaysTarget& result)
{
  result.BindImage(0);
  glDispatchCompute((result.GetWidth() + 7) / 8, (result.GetHeight() + 7) / 8, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  this->Window->GetShaderCache()->ReleaseCurrentShader(); // the cache must not keep what is ours
  this->FreeTextures();
}

std::string vtkGodRaysQuad::Include(const std::string& text)
{
  std::set<std::string> included;
  const std::string types = IncludeTopics(TopicMark + TypesName, included);
  std::string result = types + IncludeTopics(text, included);
  std::istringstream lines(types);
  for (std::string word; lines >> word;)
  {
    if (word == "#define" && lines >> word)
    {
      result += "#undef " + word.substr(0, word.find('(')) + "\n";
    }
  }
  return result;
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
  this->Program->SetUniformi(sampler, texture->GetTextureUnit());
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
  this->FreeTextures();
}

void vtkGodRaysQuad::FreeTextures()
{
  for (const auto& texture : this->Textures)
  {
    texture->Deactivate();
  }
  this->Textures.clear();
}

void vtkGodRaysQuad::Release()
{
  this->Program = nullptr;
  this->Helper = nullptr;
  this->Helpers.clear();
  this->Kernels.clear();
  this->Failed = false;
  this->Window = nullptr;
}
