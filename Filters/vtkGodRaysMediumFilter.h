// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysMediumFilter
 * @brief   what filters of physical single scattering share: camera, medium, light
 *
 * A homogeneous medium fills the space between the eye and FarLimit. Light of one source is scattered
 * once on its way to the eye:
 *
 *     L = integral of sigma_s p(cos a) E V e^(-sigma_t s) ds             directional light
 *     L = integral of sigma_s p(cos a) I V e^(-sigma_t (s + r))/r^2 ds   point light
 *
 * along the view ray from the eye to the first surface or FarLimit; s is the distance from the eye, r
 * from the light, V 1 where the light is seen and 0 in shadow, sigma_t = ScatteringCoefficient +
 * AbsorptionCoefficient, p the phase function. A directional light is not dimmed on its way to the
 * ray: LightColor is its irradiance there. The formulas are those of vtkGodRaysFunctions.glsl.
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
#include "vtkImageAlgorithm.h"

#include <string> // For std::string

struct vtkGodRaysMedium;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysMediumFilter : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkGodRaysMediumFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get where the eye is, what it looks at, and what is up [scene units]. Default: in the origin,
   * along -z, y up, so that world coordinates are view coordinates.
   */
  vtkSetVector3Macro(CameraPosition, double);
  vtkGetVector3Macro(CameraPosition, double);
  vtkSetVector3Macro(CameraFocalPoint, double);
  vtkGetVector3Macro(CameraFocalPoint, double);
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
   * Set/Get how much light is scattered and absorbed, for each colour [1/scene unit]. Valid range:
   * [0, 1e3]. Default is 0.05 and 0.
   */
  vtkSetVector3Macro(ScatteringCoefficient, double);
  vtkGetVector3Macro(ScatteringCoefficient, double);
  vtkSetVector3Macro(AbsorptionCoefficient, double);
  vtkGetVector3Macro(AbsorptionCoefficient, double);
  ///@}

  /// Into which directions light is scattered; see vtkGodRaysFunctions.glsl.
  enum PhaseFunctionType
  {
    ISOTROPIC = 0,
    RAYLEIGH = 1,
    HENYEY_GREENSTEIN = 2,
    CORNETTE_SHANKS = 3,
    SCHLICK = 4
  };

  ///@{
  /**
   * Set/Get the phase function, one of PhaseFunctionType. Default is HENYEY_GREENSTEIN.
   */
  vtkSetClampMacro(PhaseFunction, int, ISOTROPIC, SCHLICK);
  vtkGetMacro(PhaseFunction, int);
  ///@}

  ///@{
  /**
   * Set/Get the asymmetry g of the last three phase functions: above 0, light goes on rather than
   * back. Valid range: [-0.99, 0.99]. Default is 0.6.
   */
  void SetAsymmetry(double g);
  vtkGetMacro(Asymmetry, double);
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
   * Set/Get the light in homogeneous world coordinates: (x, y, z)/w is the position of a point light;
   * w = 0 is a directional light in the direction (x, y, z), of any length but 0. Default is
   * (0, 1, 0, 0).
   */
  vtkSetVector4Macro(Light, double);
  vtkGetVector4Macro(Light, double);
  ///@}

  ///@{
  /**
   * Set/Get the irradiance across a directional light [radiance sr], or the intensity of a point light
   * [radiance (scene unit)^2], for each colour. Valid range: [0, 1e30]. Default is 1.
   */
  vtkSetVector3Macro(LightColor, double);
  vtkGetVector3Macro(LightColor, double);
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
   * The medium, as a camera sees it.
   */
  vtkGodRaysMedium GetMedium(const View& view) const;

  /**
   * Which parameter cannot be used, and what to do; empty if all can.
   */
  std::string FindFault() const;

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
  double FarLimit = 100.0;
  double Light[4] = { 0.0, 1.0, 0.0, 0.0 };
  double LightColor[3] = { 1.0, 1.0, 1.0 };

private:
  vtkGodRaysMediumFilter(const vtkGodRaysMediumFilter&) = delete;
  void operator=(const vtkGodRaysMediumFilter&) = delete;
};

#endif
