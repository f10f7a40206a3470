// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysRenderView
 * @brief   ParaView's render view with god rays
 *
 * The view "Render View (God Rays)" of the ParaView plugin. It holds a vtkGodRaysPass and forwards
 * to it; what it adds is ParaView's: a sun by azimuth and elevation, presets by name, and roles by
 * representation.
 *
 * Roles given by AddOccluder(), AddLightSource() and AddIgnored() belong to a representation as a
 * whole: they follow its type (surface, volume, ...) when that changes, and take precedence over
 * those of vtkGodRaysSurfaceRepresentation. Axes, grids and the like never block light or shine.
 *
 * Real numbers and modes are checked by the pass: beyond a valid range they are clamped, NaN and
 * unknown modes are an error and change nothing.
 *
 * @sa vtkGodRaysPass vtkGodRaysSurfaceRepresentation
 */

#ifndef vtkGodRaysRenderView_h
#define vtkGodRaysRenderView_h

#include "vtkGodRaysViewsModule.h" // For export macro
#include "vtkPVRenderView.h"

#include <memory> // For std::unique_ptr

class vtkGodRaysIntegrator;
class vtkGodRaysModel;
class vtkGodRaysPass;

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
   * Set whether there are rays at all; without, the view is an ordinary render view. Default is on.
   */
  void SetUseGodRays(bool use);

  /// Where the light comes from, besides what is tagged as a light.
  enum LightSourceMode
  {
    SUN = 0,         ///< a sun, see SetSunAzimuth()
    VIEW_LIGHTS = 1, ///< the lights that the view has in ParaView's light inspector
    TAGGED_ONLY = 2  ///< nothing else
  };

  /**
   * Set where the light comes from, one of LightSourceMode. Any other number is an error and changes
   * nothing. Default is SUN.
   */
  void SetLightSource(int mode);

  /// What azimuth and elevation of the sun refer to.
  enum SunFrameType
  {
    CAMERA = 0, ///< azimuth 0 is the direction of view, elevation is up in the picture
    X_UP = 1,   ///< north is +z, east +y
    Y_UP = 2,   ///< north is -z, east +x
    Z_UP = 3    ///< north is +y, east +x, as on a map
  };

  /**
   * Set what azimuth and elevation refer to, one of SunFrameType. Any other number is an error and
   * changes nothing. Default is CAMERA.
   */
  void SetSunFrame(int frame);

  /**
   * Set the sun's azimuth, clockwise from north seen from above [degrees]; north is 0, east 90. Any
   * finite number is valid. Default is 0.
   */
  void SetSunAzimuth(double degrees);

  /**
   * Set the sun's elevation above the horizon [degrees]. Valid range: [-90, 90]; numbers beyond are
   * clamped. Default is 10.
   */
  void SetSunElevation(double degrees);

  /**
   * Set the sun's colour, as shown on the display [no unit]. Valid range: [0, 1] each.
   * Default is (1, 1, 1).
   */
  void SetSunColor(double red, double green, double blue);

  /**
   * Set the look by name, see vtkGodRaysRadialModel::ApplyPreset(), or "custom" to use the model that
   * SetModel() got. An unknown name is an error that lists the known ones, and changes nothing.
   * Default is "default".
   */
  void SetPreset(const char* name);

  ///@{
  /**
   * Give a representation a role, or take it back; a light source may also be a vtkLight, of the
   * view or not. A representation that is in several lists shines rather than is ignored, and is
   * ignored rather than blocks.
   */
  void AddOccluder(vtkObject* representation);
  void RemoveOccluder(vtkObject* representation);
  void AddLightSource(vtkObject* representationOrLight);
  void RemoveLightSource(vtkObject* representationOrLight);
  void AddIgnored(vtkObject* representation);
  void RemoveIgnored(vtkObject* representation);
  ///@}

  ///@{
  /**
   * Forwarded to the pass; see vtkGodRaysPass.
   */
  void SetModel(vtkGodRaysModel* model);
  void SetIntegrator(vtkGodRaysIntegrator* integrator);
  void SetIntensity(double intensity);
  void SetErrorTolerance(double tolerance);
  void SetInteractiveErrorTolerance(double tolerance);
  void SetResolutionScale(double scale);
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
  void UpdatePasses();
  void UpdateLights();
  void UpdateRoles();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  bool UseGodRays = true;
  int LightSource = SUN;
  int SunFrame = CAMERA;
  double SunAzimuth = 0.0;
  double SunElevation = 10.0;
};

#endif
