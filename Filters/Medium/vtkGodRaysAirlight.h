// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysAirlight
 * @brief   unshadowed airlight of the first part of every view ray of a picture
 *
 * Private. In closed form for a directional light in a homogeneous medium; otherwise one table serves all media,
 * lights and projections: rays through a grid of the picture, and along each of them nodes of a cubic Hermite
 * spline, placed so that light comes about evenly from between them; bilinear between the rays. Where that would be off,
 * e.g. next to a lamp or at a planet's limb, there are more rays, up to those of all pixels. The integrand is that of
 * the shared formulas. The table is kept while view, light and medium stay.
 *
 * Values are split into planes, one for each channel and, for a directional light in layered air, each component, as
 * the phase function is no part of them there. A spotlight's cone and fade, and a planet's shadow, are no part of the
 * table: they cut and weight what is read from it.
 */

#ifndef vtkGodRaysAirlight_h
#define vtkGodRaysAirlight_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMath.h"          // For vtkGodRays::LitRay
#include "vtkGodRaysMedium.h"        // For vtkGodRaysMedium

#include <cstdint>       // For std::int64_t
#include <string>        // For std::string
#include <unordered_map> // For std::unordered_map
#include <vector>        // For std::vector

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysAirlight
{
public:
  static constexpr int MaximumPlanes = 6;
  static constexpr int MaximumParts = 2;

  /// View coordinates are x to the right, y up, z forwards, with the eye at the origin.
  struct Scene
  {
    int Size[2] = { 0, 0 };              // of the picture [pixels]
    double PixelSize = 0.0;              // at depth 1, or of a parallel projection [scene units]
    double Center[2] = { 0.0, 0.0 };     // of the view axis; whole numbers are centres of pixels
    bool Parallel = false;               // projection
    bool Point = false;                  // light
    double Light[3] = { 0.0, 1.0, 0.0 }; // position, or direction to it, of length 1
    vtkGodRaysSpot Spot;
    vtkGodRaysMedium Medium;
    bool Colored = false; // whether one channel does not serve all, e.g. for coloured shadows
  };

  void Prepare(const Scene& scene);

  int GetNumberOfPlanes() const { return this->Channels * this->Components; }
  int GetNumberOfChannels() const { return this->Channels; } ///< 1 or 3
  int GetNumberOfComponents() const
  {
    return this->Components;
  } ///< planes of channel c are c + k channels
  bool IsClosedForm() const { return this->Closed; }
  std::string Describe() const;

  /// The view ray through a place of the picture [pixels].
  void GetRay(double x, double y, double origin[3], double direction[3]) const;

  /// Length of the view ray for each unit of view depth.
  double GetLengthPerDepth(double x, double y) const;

  /**
   * Airlight up to distances, as fractions of the whole ray's; of a closed form, but for GetFactors().
   * @param values  of planes, of places
   * @param lights  what light comes from the whole rays in a cone or past a planet, as fractions of what would come
   *                without; of planes, of places. Null: not asked for
   */
  void Evaluate(int count, const float* x, const float* y, const float* distances, float* values,
    float* lights = nullptr) const;

  ///@{
  /**
   * Whether light can come from less than a whole ray; and the parts, at most two of them, from which it can: in a
   * spotlight's cone, and not in a planet's shadow. Returns their number.
   */
  bool HasParts() const { return this->Setup.Spot.IsCone() || this->HasPlanetShadow; }
  int GetParts(double x, double y, double parts[MaximumParts][2]) const;
  ///@}

  ///@{
  /// Whether there is a planet; and where its ground ends a ray, if that is before a distance.
  bool IsOverPlanet() const { return this->IsPlanet; }
  double GetEnd(double x, double y, double distance) const;
  ///@}

  /**
   * What the values of pixels of a row, from the first on, are multiplied by for the radiance of each colour, but for
   * the light's own.
   * @param factors  of components, of colours, of pixels
   */
  void GetFactors(double y, int first, int count, float* factors) const;

private:
  struct Ladder // along a ray
  {
    float Begin;   // [scene units], or of a point light's coordinate
    float Inverse; // of its length
    float
      Bend; // the end of a point light's; else c of u = x/(x + c (1 - x)): where half of the light comes from is u = 1/2
  };
  struct Cell // of the picture, between four rays
  {
    int Corners[4]; // rays
    int Child;      // the first of four cells within it, or -1
  };
  struct Place // on a view ray
  {
    float Distance;
    float Coordinate; // of a point light; First to Last is the whole ray, Early the weight of First
    float First;
    float Last;
    float Early;

    void FindWeight();
  };
  struct Sampler;

  void MakeTable();
  void MakeRays();
  void MakeLadder(int ray, double x, double y);
  void Refine();
  void Split(int cell, int x, int y, int side);
  int FindRay(int x, int y);
  float GetDifference(int ray, const int* others, int count) const;
  const Cell& FindCell(float x, float y, float& u, float& v) const;
  float GetNode(int ray, const Place& place) const;
  void MakeKey(std::vector<double>& key) const;
  void EvaluateParts(int count, const float* x, const float* y, const float* distances,
    float* values, float* lights, int stride) const;
  int AddSteps(
    const vtkGodRays::LitRay& ray, double begin, double end, float* places, float* fades) const;
  void EvaluateWhole(int count, const float* x, const float* y, const float* distances,
    float* values, int stride) const;
  vtkGodRays::LitRay MakeRay(double x, double y) const;
  int GetParts(
    const vtkGodRays::LitRay& ray, double x, double y, double parts[MaximumParts][2]) const;
  vtkGodRays::Vec2 GetPlanetShadow(double x, double y, double end) const;
  void FindPlanetShadow();
  void MakeFade();
  void EvaluateTable(int count, const float* x, const float* y, const float* distances,
    float* values, int stride) const;
  void GetPass(float x, float y, float& foot, float& height, float& end) const;
  void GetPointFactors(float y, int first, int count, float* factors, int stride) const;
  void GetPhaseFactors(float y, int first, int count, float* factors, int stride) const;

  Scene Setup;
  int Channels = 1;
  int Components = 1;
  bool Closed = true;
  bool IsPlanet = false;
  bool HasPlanetShadow = false;
  int MaximumNumberOfParts = 1;
  double CosLit = 0.0;     // of the cone within which a spotlight's light is not negligible
  std::vector<float> Fade; // of a spotlight, over the cosine from CosLit to 1
  int Steps = 1;           // over which it is a constant, before and behind a place
  float Extinction[3] = { 0.0f, 0.0f, 0.0f };
  double LightHeight = 0.0; // of a point light
  double Nearest = 0.0;     // that it is to a view ray
  int Spacing = 16;         // of the table's rays [pixels]
  int Columns = 0;
  int Rows = 0;
  std::vector<Ladder> Ladders;
  std::vector<float> Nodes;  // of rays, of nodes, of planes: value and slope, of the whole ray's
  std::vector<float> Totals; // of rays, of planes
  std::vector<float> Units;  // of rays: what totals are fractions of
  std::vector<int> Pixels;   // of rays, two each
  std::vector<Cell> Cells;   // those of the coarsest grid first
  std::unordered_map<std::int64_t, int> Finer; // rays by pixels
  std::vector<double> Key;
  std::vector<double> NewKey;
  std::vector<float> Phases[vtkGodRaysMedium::MaximumComponents];
};

#endif
