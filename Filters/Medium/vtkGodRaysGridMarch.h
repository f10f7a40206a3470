// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysGridMarch
 * @brief   marches a view ray through media of data and the air about them; private to vtkGodRaysGridPicture
 *
 * Integrated is the difference that data make. With the transmittance T of data from the light to a place and
 * on to the eye, and that of the air, A, it is
 *
 *     integral of E A V [(sigma_data p_data + sigma_air p_air) T - sigma_air p_air] ds,
 *
 * with the irradiance E and the visibility V of the light, scattering sigma and phase functions p. In the air
 * beside data sigma_data is 0; in clear air nothing is left but data. So one rule serves all of a ray.
 *
 * The ray is cut into segments: at the faces of grids and of their blocks, at the edges of a spotlight's
 * cone, and, in haze, where the light's way begins and ends to go through data. A segment has parts, alike as
 * a lamp sees them, which are halved until light and optical depth are linear to within the tolerance; each
 * is summed by Simpson's rule. V comes from the shadowed stretches of vtkGodRaysShadowPyramid.
 */

#ifndef vtkGodRaysGridMarch_h
#define vtkGodRaysGridMarch_h

#include "vtkGodRaysFroxels.h"
#include "vtkGodRaysGrid.h"
#include "vtkGodRaysGridBlocks.h"
#include "vtkGodRaysGridLight.h"
#include "vtkGodRaysGridPicture.h" // For MaximumGrids
#include "vtkGodRaysShadowPyramid.h"
#include "vtkGodRaysSingleScattering.h" // For Parameters

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkGodRaysGridMarch
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
  const vtkGodRaysShadowGrids* Shadows = nullptr; // in view coordinates; null: nothing is hidden
  const vtkGodRaysFroxels* DiffuseAir = nullptr;  // light of two and more scatterings without data
  const vtkGodRaysFroxels::Source* Diffuse = nullptr; // what of it data scatter towards the eye
  double LastLight[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };  // the last is 1 once there is one
  bool Kept = false;
  std::atomic<std::size_t> Rays{ 0 };
  std::atomic<std::size_t> Steps{ 0 }; // places where media were evaluated

  // These belong to a picture.
  Vec3 LightColor;
  vtkGodRaysMedium Medium;
  double Tolerance = 1.0 / 255.0;
  double Brightest = 0.0; // of the radiance, or 10 means, without the light's colour; 0: not known

  void SetUp(const vtkGodRaysSingleScattering::Parameters& parameters);
  Result Evaluate(double x, double y, double depth);

private:
  struct Passage // of a ray through a grid
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
    Passage Passages[vtkGodRaysGridPicture::MaximumGrids];
    std::vector<vtkGodRaysShadowPyramid::Stretch> Stretches;
  };
  struct Segment
  {
    double Begin;
    double End;
    bool IsLit;           // in a spotlight's cone
    bool HasData;         // of an extinction above 0
    std::uint32_t Inside; // a bit for each grid
    int Parts;            // at first
    double Finest;        // length of a part
  };
  struct Node // a place of a segment
  {
    double T = 0.0;              // of the segment, as a lamp sees it [0, 1]
    double S = 0.0;              // of the ray
    Vec3 Extinction = Vec3(0.0); // of data
    Vec3 Scattering = Vec3(0.0);
    Vec3 Full =
      Vec3(0.0); // light that is scattered, without what data take of it on its way to the eye
    Vec3 Air = Vec3(0.0); // light that the air would scatter without data
  };
  struct Sums // along a ray
  {
    Vec3 Depth = Vec3(0.0);  // optical, of data
    Vec3 Scaled = Vec3(0.0); // alike, without the forward part of what is scattered
    Vec3 Light = Vec3(0.0);
    Vec3 Diffuse = Vec3(0.0); // light of two and more scatterings
    std::size_t Steps = 0;
  };

  void March(const Ray& ray, double end, Sums& sums) const;
  Vec2 FindShadow(const Ray& ray, double end) const;
  void Integrate(const Ray& ray, const Segment& segment, Node& from, Sums& sums) const;
  Node Evaluate(const Ray& ray, const Segment& segment, double t) const;
  void AddLight(const Ray& ray, double cosine, double r, const Vec3& scattered, Node& node) const;
  Vec3 GetVisibility(const Ray& ray, double begin, double end, bool& isEven) const;
  Vec3 GetTransmittance(const Vec3& depth) const;
  void AddDiffuseAir(
    const Ray& ray, double begin, double end, const Vec3& before, Sums& sums) const;
  void AddDiffuse(const Ray& ray, double s, double length, const Vec3& extinction,
    const Vec3& scattering, Sums& sums) const;

  Vec3 Position, Axes[3], Light, SpotAxis, Upwards;
  bool Parallel = false;
  bool Directional = true;
  bool Haze = false;
  bool Grey = false; // all colours are alike but for factors
  vtkGodRaysSpot Spot;
  double WidestPart = 0.15; // as a lamp sees it [radians]
  vtkGodRays::MediumComponent Components[3][2];
  vtkGodRaysShadowPyramid Pyramid;
};

#endif
