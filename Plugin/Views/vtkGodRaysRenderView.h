// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRenderView
 * @brief   ParaView's render view with god rays
 *
 * The view "Render View (God Rays)" of the ParaView plugin. It puts a vtkGodRaysPass and a vtkGodRaysSkyPass,
 * which share a vtkGodRaysSun, into ParaView's chain of passes. Their properties are theirs; what the
 * view adds is ParaView's: presets by name, lights of the light inspector, roles by representation,
 * several processes.
 *
 * What data do to light is the property God Rays Role of their representation, whatever its type: see
 * vtkSIGodRaysRoleProperty. Axes, grids and the like never block light or shine.
 *
 * @sa vtkGodRaysPass vtkGodRaysSkyPass vtkGodRaysSun vtkSIGodRaysRoleProperty
 */

#ifndef vtkGodRaysRenderView_h
#define vtkGodRaysRenderView_h

#include "vtkGodRaysViewsModule.h" // For export macro
#include "vtkPVRenderView.h"

#include <memory> // For std::unique_ptr

class vtkGodRaysIntegrator;
class vtkGodRaysModel;
class vtkGodRaysPass;
class vtkGodRaysSkyPass;
class vtkGodRaysSun;
class vtkLight;
class vtkRenderer;

class VTKGODRAYSVIEWS_EXPORT vtkGodRaysRenderView : public vtkPVRenderView
{
public:
  static vtkGodRaysRenderView* New();
  vtkTypeMacro(vtkGodRaysRenderView, vtkPVRenderView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the sun, which the passes share, the pass that draws the rays, and the pass that draws the
   * sky, over which they are. ParaView makes them as parts of the view, with their properties. Null
   * changes nothing.
   */
  void SetSun(vtkGodRaysSun* sun);
  vtkGodRaysSun* GetSun();
  void SetGodRaysPass(vtkGodRaysPass* pass);
  vtkGodRaysPass* GetGodRaysPass();
  void SetSkyPass(vtkGodRaysSkyPass* pass);
  vtkGodRaysSkyPass* GetSkyPass();
  ///@}

  /**
   * Set whether there are rays at all; without, the view is an ordinary render view. Default is on.
   */
  void SetUseGodRays(bool use);

  /// Where the light comes from, besides what is tagged as a light.
  enum LightSourceMode
  {
    SUN = 0,         ///< the sun
    VIEW_LIGHTS = 1, ///< the lights that the view has in ParaView's light inspector
    TAGGED_ONLY = 2  ///< nothing else
  };

  /**
   * Set where the light comes from, besides what is tagged as a light, one of LightSourceMode. Any other
   * number is an error and changes nothing. Default is SUN.
   */
  void SetLightSource(int mode);

  /**
   * Set whether the next still frame in which something is seen places the sun where it makes the most
   * shafts, in the upper half of the picture, by setting the sun's azimuth and elevation; it does so once.
   * See vtkGodRaysSunPlacer. A parallel projection, which sees no sun but straight ahead, waits, and so does
   * another light source than SUN. Default is off; that of ParaView's property is on.
   */
  void SetPlaceSun(bool place);

  /**
   * Azimuth and elevation of the sun [degrees] if it was placed since SetPlaceSun(), and then 1; else 0, 0
   * and 0. After these, its colour, which is that of the look unless one was set.
   */
  vtkGetVectorMacro(PlacedSun, double, 6);

  /**
   * Set whether the sky is drawn behind the scene, in the light of the sun, whatever the source of the rays
   * is; rays then have the colour that the air leaves the sun. With SunFrame CAMERA, the eye stands on the
   * ground and the horizon is straight ahead; else the planet is under SkyOrigin. With another LightSource
   * than SUN, the sun stays where it was. Default is off.
   */
  void SetUseSky(bool use);

  /**
   * Set the look or the medium by name, one of vtkGodRaysPresets, or "custom" to use the model that
   * SetModel() got. An unknown name is an error that lists the known ones, and changes nothing. Default is
   * "default".
   */
  void SetPreset(const char* name);

  /**
   * Set how long the scene's unit is for media by name and for the sky [m]: clear air shows over kilometres,
   * fog over metres. 0 says that nobody knows: media are then as dense as suits the scene, and for the sky
   * it counts as 1. Valid range: [1e-12, 1e12], and 0. Default is 0.
   */
  void SetWorldUnitInMeters(double meters);

  /**
   * Set the integrator. Models that it cannot evaluate take their own instead.
   */
  void SetIntegrator(vtkGodRaysIntegrator* integrator);

  ///@{
  /**
   * Add a light whose rays are shown besides those of SetLightSource(), in the light inspector or not; or
   * remove it. One that is there already, or is not, changes nothing.
   */
  void AddChosenLight(vtkLight* light);
  void RemoveChosenLight(vtkLight* light);
  ///@}

  /**
   * Set the model of the preset "custom".
   */
  void SetModel(vtkGodRaysModel* model);

  /**
   * What the last frame needed, as text: that of the sky, if there is one, and that of the rays.
   */
  const char* GetPlan();

  /**
   * Overridden: the rays are added before colours are mapped.
   */
  void SetUseToneMapping(bool use);

protected:
  vtkGodRaysRenderView();
  ~vtkGodRaysRenderView() override;

  void AboutToRenderOnLocalProcess(bool interactive) override;
  void AddRepresentationInternal(vtkDataRepresentation* representation) override;
  void RemoveRepresentationInternal(vtkDataRepresentation* representation) override;

private:
  vtkGodRaysRenderView(const vtkGodRaysRenderView&) = delete;
  void operator=(const vtkGodRaysRenderView&) = delete;

  void UseModel(vtkGodRaysModel* model);
  void UpdatePasses();
  bool UpdateSun();
  void UpdateLights();
  void TakePlacedSun(vtkObject*, unsigned long, void* light);
  void UpdateRayTracing();
  void UpdateRoles();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  bool UseGodRays = true;
  int LightSource = SUN;
  bool PlaceSun = false;
  double PlacedSun[6] = { 0.0, 0.0, 0.0, 1.0, 1.0, 1.0 };
  bool UseSky = false;
};

#endif
