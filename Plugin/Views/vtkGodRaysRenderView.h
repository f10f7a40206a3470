// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRenderView
 * @brief   ParaView's render view with god rays
 *
 * The view "Render View (God Rays)" of the ParaView plugin. It holds a vtkGodRaysPass and a
 * vtkGodRaysSkyPass that share a vtkGodRaysSun, and forwards to them; what it adds is ParaView's: presets by
 * name, and roles by representation.
 *
 * What data do to light is the property God Rays Role of their representation, whatever its type: see
 * vtkSIGodRaysRoleProperty. Axes, grids and the like never block light or shine.
 *
 * Real numbers and modes are checked by the pass: beyond a valid range they are clamped, NaN and
 * unknown modes are an error and change nothing.
 *
 * @sa vtkGodRaysPass vtkSIGodRaysRoleProperty
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
class vtkLight;

class VTKGODRAYSVIEWS_EXPORT vtkGodRaysRenderView : public vtkPVRenderView
{
public:
  static vtkGodRaysRenderView* New();
  vtkTypeMacro(vtkGodRaysRenderView, vtkPVRenderView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The pass that draws the rays.
   */
  vtkGodRaysPass* GetGodRaysPass();

  /**
   * The pass that draws the sky, over which the rays are.
   */
  vtkGodRaysSkyPass* GetSkyPass();

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
   * Set where the light comes from, one of LightSourceMode. Any other number is an error and changes
   * nothing. Default is SUN.
   */
  void SetLightSource(int mode);

  ///@{
  /**
   * Forwarded to the sun; see vtkGodRaysSun, and vtkGodRaysSunPosition for date and place.
   */
  void SetSunFrame(int frame);
  void SetSunUp(double x, double y, double z);
  void SetSunNorth(double x, double y, double z);
  void SetSunPosition(int mode);
  void SetSunAzimuth(double degrees);
  void SetSunElevation(double degrees);
  void SetSunDate(int year, int month, int day);
  void SetSunTimeOfDay(double hours);
  void SetSunTimeZone(double hours);
  void SetSunLatitude(double degrees);
  void SetSunLongitude(double degrees);
  void SetSunColor(double red, double green, double blue);
  double* GetSunAngles() VTK_SIZEHINT(2);
  ///@}

  /**
   * Set whether the sky is drawn behind the scene, in the light of the sun, whatever the source of the rays
   * is. With SunFrame CAMERA, the eye stands on the ground and the horizon is straight ahead. Default is
   * off.
   */
  void SetUseSky(bool use);

  /**
   * Set the air, one of vtkGodRaysAtmosphere::PresetType. Any other number is an error and changes nothing.
   * Default is EARTH_CLEAR.
   */
  void SetSkyAtmosphere(int preset);

  ///@{
  /**
   * Forwarded to the sky's pass; see vtkGodRaysSkyPass.
   */
  void SetSkyOrigin(double x, double y, double z);
  void SetSkyExposure(double exposure);
  void SetSkySunDisc(bool draw);
  void SetSkyAerialPerspective(bool draw);
  void SetSkyMultipleScattering(bool add);
  ///@}

  /**
   * Set the look or the medium by name, one of vtkGodRaysPresets, or "custom" to use the model that
   * SetModel() got. An unknown name is an error that lists the known ones, and changes nothing. Default is
   * "default".
   */
  void SetPreset(const char* name);

  /**
   * Set how long the scene's unit is for media by name and for the sky [m]. Valid range: [1e-12, 1e12].
   * Default is 1.
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

  ///@{
  /**
   * Forwarded to the pass; see vtkGodRaysPass.
   */
  void SetModel(vtkGodRaysModel* model);
  void SetIntensity(double intensity);
  void SetErrorTolerance(double tolerance);
  void SetInteractiveErrorTolerance(double tolerance);
  void SetUntaggedPropsOcclude(bool occlude);
  void SetSourceRadius(double radius);
  void SetSunAngularRadius(double degrees);
  void SetBackgroundGlow(double glow);
  void SetBackgroundGlowRadius(double degrees);
  void SetBackgroundGlowFalloff(double degrees);
  void SetLayerMargin(double margin);
  void SetBlend(int mode);
  void SetOutput(int output);
  void SetPrecision(int precision);
  void SetMeasureTimes(bool measure);
  const char* GetPlan();
  ///@}

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

  bool SetMode(const char* name, int& mode, int value, int last);
  void UseModel(vtkGodRaysModel* model);
  void UpdatePasses();
  bool UpdateSun();
  void UpdateLights();
  void UpdateRayTracing();
  void UpdateRoles();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  bool UseGodRays = true;
  int LightSource = SUN;
  bool UseSky = false;
};

#endif
