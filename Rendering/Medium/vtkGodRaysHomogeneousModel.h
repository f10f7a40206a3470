// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysHomogeneousModel
 * @brief   a medium that is the same everywhere: haze, fog, a dusty room, water
 *
 * See vtkGodRaysMediumModel for what is computed and how much light there is. Directional lights are
 * not dimmed on their way to a view ray, as in a room with a window: their colour is what arrives.
 *
 * Numbers beyond a valid range are clamped to it; NaN and infinities are errors and change nothing.
 */

#ifndef vtkGodRaysHomogeneousModel_h
#define vtkGodRaysHomogeneousModel_h

#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysRenderingModule.h" // For export macro

#include <string> // For std::string

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysHomogeneousModel : public vtkGodRaysMediumModel
{
public:
  static vtkGodRaysHomogeneousModel* New();
  vtkTypeMacro(vtkGodRaysHomogeneousModel, vtkGodRaysMediumModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the optical depth, in green, across the diagonal of the bounds of all visible props, as
   * vtkGodRaysPass::ResetSceneSize() says, that the medium has while WorldUnitInMeters is 0: coefficients are
   * then scaled as a whole. 0 takes them as they
   * are, per scene unit. ApplyPreset() sets one; to change a coefficient, or to set the visibility, sets 0.
   * Pictures are most believable from 0.1 to 1. Valid range: [0, 100]. Default is 0 [no unit].
   */
  void SetOpticalDepth(double depth);
  vtkGetMacro(OpticalDepth, double);
  ///@}

  ///@{
  /**
   * Set/Get how much light is scattered and absorbed, for red, green and blue [1/m]. Valid range: [0, 1e15].
   * Default is 0.02 and 0.
   */
  void SetScatteringCoefficient(double red, double green, double blue);
  void SetScatteringCoefficient(const double coefficient[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(ScatteringCoefficient, double);
  void SetAbsorptionCoefficient(double red, double green, double blue);
  void SetAbsorptionCoefficient(const double coefficient[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(AbsorptionCoefficient, double);
  ///@}

  ///@{
  /**
   * Set/Get the distance at which 5 % of a contrast is left, in green [m]: the meteorological optical range,
   * -ln(0.05)/sigma_t [Koschmieder1924], [WMO8]. To set it scales both coefficients of all colours by one
   * factor; where there is nothing to scale, it sets equal scattering. Valid range: [1e-9, 1e12]; a number
   * that is not above 0 is an error and changes nothing. Infinite without extinction. Default is 149.8.
   */
  void SetVisibility(double meters);
  double GetVisibility();
  ///@}

  ///@{
  /**
   * Set/Get into which directions light is scattered, one of PhaseFunctionType. Default is
   * HENYEY_GREENSTEIN.
   */
  void SetPhaseFunction(int phaseFunction);
  vtkGetMacro(PhaseFunction, int);
  ///@}

  ///@{
  /**
   * Set/Get the asymmetry g of the phase functions that have one [no unit]: above 0, light goes on
   * rather than back. Valid range: [-0.99, 0.99]. Default is 0.6.
   */
  void SetAsymmetry(double g);
  vtkGetMacro(Asymmetry, double);
  ///@}

  ///@{
  /**
   * Set/Get a second phase function, of a part of the light, one of PhaseFunctionType: together they are (1
   * - SecondWeight) first + SecondWeight second. Default is ISOTROPIC.
   */
  void SetSecondPhaseFunction(int phaseFunction);
  vtkGetMacro(SecondPhaseFunction, int);
  ///@}

  ///@{
  /**
   * Set/Get the asymmetry g of the second phase function [no unit]. Valid range: [-0.99, 0.99]. Default is
   * 0.
   */
  void SetSecondAsymmetry(double g);
  vtkGetMacro(SecondAsymmetry, double);
  ///@}

  ///@{
  /**
   * Set/Get how much of the light the second phase function scatters [fraction]. Valid range: [0, 1].
   * Default is 0: none.
   */
  void SetSecondWeight(double weight);
  vtkGetMacro(SecondWeight, double);
  ///@}

  ///@{
  /**
   * Set coefficients and phase function to those of a medium in nature, which is that dense if
   * WorldUnitInMeters is set; else OpticalDepth, the last number, says how dense it is. WorldUnitInMeters,
   * FarLimit and AttenuateScene stay. Red, green and blue stand for 680, 550 and 440 nm.
   *
   * | name       | scattering [1/m]       | absorption [1/m]  | phase function | source | depth |
   * |------------|------------------------|-------------------|----------------|--------|-------|
   * | clear-air  | 5.802, 13.558, 33.1e-6 | 0                 | Rayleigh       | air at sea level without aerosols [Bruneton2017] | 0.15 |
   * | haze       | 7.49e-4                | 0                 | HG 0.9         | a visibility of 4 km, 3.00/V [WMO8]; g above the 0.76 of aerosols [Bruneton2017], for clear shafts | 0.3 |
   * | fog        | 1.5e-2                 | 0                 | HG 0.85        | a visibility of 200 m; g of droplets [HansenTravis1974] | 0.6 |
   * | dust       | 5.64, 5.28, 4.56e-3    | 0.36, 0.72, 1.44e-3 | HG 0.67      | 10 mg/m3, the limit for a workplace, times 0.6 m2/g of coarse dust [Pitchford2007]; g of a desert's and three times its part of absorption [Dubovik2002], for grains three times as large; its albedo in green, 0.88, is among the 0.70 to 0.97 measured over the Sahara [Ryder2013] | 0.5 |
   * | smoke      | 1.71, 2.58, 3.93e-3    | 0.33, 0.42, 0.54e-3 | HG 0.6       | a visibility of 1 km; albedo, g and colour of burning savanna [Dubovik2002] | 0.4 |
   * | sea-water  | 0.219                  | 0.61, 0.20, 0.151 | HG 0.924       | coastal [Petzold1972]: 0.219 and 0.179 at 514 nm; colours as pure water's [PopeFry1997] | 0.4 |
   *
   * Returns false, with an error that lists the names, for a name that is none of them.
   */
  bool ApplyPreset(const char* name) override;
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index);
  static const char* GetPresetDescription(int index);
  ///@}

  std::string Describe() const override;

protected:
  vtkGodRaysHomogeneousModel() = default;
  ~vtkGodRaysHomogeneousModel() override = default;

  void FillMedium(vtkGodRaysMedium& medium, const double worldToView[16]) const override;
  double GetScale(const vtkGodRaysMedium& medium, double diagonal) const override;

private:
  vtkGodRaysHomogeneousModel(const vtkGodRaysHomogeneousModel&) = delete;
  void operator=(const vtkGodRaysHomogeneousModel&) = delete;

  double OpticalDepth = 0.0;
  double ScatteringCoefficient[3] = { 0.02, 0.02, 0.02 };
  double AbsorptionCoefficient[3] = { 0.0, 0.0, 0.0 };
  int PhaseFunction = HENYEY_GREENSTEIN;
  double Asymmetry = 0.6;
  int SecondPhaseFunction = ISOTROPIC;
  double SecondAsymmetry = 0.0;
  double SecondWeight = 0.0;
};

#endif
