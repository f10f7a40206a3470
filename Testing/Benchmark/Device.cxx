// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Device.h"

#include "GodRaysPictures.h"

#include "vtkGodRaysOpenGL.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderingOpenGLConfigure.h"
#include "vtkShaderProgram.h"
#include "vtkVersionMacros.h"

#include <chrono>
#include <cstdlib>
#include <vector>

#ifdef VTK_USE_X
#include <dlfcn.h>
#endif

namespace
{
const char* const CopyShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D picture;
void main()
{
  gl_FragData[0] = texture(picture, texCoord);
}
)";

// With a light inside the picture: all taps are in it.
const char* const MarchShader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D picture;
void main()
{
  vec2 position = texCoord;
  vec2 stride = (position - vec2(0.53, 0.56)) * (0.96 / 60.0);
  float weight = 0.4;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 60; ++i)
  {
    position -= stride;
    sum += weight * texture(picture, position);
    weight *= 0.93;
  }
  gl_FragData[0] = 0.6 * sum;
}
)";
}

//------------------------------------------------------------------------------
std::string FindWhyNoDisplay()
{
#if defined(VTK_OPENGL_HAS_EGL) && VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  if (!vtkNew<vtkRenderWindow>()->SupportsOpenGL()) // without a display VTK draws through EGL
  {
    return "VTK finds no OpenGL, neither on a display nor through EGL";
  }
#elif defined(VTK_USE_X)
  const std::string remedy =
    "; run the program in a desktop session, or under xvfb-run -a -s \"-screen 0 1280x1024x24 "
    "-noreset\"";
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    return "there is no X display to draw on (DISPLAY is not set)" + remedy;
  }
  // VTK, which is linked to it, has loaded this library
  using Open = void* (*)(const char*);
  using Close = int (*)(void*);
  const auto open = reinterpret_cast<Open>(dlsym(RTLD_DEFAULT, "XOpenDisplay"));
  const auto close = reinterpret_cast<Close>(dlsym(RTLD_DEFAULT, "XCloseDisplay"));
  if (open && close)
  {
    void* display = open(name);
    if (!display)
    {
      return "the X display " + std::string(name) + " cannot be opened" + remedy;
    }
    close(display);
  }
#endif
  return {};
}

//------------------------------------------------------------------------------
Device::Device()
{
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(64, 64);
  this->Window->Render();
  this->OpenGLWindow = vtkOpenGLRenderWindow::SafeDownCast(this->Window);
  this->Copy =
    std::make_unique<vtkOpenGLQuadHelper>(this->OpenGLWindow, nullptr, CopyShader, nullptr);
  this->March =
    std::make_unique<vtkOpenGLQuadHelper>(this->OpenGLWindow, nullptr, MarchShader, nullptr);
}

//------------------------------------------------------------------------------
Device::~Device()
{
  this->From.Release(this->Window);
  this->To.Release(this->Window);
}

//------------------------------------------------------------------------------
std::string Device::GetRendererName() const
{
  this->OpenGLWindow->MakeCurrent();
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

//------------------------------------------------------------------------------
double Device::Measure(const std::function<void()>& run)
{
  this->OpenGLWindow->MakeCurrent();
  glFinish();
  const auto start = std::chrono::steady_clock::now();
  run();
  glFinish();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  return time.count();
}

//------------------------------------------------------------------------------
void Device::PrepareUnits(int width, int height)
{
  this->OpenGLWindow->MakeCurrent();
  this->From.Prepare(this->OpenGLWindow, width, height, { GL_RGBA8, 0 });
  this->To.Prepare(this->OpenGLWindow, width, height, { GL_RGBA8, 0 });
  GodRaysPictures::Mask mask(width, height);
  GodRaysPictures::DrawDiscs(mask);
  std::vector<unsigned char> pixels;
  for (float open : mask.Open)
  {
    pixels.insert(pixels.end(), 4, static_cast<unsigned char>(255.0f * open));
  }
  this->From.Write(GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

//------------------------------------------------------------------------------
double Device::Draw(vtkOpenGLQuadHelper& quad)
{
  vtkOpenGLState* state = this->OpenGLWindow->GetState();
  return this->Measure(
    [&]()
    {
      state->PushFramebufferBindings();
      this->To.Bind();
      state->vtkglDisable(GL_BLEND);
      state->vtkglDisable(GL_DEPTH_TEST);
      this->OpenGLWindow->GetShaderCache()->ReadyShaderProgram(quad.Program);
      this->From.GetColor()->Activate();
      quad.Program->SetUniformi("picture", this->From.GetColor()->GetTextureUnit());
      quad.Render();
      this->From.GetColor()->Deactivate();
      state->PopFramebufferBindings();
    });
}

//------------------------------------------------------------------------------
double Device::MeasureCopy()
{
  return this->Draw(*this->Copy);
}

//------------------------------------------------------------------------------
double Device::MeasureMarch()
{
  return this->Draw(*this->March);
}
