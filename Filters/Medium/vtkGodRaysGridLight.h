// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysGridLight.h
 * @brief   what a medium of data leaves of a light, at all places
 *
 * Private. Optical depths of the light's ways through one grid, in 16 bits each, at nodes about twice as far
 * apart as its points, and at least 40 along each axis: at most a sixteenth of its memory, but for small or
 * thin ones, whose depths bend between points where no datum changes. The nodes of a directional light stand
 * in columns along its direction, so that sums along a column are exact and nothing is smeared from plane to
 * plane; each plane across the axis that light goes along most keeps the columns that go through the grid
 * there. Of a point light, they stand along the grid's axes, and have means along the light's ways: depths
 * rise from the light as a cone does, which no straight lines between nodes tell. Its long ways are sums over
 * the planes of points that they go through.
 */

#ifndef vtkGodRaysGridLight_h
#define vtkGodRaysGridLight_h

#include "vtkGodRaysGrid.h"

#include <cstdint>
#include <cstring>
#include <vector>

/**
 * Numbers of at least 0 in 16 bits. As there is no sign, 5 are the exponent and 11 the fraction: with
 * 2^-16 added, numbers are kept to 2^-12 of themselves, and 0 as it is. Optical depths of d are off by at
 * most 2^-12 d, so that what is left of light is by 2^-12 d exp(-d), 9e-5 at most.
 */
struct vtkGodRaysGridDepth
{
  static constexpr float Offset = 1.0f / 65536.0f;
  static constexpr float Largest = 65500.0f; // as good as any: nothing is left of light

  static std::uint16_t Encode(float depth)
  {
    const float shifted = std::min(depth, Largest) + Offset;
    std::uint32_t bits;
    std::memcpy(&bits, &shifted, sizeof(bits));
    return static_cast<std::uint16_t>((bits - First + (1u << (Dropped - 1))) >> Dropped);
  }

  /// With Offset, so that sums and means of several lose it once.
  static float Decode(std::uint16_t depth)
  {
    const std::uint32_t bits = (static_cast<std::uint32_t>(depth) << Dropped) + First;
    float shifted;
    std::memcpy(&shifted, &bits, sizeof(shifted));
    return shifted;
  }

private:
  static constexpr int Dropped = 12;                        // bits of a float's fraction
  static constexpr std::uint32_t First = (127u - 16) << 23; // bits of Offset
};

class vtkGodRaysGridBlocks;

class vtkGodRaysGridLight
{
public:
  using Vec3 = vtkGodRays::Vec3;

  /**
   * Sum the depths. The light is a position, or a direction of length 1. Grid and blocks are not kept.
   */
  void Build(const vtkGodRaysGrid& grid, const vtkGodRaysGridBlocks& blocks, const Vec3& light,
    bool directional);

  /**
   * Add the optical depths of the light's way to a place in points of the grid, in it or not, for as many
   * bands as it has: between the nodes linear.
   */
  void AddDepth(const vtkGodRaysGrid& grid, const Vec3& place, float* depth) const;

  /// How many bytes its numbers take.
  std::size_t GetSize() const { return this->Depths.size() * sizeof(this->Depths[0]); }

private:
  void Look(const Vec3& place, float* known) const;

  Vec3 Light = Vec3(0.0); // place, or steps
  bool Directional = true;
  double Reach =
    1.0; // of a point light's ways [scene units]; depths are means along them times this
  int Bands = 1;
  int Order[3] = { 0, 1, 2 };             // axes across planes, and along them
  int Size[3] = { 2, 2, 2 };              // planes, and nodes of each, along these
  double Distance[3] = { 1.0, 1.0, 1.0 }; // of neighbours [points]
  double Slope[2] = { 0.0, 0.0 };    // by which columns move aside for each point across planes
  std::vector<int> Base[2];          // the first column of each plane
  std::vector<std::uint16_t> Depths; // see vtkGodRaysGridDepth
};

#endif
