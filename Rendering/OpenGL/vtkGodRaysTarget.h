// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysTarget
 * @brief   textures to draw into, with their framebuffer; private to this module
 *
 * Prepare() makes what is asked for and does nothing when it is there already, so that it can be
 * called every frame. The depth texture is the target's own, or one lent by another target.
 */

#ifndef vtkGodRaysTarget_h
#define vtkGodRaysTarget_h

#include "vtkOpenGLFramebufferObject.h" // For vtkSmartPointer
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h" // For vtkSmartPointer

#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkWindow;

class vtkGodRaysTarget
{
public:
  /// OpenGL internal formats of the two textures; 0 for none.
  struct Format
  {
    unsigned int Color = 0;
    unsigned int Depth = 0;
    bool operator==(const Format& other) const
    {
      return this->Color == other.Color && this->Depth == other.Depth;
    }
  };

  vtkGodRaysTarget();
  ~vtkGodRaysTarget();
  vtkGodRaysTarget(const vtkGodRaysTarget&) = delete;
  void operator=(const vtkGodRaysTarget&) = delete;

  ///@{
  /**
   * Make textures of this size and format, for this window. The second form borrows the depth texture;
   * without a format of colours there are none, and the target may be a part of the texture: left and lower
   * edge, width and height.
   */
  void Prepare(vtkOpenGLRenderWindow* window, int width, int height, Format format);
  void Prepare(vtkOpenGLRenderWindow* window, unsigned int color, vtkTextureObject* depth,
    const int* part = nullptr);
  ///@}

  /**
   * Make this the framebuffer drawn into, over its whole size, with the scissor set to it.
   * The caller keeps and restores the former bindings. Returns false when the driver refuses the
   * formats.
   */
  bool Bind();

  /// Make the colours of what is bound the image of this number, which compute shaders write.
  void BindImage(unsigned int number);

  void Release(vtkWindow* window);

  const int* GetOrigin() const { return this->Origin; } ///< in the textures [pixels]
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  vtkTextureObject* GetColor() const { return this->Color; }
  vtkTextureObject* GetDepth() const { return this->Depth; }
  unsigned int GetColorFormat() const { return this->Formats.Color; }
  bool IsReady() const { return this->Color || this->Depth; }

  /// A number that changes whenever the contents may have changed.
  unsigned int GetVersion() const { return this->Version; }

  /// Whether the colour is one value a pixel, in red.
  bool HasOneChannel() const;

  ///@{
  /**
   * Copy depth or colours (RGBA) to and from memory.
   */
  std::vector<float> ReadDepth();
  std::vector<float> ReadColor();
  void WriteDepth(const std::vector<float>& depth);
  void WriteColor(const std::vector<float>& color);
  ///@}

  /**
   * Copy the colours, or depths, to memory; waits for the drawing. OpenGL format and type; rowLength is
   * how far apart rows are in memory [pixels], 0 for the width.
   */
  void Read(unsigned int format, unsigned int type, void* pixels, int rowLength);

  /**
   * Copy colours from memory, rows one after the other, to all of it or a part. OpenGL format and type.
   */
  void Write(unsigned int format, unsigned int type, const void* pixels, const int* part = nullptr);

  /**
   * Copy the colours into an image of three 32-bit floats a pixel; waits for the drawing. Where
   * there is one channel only, colours are that times the tint.
   */
  void Download(vtkImageData* image, const double tint[3]);
  void Download(vtkImageData* image)
  {
    const double white[3] = { 1.0, 1.0, 1.0 };
    this->Download(image, white);
  }

private:
  void Attach(vtkOpenGLRenderWindow* window);
  bool IsOf(vtkOpenGLRenderWindow* window) const;

  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkTextureObject> Depth;
  Format Formats;
  int Origin[2] = { 0, 0 };
  int Width = 0;
  int Height = 0;
  unsigned int Version = 0;
};

#endif
