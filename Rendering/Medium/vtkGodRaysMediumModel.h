// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMediumModel
 * @brief   light that a physical medium scatters once: the base of its models
 *
 * The medium fills the space between the eye and FarLimit. Every point of a view ray that a light
 * reaches scatters some of it towards the eye,
 *
 *     L = integral of sigma_s p(cos a) E V e^(-sigma_t s) ds             directional light
 *     L = integral of sigma_s p(cos a) I V e^(-sigma_t (s + r))/r^2 ds   positional light
 *
 * from the eye to the first surface; s is the distance from the eye, r from the light, V 1 where the
 * light is seen and 0 in the shadow of an occluder. There is no scale to fit, and no occlusion
 * layer: shafts are what shadows leave. They are as long as things are thick and far apart, so the
 * medium should be chosen for the size of the scene: as a start, an optical depth of about 1 across it,
 * sigma_t = 1/its diagonal.
 *
 * How much light there is follows from VTK's lights: one that makes a white surface white, of
 * intensity 1 and vertically above it, has an irradiance E of pi. A positional light has the intensity
 * I = pi c/q, where q is the last of its AttenuationValues, or, where that is 0, as in a vtkLight that
 * nobody touched, I = pi c d^2 with d = half the diagonal of the visible props' bounds. A prop tagged
 * LIGHT is a sphere about its centre that is as bright all over as its colour, I = pi c r^2, r being
 * half the diagonal of its bounds over the square root of 3; it does not block light. c is colour times
 * intensity, in linear light. A positional light with a ConeAngle below 90 degrees is a spotlight, as VTK
 * shades with it: I cos(a)^Exponent within the cone, a being the angle from its axis, and nothing outside.
 *
 * The data of a vtkVolume tagged MEDIUM scatter, too, beside this medium and within it: extinction from its
 * scalar opacity, tint from its colours, and for all such volumes of a pass the Data numbers.
 *
 * Translucent props and volumes take part of the light, see Documentation/Pipeline.md. A picture that is
 * tilted against the axis of view, as only a projection matrix made by hand has it, or has pixels that are
 * oblong by 2 percent, as it and a vtkDepthOfFieldPass in an oblong window have them, is an error.
 *
 * @sa vtkGodRaysHomogeneousModel vtkGodRaysVolumeModel vtkGodRaysShadowMapIntegrator
 */

#ifndef vtkGodRaysMediumModel_h
#define vtkGodRaysMediumModel_h

#include "vtkGodRaysModel.h"
#include "vtkGodRaysPhaseFunction.h"   // For PhaseFunctionType
#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkWrappingHints.h"          // For VTK_WRAPEXCLUDE

struct vtkGodRaysMedium;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysMediumModel : public vtkGodRaysModel
{
public:
  vtkTypeMacro(vtkGodRaysMediumModel, vtkGodRaysModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Into which directions light is scattered; see vtkGodRaysPhaseFunction.h.
  enum PhaseFunctionType
  {
    vtkGodRaysPhaseFunctionConstantsMacro()
  };

  ///@{
  /**
   * Set/Get how long the scene's unit is [m]. Coefficients are in 1/m. 0 says that nobody knows: it counts
   * as 1. Then vtkGodRaysHomogeneousModel::SetOpticalDepth() scales them. Valid range: [1e-12, 1e12], and 0.
   * Default is 0.
   */
  void SetWorldUnitInMeters(double meters);
  vtkGetMacro(WorldUnitInMeters, double);
  ///@}

  ///@{
  /**
   * Set/Get the view depth at which the medium ends where nothing is seen [scene units]. 0 takes the
   * camera's far clipping plane, which VTK sets to just beyond the scene. Valid range: [0, 1e9].
   * Default is 0.
   */
  void SetFarLimit(double depth);
  vtkGetMacro(FarLimit, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the medium dims what is seen through it: e^-tau, the law of Beer and Lambert. Off,
   * light is added to a scene as bright as without a medium, which no medium does. Default is on.
   */
  vtkSetMacro(AttenuateScene, bool);
  vtkGetMacro(AttenuateScene, bool);
  vtkBooleanMacro(AttenuateScene, bool);
  ///@}

  /// How often light that reaches the eye was scattered.
  enum ScatteringOrdersType
  {
    SINGLE = 0, ///< once
    ALL = 1     ///< once, exactly, and all further times on a coarse lattice
  };

  ///@{
  /**
   * Set/Get how often light is scattered on its way to the eye, one of ScatteringOrdersType. SINGLE is too
   * dark in dense media: it has half of the light at an optical depth of about 0.5, and 5 % below a cloud.
   * ALL adds the rest, which is smooth, from a lattice about the visible props. It is solved anew when light,
   * medium or occluders change. Scenes on several processes have SINGLE. Default is SINGLE.
   */
  vtkSetClampMacro(ScatteringOrders, int, SINGLE, ALL);
  vtkGetMacro(ScatteringOrders, int);
  ///@}

  ///@{
  /**
   * Set/Get what the extinction of volumes with the role MEDIUM is times: above 1, data are denser than
   * their opacity says. Valid range: [0, 1e9]. Useful range: [0, 10]. Default is 1 [no unit].
   */
  void SetDataScale(double scale);
  vtkGetMacro(DataScale, double);
  ///@}

  ///@{
  /**
   * Set/Get the single-scattering albedo of volumes with the role MEDIUM where their colour is white: what
   * part of extinction is scattering, for red, green and blue. Valid range: [0, 1]. Default is 1: nothing is
   * absorbed.
   */
  void SetDataAlbedo(double red, double green, double blue);
  void SetDataAlbedo(const double albedo[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(DataAlbedo, double);
  ///@}

  ///@{
  /**
   * Set/Get into which directions volumes with the role MEDIUM scatter light, one of PhaseFunctionType.
   * Default is HENYEY_GREENSTEIN.
   */
  void SetDataPhaseFunction(int phaseFunction);
  vtkGetMacro(DataPhaseFunction, int);
  ///@}

  ///@{
  /**
   * Set/Get the asymmetry g of their phase function [no unit]: the mean cosine of the angle into which they
   * scatter. Valid range: [-0.99, 0.99]. Default is 0.6.
   */
  void SetDataAsymmetry(double g);
  vtkGetMacro(DataAsymmetry, double);
  ///@}

  ///@{
  /**
   * Set/Get how many points along an axis an image has at most to which volumes with the role MEDIUM on
   * other grids are resampled: along the longest one of cells of any shape; rectilinear and AMR grids take
   * no more than suits their shortest cells. The plan tells the error. Valid range: [8, 1024]. Default is
   * 128.
   */
  vtkSetClampMacro(DataResolution, int, 8, 1024);
  vtkGetMacro(DataResolution, int);
  ///@}

  /**
   * The medium in scene units, as an eye sees it: worldToView is that of vtkGodRaysView, farDepth the
   * view depth of the far clipping plane, diagonal that of the scene's bounds, 0 if it has none.
   */
  VTK_WRAPEXCLUDE vtkGodRaysMedium GetMedium(
    const double worldToView[16], double farDepth, double diagonal) const;

  bool CanScatter() const override;
  VTK_NEWINSTANCE vtkGodRaysIntegrator* MakeIntegrator() const override;
  VTK_WRAPEXCLUDE std::unique_ptr<vtkGodRaysEffect> MakeEffect() override;

protected:
  vtkGodRaysMediumModel() = default;
  ~vtkGodRaysMediumModel() override = default;

  /**
   * Fill in components, and what their heights are counted from [1/m, m].
   */
  virtual void FillMedium(vtkGodRaysMedium& medium, const double worldToView[16]) const = 0;

  /**
   * The factor on all coefficients with which a medium of no known unit suits a scene.
   */
  virtual double GetScale(const vtkGodRaysMedium&, double) const { return 1.0; }

  /**
   * How long the scene's unit is taken to be [m], above 0.
   */
  double GetUnit() const;

  double WorldUnitInMeters = 0.0;
  double FarLimit = 0.0;
  bool AttenuateScene = true;
  int ScatteringOrders = SINGLE;
  double DataScale = 1.0;
  double DataAlbedo[3] = { 1.0, 1.0, 1.0 };
  int DataPhaseFunction = HENYEY_GREENSTEIN;
  double DataAsymmetry = 0.6;
  int DataResolution = 128;

private:
  vtkGodRaysMediumModel(const vtkGodRaysMediumModel&) = delete;
  void operator=(const vtkGodRaysMediumModel&) = delete;
};

#endif
