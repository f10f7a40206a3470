// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysTarget.h"

#include "vtkGodRaysOpenGL.h"
#include "vtkImageData.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cstddef>

namespace
{
bool HasOneChannel(unsigned int format)
{
  return format == GL_R16F || format == GL_R32F;
}

/// A colour texture that filters linearly and is 0 outside unless told otherwise.
vtkSmartPointer<vtkTextureObject> MakeColor(
  vtkOpenGLRenderWindow* window, int width, int height, unsigned int format)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetInternalFormat(format);
  texture->SetFormat(HasOneChannel(format) ? GL_RED : GL_RGBA);
  texture->SetDataType(format == GL_RGBA8 ? GL_UNSIGNED_BYTE : GL_FLOAT);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetBorderColor(0.0f, 0.0f, 0.0f, 0.0f);
  texture->Allocate2D(width, height, HasOneChannel(format) ? 1 : 4,
    format == GL_RGBA8 ? VTK_UNSIGNED_CHAR : VTK_FLOAT);
  return texture;
}

/// A depth texture of exactly this format, so that depth can be copied into it bit by bit.
vtkSmartPointer<vtkTextureObject> MakeDepth(
  vtkOpenGLRenderWindow* window, int width, int height, unsigned int format)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  switch (format)
  {
    case GL_DEPTH24_STENCIL8:
      texture->AllocateDepthStencil(width, height);
      break;
    case GL_DEPTH_COMPONENT32F:
      texture->AllocateDepth(width, height, vtkTextureObject::Float32);
      break;
    case GL_DEPTH_COMPONENT24:
      texture->AllocateDepth(width, height, vtkTextureObject::Fixed24);
      break;
    case GL_DEPTH_COMPONENT16:
      texture->AllocateDepth(width, height, vtkTextureObject::Fixed16);
      break;
    default:
      texture->AllocateDepth(width, height, vtkTextureObject::Fixed32);
      break;
  }
  return texture;
}
}

vtkGodRaysTarget::vtkGodRaysTarget() = default;
vtkGodRaysTarget::~vtkGodRaysTarget() = default;

void vtkGodRaysTarget::Prepare(vtkOpenGLRenderWindow* window, int width, int height, Format format)
{
  if (this->IsReady() && this->IsOf(window) && this->Width == width && this->Height == height &&
    this->Formats == format)
  {
    return;
  }
  this->Release(window);
  this->Width = width;
  this->Height = height;
  this->Formats = format;
  if (format.Color)
  {
    this->Color = MakeColor(window, width, height, format.Color);
  }
  if (format.Depth)
  {
    this->Depth = MakeDepth(window, width, height, format.Depth);
  }
  this->Attach(window);
}

void vtkGodRaysTarget::Prepare(
  vtkOpenGLRenderWindow* window, unsigned int color, vtkTextureObject* depth, const int* part)
{
  const int whole[4] = { 0, 0, static_cast<int>(depth->GetWidth()),
    static_cast<int>(depth->GetHeight()) };
  part = part ? part : whole;
  if (this->IsOf(window) && this->Depth == depth && std::equal(part, part + 2, this->Origin) &&
    this->Width == part[2] && this->Height == part[3] && this->Formats.Color == color)
  {
    return;
  }
  this->Release(window);
  std::copy_n(part, 2, this->Origin);
  this->Width = part[2];
  this->Height = part[3];
  this->Formats = { color, 0 };
  this->Color = color ? MakeColor(window, this->Width, this->Height, color) : nullptr;
  this->Depth = depth;
  this->Attach(window);
}

void vtkGodRaysTarget::Attach(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind();
  if (this->Color)
  {
    this->Framebuffer->AddColorAttachment(0, this->Color);
    this->Framebuffer->ActivateDrawBuffer(0);
    this->Framebuffer->ActivateReadBuffer(0);
  }
  else
  {
    this->Framebuffer->DeactivateDrawBuffers();
    this->Framebuffer->DeactivateReadBuffer();
  }
  if (this->Depth)
  {
    this->Framebuffer->AddDepthAttachment(this->Depth);
  }
  state->PopFramebufferBindings();
}

bool vtkGodRaysTarget::IsOf(vtkOpenGLRenderWindow* window) const
{
  return this->Framebuffer && this->Framebuffer->GetContext() == window;
}

bool vtkGodRaysTarget::Bind()
{
  ++this->Version;
  this->Framebuffer->Bind();
  vtkOpenGLState* state = this->Framebuffer->GetContext()->GetState();
  state->vtkglViewport(this->Origin[0], this->Origin[1], this->Width, this->Height);
  state->vtkglScissor(this->Origin[0], this->Origin[1], this->Width, this->Height);
  const char* description = nullptr;
  return vtkOpenGLFramebufferObject::GetFrameBufferStatus(
    vtkOpenGLFramebufferObject::GetDrawMode(), description);
}

void vtkGodRaysTarget::BindImage(unsigned int number)
{
  glBindImageTexture(
    number, this->Color->GetHandle(), 0, GL_FALSE, 0, GL_WRITE_ONLY, this->Formats.Color);
}

void vtkGodRaysTarget::Release(vtkWindow* window)
{
  ++this->Version;
  if (this->Framebuffer)
  {
    this->Framebuffer->ReleaseGraphicsResources(window);
    this->Framebuffer = nullptr;
  }
  if (this->Color)
  {
    this->Color->ReleaseGraphicsResources(window);
    this->Color = nullptr;
  }
  if (this->Depth)
  {
    if (this->Formats.Depth) // a borrowed texture stays with its owner
    {
      this->Depth->ReleaseGraphicsResources(window);
    }
    this->Depth = nullptr;
  }
  this->Origin[0] = this->Origin[1] = this->Width = this->Height = 0;
}

bool vtkGodRaysTarget::HasOneChannel() const
{
  return ::HasOneChannel(this->Formats.Color);
}

void vtkGodRaysTarget::Read(unsigned int format, unsigned int type, void* pixels, int rowLength)
{
  vtkOpenGLState* state = this->Framebuffer->GetContext()->GetState();
  state->PushReadFramebufferBinding();
  this->Framebuffer->Bind(vtkOpenGLFramebufferObject::GetReadMode());
  if (this->Color)
  {
    this->Framebuffer->ActivateReadBuffer(0);
  }
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, rowLength); // which vtkOpenGLState does not know
  glReadPixels(this->Origin[0], this->Origin[1], this->Width, this->Height, format, type, pixels);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  state->PopReadFramebufferBinding();
}

void vtkGodRaysTarget::Write(
  unsigned int format, unsigned int type, const void* pixels, const int* part)
{
  const int whole[4] = { 0, 0, this->Width, this->Height };
  part = part ? part : whole;
  ++this->Version;
  this->Color->Activate();
  vtkOpenGLState* state = this->Framebuffer->GetContext()->GetState();
  state->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, part[0], part[1], part[2], part[3], format, type, pixels);
  this->Color->Deactivate();
}

void vtkGodRaysTarget::Download(vtkImageData* image, const double tint[3])
{
  image->SetDimensions(this->Width, this->Height, 1);
  image->SetOrigin(0.0, 0.0, 0.0);
  image->SetSpacing(1.0, 1.0, 1.0);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  this->Read(GL_RGB, GL_FLOAT, values, 0);
  if (this->HasOneChannel())
  {
    const std::ptrdiff_t count = static_cast<std::ptrdiff_t>(this->Width) * this->Height;
    for (std::ptrdiff_t i = 0; i < count; ++i)
    {
      const double value = values[3 * i];
      for (int c = 0; c < 3; ++c)
      {
        values[3 * i + c] = static_cast<float>(tint[c] * value);
      }
    }
  }
}

std::vector<float> vtkGodRaysTarget::ReadDepth()
{
  std::vector<float> depth(static_cast<std::size_t>(this->Width) * this->Height);
  this->Read(GL_DEPTH_COMPONENT, GL_FLOAT, depth.data(), 0);
  return depth;
}

std::vector<float> vtkGodRaysTarget::ReadColor()
{
  std::vector<float> color(4 * static_cast<std::size_t>(this->Width) * this->Height);
  this->Read(GL_RGBA, GL_FLOAT, color.data(), 0);
  return color;
}

void vtkGodRaysTarget::WriteDepth(const std::vector<float>& depth)
{
  this->Depth->Activate();
  this->Framebuffer->GetContext()->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(GL_TEXTURE_2D, 0, this->Origin[0], this->Origin[1], this->Width, this->Height,
    GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  this->Depth->Deactivate();
}

void vtkGodRaysTarget::WriteColor(const std::vector<float>& color)
{
  this->Write(GL_RGBA, GL_FLOAT, color.data());
}
