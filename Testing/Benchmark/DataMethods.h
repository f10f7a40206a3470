// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What DataErrors.h compares: ours, froxels, a march with shadow rays, VTK's volume mapper. Each draws the
// light of the smoke alone, before the terrain; pixels that are not drawn hold NaN.

#ifndef DataMethods_h
#define DataMethods_h

#include "DataScene.h"
#include "Device.h"

#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkVersionMacros.h"

#include <memory>

// The mapper scatters from VTK 9.2 on.
#define HAS_SCATTERING_MAPPER (VTK_MAJOR_VERSION * 100 + VTK_MINOR_VERSION >= 902)

namespace DataMedium
{
/// Equal steps through the grid's box, each with a ray of an eighth as many steps to the sun.
void March(const Scene& scene, int steps, int rowStride, Picture& picture);

/// What engines do, see Froxels.h: slices at depths that grow exponentially; each cell has one sample and one
/// ray of 32 steps to the sun; slices are summed with the light that each scatters integrated over it
/// (Hillaire, Physically Based and Unified Volumetric Rendering in Frostbite, 2015).
void DrawFroxels(const Scene& scene, int slices, Picture& picture);

//------------------------------------------------------------------------------
/// Ours.
class Ours
{
public:
  Ours(const Scene& scene, bool hazy)
    : From(scene)
    , IsHazy(hazy)
    , Radiance(3 * scene.Depths.size())
    , Transmittance(3 * scene.Depths.size())
  {
    this->Forget();
  }

  /// As if nothing had been drawn yet.
  void Forget()
  {
    this->Drawer = std::make_unique<vtkGodRaysGridPicture>();
    this->Drawer->SetGrids({ this->From.Grid });
    this->Drawer->SetShadows(&this->From.Shadows);
  }

  void Draw(double tolerance)
  {
    Parameters parameters = this->IsHazy ? this->From.Hazy : this->From.Clear;
    parameters.Tolerance = tolerance;
    vtkGodRaysGridPicture::Picture picture;
    picture.Size[0] = this->From.Width;
    picture.Size[1] = this->From.Height;
    picture.PixelSize = this->From.GetPixelSize();
    picture.Center[0] = 0.5 * this->From.Width;
    picture.Center[1] = 0.5 * this->From.Height;
    picture.Depths = this->From.Depths.data();
    picture.Radiance = this->Radiance.data();
    picture.Transmittance = this->Transmittance.data();
    this->Drawer->Draw(parameters, picture);
  }

  void Get(Picture& picture) const
  {
    picture.resize(this->From.Depths.size());
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      picture[i] = this->Radiance[3 * i];
    }
  }

private:
  const Scene& From;
  bool IsHazy;
  std::unique_ptr<vtkGodRaysGridPicture> Drawer;
  Picture Radiance;
  Picture Transmittance;
};

#if HAS_SCATTERING_MAPPER
//------------------------------------------------------------------------------
/// VTK's volume mapper with all of its scattering in a volume, before a black terrain.
class Mapper
{
public:
  Mapper(Device& device, const Scene& scene);
  ~Mapper();
  Mapper(const Mapper&) = delete;
  void operator=(const Mapper&) = delete;

  void Draw(Picture& picture);

private:
  Device& OpenGL;
  vtkNew<vtkRenderer> Renderer;
};
#endif
}

#endif
