// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The pictures and lights that the benchmark measures on: the same on every machine, in every run.

#ifndef GodRaysPictures_h
#define GodRaysPictures_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>
#include <vector>

namespace GodRaysPictures
{
/// A light, by its place in the picture [fractions of its width and height].
struct Light
{
  const char* Name;
  double U;
  double V;

  bool IsOnScreen() const
  {
    return this->U >= 0.0 && this->U <= 1.0 && this->V >= 0.0 && this->V <= 1.0;
  }
};

inline const std::vector<Light>& GetLights()
{
  static const std::vector<Light> lights = { { "centre", 0.5, 0.5 }, { "near edge", 0.035, 0.62 },
    { "corner", 0.0, 0.0 }, { "0.5 off", -0.5, 0.31 }, { "10 off", -10.0, 0.3 },
    { "10 off diagonal", 7.1, -7.0 } };
  return lights;
}

/// What stands before the light: 1 where it is open, 0 where it is blocked; rows from below.
struct Mask
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Open;

  Mask(int width, int height)
    : Width(width)
    , Height(height)
    , Open(static_cast<std::size_t>(width) * height, 1.0f)
  {
  }

  float& At(int x, int y) { return this->Open[static_cast<std::size_t>(y) * this->Width + x]; }

  /// Set every pixel by a function of its column and row.
  template <typename Function>
  void Fill(const Function& function)
  {
    for (int y = 0; y < this->Height; ++y)
    {
      for (int x = 0; x < this->Width; ++x)
      {
        this->At(x, y) = static_cast<float>(function(x, y));
      }
    }
  }

  /// Sizes are those of a picture of 1280 by 720.
  double GetScale() const { return this->Height / 720.0; }
};

/// A number from 0 to 1 for two numbers, the same every time.
inline double Hash(int x, int y)
{
  unsigned int h = x * 374761393u + y * 668265263u;
  h = (h ^ (h >> 13)) * 1274126177u;
  return ((h ^ (h >> 16)) & 0xffffffu) / 16777216.0;
}

/// Hash() between whole numbers.
inline double SmoothNoise(double x, double y)
{
  const double left = std::floor(x);
  const double low = std::floor(y);
  const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double fx = ease(x - left);
  const double fy = ease(y - low);
  const auto at = [&](int i, int j)
  { return Hash(static_cast<int>(left) + i, static_cast<int>(low) + j); };
  return (1.0 - fy) * ((1.0 - fx) * at(0, 0) + fx * at(1, 0)) +
    fy * ((1.0 - fx) * at(0, 1) + fx * at(1, 1));
}

/// Large discs.
inline void DrawDiscs(Mask& mask)
{
  const double scale = mask.GetScale();
  const double discs[][3] = { { 0.34, 0.36, 70 }, { 0.66, 0.62, 50 }, { 0.2, 0.85, 60 },
    { 0.85, 0.25, 35 }, { 0.52, 0.22, 40 } };
  mask.Fill(
    [&](double x, double y)
    {
      for (const double* disc : discs)
      {
        if (std::hypot(x - disc[0] * mask.Width, y - disc[1] * mask.Height) < disc[2] * scale)
        {
          return 0.0;
        }
      }
      return 1.0;
    });
}

/// A slanted lattice, and a statue: a head on shoulders on a pedestal.
inline void DrawLattice(Mask& mask)
{
  const double scale = mask.GetScale();
  mask.Fill(
    [&](double x, double y)
    {
      const double dx = (x - 0.62 * mask.Width) / scale;
      const double dy = y / scale;
      if (std::hypot(dx, dy - 400.0) < 45.0 || std::hypot(dx / 110.0, (dy - 260.0) / 120.0) < 1.0 ||
        (std::abs(dx) < 80.0 && dy < 170.0))
      {
        return 0.0;
      }
      const double a = (0.955 * x + 0.296 * y) / (22.0 * scale);
      const double b = (0.955 * y - 0.296 * x) / (26.0 * scale);
      return a - std::floor(a) < 0.1 || b - std::floor(b) < 0.085 ? 0.0 : 1.0;
    });
}

/// Clouds: seven octaves of noise, half open.
inline void DrawClouds(Mask& mask)
{
  const double scale = mask.GetScale();
  mask.Fill(
    [&](double x, double y)
    {
      double sum = 0.0;
      for (int octave = 0; octave < 7; ++octave)
      {
        const double frequency = std::ldexp(1.0 / (220.0 * scale), octave);
        sum += std::ldexp(0.5, -octave) * SmoothNoise(x * frequency, y * frequency);
      }
      return 1.0 - std::min(1.0, std::max(0.0, (sum - 0.42) / 0.14));
    });
}

/// Branches of a tree, drawn as capsules, from a point in a direction [radians].
inline void Grow(Mask& mask, double x, double y, double angle, double length, double radius,
  int depth, std::mt19937& random)
{
  if (depth == 0 || radius < 0.35)
  {
    return;
  }
  const double endX = x + length * std::cos(angle);
  const double endY = y + length * std::sin(angle);
  const int left = std::max(0, static_cast<int>(std::min(x, endX) - radius));
  const int right = std::min(mask.Width - 1, static_cast<int>(std::max(x, endX) + radius + 1));
  const int low = std::max(0, static_cast<int>(std::min(y, endY) - radius));
  const int high = std::min(mask.Height - 1, static_cast<int>(std::max(y, endY) + radius + 1));
  for (int j = low; j <= high; ++j)
  {
    for (int i = left; i <= right; ++i)
    {
      const double along = ((i - x) * std::cos(angle) + (j - y) * std::sin(angle)) / length;
      const double t = std::min(1.0, std::max(0.0, along));
      if (std::hypot(i - x - t * (endX - x), j - y - t * (endY - y)) < radius)
      {
        mask.At(i, j) = 0.0f;
      }
    }
  }
  for (const double turn : { -0.45, 0.05, 0.5 })
  {
    const double spread = 0.6 * (random() / 4294967296.0 - 0.5); // of any library the same
    Grow(mask, endX, endY, angle + turn + spread, 0.76 * length, 0.66 * radius, depth - 1, random);
  }
}

inline void DrawTrees(Mask& mask)
{
  const double scale = mask.GetScale();
  std::mt19937 random(7);
  Grow(mask, 0.5 * mask.Width, 0.0, 1.5, 170.0 * scale, 17.0 * scale, 10, random);
  Grow(mask, 0.15 * mask.Width, 0.0, 1.7, 120.0 * scale, 11.0 * scale, 9, random);
  Grow(mask, 0.85 * mask.Width, 0.0, 1.4, 130.0 * scale, 12.0 * scale, 9, random);
}

/// Bars of one pixel, whatever the size of the picture: the hardest case.
inline void DrawPixelLattice(Mask& mask)
{
  mask.Fill([](int x, int y) { return x % 7 == 0 || y % 9 == 0 ? 0.0 : 1.0; });
}

struct Picture
{
  const char* Name;
  void (*Draw)(Mask& mask);
};

inline const std::vector<Picture>& GetPictures()
{
  static const std::vector<Picture> pictures = { { "discs", DrawDiscs }, { "lattice", DrawLattice },
    { "clouds", DrawClouds }, { "trees", DrawTrees }, { "one-pixel lattice", DrawPixelLattice } };
  return pictures;
}

/// The nearest number that 16 bits can hold, for numbers from 2^-14 to 65504; 0 for smaller ones.
/// A layer of such numbers is the same in 16 bits and in 32.
inline float RoundToHalf(float value)
{
  if (value < 6.103515625e-5f)
  {
    return 0.0f;
  }
  unsigned int bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  bits += 0x0fffu + ((bits >> 13) & 1u);
  bits &= ~0x1fffu;
  std::memcpy(&value, &bits, sizeof(bits));
  return value;
}

/// The layer of a light: a disc of 1 with a halo about it, behind what blocks it.
inline std::vector<float> MakeLayer(const Mask& mask, const Light& light)
{
  std::vector<float> layer(mask.Open.size());
  const double away = std::max({ 0.0, -light.U, light.U - 1.0, -light.V, light.V - 1.0 });
  const double reach = (0.35 + 0.7 * away) * mask.Width;
  std::size_t i = 0;
  for (int y = 0; y < mask.Height; ++y)
  {
    for (int x = 0; x < mask.Width; ++x, ++i)
    {
      const double distance = std::hypot(x - light.U * mask.Width, y - light.V * mask.Height);
      const double glow =
        distance < 0.03 * mask.Width ? 1.0 : 0.1 + 0.5 * std::exp(-distance / reach);
      layer[i] = RoundToHalf(static_cast<float>(mask.Open[i] * glow));
    }
  }
  return layer;
}
}

#endif
