// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Ways to draw a medium that the library does not offer, to compare it with. All are of a directional light
// in perspective, run on the processor, and give their picture to the pass as the library's walk does.

#ifndef MediumMethods_h
#define MediumMethods_h

#include "ShadowTree.h"

#include "vtkGodRaysMediumIntegrator.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkGodRaysWalkedLight.h"

#include "vtkNew.h"

#include <string>
#include <vector>

/// Light without any shadow: what the library does where no occluder reaches.
class ClosedFormIntegrator : public vtkGodRaysMediumIntegrator
{
public:
  static ClosedFormIntegrator* New();
  vtkTypeMacro(ClosedFormIntegrator, vtkGodRaysMediumIntegrator);

  bool Integrate(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  ClosedFormIntegrator() = default;
  ~ClosedFormIntegrator() override = default;

private:
  vtkGodRaysWalkedLight Light;
};

/// A picture of the light in a homogeneous medium that the processor makes from the library's shadow map, one
/// of 1024 x 1024 pixels.
class PictureIntegrator : public vtkGodRaysMediumIntegrator
{
public:
  vtkTypeMacro(PictureIntegrator, vtkGodRaysMediumIntegrator);

  bool Integrate(const Request& request) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  using Scene = vtkGodRaysInScattering::Parameters;

  PictureIntegrator();
  ~PictureIntegrator() override = default;

  /// Fill the picture, of so many components, with radiances of rays to these depths.
  virtual void Fill(
    const Scene& scene, const int size[2], int components, const float* depths, float* picture) = 0;

private:
  vtkNew<vtkGodRaysShadowMapIntegrator> Map;
  std::vector<float> Depths;
  std::vector<float> Picture;
  vtkGodRaysTarget Rays[2]; // of one channel, and of three
};

/// What games do: a grid of the view's cells, slices at depths that grow as squares; each cell asks the map
/// whether its middle is lit, and if it is, has all its light; see Froxels.h.
class FroxelsIntegrator : public PictureIntegrator
{
public:
  static FroxelsIntegrator* New();
  vtkTypeMacro(FroxelsIntegrator, PictureIntegrator);

  void SetSize(int columns, int rows, int slices);
  std::string Describe(vtkGodRaysModel* model) override;

protected:
  FroxelsIntegrator() = default;
  ~FroxelsIntegrator() override = default;

  void Fill(const Scene& scene, const int size[2], int components, const float* depths,
    float* picture) override;

private:
  int Columns = 160;
  int Rows = 90;
  int Slices = 64;
};

/// Epipolar lines, which meet the picture's border two pixels apart, with a tree of the map's least and
/// greatest heights each, which the view ray of every pixel walks; see ShadowTree.h.
class TreesIntegrator : public PictureIntegrator
{
public:
  static TreesIntegrator* New();
  vtkTypeMacro(TreesIntegrator, PictureIntegrator);

  std::string Describe(vtkGodRaysModel* model) override;

protected:
  TreesIntegrator() = default;
  ~TreesIntegrator() override = default;

  void Fill(const Scene& scene, const int size[2], int components, const float* depths,
    float* picture) override;

private:
  std::vector<double> Angles; // of the lines, ascending
  std::vector<int> Nearest;   // line, of each of as many equal parts of a turn
  std::vector<ShadowTree> Trees;
};

#endif
