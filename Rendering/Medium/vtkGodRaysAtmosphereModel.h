// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysAtmosphereModel
 * @brief   air over a plane or a planet: molecules and aerosols whose density falls with height
 *
 * Two components, each of density e^(-h/ScaleHeight) at the height h above GroundLevel: molecules that
 * scatter as Rayleigh's theory has it, and aerosols that scatter forwards [CornetteShanks1992] and
 * absorb. Directional lights are dimmed on their way down to each point of a view ray, so that a low sun
 * is red: their colour is what arrives above the air. A light below the horizon gives nothing. The
 * ground is plane unless there is a PlanetRadius: from about 85 degrees off the zenith on, light and view
 * rays through a real, round atmosphere have a shorter way. See vtkGodRaysMediumModel for what is computed
 * and how much light there is.
 *
 * Defaults are clear air over the Earth, [Bruneton2017]; red, green and blue stand for 680, 550
 * and 440 nm. In a scene of some kilometres that is what makes distant hills blue; for shafts, raise
 * MieScattering.
 *
 * Numbers beyond a valid range are clamped to it; NaN and infinities are errors and change nothing.
 */

#ifndef vtkGodRaysAtmosphereModel_h
#define vtkGodRaysAtmosphereModel_h

#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkSmartPointer.h"           // For vtkSmartPointer

#include <string> // For std::string

class vtkGodRaysAtmosphere;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysAtmosphereModel : public vtkGodRaysMediumModel
{
public:
  static vtkGodRaysAtmosphereModel* New();
  vtkTypeMacro(vtkGodRaysAtmosphereModel, vtkGodRaysMediumModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the atmosphere whose molecules and aerosol these are, as a sky has it: scattering, absorption,
   * heights, asymmetry, of which green's is that of all colours. One object may be that of a model, of a
   * vtkGodRaysSkyPass and of a vtkGodRaysSkySource: this model has its numbers now, and again whenever it
   * changes; what is set here holds until then. Its profiles count as EXPONENTIAL, the aerosol's phase
   * function as CORNETTE_SHANKS, and ozone is left out: near the ground there is next to none. Default is
   * null: the model has numbers of its own, at first those of the Earth, a new vtkGodRaysAtmosphere; null
   * leaves them as they are.
   */
  void SetAtmosphere(vtkGodRaysAtmosphere* atmosphere);
  vtkGodRaysAtmosphere* GetAtmosphere();
  ///@}

  ///@{
  /**
   * Set/Get how much light molecules scatter at GroundLevel, for red, green and blue [1/m]. Valid range: [0,
   * 1e15]. Default is that of the Earth, see SetAtmosphere(): 5.802e-6, 13.558e-6, 33.10e-6.
   */
  void SetRayleighScattering(double red, double green, double blue);
  void SetRayleighScattering(const double coefficient[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(RayleighScattering, double);
  ///@}

  ///@{
  /**
   * Set/Get over which height the density of molecules falls to 1/e [m]. Valid range: [1e-6, 1e9]. Default
   * is 8000.
   */
  void SetRayleighScaleHeight(double height);
  vtkGetMacro(RayleighScaleHeight, double);
  ///@}

  ///@{
  /**
   * Set/Get how much light aerosols scatter and absorb at GroundLevel, for red, green and blue [1/m]. More
   * of it makes shafts. Valid range: [0, 1e15]. Defaults are 3.996e-6 and 4.44e-7.
   */
  void SetMieScattering(double red, double green, double blue);
  void SetMieScattering(const double coefficient[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(MieScattering, double);
  void SetMieAbsorption(double red, double green, double blue);
  void SetMieAbsorption(const double coefficient[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(MieAbsorption, double);
  ///@}

  ///@{
  /**
   * Set/Get over which height the density of aerosols falls to 1/e [m]. Valid range: [1e-6, 1e9]. Default is
   * 1200.
   */
  void SetMieScaleHeight(double height);
  vtkGetMacro(MieScaleHeight, double);
  ///@}

  ///@{
  /**
   * Set/Get the asymmetry g of aerosols [no unit]: the mean cosine of the angle into which they scatter.
   * Valid range: [-0.99, 0.99]. Default is 0.8.
   */
  void SetMieAsymmetry(double g);
  vtkGetMacro(MieAsymmetry, double);
  ///@}

  ///@{
  /**
   * Set/Get which way is up, a direction of the world of any length but 0. Default is (0, 0, 1).
   */
  void SetUp(double x, double y, double z);
  void SetUp(const double direction[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Set/Get where heights are counted from: the coordinate along Up [scene units]. Valid range:
   * [-1e30, 1e30]. Default is 0.
   */
  void SetGroundLevel(double level);
  vtkGetMacro(GroundLevel, double);
  ///@}

  ///@{
  /**
   * Set/Get the radius of a planet, of which GroundLevel is the ground and whose centre is that far below
   * it along Up from the world's origin [m]. Its ground hides lights and ends the medium that is seen:
   * scenes should lie above it, and lamps in it give no light. It should be above 500 scale heights; the
   * Earth's is 6.36e6. 0 is a plane without a horizon. Valid range: [0, 1e15]. Default is 0.
   */
  void SetPlanetRadius(double radius);
  vtkGetMacro(PlanetRadius, double);
  ///@}

  std::string Describe() const override;

protected:
  vtkGodRaysAtmosphereModel();
  ~vtkGodRaysAtmosphereModel() override;

  void FillMedium(vtkGodRaysMedium& medium, const double worldToView[16]) const override;

private:
  vtkGodRaysAtmosphereModel(const vtkGodRaysAtmosphereModel&) = delete;
  void operator=(const vtkGodRaysAtmosphereModel&) = delete;

  void Take(vtkGodRaysAtmosphere* atmosphere);
  void Follow(); // the atmosphere, which has changed

  vtkSmartPointer<vtkGodRaysAtmosphere> Atmosphere;
  unsigned long Observer = 0; // of it
  double RayleighScattering[3] = { 0.0, 0.0, 0.0 };
  double RayleighScaleHeight = 1.0;
  double MieScattering[3] = { 0.0, 0.0, 0.0 };
  double MieAbsorption[3] = { 0.0, 0.0, 0.0 };
  double MieScaleHeight = 1.0;
  double MieAsymmetry = 0.0;
  double Up[3] = { 0.0, 0.0, 1.0 };
  double GroundLevel = 0.0;
  double PlanetRadius = 0.0;
};

#endif
