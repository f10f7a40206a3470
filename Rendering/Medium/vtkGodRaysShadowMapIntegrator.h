// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysShadowMapIntegrator
 * @brief   single scattering with the shadows of all props, also of those outside the picture: the default of
 *          vtkGodRaysMediumModel
 *
 * The props that block light are rendered once more, as the light sees them, into depth maps: in their
 * ordinary way and with the scene's own shaders, only through another projection. View rays walk through the
 * maps by their least and greatest heights, at a cost that hardly depends on their size, and sum the airlight
 * of what is lit of them; there is no noise, and a shadow starts at what casts it.
 *
 * Airlight is in closed form for a directional light in a homogeneous medium. On the processor a ray is
 * walked in 8 x 8 pixels at first, and up to each where the error would be above that which the pass asks
 * for; other airlight is read from a table. In shaders, which a graphics card has, every pixel's ray is
 * walked and nothing is read back; other airlight is a quadrature in 32 parts of the ray. Where translucent
 * surfaces or volumes leave a part of the light, the walk is on the processor.
 *
 * What the depth of the picture lacks, things outside it or behind others, casts its shadow; each prop is
 * rendered once or six times more for each light of a frame. A map is fitted to the occluders, and to what
 * is seen of its shadow for a directional light. A point light that does not see all that blocks within 60
 * degrees of one direction takes a cube of six maps, which leave out what is nearer than 1e-4 of the
 * farthest thing. A shadow's edge is no finer than a map's pixels. Each light's map, and what is made of
 * it, are kept while nothing in them changes. In a scene on several processes the maps are joined.
 *
 * @sa vtkGodRaysMediumModel
 */

#ifndef vtkGodRaysShadowMapIntegrator_h
#define vtkGodRaysShadowMapIntegrator_h

#include "vtkGodRaysMediumIntegrator.h"
#include "vtkGodRaysRenderingModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysShadowMapIntegrator : public vtkGodRaysMediumIntegrator
{
public:
  static vtkGodRaysShadowMapIntegrator* New();
  vtkTypeMacro(vtkGodRaysShadowMapIntegrator, vtkGodRaysMediumIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get where light is summed, one of BackendType. Default is AUTOMATIC.
   */
  vtkSetClampMacro(Backend, int, AUTOMATIC, FRAGMENTS);
  vtkGetMacro(Backend, int);
  ///@}

  ///@{
  /**
   * Set/Get how wide and high a map is [pixels]; the driver may allow fewer. 0: as vtkGodRaysPass's error
   * tolerance asks for, or a fraction of it where VerifyPixels has found a larger error, until the tolerance
   * changes. Documentation/Evidence/ModelError.md has errors and costs. Valid range: [0, 8192]; others are
   * at least 64. Default is 0.
   */
  vtkSetClampMacro(MapSize, int, 0, 8192);
  vtkGetMacro(MapSize, int);
  ///@}

  ///@{
  /**
   * Set/Get how many maps a directional light, seen in perspective, has [no unit]: one of MapSize, which
   * serves while the camera moves; or more of half of it, each half as wide as the one before, about the
   * axis through the eye, which need drawing when the eye moves and are finer where shadows are seen small.
   * While a camera is dragged, to a tolerance above 0.009, there is one, if MapSize is 0. Valid range: [1,
   * 4]. Default is 4.
   */
  vtkSetClampMacro(NumberOfNestedMaps, int, 1, 4);
  vtkGetMacro(NumberOfNestedMaps, int);
  ///@}

  VTK_WRAPEXCLUDE bool Integrate(const Request& request) override;
  VTK_WRAPEXCLUDE bool Contribute(const Request& request) override;
  VTK_WRAPEXCLUDE const vtkGodRaysShadowGrids* GetShadows() override;
  VTK_WRAPEXCLUDE const vtkGodRaysShadowGrids* DrawShadows(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGodRaysShadowMapIntegrator();
  ~vtkGodRaysShadowMapIntegrator() override;

private:
  vtkGodRaysShadowMapIntegrator(const vtkGodRaysShadowMapIntegrator&) = delete;
  void operator=(const vtkGodRaysShadowMapIntegrator&) = delete;

  Request Choose(const Request& request);
  bool DrawMap(const Request& request);

  struct Internals;
  std::unique_ptr<Internals> Internal;

  int MapSize = 0;
  int NumberOfNestedMaps = 4;
};

#endif
