// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysQuad
 * @brief   a shader over the shared mathematics for each pixel of a picture; private to this module
 *
 * A line //VTK::GodRays::<Topic> of the shader's text becomes the formulas of vtkGodRays<Topic>Math.glsl,
 * with those that they need. The tag //VTK::GodRays::Terms becomes a constant
 * bool for each term that a frame needs or does not, so that what is not needed costs nothing. A shader is
 * built at the first Begin() with its terms and kept until Release(): numbers are uniforms, never text.
 *
 * It is a fragment shader, which is drawn as a quad. One that ends with the tag //VTK::GodRays::Main, and has
 * vec4 GetColor(ivec2 pixel) and vec2 pictureSize in the place of main(), can be a compute shader, too: see
 * BeginCompute().
 */

#ifndef vtkGodRaysQuad_h
#define vtkGodRaysQuad_h

#include "vtkSmartPointer.h"

#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkGodRaysTarget;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

class vtkGodRaysQuad
{
public:
  /**
   * @param name of the shader, for the message when it does not compile
   * @param source of the fragment shader
   */
  vtkGodRaysQuad(const char* name, const std::string& source);
  ~vtkGodRaysQuad();
  vtkGodRaysQuad(const vtkGodRaysQuad&) = delete;
  void operator=(const vtkGodRaysQuad&) = delete;

  /// A constant of the shader.
  struct Term
  {
    const char* Name;
    bool Value;
  };

  /**
   * Make the shader current, building it if need be; null, after one error, when that fails.
   * Always give all terms, in one order.
   */
  vtkShaderProgram* Begin(vtkOpenGLRenderWindow* window, std::initializer_list<Term> terms = {});

  ///@{
  /**
   * Make it current as a compute shader, where OpenGL has such; and run it for each pixel of a target that
   * is bound, whose colours it writes. The result can be read as a texture and from its framebuffer.
   */
  bool CanCompute(vtkOpenGLRenderWindow* window);
  vtkShaderProgram* BeginCompute(
    vtkOpenGLRenderWindow* window, std::initializer_list<Term> terms = {});
  void EndCompute(vtkGodRaysTarget& result);
  ///@}

  /**
   * Returns a text with the formulas that it names, without their macros at the end: for shaders of others.
   */
  static std::string Include(const std::string& text);

  /**
   * How often Begin() has returned null, of all shaders: what fails in between was told of already.
   */
  static int GetNumberOfFailures();

  /**
   * Set a uniform of three numbers.
   */
  static void SetVector(vtkShaderProgram* program, const char* name, const double value[3]);

  /**
   * Bind a texture to a sampler of the shader until the next End().
   */
  void SetTexture(const char* sampler, vtkTextureObject* texture);

  /// Where to draw.
  enum Place
  {
    EVERYWHERE = 0, ///< without depth test
    BEHIND = 1,     ///< where the framebuffer's depth is that of nothing
    BEFORE = 2      ///< where it is that of something
  };

  /**
   * Draw over the viewport, and free the textures' units.
   */
  void End(Place place = EVERYWHERE);

  void Release();

private:
  class Kernel;

  bool IsReady(vtkOpenGLRenderWindow* window);
  std::string Complete(
    std::initializer_list<Term> terms, const std::string& heading, const char* ending);
  vtkShaderProgram* Take(vtkShaderProgram* program);
  void FreeTextures();

  const char* Name;
  std::string Source;
  bool Failed = false;
  bool Computes = false;
  vtkMTimeType AskedTime = 0; // for which context that was found
  vtkOpenGLRenderWindow* Window = nullptr;
  std::map<unsigned int, std::unique_ptr<vtkOpenGLQuadHelper>> Helpers; // by values of the terms
  std::map<unsigned int, vtkSmartPointer<Kernel>> Kernels;
  vtkOpenGLQuadHelper* Helper = nullptr; // that Begin() chose
  vtkShaderProgram* Program = nullptr;   // that is current
  std::vector<vtkSmartPointer<vtkTextureObject>> Textures;
};

#endif
