// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysGridSight
 * @brief   what media of data do to the light of one view ray; private to vtkGodRaysGridPicture
 *
 * What of a ray is in data is in vtkGodRaysGridSightInData.cxx, the rest in vtkGodRaysGridSightOutside.cxx.
 */

#ifndef vtkGodRaysGridSight_h
#define vtkGodRaysGridSight_h

#include "vtkGodRaysFroxels.h"
#include "vtkGodRaysGrid.h"
#include "vtkGodRaysGridBlocks.h"
#include "vtkGodRaysGridLight.h"
#include "vtkGodRaysGridPicture.h" // For MaximumGrids
#include "vtkGodRaysGridShadows.h"
#include "vtkGodRaysSingleScattering.h" // For Parameters

#include <atomic>
#include <cstddef>
#include <vector>

class vtkGodRaysGridSight
{
public:
  using Vec2 = vtkGodRays::Vec2;
  using Vec3 = vtkGodRays::Vec3;

  struct Result
  {
    Vec3 Radiance;
    Vec3 Transmittance;
  };

  std::vector<vtkGodRaysGrid> Grids;
  std::vector<vtkGodRaysGridBlocks> AllBlocks;
  std::vector<vtkGodRaysGridLight> Lights;
  vtkGodRaysGridShadows Shadows;
  const vtkGodRaysFroxels* DiffuseAir = nullptr; // light of two and more scatterings without data
  const vtkGodRaysFroxels::Source* Diffuse = nullptr; // what of it data scatter towards the eye
  double LastLight[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };  // the last is 1 once there is one
  bool Kept = false;
  std::atomic<std::size_t> Rays{ 0 };
  std::atomic<std::size_t> Steps{ 0 };

  // Of a picture.
  Vec3 Position, Axes[3], Light, LightColor, SpotAxis, Upwards;
  bool Parallel = false;
  bool Directional = true;
  bool Haze = false;
  bool Grey = false; // all colours are alike but for factors
  vtkGodRaysMedium Medium;
  vtkGodRaysSpot Spot;
  double Tolerance = 1.0 / 255.0;
  double WidestPiece = 0.15; // of a step, as a lamp sees it [radians]
  double Brightest = 0.0; // of the radiance, or 10 means, without the light's colour; 0: not known
  vtkGodRays::MediumComponent Components[3][2];

  void SetUp(const vtkGodRaysSingleScattering::Parameters& parameters);
  Result Evaluate(double x, double y, double depth);

private:
  struct Passage
  {
    Vec3 Place;
    Vec3 Steps;
    double Begin;
    double End;
    double Speed; // points for each unit of length, along the axis along which that is most
    double Phase; // of a directional light
  };
  struct Ray
  {
    double X; // of the picture
    double Y;
    double PerDepth; // length for each unit of view depth
    Vec3 Origin;
    Vec3 Along;
    vtkGodRays::LitRay Lit;
    double Foot;
    Passage Passages[vtkGodRaysGridPicture::MaximumGrids];
  };
  struct Air // what the medium of formulas is at a place of a ray
  {
    Vec3 Scattered = Vec3(0.0); // [1/(length sr)]
    Vec3 Left = Vec3(1.0);      // of light on its ways to there and on
    bool Visible = true;
    double Cosine = 0.0; // of the angle of scattering
    double Strength =
      1.0;               // of the light there, of its irradiance or intensity; not yet over Square
    double Square = 1.0; // of the distance from a lamp

    double GetChange(const Air& other) const;
  };
  struct Front // what is where a ray has been followed to
  {
    bool IsKnown = false;
    bool HasArriving = false;
    Vec3 Edge; // what surfaces leave of the light
    Air Medium;
    Vec3 Arriving; // what data leave of it
  };

  struct Way // what has been summed of a ray
  {
    Vec3 Depth = Vec3(0.0);  // optical, of data
    Vec3 Scaled = Vec3(0.0); // alike, without the forward part of what is scattered
    Vec3 Light = Vec3(0.0);
    Vec3 Diffuse = Vec3(0.0); // light of two and more scatterings
    std::size_t Steps = 0;
  };

  void AddDiffuseAir(const Ray& ray, double begin, double end, const Vec3& before, Way& way) const;
  void AddDiffuse(const Ray& ray, double s, double length, const Vec3& extinction,
    const Vec3& scattering, Way& way) const;
  Air GetAir(const Ray& ray, double s) const;
  void AddLightDepth(const Vec3& position, float* depth) const;
  int CountPieces(const vtkGodRays::LitRay& lit, double begin, double end) const;
  Vec3 GetArriving(const Vec3& position) const;
  void March(const Ray& ray, double begin, double end, Way& way) const;
  void MarchBlock(const Ray& ray, double begin, double end, double parts, double cells,
    double thickest, Front& front, Way& way) const;
  Vec2 FindShadow(std::size_t i, const Passage& passage, double begin, double end) const;
  void Cross(const Ray& ray, double begin, double end, Way& way) const;
  void CrossPart(
    const Ray& ray, double begin, double end, int parts, double finest, Way& way) const;
};

#endif
