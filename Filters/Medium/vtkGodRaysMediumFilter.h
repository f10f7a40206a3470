// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMediumFilter
 * @brief   what filters of physical single scattering share: camera, medium, light
 *
 * A medium fills the space between the eye and FarLimit. Light of one source is scattered once on its
 * way to the eye:
 *
 *     L = integral of sigma_s p(cos a) E V e^-(tau(s) + tau_light) ds        directional light
 *     L = integral of sigma_s p(cos a) I V e^-(tau(s) + tau(r))/r^2 ds       point light
 *
 * along the view ray from the eye to the first surface or FarLimit; s is the distance from the eye, r
 * from the light, V 1 where the light is seen and 0 in shadow, p the phase function, tau the optical
 * depth of a way: sigma_t = ScatteringCoefficient + AbsorptionCoefficient times its length in a
 * homogeneous medium, the default.
 *
 * With a ScaleHeight H, the density of the medium falls with the height above a plane, as e^(-height/H); its
 * coefficients are those at GroundLevel. A second component of the medium, say the molecules of air among
 * droplets, has the same parameters with names that begin with Gas; the two add up. A directional light
 * comes from above through the medium, which dims it (and hides one below the horizon altogether);
 * by what is homogeneous, which has no end, it is not dimmed: LightColor is its irradiance there.
 *
 * The formulas are those of vtkGodRaysPhaseMath.glsl.
 *
 * All lengths are in the scene's unit, coefficients in its reciprocal. Pictures have rows from the
 * bottom up and square pixels; view rays go through their centres.
 *
 * Parameters are looked at when the filter executes: one that cannot be used is one error that says
 * what to do, and the output is empty.
 */

#ifndef vtkGodRaysMediumFilter_h
#define vtkGodRaysMediumFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysPhaseFunction.h" // For PhaseFunctionType
#include "vtkImageAlgorithm.h"

#include <string> // For std::string

struct vtkGodRaysMedium;
struct vtkGodRaysSpot;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysMediumFilter : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkGodRaysMediumFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get where the eye is [scene units]. Valid range: [-1e15, 1e15] each. Default is (0, 0, 0): world
   * coordinates are view coordinates.
   */
  vtkSetVector3Macro(CameraPosition, double);
  vtkGetVector3Macro(CameraPosition, double);
  ///@}

  ///@{
  /**
   * Set/Get what the eye looks at [scene units]. Valid range: [-1e15, 1e15] each. Default is (0, 0, -1).
   */
  vtkSetVector3Macro(CameraFocalPoint, double);
  vtkGetVector3Macro(CameraFocalPoint, double);
  ///@}

  ///@{
  /**
   * Set/Get what is up in the picture: a direction of any length, not that of view. Valid range: [-1e15,
   * 1e15] each. Default is (0, 1, 0).
   */
  vtkSetVector3Macro(CameraViewUp, double);
  vtkGetVector3Macro(CameraViewUp, double);
  ///@}

  ///@{
  /**
   * Set/Get the angle under which the picture's height is seen [degrees], without ParallelProjection.
   * Valid range: [1e-3, 170]. Default is 30.
   */
  void SetViewAngle(double angle);
  vtkGetMacro(ViewAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get whether view rays are parallel. Default is off.
   */
  vtkSetMacro(ParallelProjection, bool);
  vtkGetMacro(ParallelProjection, bool);
  vtkBooleanMacro(ParallelProjection, bool);
  ///@}

  ///@{
  /**
   * Set/Get half the picture's height with ParallelProjection [scene units]. Valid range:
   * [1e-9, 1e9]. Default is 1.
   */
  void SetParallelScale(double scale);
  vtkGetMacro(ParallelScale, double);
  ///@}

  ///@{
  /**
   * Set/Get how much light is scattered and absorbed, for red, green and blue [1/scene unit]. Valid range:
   * [0, 1e3]. Default is 0.05 and 0.
   */
  vtkSetVector3Macro(ScatteringCoefficient, double);
  vtkGetVector3Macro(ScatteringCoefficient, double);
  vtkSetVector3Macro(AbsorptionCoefficient, double);
  vtkGetVector3Macro(AbsorptionCoefficient, double);
  ///@}

  /// Into which directions light is scattered; see vtkGodRaysPhaseFunction.h.
  enum PhaseFunctionType
  {
    vtkGodRaysPhaseFunctionConstantsMacro()
  };

  ///@{
  /**
   * Set/Get into which directions light is scattered, one of PhaseFunctionType. Default is
   * HENYEY_GREENSTEIN.
   */
  vtkSetClampMacro(PhaseFunction, int, ISOTROPIC, vtkGodRaysLastPhaseFunction);
  vtkGetMacro(PhaseFunction, int);
  ///@}

  ///@{
  /**
   * Set/Get the asymmetry g of the phase functions that have one [no unit]: above 0, light goes on rather
   * than back. Valid range: [-0.99, 0.99]. Default is 0.6.
   */
  void SetAsymmetry(double g);
  vtkGetMacro(Asymmetry, double);
  ///@}

  ///@{
  /**
   * Set/Get a second phase function that is mixed with the first, say a peak to the back, one of
   * PhaseFunctionType: together they are (1 - SecondWeight) first + SecondWeight second. Default is
   * HENYEY_GREENSTEIN.
   */
  vtkSetClampMacro(SecondPhaseFunction, int, ISOTROPIC, vtkGodRaysLastPhaseFunction);
  vtkGetMacro(SecondPhaseFunction, int);
  ///@}

  ///@{
  /**
   * Set/Get the asymmetry g of the second phase function [no unit]. Valid range: [-0.99, 0.99]. Default is
   * -0.3.
   */
  void SetSecondAsymmetry(double g);
  vtkGetMacro(SecondAsymmetry, double);
  ///@}

  ///@{
  /**
   * Set/Get how much the second phase function counts [fraction]. Valid range: [0, 1]. Default is 0.
   */
  void SetSecondWeight(double weight);
  vtkGetMacro(SecondWeight, double);
  ///@}

  ///@{
  /**
   * Set/Get over which height the medium's density falls to 1/e [scene units]; 0: it is homogeneous.
   * Valid range: [0, 1e9]. Default is 0.
   */
  void SetScaleHeight(double height);
  vtkGetMacro(ScaleHeight, double);
  ///@}

  ///@{
  /**
   * Set/Get how much light the second component of the medium scatters and absorbs, for red, green and blue
   * [1/scene unit]. Valid range: [0, 1e3]. Default is 0 and 0.
   */
  vtkSetVector3Macro(GasScatteringCoefficient, double);
  vtkGetVector3Macro(GasScatteringCoefficient, double);
  vtkSetVector3Macro(GasAbsorptionCoefficient, double);
  vtkGetVector3Macro(GasAbsorptionCoefficient, double);
  ///@}

  ///@{
  /**
   * Set/Get into which directions the second component scatters light, one of PhaseFunctionType. Default is
   * RAYLEIGH.
   */
  vtkSetClampMacro(GasPhaseFunction, int, ISOTROPIC, vtkGodRaysLastPhaseFunction);
  vtkGetMacro(GasPhaseFunction, int);
  ///@}

  ///@{
  /**
   * Set/Get the asymmetry g of the phase function of the second component [no unit]. Valid range: [-0.99,
   * 0.99]. Default is 0.
   */
  void SetGasAsymmetry(double g);
  vtkGetMacro(GasAsymmetry, double);
  ///@}

  ///@{
  /**
   * Set/Get over which height the density of the second component falls to 1/e [scene units]; 0: it is
   * homogeneous. Valid range: [0, 1e9]. Default is 0.
   */
  void SetGasScaleHeight(double height);
  vtkGetMacro(GasScaleHeight, double);
  ///@}

  ///@{
  /**
   * Set/Get the direction in which the density of a medium with a scale height falls, in world coordinates
   * and of any length but 0. Valid range: [-1e15, 1e15] each. Default is (0, 1, 0).
   */
  vtkSetVector3Macro(MediumUp, double);
  vtkGetVector3Macro(MediumUp, double);
  ///@}

  ///@{
  /**
   * Set/Get how far along MediumUp the plane is where the coefficients of such a medium are given [scene
   * units]. Valid range: [-1e15, 1e15]. Default is 0.
   */
  void SetGroundLevel(double level);
  vtkGetMacro(GroundLevel, double);
  ///@}

  ///@{
  /**
   * Set/Get the radius of a planet whose ground is at GroundLevel [scene units], and about whose centre,
   * that far below the ground along MediumUp from the origin, the density of media falls. Its ground ends
   * view rays and hides lights. It should be above 500 scale heights. 0: the ground is a plane, which hides
   * nothing. Valid range: [0, 1e15]. Default is 0.
   */
  void SetPlanetRadius(double radius);
  vtkGetMacro(PlanetRadius, double);
  ///@}

  ///@{
  /**
   * Set/Get the view depth at which the medium ends [scene units]. Valid range: [1e-6, 1e9]. Default
   * is 100.
   */
  void SetFarLimit(double depth);
  vtkGetMacro(FarLimit, double);
  ///@}

  ///@{
  /**
   * Set/Get the light in homogeneous world coordinates: (x, y, z)/w is the position of a point light; w = 0
   * is a directional light in the direction (x, y, z), of any length but 0. Valid range: [-1e15, 1e15] each.
   * Default is (0, 1, 0, 0).
   */
  vtkSetVector4Macro(Light, double);
  vtkGetVector4Macro(Light, double);
  ///@}

  ///@{
  /**
   * Set/Get the irradiance across a directional light [radiance sr], or the intensity of a point light
   * [radiance (scene unit)^2], for red, green and blue. Valid range: [0, 1e30]. Default is 1.
   */
  vtkSetVector3Macro(LightColor, double);
  vtkGetVector3Macro(LightColor, double);
  ///@}

  ///@{
  /**
   * Set/Get half the angle of a point light's cone [degrees]. From 90 degrees on it shines everywhere alike.
   * Valid range: [1e-3, 180]. Default is 180.
   */
  void SetConeAngle(double angle);
  vtkGetMacro(ConeAngle, double);
  ///@}

  ///@{
  /**
   * Set/Get the direction of the axis of a point light's cone, of any length but 0. Valid range: [-1e15,
   * 1e15] each. Default is (0, -1, 0).
   */
  vtkSetVector3Macro(SpotDirection, double);
  vtkGetVector3Macro(SpotDirection, double);
  ///@}

  ///@{
  /**
   * Set/Get how light fades from the cone's axis: by cos(angle)^SpotExponent. That is as vtkLight has it.
   * Valid range: [0, 128]. Default is 0.
   */
  void SetSpotExponent(double exponent);
  vtkGetMacro(SpotExponent, double);
  ///@}

protected:
  vtkGodRaysMediumFilter() = default;
  ~vtkGodRaysMediumFilter() override = default;

  /**
   * The camera's axes, of length 1. The view ray of the pixel at (X, Y), in units of PixelSize from the
   * picture's centre, is Position + Z (Forward + X Right + Y Up), or with ParallelProjection
   * Position + X Right + Y Up + Z Forward, Z being the view depth.
   */
  struct View
  {
    double Position[3];
    double Right[3];
    double Up[3];
    double Forward[3];
    double PixelSize; // at depth 1, or of a parallel projection
    bool Parallel;
  };
  View GetView(int height) const;

  /**
   * The medium as a camera sees it, in its view coordinates (x right, y up, z forwards). Components that
   * neither scatter nor absorb are left out, but for the first.
   */
  vtkGodRaysMedium GetMedium(const View& view) const;

  /**
   * The light's cone, its axis in a camera's view coordinates.
   */
  vtkGodRaysSpot GetSpot(const View& view) const;

  ///@{
  /**
   * Which parameter cannot be used, and what to do; empty if all can. The second leaves out the camera.
   */
  std::string FindFault() const;
  std::string FindMediumFault() const;
  ///@}

  /**
   * Tell the progress [fraction]; false if someone has told the filter to stop. On the thread that
   * executes it only.
   */
  bool TellProgress(double progress);

  double CameraPosition[3] = { 0.0, 0.0, 0.0 };
  double CameraFocalPoint[3] = { 0.0, 0.0, -1.0 };
  double CameraViewUp[3] = { 0.0, 1.0, 0.0 };
  double ViewAngle = 30.0;
  bool ParallelProjection = false;
  double ParallelScale = 1.0;
  double ScatteringCoefficient[3] = { 0.05, 0.05, 0.05 };
  double AbsorptionCoefficient[3] = { 0.0, 0.0, 0.0 };
  int PhaseFunction = HENYEY_GREENSTEIN;
  double Asymmetry = 0.6;
  int SecondPhaseFunction = HENYEY_GREENSTEIN;
  double SecondAsymmetry = -0.3;
  double SecondWeight = 0.0;
  double ScaleHeight = 0.0;
  double GasScatteringCoefficient[3] = { 0.0, 0.0, 0.0 };
  double GasAbsorptionCoefficient[3] = { 0.0, 0.0, 0.0 };
  int GasPhaseFunction = RAYLEIGH;
  double GasAsymmetry = 0.0;
  double GasScaleHeight = 0.0;
  double MediumUp[3] = { 0.0, 1.0, 0.0 };
  double GroundLevel = 0.0;
  double PlanetRadius = 0.0;
  double FarLimit = 100.0;
  double Light[4] = { 0.0, 1.0, 0.0, 0.0 };
  double LightColor[3] = { 1.0, 1.0, 1.0 };
  double ConeAngle = 180.0;
  double SpotDirection[3] = { 0.0, -1.0, 0.0 };
  double SpotExponent = 0.0;

private:
  vtkGodRaysMediumFilter(const vtkGodRaysMediumFilter&) = delete;
  void operator=(const vtkGodRaysMediumFilter&) = delete;
};

#endif
