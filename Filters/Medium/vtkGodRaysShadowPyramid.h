// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysShadowPyramid
 * @brief   finds the shadowed stretches of a view ray by a min/max pyramid over a light's shadow maps
 *
 * Private. A ray is straight in the space of a map: texels across the light, and a height that is an affine
 * function of the window depth, towards the light (directional: height; point light: 1/distance). A place is
 * in shadow where its height is below the texel's, which is a plane through its neighbours. The pyramid has
 * the least and the greatest height of 2 x 2, 4 x 4 ... texels in 16 bits each, rounded outwards, so that the
 * walk descends only where shadow can begin or end, and its result is that of all texels along the ray.
 *
 * Whatever the projections of camera and light are, there is no special case: not for a light in the picture,
 * behind the eye or along the view rays.
 */

#ifndef vtkGodRaysShadowPyramid_h
#define vtkGodRaysShadowPyramid_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysShadowGrids.h"

#include <cstddef> // For std::size_t
#include <cstdint> // For std::uint32_t
#include <vector>  // For std::vector

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysShadowPyramid
{
public:
  /// Part of a ray to which an occluder lets less light through. Stretches of several layers overlap, and add
  /// up.
  struct Stretch
  {
    float Begin; ///< distance from the ray's start [scene units]
    float End;
    float Dark[3]; ///< part of the light that is lost, of each colour, on average [0, 1]
  };

  /// Takes the maps of a light: its position, or the direction to it, of length 1. Pyramids are made anew
  /// unless the grids' version is that of the last call.
  void Build(const vtkGodRaysShadowGrids& grids, const double light[3]);

  /// Whether Dark is 1 in all stretches.
  bool IsOpaque() const { return this->Opaque; }

  /**
   * Appends the shadowed stretches of a view ray. Not before Build(); from several threads at a time.
   * @param origin     start of the ray, in view coordinates
   * @param direction  of length 1
   * @param end        length of the ray, at least 0 [scene units]
   */
  void Walk(const double origin[3], const double direction[3], double end,
    std::vector<Stretch>& stretches) const;

private:
  struct Level
  {
    std::size_t First; // of its nodes
    int Size[2];
  };
  struct Node
  {
    std::uint16_t Least; // height, rounded down; 0: a texel without occluder is among them
    std::uint16_t Most;  // rounded up; 0: no texel has one
  };
  struct Dimming
  {
    std::uint16_t Least[3]; // rounded down
    std::uint16_t Most[3];  // rounded up
    float Mean[3];
  };
  struct Patch // a texel's plane: planes of the scene are planes in a map
  {
    float Height; // in the middle
    float SlopeX; // for each texel
    float SlopeY;
    float X;
    float Y;

    float GetHeight(float x, float y) const
    {
      return this->Height + this->SlopeX * (x - this->X) + this->SlopeY * (y - this->Y);
    }
  };
  struct Map // of one grid and layer
  {
    Patch GetPatch(int x, int y) const;

    int Size[2] = { 0, 0 };
    std::vector<Level> Levels;   // above the texels
    std::vector<float> Heights;  // of texels; None where there is no occluder
    std::vector<float> Darks;    // of texels, three each, in layers
    std::vector<Node> Nodes;     // of all levels
    std::vector<Dimming> Darker; // of nodes, in layers: of what their texels dim
  };
  class Walker;

  void Fill(const vtkGodRaysShadowGrids& grids, int grid, int layer, Map& map) const;
  void Reduce(Map& map) const;
  std::uint32_t EncodeDown(float height) const;
  std::uint32_t EncodeUp(float height) const;

  vtkGodRaysShadowGrids Grids;
  double Light[3] = { 0.0, 0.0, 0.0 };
  std::vector<Map> Maps; // of layers, of grids
  bool Opaque = true;
  float Alike = 0.0f; // by how much parts of the light may differ in a layer, to be taken together
  float Scale = 1.0f; // of a directional light's heights, to codes
};

#endif
