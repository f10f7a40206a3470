// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysMath.h
 * @brief   the formulas of vtkGodRays<Topic>Math.glsl in C++, in double precision
 *
 * Private: never included by a public header. Needs GLM only, no VTK and no OpenGL. All functions
 * are inline, in namespace vtkGodRays; their documentation is where they are written. A layer
 * is any type with a function `Vec3 SampleLayer(const T& layer, const Vec2& uv)` that lookup by
 * argument finds; ImageLayer is the one that reads an image as the graphics card does.
 */

#ifndef vtkGodRaysMath_h
#define vtkGodRaysMath_h

#include "vtkGodRaysPhaseFunction.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace vtkGodRays
{
using Real = double;
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;

#include "vtkGodRaysFormulas.inl"

/**
 * What a layer holds beyond its edges.
 */
enum Border
{
  BORDER_ZERO = 0, ///< nothing: GL_CLAMP_TO_BORDER with border colour 0
  BORDER_EDGE = 1  ///< its outermost pixels: GL_CLAMP_TO_EDGE
};

/**
 * An RGB image, rows from the bottom up, read as GL_LINEAR reads it, in double precision.
 * The pixels are not owned.
 */
template <typename Scalar>
struct ImageLayerOf
{
  const Scalar* Pixels;
  int Width;
  int Height;
  int Border;
};
using ImageLayer = ImageLayerOf<float>;

/**
 * The pixel in column x and row y, or what the border has in its place.
 */
template <typename Scalar>
inline Vec3 FetchPixel(const ImageLayerOf<Scalar>& layer, int x, int y)
{
  const int column = glm::clamp(x, 0, layer.Width - 1);
  const int row = glm::clamp(y, 0, layer.Height - 1);
  if (layer.Border == BORDER_ZERO && (column != x || row != y))
  {
    return Vec3(0.0);
  }
  const Scalar* pixel = layer.Pixels + 3 * (static_cast<std::size_t>(row) * layer.Width + column);
  return Vec3(pixel[0], pixel[1], pixel[2]);
}

/**
 * The image at uv, interpolated linearly between the centres of the four pixels about it.
 */
template <typename Scalar>
inline Vec3 SampleLayer(const ImageLayerOf<Scalar>& layer, const Vec2& uv)
{
  // Beyond two pixels outside nothing changes, and the conversion to int stays defined.
  const Vec2 size(layer.Width, layer.Height);
  const Vec2 position = glm::clamp(uv * size - 0.5, Vec2(-2.0), size + 1.0);
  const Vec2 corner = glm::floor(position);
  const Vec2 t = position - corner;
  const int x = static_cast<int>(corner.x);
  const int y = static_cast<int>(corner.y);
  const Vec3 lower = (1.0 - t.x) * FetchPixel(layer, x, y) + t.x * FetchPixel(layer, x + 1, y);
  const Vec3 upper =
    (1.0 - t.x) * FetchPixel(layer, x, y + 1) + t.x * FetchPixel(layer, x + 1, y + 1);
  return (1.0 - t.y) * lower + t.y * upper;
}
}

#endif
