// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSkySource
 * @brief   pictures of the sky: the radiance from every direction
 *
 * Light of the sun that an atmosphere scatters once on its way to the eye, and optionally more often:
 *
 *     L = E integral of (beta_R p_R + beta_M p_M) V e^-(tau(eye) + tau(sun)) ds
 *
 * along the view ray through the spherical atmosphere to its top or the ground; V is 0 in the planet's
 * shadow, whose edges divide the ray, tau the optical depth to the eye and to the sun, in closed form.
 * The rule of Gauss and Kronrod of 7 and 15 points is applied to parts of the ray until Tolerance is kept.
 * Where the ray meets the ground, the ground's own light is added: that of the sun, reflected. The
 * formulas are those of vtkGodRaysSkyMath.glsl; [Nishita1993] has the model.
 *
 * The observer's frame is x east, y north, z up; directions are of straight rays, without refraction. The
 * sun is a point as far as light is scattered, so that the shadow has no penumbra.
 *
 * Output: the picture's rows from the bottom up, three components, "Radiance" [unit of the atmosphere's
 * SunIrradiance/sr]. Values are finite and at least 0 for any observer and sun. Any part of the picture
 * can be asked for. What cannot be used is one error that says what to do, and the output is empty; so it
 * is after AbortExecute, which is looked at some 20 times.
 *
 * @sa vtkGodRaysAtmosphere vtkGodRaysSun vtkGodRaysHDRWriter
 */

#ifndef vtkGodRaysSkySource_h
#define vtkGodRaysSkySource_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <memory> // For std::unique_ptr

class vtkGodRaysAtmosphere;
class vtkGodRaysSun;
class vtkImageData;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysSkySource : public vtkImageAlgorithm
{
public:
  static vtkGodRaysSkySource* New();
  vtkTypeMacro(vtkGodRaysSkySource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the atmosphere, which can also be changed in place. Null makes a new one, the default.
   */
  void SetAtmosphere(vtkGodRaysAtmosphere* atmosphere);
  vtkGodRaysAtmosphere* GetAtmosphere();
  ///@}

  ///@{
  /**
   * Set/Get the preset to which this has set the atmosphere last, one of vtkGodRaysAtmosphere::PresetType.
   * Setting it sets all of the atmosphere's parameters. Default is EARTH_CLEAR.
   */
  void SetAtmospherePreset(int preset);
  vtkGetMacro(AtmospherePreset, int);
  ///@}

  ///@{
  /**
   * Set/Get the height of the observer above the ground [m]. Valid range: [0, 1e12]. Default is 2.
   */
  void SetObserverHeight(double height);
  vtkGetMacro(ObserverHeight, double);
  ///@}

  ///@{
  /**
   * Set/Get the sun, which can also be changed in place: its angles count, and its AngularRadius for the
   * disc. Null makes a new one, the default: elevation 45 and azimuth 180 degrees.
   */
  void SetSun(vtkGodRaysSun* sun);
  vtkGodRaysSun* GetSun();
  ///@}

  ///@{
  /**
   * Set/Get the sun's elevation above the horizontal plane [degrees]. Valid range: [-90, 90]. Default is 45.
   */
  void SetSunElevation(double degrees);
  double GetSunElevation();
  ///@}

  ///@{
  /**
   * Set/Get the sun's azimuth, from north by east [degrees]. Any finite number is valid. Default is 180.
   */
  void SetSunAzimuth(double degrees);
  double GetSunAzimuth();
  ///@}

  ///@{
  /**
   * Set/Get whether the sun's disc is drawn: evenly bright, dimmed by the air, its edge a pixel wide, so
   * that its irradiance is right however large pixels are. Default is off.
   */
  vtkSetMacro(SunDisc, bool);
  vtkGetMacro(SunDisc, bool);
  vtkBooleanMacro(SunDisc, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether light that is scattered more than once is added, after [Hillaire2020]: it is taken to be
   * isotropic. The forward peak of the aerosol is left in the light instead, after [Joseph1976], also in that
   * of the single scattering. See Documentation/Evidence/Sky.md for the error. The first time it takes a
   * second for a table. Not with the method STEPS. Default is off.
   */
  vtkSetMacro(MultipleScattering, bool);
  vtkGetMacro(MultipleScattering, bool);
  vtkBooleanMacro(MultipleScattering, bool);
  ///@}

  /// How the integral along the view ray is evaluated.
  enum MethodType
  {
    ADAPTIVE = 0, ///< to Tolerance
    STEPS = 1     ///< NumberOfSteps steps of the first order, as published: [Lodato2015]
  };

  ///@{
  /**
   * Set/Get how the integral is evaluated, one of MethodType. STEPS is there for comparison, and is that
   * of the publication with the atmosphere LODATO_2015: a step of optical depth tau is too bright by
   * tau/(1 - e^-tau). Default is ADAPTIVE.
   */
  vtkSetClampMacro(Method, int, ADAPTIVE, STEPS);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of steps of STEPS. Valid range: [1, 100000]. Default is 64.
   */
  vtkSetClampMacro(NumberOfSteps, int, 1, 100000);
  vtkGetMacro(NumberOfSteps, int);
  ///@}

  ///@{
  /**
   * Set/Get the error that is accepted with ADAPTIVE [fraction of the brightest colour of a pixel]. Valid
   * range: [1e-10, 0.1]. Default is 1e-3.
   */
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  ///@}

  /// Which direction each pixel has; see SkyMapDirection in vtkGodRaysSkyMapMath.glsl.
  enum MappingType
  {
    PARABOLOID = 0,      ///< the upper hemisphere in a circle, a little more in the corners; square
    EQUIRECTANGULAR = 1, ///< azimuth 0 to 360 degrees to the right, nadir to zenith upwards; 2 to 1
    FISHEYE = 2,         ///< the upper hemisphere in a circle, angles to scale; square
    CUBE_MAP =
      3 ///< six slices: +x, -x, +y, -y, +z, -z as OpenGL turns them, rows from its top down
  };

  ///@{
  /**
   * Set/Get which direction each pixel has, one of MappingType. Default is PARABOLOID.
   */
  vtkSetClampMacro(Mapping, int, PARABOLOID, CUBE_MAP);
  vtkGetMacro(Mapping, int);
  ///@}

  ///@{
  /**
   * Set/Get the picture's height [pixels]. Valid range: [1, 16384]. Default is 256.
   */
  vtkSetClampMacro(Resolution, int, 1, 16384);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Set/Get the type of the output's values, VTK_FLOAT or VTK_DOUBLE; others count as VTK_FLOAT. Default
   * is VTK_FLOAT.
   */
  void SetOutputScalarType(int type);
  vtkGetMacro(OutputScalarType, int);
  ///@}

  /**
   * The radiance in one direction (x east, y north, z up; of any length but 0), as a pixel has it, without
   * the sun's disc. Returns false after an error, with 0.
   */
  bool GetRadiance(const double direction[3], double radiance[3]);

  /**
   * The irradiance of the sun across its light at the observer: what is left of SunIrradiance, 0 behind
   * the ground. This is the colour of a light for a scene. Returns false after an error, with 0.
   */
  bool GetSunLight(double irradiance[3]);

  ///@{
  /**
   * The irradiance of a surface with this normal (x east, y north, z up; of any length but 0) by the light of
   * the sky and of the ground, without the sun, from the harmonics of radiance to the second order
   * [Ramamoorthi2001]; the error is in Documentation/Evidence/Sky.md. Forms are all of it: for red, green and
   * blue a symmetric matrix of 4 x 4 each, with which irradiance is (n, 1)^T matrix (n, 1) for a normal n of
   * length 1, or 0 where that is less. They are kept while only the sun's azimuth changes. The ground has
   * light of the sky, too. Returns false after an error, with 0.
   */
  bool GetIrradiance(const double normal[3], double irradiance[3]);
  bool GetIrradianceForms(double forms[48]);
  ///@}

  /**
   * The table by which MultipleScattering goes, whatever that is set to: light that arrives at a point
   * after two scatterings or more, from everywhere alike, for an irradiance of 1 [1/sr]. A row for each of
   * 16 heights, (j/15)^2 of the atmosphere's, of 48 slopes of the way to the sun, u |u| for
   * u = 2 i/47 - 1; 32-bit floats. It depends on the atmosphere alone, and is kept. Returns false after an
   * error, with an empty image.
   */
  bool GetMultipleScattering(vtkImageData* table);

  /**
   * Changes of the atmosphere and of the sun count.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkGodRaysSkySource();
  ~vtkGodRaysSkySource() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysSkySource(const vtkGodRaysSkySource&) = delete;
  void operator=(const vtkGodRaysSkySource&) = delete;

  bool TellProgress(double progress);
  // False after an error about the atmosphere.
  bool Prepare();
  void MakeIrradianceForms(double sunHeight, double azimuth);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  vtkSmartPointer<vtkGodRaysAtmosphere> Atmosphere;
  vtkSmartPointer<vtkGodRaysSun> Sun;
  int AtmospherePreset = 0;
  double ObserverHeight = 2.0;
  bool SunDisc = false;
  bool MultipleScattering = false;
  int Method = ADAPTIVE;
  int NumberOfSteps = 64;
  double Tolerance = 1e-3;
  int Mapping = PARABOLOID;
  int Resolution = 256;
  int OutputScalarType = VTK_FLOAT;
};

#endif
