// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysShadowMapIntegrator
 * @brief   single scattering with the shadows of all props, also of those outside the picture
 *
 * For models of a medium. The props that block light are rendered once more, as the light sees them,
 * into a depth map: in their ordinary way and with the scene's own shaders, only through another
 * projection. NumberOfSteps places of each view ray, from between which equal light comes, are looked
 * up in it; an interleaved noise moves them from pixel to pixel, and what part of a ray's airlight is
 * lit is the mean of 5 x 5 pixels that end at about the same depth, of rows and then of columns. The
 * airlight itself is in closed form for a directional light in a medium that is homogeneous or has one
 * component, otherwise a quadrature of 2 points in each of 32 parts of the ray: without anything that
 * blocks, the number of steps does not matter.
 *
 * What the depth of the picture lacks, things outside it or behind others, casts its shadow; each prop
 * is rendered once or six times more for each light of a frame. A map is fitted to the occluders, and to
 * what is seen of its shadow for a directional light. A point light that does not see all that blocks
 * within 60 degrees of one direction takes a cube of six maps, which leave out what is nearer than 1e-4
 * of the farthest thing. A shadow starts 1.5 of the map's pixels behind what casts it, and its edge is
 * no finer than they are. A walk lets light through translucent surfaces and volumes by what they leave of
 * it; steps leave these out. Each light's map, and a walk's table of its airlight, are kept while nothing in
 * them changes. In a scene on several processes the maps are joined.
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
   * Set/Get how wide and high a map is [pixels]; the driver may allow fewer. Valid range: [64, 8192].
   * Default is 1024.
   */
  vtkSetClampMacro(MapSize, int, 64, 8192);
  vtkGetMacro(MapSize, int);
  ///@}

  ///@{
  /**
   * Set/Get how many places of a view ray are looked up [no unit]. Valid range: [1, 1024]. Default
   * is 16.
   */
  vtkSetClampMacro(NumberOfSteps, int, 1, 1024);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Set/Get whether light is summed on the processor in place of steps. View rays walk through the map by its
   * least and greatest heights, at a cost that hardly depends on its size, one in 8 x 8 pixels at first and
   * up to every one where the error would be above that which the pass asks for; there is no noise, and a
   * shadow starts at what casts it. For a directional light, seen in perspective, the map is then
   * NumberOfNestedMaps. Default is off.
   */
  vtkSetMacro(WalkMap, bool);
  vtkGetMacro(WalkMap, bool);
  vtkBooleanMacro(WalkMap, bool);
  ///@}

  ///@{
  /**
   * Set/Get how many maps a directional light has for a walk [no unit]: one of MapSize, which serves while
   * the camera moves; or more of half of it, each half as wide as the one before, about the axis through the
   * eye, which need drawing when the eye moves and are finer where shadows are seen small. Valid range:
   * [1, 4]. Default is 4.
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

  bool DrawMap(const Request& request);
  bool Walk(const Request& request);

  struct Internals;
  std::unique_ptr<Internals> Internal;

  int MapSize = 1024;
  int NumberOfSteps = 16;
  bool WalkMap = false;
  int NumberOfNestedMaps = 4;
};

#endif
