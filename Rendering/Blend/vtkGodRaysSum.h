// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSum
 * @brief   the light scattered towards the eye by all lights of a frame; private to this module
 *
 * Integrators draw into it (BindToAdd()), or hand over a texture that they filled themselves (Lend()).
 * The one texture of a single light is used as it is, without another copy of the picture.
 *
 * A light may have a response. The sum of one light is then shown with it, and added with it to that of
 * others.
 */

#ifndef vtkGodRaysSum_h
#define vtkGodRaysSum_h

#include "vtkGodRaysBlendPass.h" // For LightResponse
#include "vtkGodRaysTarget.h"

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkWindow;

class vtkGodRaysSum
{
public:
  vtkGodRaysSum();
  ~vtkGodRaysSum();
  vtkGodRaysSum(const vtkGodRaysSum&) = delete;
  void operator=(const vtkGodRaysSum&) = delete;

  /**
   * Start a frame with no light: width and height of the picture [pixels], GL_RGBA16F or GL_RGBA32F.
   */
  void Begin(vtkOpenGLRenderWindow* window, int width, int height, unsigned int format);

  /**
   * Set the response of the lights that are added from now on, until Begin(). Default is a linear one.
   */
  void SetResponse(const vtkGodRaysBlendPass::LightResponse& response)
  {
    this->Response = response;
  }
  bool IsLinear() const { return this->Response.IsLinear(); }

  /**
   * Make the sum the framebuffer drawn into, with blending set so that what is drawn over the whole
   * of it is added. The caller keeps and restores the former state. Returns false when the driver
   * refuses.
   */
  bool BindToAdd();

  ///@{
  /**
   * Add colours that cover the picture, or a larger layer of whose width and height the picture is
   * a fraction, about its centre. One channel counts times the tint, which otherwise is not read.
   * Lent colours are read until Settle() or the next frame's Begin(); before then the lender must
   * not change them. Returns false, after an error, if that failed.
   */
  bool Add(vtkGodRaysTarget& colors, const double tint[3], double viewScale);
  bool Lend(vtkGodRaysTarget& colors, const double tint[3], double viewScale);
  bool Settle();
  ///@}

  /**
   * End a frame: what is lent is added, unless it is all that there is. Returns false, after an error, if
   * that failed.
   */
  bool Finish() { return !this->Drawn || this->Settle(); }

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  unsigned int GetFormat() const { return this->Format; }
  bool IsEmpty() const { return !this->Drawn && !this->Lent; }

  ///@{
  /**
   * What there is: a texture, of one channel times a tint if that is not null; null without light.
   */
  vtkTextureObject* GetTexture() const;
  const double* GetTint() const;
  ///@}

  /**
   * The response with which the texture is to be shown; null if there is none.
   */
  const vtkGodRaysBlendPass::LightResponse* GetResponse() const;

  ///@{
  /**
   * Copy it, or the light that was added last, without its response, into an image of three 32-bit floats a
   * pixel; waits for the drawing. Lights without a response cannot be told apart: then the second copies all.
   * False, and the image is left alone, without light, and if what was lent is not there any more.
   */
  bool Download(vtkImageData* image);
  bool DownloadLinear(vtkImageData* image);
  ///@}

  void Release(vtkWindow* window);

private:
  bool BindTarget();
  bool Draw(vtkGodRaysTarget& colors, const double tint[3], double viewScale,
    const vtkGodRaysBlendPass::LightResponse& response);

  vtkGodRaysTarget Target;
  vtkSmartPointer<vtkGodRaysBlendPass> Adding;
  vtkOpenGLRenderWindow* Window = nullptr;
  int Width = 0;
  int Height = 0;
  unsigned int Format = 0;
  bool Drawn = false;
  vtkGodRaysTarget Staging; // of one light with a response, which is drawn rather than lent
  vtkGodRaysBlendPass::LightResponse Response;
  vtkGodRaysBlendPass::LightResponse LentResponse;
  vtkGodRaysTarget* Lent = nullptr;
  unsigned int LentVersion = 0;
  double Tint[3] = { 1.0, 1.0, 1.0 };
};

#endif
