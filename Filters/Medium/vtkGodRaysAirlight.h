// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysAirlight
 * @brief   unshadowed airlight of the first part of every view ray of a picture
 *
 * Private. In closed form for a directional light in a homogeneous medium; otherwise one table serves all
 * media, lights and projections, and is kept while view, light and medium stay: see vtkGodRaysAirlightTable.
 *
 * Values are split into planes, one for each channel and, for a directional light in layered air, each
 * component, as the phase function is no part of them there. A spotlight's cone and fade, and a planet's
 * shadow, are no part of the table: they cut and weight what is read from it.
 */

#ifndef vtkGodRaysAirlight_h
#define vtkGodRaysAirlight_h

#include "vtkGodRaysAirlightTable.h"
#include "vtkGodRaysFiltersModule.h" // For export macro

#include <string> // For std::string
#include <vector> // For std::vector

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysAirlight
{
public:
  static constexpr int MaximumPlanes = vtkGodRaysAirlightTable::MaximumPlanes;
  static constexpr int MaximumParts = 2;

  using Scene = vtkGodRaysAirlightScene;

  void Prepare(const Scene& scene);

  int GetNumberOfPlanes() const { return this->Setup.GetNumberOfPlanes(); }
  int GetNumberOfChannels() const { return this->Setup.Channels; } ///< 1 or 3
  int GetNumberOfComponents() const
  {
    return this->Setup.Components;
  } ///< planes of channel c are c + k channels
  bool IsClosedForm() const { return this->Closed; }
  std::string Describe() const;

  /// As it is, but for what Prepare() finds.
  const Scene& GetScene() const { return this->Setup; }

  /**
   * Airlight up to distances, as fractions of the whole ray's; of a closed form, but for GetFactors().
   * @param values  of planes, of places
   * @param lights  light of the whole rays in a cone or past a planet, as fractions of the light without
   *                either; of planes, of places. Null: not asked for
   */
  void Evaluate(int count, const float* x, const float* y, const float* distances, float* values,
    float* lights = nullptr) const;

  ///@{
  /**
   * HasParts() returns whether a spotlight's cone or a planet's shadow limits the light to parts of a ray.
   * GetParts() finds these, at most two, and returns their number.
   */
  bool HasParts() const { return this->Setup.Spot.IsCone() || this->HasPlanetShadow; }
  int GetParts(double x, double y, double parts[MaximumParts][2]) const;
  ///@}

  ///@{
  /// Returns whether there is a planet; and the distance at which its ground ends a ray, or the one given, if
  /// that is less.
  bool IsOverPlanet() const { return this->IsPlanet; }
  double GetEnd(double x, double y, double distance) const;
  ///@}

  /**
   * Finds the factors that turn values of pixels of a row, from the first on, into the radiance of each
   * colour. They leave out the light's own colour.
   * @param factors  of components, of colours, of pixels
   */
  void GetFactors(double y, int first, int count, float* factors) const;

private:
  int EvaluateParts(int count, const float* x, const float* y, const float* distances,
    float* values, float* lights, int stride) const;
  int AddSteps(const vtkGodRays::LitRay& ray, int steps, double begin, double end, float* places,
    float* fades) const;
  void EvaluateWhole(int count, const float* x, const float* y, const float* distances,
    float* values, int stride) const;
  vtkGodRays::LitRay MakeRay(double x, double y) const;
  int GetParts(
    const vtkGodRays::LitRay& ray, double x, double y, double parts[MaximumParts][2]) const;
  vtkGodRays::Vec2 GetPlanetShadow(double x, double y, double end) const;
  void FindPlanetShadow();
  void MakeFade();
  void GetPointFactors(float y, int first, int count, float* factors, int stride) const;
  void GetPhaseFactors(float y, int first, int count, float* factors, int stride) const;

  Scene Setup;
  bool Closed = true;
  bool IsPlanet = false;
  bool HasPlanetShadow = false;
  int MaximumNumberOfParts = 1;
  double CosLit = 0.0;     // of the cone within which a spotlight's light is not negligible
  std::vector<float> Fade; // of a spotlight, over the cosine from CosLit to 1
  int Steps = 1;           // of a part, over which it is a constant
  float Extinction[3] = { 0.0f, 0.0f, 0.0f };
  vtkGodRaysAirlightTable Table;
  std::vector<float> Phases[vtkGodRaysMedium::MaximumComponents];
};

#endif
