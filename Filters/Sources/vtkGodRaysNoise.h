// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysNoise.h
 * @brief   random numbers by index, gradient noise with its gradient, and sums of its octaves
 *
 * Private. Each value follows from its arguments alone, in whole numbers as far as chance goes: it is
 * the same on every thread and in any order.
 *
 * vtkPerlinNoise is not used: it has no seed, its gradient is always 0, and its cubic weights leave
 * creases, which are seen in normals. Documentation/Evidence/Sources.md has figures.
 */

#ifndef vtkGodRaysNoise_h
#define vtkGodRaysNoise_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace vtkGodRaysNoise
{
using Vector = std::array<double, 3>;

/**
 * Mixes the bits of a number: a bijection. [Wellons2018], lowbias32.
 */
inline std::uint32_t Hash(std::uint32_t bits)
{
  bits = (bits ^ (bits >> 16)) * 0x7feb352du;
  bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
  return bits ^ (bits >> 16);
}

/**
 * Another seed for each channel of one.
 */
inline std::uint32_t MakeSeed(std::uint32_t seed, std::uint32_t channel)
{
  return Hash(Hash(seed) + channel);
}

/**
 * The random number of an index, in [0, 1).
 */
inline double Uniform(std::uint32_t seed, std::uint64_t index)
{
  const auto low = static_cast<std::uint32_t>(index);
  const auto high = static_cast<std::uint32_t>(index >> 32);
  return Hash(low + Hash(high + seed)) / 4294967296.0;
}

/**
 * 0 below the one edge, 1 above the other, and smooth between; a step where they are the same.
 */
inline double SmoothStep(double below, double above, double value)
{
  if (value <= below || value >= above)
  {
    return value < above ? 0.0 : 1.0;
  }
  const double t = (value - below) / (above - below);
  return t * t * (3.0 - 2.0 * t);
}

struct Sample
{
  double Value = 0.0;
  Vector Gradient = { 0.0, 0.0, 0.0 }; // [1/unit of position]
};

/**
 * Root mean square of GradientNoise over space [no unit].
 */
constexpr double RootMeanSquare = 0.2605;

/**
 * Gradient noise: 0 at whole coordinates, with a random slope there, one of those to the 12 edges of
 * a cube, and between them blended by 6 t^5 - 15 t^4 + 10 t^3, so that its second derivatives are
 * continuous. Within [-1, 1]. [Perlin2002]
 */
inline Sample GradientNoise(const Vector& position, std::uint32_t seed)
{
  constexpr double largest = 1.0363538112118025;     // of the sum below
  constexpr double mostPrecise = 9007199254740992.0; // 2^53: numbers beyond have no fraction
  std::array<std::int64_t, 3> cell;
  double offset[3][2]; // from the lower and the upper corners
  double weight[3][2];
  double slope[3];
  for (int i = 0; i < 3; ++i)
  {
    const double inRange = std::min(std::max(position[i], -mostPrecise), mostPrecise);
    const double floor = std::floor(inRange);
    const double t = inRange - floor;
    cell[i] = static_cast<std::int64_t>(floor);
    offset[i][0] = t;
    offset[i][1] = t - 1.0;
    weight[i][1] = t * t * t * ((6.0 * t - 15.0) * t + 10.0);
    weight[i][0] = 1.0 - weight[i][1];
    slope[i] = 30.0 * t * t * (t - 1.0) * (t - 1.0);
  }

  Sample sum;
  const int corners = offset[2][0] == 0.0 ? 1 : 2; // at whole z, the upper ones weigh nothing
  for (int z = 0; z < corners; ++z)
  {
    const std::uint32_t hashZ = Hash(static_cast<std::uint32_t>(cell[2] + z) + seed);
    for (int y = 0; y < 2; ++y)
    {
      const std::uint32_t hashY = Hash(static_cast<std::uint32_t>(cell[1] + y) + hashZ);
      for (int x = 0; x < 2; ++x)
      {
        // An edge is parallel to one axis and leads along the two others, each way.
        const std::uint32_t hash = Hash(static_cast<std::uint32_t>(cell[0] + x) + hashY);
        const std::uint32_t axis = ((hash >> 8) * 3u) >> 24;
        const double first = hash & 1u ? 1.0 : -1.0;
        const double second = hash & 2u ? 1.0 : -1.0;
        const Vector edge = { axis == 0 ? 0.0 : first,
          axis == 1     ? 0.0
            : axis == 0 ? first
                        : second,
          axis == 2 ? 0.0 : second };
        const double plane =
          edge[0] * offset[0][x] + edge[1] * offset[1][y] + edge[2] * offset[2][z];
        const double yz = weight[1][y] * weight[2][z];
        const double xz = weight[0][x] * weight[2][z];
        const double xy = weight[0][x] * weight[1][y];
        const double all = weight[0][x] * yz;
        sum.Value += all * plane;
        sum.Gradient[0] += all * edge[0] + (x ? slope[0] : -slope[0]) * yz * plane;
        sum.Gradient[1] += all * edge[1] + (y ? slope[1] : -slope[1]) * xz * plane;
        sum.Gradient[2] += all * edge[2] + (z ? slope[2] : -slope[2]) * xy * plane;
      }
    }
  }
  sum.Value /= largest;
  for (double& component : sum.Gradient)
  {
    component /= largest;
  }
  return sum;
}

/**
 * Fractal Brownian motion: octaves of noise, each finer than the one before by Lacunarity and lower
 * by Gain [MusgraveKolbMace1989].
 */
struct Fractal
{
  int Octaves = 1;
  double Gain = 0.5;
  double Lacunarity = 2.0;
  std::uint32_t Seed = 0;

  // The sum of the amplitudes of all octaves: the bound of their sum.
  double GetBound() const
  {
    double bound = 0.0;
    double amplitude = 1.0;
    for (int i = 0; i < this->Octaves; ++i, amplitude *= this->Gain)
    {
      bound += amplitude;
    }
    return bound;
  }

  // Root mean square of Evaluate(): octaves are independent.
  double GetRootMeanSquare() const
  {
    double square = 0.0;
    double amplitude = 1.0;
    for (int i = 0; i < this->Octaves; ++i, amplitude *= this->Gain)
    {
      square += amplitude * amplitude;
    }
    return RootMeanSquare * std::sqrt(square) / this->GetBound();
  }

  /**
   * The first octaves of the sum, in units of the bound of all: within [-1, 1]. Each octave is turned
   * about z by atan(3/4) against the one before, so that the directions of its lattice do not add up.
   */
  Sample Evaluate(const Vector& position, int octaves) const
  {
    Sample sum;
    double amplitude = 1.0 / this->GetBound();
    double scale = 1.0;
    double cosine = 1.0; // of the octave's turn
    double sine = 0.0;
    for (int i = 0; i < octaves; ++i)
    {
      const Vector turned = { scale * (cosine * position[0] - sine * position[1]),
        scale * (sine * position[0] + cosine * position[1]), scale * position[2] };
      const Sample noise =
        GradientNoise(turned, MakeSeed(this->Seed, static_cast<unsigned int>(i)));
      const double steepness = amplitude * scale;
      sum.Value += amplitude * noise.Value;
      sum.Gradient[0] += steepness * (cosine * noise.Gradient[0] + sine * noise.Gradient[1]);
      sum.Gradient[1] += steepness * (cosine * noise.Gradient[1] - sine * noise.Gradient[0]);
      sum.Gradient[2] += steepness * noise.Gradient[2];
      const double oldCosine = cosine;
      cosine = 0.8 * oldCosine - 0.6 * sine;
      sine = 0.6 * oldCosine + 0.8 * sine;
      amplitude *= this->Gain;
      scale *= this->Lacunarity;
    }
    return sum;
  }
  Sample Evaluate(const Vector& position) const { return this->Evaluate(position, this->Octaves); }
};
}

#endif
