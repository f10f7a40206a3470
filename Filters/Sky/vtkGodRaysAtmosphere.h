// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysAtmosphere
 * @brief   a planet's atmosphere, for the light of its sky
 *
 * Three constituents in spherical shells: air that scatters after Rayleigh, aerosol that scatters after
 * Mie and absorbs, and ozone that absorbs. Each has a density profile, 1 where its coefficients are
 * given, and coefficients for three colours; a preset's are those of the wavelengths 680, 550 and 440 nm.
 * Lengths are in metres. The formulas are those of vtkGodRaysSkyMath.glsl.
 *
 * Vectors are looked at where the atmosphere is used: FindFault() tells what cannot be used.
 *
 * @sa vtkGodRaysSkySource vtkGodRaysSun
 */

#ifndef vtkGodRaysAtmosphere_h
#define vtkGodRaysAtmosphere_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysPhaseFunction.h" // For PhaseFunctionType
#include "vtkObject.h"

#include <string> // For std::string

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysAtmosphere : public vtkObject
{
public:
  static vtkGodRaysAtmosphere* New();
  vtkTypeMacro(vtkGodRaysAtmosphere, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Atmospheres that are known by name.
  enum PresetType
  {
    EARTH_CLEAR = 0,    ///< very clean air, 300 DU of ozone: the constants of [Bruneton2017]
    EARTH_HAZY = 1,     ///< aerosol of optical depth 0.2 at 550 nm, hardly absorbing
    EARTH_POLLUTED = 2, ///< aerosol of optical depth 0.6 at 550 nm that absorbs a sixth
    MARS = 3,           ///< thin air, and dust of optical depth 0.5 that absorbs blue
    LODATO_2015 = 4     ///< uniform density up to a thin top, as published for WebGL: [Lodato2015]
  };

  /**
   * Set all parameters to those of a preset, one of PresetType; others are an error. A new atmosphere is
   * EARTH_CLEAR. Haze, pollution and dust are typical values, not measurements of a day.
   */
  void LoadPreset(int preset);

  /**
   * Set it by name: earth-clear, earth-hazy, earth-polluted, mars or lodato-2015. Returns false after an
   * error about another name, and nothing is changed.
   */
  bool LoadPreset(const std::string& name);

  ///@{
  /**
   * Set/Get the planet's radius [m]. Valid range: [1e3, 1e9]. Default is 6.36e6.
   */
  void SetGroundRadius(double radius);
  vtkGetMacro(GroundRadius, double);
  ///@}

  ///@{
  /**
   * Set/Get the height above the ground at which the atmosphere ends [m]. Valid range: [1, 1e8]. Default
   * is 60000.
   */
  void SetTopHeight(double height);
  vtkGetMacro(TopHeight, double);
  ///@}

  /// How density depends on the height h; see SkyProfile in vtkGodRaysSkyMath.glsl.
  enum ProfileType
  {
    EXPONENTIAL = 0, ///< e^(-h/Height)
    UNIFORM = 1,     ///< 1 up to Height
    LAYER = 2        ///< 1 - |h - Height|/Width, at least 0
  };

  ///@{
  /**
   * Set/Get the air: how its density depends on the height, one of ProfileType, with its lengths [m],
   * valid in [1, 1e8], and how much it scatters of each colour where the density is 1 [1/m], valid in
   * [0, 1]. Default: EXPONENTIAL of 8000 m, 1.24062e-6 (wavelength/um)^-4.
   */
  vtkSetClampMacro(RayleighProfile, int, EXPONENTIAL, LAYER);
  vtkGetMacro(RayleighProfile, int);
  void SetRayleighHeight(double height);
  vtkGetMacro(RayleighHeight, double);
  void SetRayleighWidth(double width);
  vtkGetMacro(RayleighWidth, double);
  vtkSetVector3Macro(RayleighScattering, double);
  vtkGetVector3Macro(RayleighScattering, double);
  ///@}

  /**
   * The Earth's Rayleigh scattering at sea level for a wavelength [nm], at least 100: 1.24062e-6 times
   * its -4th power in micrometres [1/m].
   */
  static double GetRayleighScatteringOf(double wavelength);

  ///@{
  /**
   * Set/Get the aerosol, as the air, and how much it absorbs [1/m], valid in [0, 1]. Default:
   * EXPONENTIAL of 1200 m, 3.996e-6 and 0.444e-6.
   */
  vtkSetClampMacro(MieProfile, int, EXPONENTIAL, LAYER);
  vtkGetMacro(MieProfile, int);
  void SetMieHeight(double height);
  vtkGetMacro(MieHeight, double);
  void SetMieWidth(double width);
  vtkGetMacro(MieWidth, double);
  vtkSetVector3Macro(MieScattering, double);
  vtkGetVector3Macro(MieScattering, double);
  vtkSetVector3Macro(MieAbsorption, double);
  vtkGetVector3Macro(MieAbsorption, double);
  ///@}

  ///@{
  /**
   * Set/Get the ozone, as the air; it absorbs only. Default: LAYER of 25000 m, 15000 m, (0.650, 1.881,
   * 0.085) 1e-6 [1/m].
   */
  vtkSetClampMacro(OzoneProfile, int, EXPONENTIAL, LAYER);
  vtkGetMacro(OzoneProfile, int);
  void SetOzoneHeight(double height);
  vtkGetMacro(OzoneHeight, double);
  void SetOzoneWidth(double width);
  vtkGetMacro(OzoneWidth, double);
  vtkSetVector3Macro(OzoneAbsorption, double);
  vtkGetVector3Macro(OzoneAbsorption, double);
  ///@}

  /// Into which directions light is scattered; see vtkGodRaysPhaseFunction.h.
  enum PhaseFunctionType
  {
    vtkGodRaysPhaseFunctionConstantsMacro()
  };

  ///@{
  /**
   * Set/Get the aerosol's phase function, one of PhaseFunctionType, and its asymmetry g, for each
   * colour or one for all, valid in [-0.99, 0.99]. The air's is RAYLEIGH. Default: CORNETTE_SHANKS of 0.8.
   */
  vtkSetClampMacro(MiePhaseFunction, int, ISOTROPIC, vtkGodRaysLastPhaseFunction);
  vtkGetMacro(MiePhaseFunction, int);
  void SetMieAsymmetry(double red, double green, double blue);
  void SetMieAsymmetry(const double g[3]);
  void SetMieAsymmetry(double g);
  vtkGetVector3Macro(MieAsymmetry, double);
  ///@}

  ///@{
  /**
   * Set/Get the sun's irradiance across its light, outside the atmosphere, for each colour [the radiance's
   * unit times sr]. Valid range: [0, 1e30]. Default: (1.474, 1.8504, 1.91198) W/(m^2 nm), of [ASTM-G173].
   */
  vtkSetVector3Macro(SunIrradiance, double);
  vtkGetVector3Macro(SunIrradiance, double);
  ///@}

  ///@{
  /**
   * Set/Get how far away the sun is [astronomical units]: its disc has the AngularRadius of a vtkGodRaysSun
   * divided by that. Valid range: [0.01, 1000]. Default is 1. It matters for the disc alone: SunIrradiance
   * is that at the planet, and as a source of scattered light the sun is a point.
   */
  void SetSunDistance(double distance);
  vtkGetMacro(SunDistance, double);
  ///@}

  ///@{
  /**
   * Set/Get how much light the ground reflects into all directions alike (after Lambert), for each colour.
   * Valid range: [0, 1]. Default is 0.1.
   */
  vtkSetVector3Macro(GroundAlbedo, double);
  vtkGetVector3Macro(GroundAlbedo, double);
  ///@}

  /**
   * Which parameter cannot be used, and what to do; empty if all can.
   */
  std::string FindFault() const;

protected:
  vtkGodRaysAtmosphere();
  ~vtkGodRaysAtmosphere() override = default;

  double GroundRadius = 0.0;
  double TopHeight = 0.0;
  int RayleighProfile = EXPONENTIAL;
  double RayleighHeight = 0.0;
  double RayleighWidth = 0.0;
  double RayleighScattering[3] = { 0.0, 0.0, 0.0 };
  int MieProfile = EXPONENTIAL;
  double MieHeight = 0.0;
  double MieWidth = 0.0;
  double MieScattering[3] = { 0.0, 0.0, 0.0 };
  double MieAbsorption[3] = { 0.0, 0.0, 0.0 };
  int OzoneProfile = LAYER;
  double OzoneHeight = 0.0;
  double OzoneWidth = 0.0;
  double OzoneAbsorption[3] = { 0.0, 0.0, 0.0 };
  int MiePhaseFunction = CORNETTE_SHANKS;
  double MieAsymmetry[3] = { 0.0, 0.0, 0.0 };
  double SunIrradiance[3] = { 0.0, 0.0, 0.0 };
  double SunDistance = 1.0;
  double GroundAlbedo[3] = { 0.0, 0.0, 0.0 };

private:
  vtkGodRaysAtmosphere(const vtkGodRaysAtmosphere&) = delete;
  void operator=(const vtkGodRaysAtmosphere&) = delete;

  // Aerosol of an optical depth at 550 nm, whose extinction is as wavelength^-exponent, and of which
  // a part is scattered.
  void SetAerosol(double depth, double exponent, double scattered);
};

#endif
