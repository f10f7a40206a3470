// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LinearPicture.h"

#include "Failure.h"

#include "vtkFloatArray.h"
#include "vtkGodRaysToneMappingFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
//------------------------------------------------------------------------------
bool HasFloats(vtkOpenGLFramebufferObject* buffer)
{
  vtkTextureObject* color = buffer->GetColorAttachmentAsTextureObject(0);
  return color && color->GetVTKDataType() == VTK_FLOAT;
}

//------------------------------------------------------------------------------
/**
 * Draw in 32 bits, with depth and stencil as VTK's window has them.
 */
bool DrawInFloats(vtkOpenGLRenderWindow* window)
{
  window->MakeCurrent();
  const int* size = window->GetSize();
  constexpr int depthBits = 32;
  // what is drawn into, and what it is copied to at the end of a frame
  const bool isMade =
    window->GetRenderFramebuffer()->PopulateFramebuffer(size[0], size[1], true, 1, VTK_FLOAT, true,
      depthBits, window->GetMultiSamples(), window->GetStencilCapable() != 0) &&
    window->GetDisplayFramebuffer()->PopulateFramebuffer(
      size[0], size[1], true, 1, VTK_FLOAT, false, depthBits, 0, false);
  if (isMade)
  {
    window->Render();
  }
  return isMade;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> TakeLinearPicture(vtkRenderWindow* window, bool transparent)
{
  auto* drawn = vtkOpenGLRenderWindow::SafeDownCast(window);
  const bool isReady = drawn && (HasFloats(drawn->GetDisplayFramebuffer()) || DrawInFloats(drawn));
  if (!isReady || !HasFloats(drawn->GetDisplayFramebuffer()))
  {
    throw Failure(
      "--output: the display cannot draw in colours of 32 bits; write a .png", Failure::Display);
  }
  const int* size = window->GetSize();
  vtkNew<vtkFloatArray> colors;
  constexpr int shown = 1; // what was drawn would be resolved to 8 bits
  window->GetRGBAPixelData(0, 0, size[0] - 1, size[1] - 1, shown, colors);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(size[0], size[1], 1);
  const int components = transparent ? 4 : 3;
  picture->AllocateScalars(VTK_FLOAT, components);
  auto* light = static_cast<float*>(picture->GetScalarPointer());
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      light[components * i + c] = static_cast<float>(
        vtkGodRaysToneMappingFilter::Decode(std::max(0.0F, colors->GetValue(4 * i + c))));
    }
    if (transparent)
    {
      light[components * i + 3] = std::clamp(colors->GetValue(4 * i + 3), 0.0F, 1.0F);
    }
  }
  return picture;
}
