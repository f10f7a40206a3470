// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSkyPass
 * @brief   the physical sky behind a scene, and the air before it
 *
 * Draws the light that a vtkGodRaysAtmosphere scatters on its way from the sun to the eye, wherever
 * nothing else is seen: the sky from the ground, the planet and its limb from space. It is the sky of
 * vtkGodRaysSkySource, looked up in a table of directions; the aureole about the sun is exact for each
 * pixel. See Documentation/Evidence/Sky.md for what it costs and how right it is.
 *
 * @code
 * vtkGodRaysSkyPass* sky = vtkGodRaysSkyPass::Attach(renderer);
 * sky->SetSunElevation(5.0);
 * sky->SetSunAzimuth(270.0);
 * sky->UpdateLight(sun);  // a vtkLight: it has the sun's direction and colour now
 * rays->AddLight(sun);    // a vtkGodRaysPass; its shafts have that colour, too
 * rays->Attach(renderer); // the rays are over the sky
 * @endcode
 *
 * Lengths in the scene are in its units, of WorldUnitInMeters. The planet's ground touches the scene at
 * Origin; the sun's Up and North are directions there. With the sun's frame CAMERA, the eye stands on the
 * ground instead, and looks to the north. Everything is computed relative to the camera, so scenes may
 * be as large as the planet. A camera below the ground counts as one on it. In a parallel projection all
 * view rays have the same direction, so that the sky has one colour.
 *
 * Without a delegate the sky is drawn between the background and the scene if anything is translucent, so
 * that it is before the sky. A delegate draws scene and background at once, and so does vtkRenderer with
 * UseSSAO: then the sky is drawn after it, where the depth is that of nothing, and replaces what is
 * translucent there. So let passes such as vtkSSAAPass and vtkToneMappingPass have this one as their
 * delegate instead.
 *
 * Colours are written as the window shows them: radiance times Exposure is linear light, encoded by the
 * DisplayTransfer, as god rays are. In a floating-point framebuffer, such as that of a vtkToneMappingPass
 * that has this pass as its delegate, the sun is brighter than 1; where values have 8 bits, HighlightShoulder
 * can keep the hue of a bright sky. The scene's depth stays as it is.
 *
 * Numbers beyond a valid range are clamped to it. NaN and infinities are errors and change nothing. An
 * atmosphere that cannot be used is told once, and the scene is drawn without sky.
 *
 * @sa vtkGodRaysSkySource vtkGodRaysAtmosphere vtkGodRaysSun vtkGodRaysPass
 */

#ifndef vtkGodRaysSkyPass_h
#define vtkGodRaysSkyPass_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkImageProcessingPass.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class vtkGodRaysAtmosphere;
class vtkGodRaysCompositor;
class vtkGodRaysSkyTable;
class vtkGodRaysSun;
class vtkLight;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTexture;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysSkyPass : public vtkImageProcessingPass
{
public:
  static vtkGodRaysSkyPass* New();
  vtkTypeMacro(vtkGodRaysSkyPass, vtkImageProcessingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Attach: give a renderer a sky, or return the one that it has. It is put among the renderer's passes, and
   * kept there, as by vtkGodRaysPass::Attach(), under god rays. The renderer owns the pass. Null, after an
   * error, for a null renderer.
   * Detach: take the sky off and give the renderer back what it had. False if it has none, or if
   * another pass was given it for its delegate by hand: give that pass another one.
   * Find: the sky that a renderer has, null if it has none.
   */
  static vtkGodRaysSkyPass* Attach(vtkRenderer* renderer);
  static bool Detach(vtkRenderer* renderer);
  static vtkGodRaysSkyPass* Find(vtkRenderer* renderer);
  ///@}

  ///@{
  /**
   * Set/Get the air; it can be changed in place. Null makes a new one, the default: clear air over the Earth.
   */
  void SetAtmosphere(vtkGodRaysAtmosphere* atmosphere);
  vtkGodRaysAtmosphere* GetAtmosphere();
  ///@}

  ///@{
  /**
   * Set/Get the sun, which can be changed in place. Its Color does not count: the air gives it one. Null
   * makes a new one, the default: frame UP_AND_NORTH as on a map, elevation 45 and azimuth 180 degrees.
   */
  void SetSun(vtkGodRaysSun* sun);
  vtkGodRaysSun* GetSun();
  ///@}

  ///@{
  /**
   * Set/Get the sun's elevation, in [-90, 90], and azimuth [degrees], and axes, see vtkGodRaysSun. They set
   * its position AZIMUTH_AND_ELEVATION or frame UP_AND_NORTH. Defaults: 45, 180, (0, 0, 1) and (0, 1, 0).
   */
  void SetSunElevation(double degrees);
  double GetSunElevation();
  void SetSunAzimuth(double degrees);
  double GetSunAzimuth();
  void SetUp(double x, double y, double z);
  void SetUp(const double direction[3]) VTK_SIZEHINT(3);
  double* GetUp() VTK_SIZEHINT(3);
  void SetNorth(double x, double y, double z);
  void SetNorth(const double direction[3]) VTK_SIZEHINT(3);
  double* GetNorth() VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * Set/Get a point of the scene that is on the planet's ground [scene units]; the planet's centre is under
   * it, unless the sun's frame is CAMERA. Valid range: [-1e30, 1e30]. Default is (0, 0, 0).
   */
  void SetOrigin(double x, double y, double z);
  void SetOrigin(const double point[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Set/Get how long the scene's unit is [m]. Valid range: [1e-12, 1e12]. Default is 1.
   */
  void SetWorldUnitInMeters(double meters);
  vtkGetMacro(WorldUnitInMeters, double);
  ///@}

  ///@{
  /**
   * Set/Get the factor from radiance [the unit of the atmosphere's SunIrradiance/sr] to linear light, of
   * which 1 is as bright as the window shows; see WhiteBalance. Valid range: [0, 1e30]. Useful range:
   * [0, 20]. Default is 4: the sky of a clear day is bright, and white things in the sun are too bright to be
   * shown, as on a photograph of the sky.
   */
  void SetExposure(double exposure);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the sun is white before its light meets the air: the three radiances are then weighted
   * such that the atmosphere's SunIrradiance is grey, of the luminance that it has. Else they are red, green
   * and blue as they are; SunIrradiance of sunlight is bluish so, and a sky of dust greenish. Default is on.
   */
  vtkSetMacro(WhiteBalance, bool);
  vtkGetMacro(WhiteBalance, bool);
  vtkBooleanMacro(WhiteBalance, bool);
  ///@}

  ///@{
  /**
   * Set/Get how colours stand for light, one of vtkGodRaysPass::DisplayTransferType, as there. Default is
   * AUTOMATIC_TRANSFER.
   */
  void SetDisplayTransfer(int transfer);
  vtkGetMacro(DisplayTransfer, int);
  ///@}

  ///@{
  /**
   * Set/Get whether light of the sky and of the air stays below white, where it would else be clipped,
   * channel by channel, and lose its hue: light up to half of white is as it is, what is brighter is
   * compressed, all channels alike. The sun's disc is clipped, and so is seen.
   * vtkGodRaysPass::SetHighlightShoulder() does the same. Floating-point framebuffers do without, so that
   * tone mapping has all of the light. Default is off: what is shown is the sky's light times Exposure.
   */
  vtkSetMacro(HighlightShoulder, bool);
  vtkGetMacro(HighlightShoulder, bool);
  vtkBooleanMacro(HighlightShoulder, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether ordered noise of half a level hides the steps of 8-bit framebuffers in gradients of the
   * sky and of the air. Off, light is rounded. Default is on.
   */
  vtkSetMacro(Dithering, bool);
  vtkGetMacro(Dithering, bool);
  vtkBooleanMacro(Dithering, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the sun's disc is drawn, darker towards its limb. Its size is the sun's AngularRadius
   * at the atmosphere's SunDistance. Default is on.
   */
  vtkSetMacro(SunDisc, bool);
  vtkGetMacro(SunDisc, bool);
  vtkBooleanMacro(SunDisc, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the scene is seen through the air: dimmed, and behind the light that the air before it
   * scatters. It shows over kilometres: see WorldUnitInMeters. Leave it off with a
   * vtkGodRaysAtmosphereModel, which computes the same air. It goes by the scene's depth, so translucent
   * things over the open sky are left as they are; and where it is seen, multisampling is lost. The scene's
   * own shadows are not looked at. It is skipped where it would change less than 5e-4. Default is on.
   */
  vtkSetMacro(AerialPerspective, bool);
  vtkGetMacro(AerialPerspective, bool);
  vtkBooleanMacro(AerialPerspective, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether the sky lights the scene, in proportion to what it is: blue by day, dark at night. The
   * media of rays whose light is that of UpdateLight() scatter its mean radiance, which nothing dims. On
   * surfaces it is the light of GetSkyIrradiance() by each normal, which nothing in the scene takes away; so
   * let vtkSSAOPass darken what is narrow. Surfaces in physically based shading mirror it, too, as dull ones
   * do; where VTK lights them by an environment, it stays away. So it does from surfaces without lights,
   * from volumes, and from scenes that reach across a twentieth of the planet's radius, which have more than
   * one sky. Default is on.
   */
  vtkSetMacro(SurfaceLight, bool);
  vtkGetMacro(SurfaceLight, bool);
  vtkBooleanMacro(SurfaceLight, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether light that is scattered more than once is added. It takes a table that depends on the
   * atmosphere alone. Default is on.
   */
  vtkSetMacro(MultipleScattering, bool);
  vtkGetMacro(MultipleScattering, bool);
  vtkBooleanMacro(MultipleScattering, bool);
  ///@}

  ///@{
  /**
   * Set/Get what joins the scene, if its parts are on several processes and this pass has for its delegate
   * one that joins their pictures over nothing, with alpha: the process that has the joined picture puts the
   * sky under it by its alpha, and the others draw none. Default is null: the whole scene is here.
   */
  void SetCompositor(vtkGodRaysCompositor* compositor);
  vtkGodRaysCompositor* GetCompositor();
  ///@}

  /**
   * The irradiance of the sun across its light at Origin, on the ground: what the air leaves of the
   * atmosphere's SunIrradiance, in its unit, with WhiteBalance. 0 after an error, and for a sun below the
   * horizon.
   */
  void GetSunColor(double irradiance[3]);

  /**
   * The radiance of the sky in a direction from Origin, on the ground (x east, y north, z up; of any length
   * but 0), without the sun's disc, in the unit of the atmosphere's SunIrradiance/sr, with WhiteBalance;
   * times Exposure it is linear light. Returns false after an error, with 0.
   */
  bool GetSkyColor(const double direction[3], double radiance[3]);

  /**
   * The irradiance of a surface at Origin, on the ground, by the light of the sky and the ground, without the
   * sun: vtkGodRaysSkySource::GetIrradiance(), with WhiteBalance. Times Exposure/pi it is the radiance of a
   * white surface, as linear light. Returns false after an error, with 0.
   */
  bool GetSkyIrradiance(const double normal[3], double irradiance[3]);

  /**
   * Make a light that of the sun, as vtkGodRaysSun::UpdateLight() does, in the colour that the air leaves it.
   * In linear light, its colour times its intensity is irradiance times Exposure/pi, the radiance that a
   * white surface across it has; so scene, sky and shafts belong together. The brightest colour is 1. Its
   * information keeps what the sun is above the air, which a vtkGodRaysAtmosphereModel takes: that dims it
   * itself. It does so while the light has this colour.
   */
  bool UpdateLight(vtkLight* light);

  /**
   * The light of the sky and the ground about Origin, as linear light, for image-based lighting: a texture
   * for vtkRenderer::SetEnvironmentTexture(), with EnvironmentUp set to Up and EnvironmentRight to the
   * opposite of North; or for a vtkSkybox in a sphere's projection, with FloorPlane set to Up and FloorRight
   * to the west. It is equirectangular, 128 x 64, without the sun's disc, which is a light of its own. It is
   * the same object every time, and made anew by this call when the sun, the atmosphere, MultipleScattering,
   * Exposure or WhiteBalance has changed. Null after an error.
   */
  vtkTexture* GetEnvironmentTexture();

  /**
   * What the last frame needed, as text: the observer, the tables and why they were made anew, and what
   * was skipped.
   */
  std::string GetPlan() const;

  /**
   * How often tables of directions have been made, one for the sky and one for the air before the scene.
   */
  vtkGetMacro(NumberOfTables, int);

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  vtkMTimeType GetMTime() override;

protected:
  vtkGodRaysSkyPass();
  ~vtkGodRaysSkyPass() override;

private:
  vtkGodRaysSkyPass(const vtkGodRaysSkyPass&) = delete;
  void operator=(const vtkGodRaysSkyPass&) = delete;

  const char* FindReasonForNoSky(const vtkRenderState* s, vtkOpenGLRenderWindow* window);
  const char* FindReasonForNoAir(const vtkRenderState* s);
  void SetObserver(const vtkRenderState* s);
  void RenderScene(const vtkRenderState* s);
  const char* FindReasonForNoLight(const vtkRenderState* s);
  void LightSurfaces(const vtkRenderState* s);
  void PrepareSource();
  bool UpdateTable(vtkGodRaysSkyTable& table, const char* name);
  bool JoinsPictures() const;
  bool DrawSky(const vtkRenderState* s);
  bool DrawAir(const vtkRenderState* s);
  enum Stage
  {
    SKY,
    SKY_WITH_SUN,
    AIR
  };
  bool Draw(const int viewport[4], const int part[4], Stage stage);
  void Complain(const char* what, const std::string& reason);

  struct Internals;
  std::unique_ptr<Internals> Internal;

  double Origin[3] = { 0.0, 0.0, 0.0 };
  double WorldUnitInMeters = 1.0;
  double Exposure = 4.0;
  bool WhiteBalance = true;
  int DisplayTransfer = 0;
  bool HighlightShoulder = false;
  bool Dithering = true;
  bool SunDisc = true;
  bool AerialPerspective = true;
  bool SurfaceLight = true;
  bool MultipleScattering = true;
  int NumberOfTables = 0;
};

#endif
