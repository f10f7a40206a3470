// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysPass
 * @brief   put god rays (light shafts through occluders) into a VTK scene
 *
 * Draws the scene where it would have been drawn without it, then adds the light that the medium
 * between the scene and the eye scatters towards the viewer:
 *
 * 1. Occlusion: for each light, a layer of its emitter (the light's own disc, or the props tagged
 *    LIGHT, and the open background about it) less the occluders. See vtkGodRaysOcclusionPass.
 * 2. Scattering: a vtkGodRaysModel says what is summed, a vtkGodRaysIntegrator how.
 * 3. Blend: the sum is added to the picture in linear light. See vtkGodRaysBlendPass.
 *
 * The usual way to use it is three lines:
 * @code
 * vtkNew<vtkGodRaysPass> rays;
 * rays->AddLight(sun); // a vtkLight; or vtkGodRaysPass::SetRole(actor, vtkGodRaysPass::LIGHT)
 * rays->Attach(renderer);
 * @endcode
 *
 * Depth, alpha, anti-aliasing, volumes, depth peeling, SSAO, FXAA, layers and later passes stay as
 * they were, and pixels that no ray reaches keep their bytes. When no light can reach the picture,
 * or Intensity or the model's density is 0, the scene is drawn straight through: GetPlan() says so.
 * 2-D props (text, scalar bars) neither block light nor receive rays: they are drawn last, over them.
 *
 * The pass belongs to one renderer at a time, and that renderer's window must be an OpenGL one;
 * with any other window the scene is drawn without rays, after one warning.
 *
 * Many lamps and glass take their time. The window invokes its AbortCheckEvent between and within lights:
 * vtkRenderWindow::SetAbortRender(1) ends the frame without rays. From 2 s on, the pass invokes
 * vtkCommand::ProgressEvent after each light, with the fraction of the lights that are done, a double.
 *
 * Numbers beyond a valid range are clamped to it. NaN, infinities, and modes that are none of those
 * listed are errors, and change nothing.
 *
 * Setting the environment variable GODRAYS_DISABLE to anything but 0 draws every scene straight
 * through, to compare a picture with and without rays.
 *
 * @sa vtkGodRaysRadialModel vtkGodRaysEpipolarIntegrator vtkImageProcessingPass
 */

#ifndef vtkGodRaysPass_h
#define vtkGodRaysPass_h

#include "vtkCommand.h"                // For UserEvent
#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkImageProcessingPass.h"
#include "vtkWrappingHints.h" // For VTK_SIZEHINT

#include <memory> // For std::unique_ptr
#include <string> // For std::string
#include <vector> // For std::vector

class vtkGodRaysCompositor;
class vtkGodRaysIntegrator;
class vtkGodRaysModel;
class vtkGodRaysSun;
class vtkGodRaysSunPlacer;
class vtkImageData;
class vtkInformationIntegerKey;
class vtkLight;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkProp;
class vtkRenderer;
struct vtkGodRaysFramebuffer;
struct vtkGodRaysLight;
struct vtkGodRaysView;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysPass : public vtkImageProcessingPass
{
public:
  static vtkGodRaysPass* New();
  vtkTypeMacro(vtkGodRaysPass, vtkImageProcessingPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What a prop does to the light.
  enum Role
  {
    AUTOMATIC = 0, ///< blocks light if UntaggedPropsOcclude is on; the role of every prop at first
    OCCLUDER = 1,  ///< blocks light
    LIGHT = 2,     ///< shines, in the colours in which it is drawn
    IGNORED = 3,   ///< neither blocks nor shines
    MEDIUM = 4     ///< of a vtkVolume: its data scatter light in place of being drawn by its mapper
  };

  ///@{
  /**
   * Set/Get what a prop does to the light, one of Role. Any vtkProp can be tagged: actors,
   * assemblies (as a whole), LOD actors, volumes. The role is stored under ROLE() in the prop's
   * property keys; its other keys stay, also those that it shares with other props. A change is
   * seen in the next frame. Any other role, or a null prop, is an error and changes nothing.
   *
   * MEDIUM needs a vtkGodRaysMediumModel, whose Data numbers hold for all volumes of the role, and a
   * vtkVolume itself, not an assembly of them; grids that are no images are resampled. With other models
   * it is as AUTOMATIC. What cannot be such a medium is an error, and the scene is drawn without rays.
   * See Documentation/Pipeline.md.
   */
  static void SetRole(vtkProp* prop, int role);
  static int GetRole(vtkProp* prop);
  ///@}

  /**
   * The key under which a prop's role is stored; absent means AUTOMATIC.
   */
  static vtkInformationIntegerKey* ROLE();

  ///@{
  /**
   * Add or remove a light that shafts come from, any number, each with its own colour and
   * intensity. Positional lights are spheres of SourceRadius, directional ones suns of
   * SunAngularRadius. Camera lights and headlights count by their transformed position. A light
   * that is switched off, or has intensity 0, makes no shafts. The light need not be one of the
   * renderer's. Adding null, or a light twice, changes nothing. GetLight() is null for an index that
   * is out of range.
   */
  void AddLight(vtkLight* light);
  void RemoveLight(vtkLight* light);
  void RemoveAllLights();
  int GetNumberOfLights();
  vtkLight* GetLight(int index);
  ///@}

  /// Who says where a sun stands.
  enum SunPlacementType
  {
    SUN_BY_HAND = 0, ///< who adds lights, or calls PlaceSun()
    SUN_ONCE = 1,    ///< the first frame that has something to see
    SUN_EVERY_VIEW =
      2, ///< as SUN_ONCE, and again in still frames in which its place has become poor
    SUN_IF_NO_LIGHT = 3 ///< as SUN_EVERY_VIEW, from the first frame that no light reaches
  };

  ///@{
  /**
   * Put a sun behind the scene: where it makes the most shafts, see vtkGodRaysSunPlacer, or at a place of
   * the picture, from (0, 0) at the lower left to (1, 1). The former is found in the next frame, by what
   * that covers of the picture; until then the sun stands at (0.35, 0.75). The sun is a directional
   * vtkLight; in a parallel projection, which sees no sun but straight ahead, a lamp closely behind the
   * scene. It is one, too, where a place is found in the air of a vtkGodRaysHomogeneousModel, in which a
   * lamp's shafts spread and a sun's do not; its intensity is 24 there, as it lights less of the air. The
   * light's diffuse colour is warm, (1, 0.85, 0.62), before a blue background that is not dark a cool (0.81,
   * 0.91, 1), in a medium a pale (1, 0.905, 0.76); a colour that is set by hand stays. It is this pass's
   * alone: the renderer keeps the lights by which it shades the scene. It stays where it is in the world
   * while the camera moves; a further call moves it. Returns the light; null, after an error, without a
   * renderer.
   */
  vtkLight* PlaceSun(vtkRenderer* renderer);
  vtkLight* PlaceSun(vtkRenderer* renderer, double x, double y);
  ///@}

  /**
   * Find anew in the next frame how large the scene is. The density of air of no known unit, where it ends,
   * and the power and radius of lamps that nobody set follow from the bounds of the visible props. They are
   * found once and held while one of the props is visible of which they were found: nothing that flies by
   * changes the light of a film, and new data in place of all former ones have their own. GetPlan() tells
   * both sizes where they differ.
   */
  void ResetSceneSize();

  /// Events of the pass.
  enum Events
  {
    /// A frame moved the sun, the vtkLight that the call data point to; lights may be changed.
    SunPlacedEvent = vtkCommand::UserEvent + 1
  };

  ///@{
  /**
   * Set/Get who places a sun, one of SunPlacementType. Default is SUN_BY_HAND. With SUN_EVERY_VIEW, the sun
   * stays while its score is 0.8 of the best one or more in the new view, and while the camera is dragged.
   */
  vtkSetClampMacro(SunPlacement, int, SUN_BY_HAND, SUN_IF_NO_LIGHT);
  vtkGetMacro(SunPlacement, int);
  ///@}

  /**
   * Returns the object that finds the place of the sun, with its settings and its last result.
   */
  vtkGodRaysSunPlacer* GetSunPlacer();

  ///@{
  /**
   * Set/Get what is summed. Null restores the default, a vtkGodRaysRadialModel.
   */
  void SetModel(vtkGodRaysModel* model);
  vtkGodRaysModel* GetModel();
  ///@}

  ///@{
  /**
   * Set/Get how the sum is evaluated. Null restores the default, that of the model: a
   * vtkGodRaysEpipolarIntegrator, or, of a medium, a vtkGodRaysShadowMapIntegrator.
   */
  void SetIntegrator(vtkGodRaysIntegrator* integrator);
  vtkGodRaysIntegrator* GetIntegrator();
  ///@}

  ///@{
  /**
   * Set/Get what joins a scene whose parts are on several processes; null, the default, if it is on
   * one. Stages that only the joined picture needs are left out where there is none.
   */
  void SetCompositor(vtkGodRaysCompositor* compositor);
  vtkGodRaysCompositor* GetCompositor();
  ///@}

  /**
   * Take a look or a medium by name, one of vtkGodRaysPresets: the model's parameters are set, or, if the
   * name belongs to another class of models, a new model of that class takes its place. Returns false, with
   * an error that lists the names, for any other name, and changes nothing.
   */
  bool ApplyPreset(const char* name);

  ///@{
  /**
   * Set/Get the factor on all rays [no unit]. 0 draws the scene straight through.
   * Valid range: [0, 1e4]. Useful range: [0, 4]. Default is 1.
   */
  void SetIntensity(double intensity);
  vtkGetMacro(Intensity, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the strength of the rays is chosen by the picture, before Intensity, so that shafts are
   * seen and data stay readable. The rays are up to four times as strong as their parameters say: until
   * their mean is 0.08, or their 99th percentile 1.2; in a medium 0.18 and 1.5 [linear light, 1 is white].
   * Over data, each pixel has at most 0.1 of them; and on average, data that are lit, and, where most are,
   * all, change by at most 9 in CIE 1976 L*a*b* and keep 90 % of their chroma, to which a look adds 10 % at
   * most or, where data are nearly grey, 2. What a medium takes of the data's light on average is made up
   * for, up to twofold. While the user drags the camera, the strength changes gradually. Published sums of
   * shown values are as published. Off, Intensity and the model's parameters are the strength, and a medium
   * dims data by all that it takes. Default is on.
   */
  vtkSetMacro(AutomaticExposure, bool);
  vtkGetMacro(AutomaticExposure, bool);
  vtkBooleanMacro(AutomaticExposure, bool);
  ///@}

  ///@{
  /**
   * The factor on all rays in the last frame, that of AutomaticExposure times Intensity, and the further ones
   * on rays over data that are lit, and over dark ones; the factor on data behind a medium, which has at most
   * what the medium takes of them [no unit].
   */
  double GetExposure();
  double GetDataExposure();
  double GetDarkDataExposure();
  double GetDataGain();
  ///@}

  ///@{
  /**
   * Set/Get whether sums of scene and rays stay below white, where rays would else be clipped, channel by
   * channel, and change their hue. The sum is exact up to half of the room that the scene leaves. Pictures
   * of floating-point colours, SCREEN, and published sums of shown values do without. Default is on.
   */
  vtkSetMacro(HighlightShoulder, bool);
  vtkGetMacro(HighlightShoulder, bool);
  vtkBooleanMacro(HighlightShoulder, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether shadows darken a light background, to a cool grey, sRGB's (178, 189, 208) of white: from
   * a lightness of 60 on, all of it from 80 on [CIE 1976 L*, white is 100]. From 75 to 90 on, rays
   * themselves fade, over data, too, so that these keep their colours. Off, rays are hardly seen there.
   * Published sums of shown values do without. Default is on.
   */
  vtkSetMacro(DarkenLightBackground, bool);
  vtkGetMacro(DarkenLightBackground, bool);
  vtkBooleanMacro(DarkenLightBackground, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether rays, and a medium before them, change nothing of the data's colours but their
   * lightness, and that by at most MostDataLightness: for figures whose colours stand for numbers. Data are
   * the pixels in which something is drawn. Published sums of shown values do without. Default is off.
   */
  vtkSetMacro(DataFirst, bool);
  vtkGetMacro(DataFirst, bool);
  vtkBooleanMacro(DataFirst, bool);
  ///@}

  ///@{
  /**
   * Set/Get by how much rays change the lightness of data at most with DataFirst [CIE 1976 L*, white is
   * 100]. Valid range: [0, 100]. Default is 10.
   */
  void SetMostDataLightness(double lightness);
  vtkGetMacro(MostDataLightness, double);
  ///@}

  ///@{
  /**
   * Set/Get whether the first light of the rays also lights the data: two lights are added to the renderer,
   * a rim light that grazes the data from the sun's side of the picture, and a soft key light from there.
   * Where a prop is coloured by data or by a texture, there is only a weak rim light, which changes these
   * colours by less than 4 in CIE 1976 L*a*b* on average. The renderer's other lights are left alone, and
   * Detach() takes both off again. Default is off.
   */
  vtkSetMacro(LightData, bool);
  vtkGetMacro(LightData, bool);
  vtkBooleanMacro(LightData, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether lights that stand in the scene, those of the rays, too, cast shadows on surfaces: at
   * most eight, the strongest ones. Headlights cast none. Lights of the rays that the renderer lacks are
   * added to it, with an intensity of at most 0.6, until Detach(). What blocks the light of rays casts a
   * shadow, but for points and lines; whatever VTK shades by its lights receives it. Intensity 0 leaves
   * shadows without rays. Default is off.
   */
  vtkSetMacro(SurfaceShadows, bool);
  vtkGetMacro(SurfaceShadows, bool);
  vtkBooleanMacro(SurfaceShadows, bool);
  ///@}

  ///@{
  /**
   * Set/Get whether shadows on surfaces are as soft as the size of the light makes them, SunAngularRadius or
   * SourceRadius, where that is more than a pixel. Default is on.
   */
  vtkSetMacro(SoftShadows, bool);
  vtkGetMacro(SoftShadows, bool);
  vtkBooleanMacro(SoftShadows, bool);
  ///@}

  ///@{
  /**
   * Set/Get how much of a light shadows take at most from surfaces that are coloured by data [fraction], so
   * that colours can be compared with a colour bar. Valid range: [0, 1]. Default is 0.5.
   */
  void SetMostDataShadow(double part);
  vtkGetMacro(MostDataShadow, double);
  ///@}

  ///@{
  /**
   * Set/Get the error that the rays may have, root mean square over the picture, as a fraction of
   * the brightest possible result [no unit], in a medium of 10 times its mean if that is less; the
   * integrator chooses its work by it. Of a look the exact result is its converged sum, of a medium single
   * scattering, see vtkGodRaysShadowMapIntegrator. Half of it holds where a picture is drawn in tiles, so
   * that edges do not show. Valid range: [1e-6, 0.1]. Default is 1/255, a level of an 8-bit picture.
   */
  void SetErrorTolerance(double tolerance);
  vtkGetMacro(ErrorTolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get the error that the rays may have while the user drags the camera, if it is more than
   * ErrorTolerance [no unit]. That is so while the window's desired update rate is 1 frame a second
   * or more, as interactors set it. A still picture does not depend on it. Valid range: [1e-6, 0.1].
   * Default is 0.01.
   */
  void SetInteractiveErrorTolerance(double tolerance);
  vtkGetMacro(InteractiveErrorTolerance, double);
  ///@}

  ///@{
  /**
   * Set/Get whether props without a role block light. Default is on.
   */
  vtkSetMacro(UntaggedPropsOcclude, bool);
  vtkGetMacro(UntaggedPropsOcclude, bool);
  vtkBooleanMacro(UntaggedPropsOcclude, bool);
  ///@}

  ///@{
  /**
   * Set/Get the radius of a positional light's sphere [world units]. 0 takes one fiftieth of the
   * diagonal of the visible props' bounds. Valid range: [0, 1e30]. Default is 0.
   */
  void SetSourceRadius(double radius);
  vtkGetMacro(SourceRadius, double);
  ///@}

  ///@{
  /**
   * Set/Get the sun whose AngularRadius directional lights have [degrees], in [0.01, 90], default 0.2678. To
   * have its light, too, AddLight() one that its UpdateLight() was given. Null makes a new one, the default.
   */
  void SetSun(vtkGodRaysSun* sun);
  vtkGodRaysSun* GetSun();
  void SetSunAngularRadius(double degrees);
  double GetSunAngularRadius();
  ///@}

  ///@{
  /**
   * Set/Get the radiance of the open background about a light, as a fraction of the light's own
   * [no unit]. The open background is where no prop is drawn; its glow makes shafts also while the
   * light itself is hidden or outside the picture. 0 switches it off. Valid range: [0, 1].
   * Default is 1.
   */
  void SetBackgroundGlow(double glow);
  vtkGetMacro(BackgroundGlow, double);
  ///@}

  ///@{
  /**
   * Set/Get the angle about the light over which the glow is full, and the further angle over
   * which it falls smoothly to 0 [degrees, seen from the eye]. In a parallel projection, which
   * has no angles about a positional light, the picture's height counts as 30 degrees.
   * Valid range: [0, 180] each. Defaults are 0.75 and 3.6.
   */
  void SetBackgroundGlowRadius(double degrees);
  vtkGetMacro(BackgroundGlowRadius, double);
  void SetBackgroundGlowFalloff(double degrees);
  vtkGetMacro(BackgroundGlowFalloff, double);
  ///@}

  ///@{
  /**
   * Set/Get how far the occlusion layer reaches beyond each edge of the picture, as a fraction of
   * the picture's width and height [no unit], so that lights and occluders just outside act as
   * they should. Above 0 the occluders are rendered a second time. Where a window is drawn in n by n
   * tiles, as by vtkWindowToImageFilter with a scale of n, it is n - 1 at least, as far as textures can
   * be large enough: a tile is a picture of its own, and rays come from what is on the others. Valid
   * range: [0, 1]. Default is 0.
   */
  void SetLayerMargin(double margin);
  vtkGetMacro(LayerMargin, double);
  ///@}

  /// How rays join the picture.
  enum BlendMode
  {
    MODEL_BLEND = 0, ///< ADD but for some published sums
    ADD = 1,         ///< scene + rays
    SCREEN = 2       ///< scene + rays - min(scene * rays, 1)
  };

  ///@{
  /**
   * Set/Get how rays join the picture, one of BlendMode. Default is MODEL_BLEND.
   */
  void SetBlend(int mode);
  vtkGetMacro(Blend, int);
  ///@}

  /// How the scene's colours stand for light.
  enum DisplayTransferType
  {
    AUTOMATIC_TRANSFER = 0, ///< POWER_TRANSFER within a vtkToneMappingPass, else SRGB_TRANSFER
    SRGB_TRANSFER = 1,      ///< by sRGB's transfer, as a monitor shows them
    POWER_TRANSFER = 2 ///< by a power of 2.2, which VTK's tone mapping and PBR shaders take for it
  };

  ///@{
  /**
   * Set/Get how the colours of the scene and of lights stand for light, one of DisplayTransferType. Light
   * is added between decoding and encoding by it; a tone mapping that comes later must decode as was
   * encoded. A vtkToneMappingPass is known by itself if it is the renderer's pass, and this one its
   * delegate, or the delegate of other passes of images between. Published sums of shown values do not
   * depend on it. Default is AUTOMATIC_TRANSFER.
   */
  void SetDisplayTransfer(int transfer);
  vtkGetMacro(DisplayTransfer, int);
  ///@}

  /// What the picture shows.
  enum OutputMode
  {
    COMPOSITE = 0, ///< the scene with rays
    OCCLUSION = 1, ///< the occlusion layers of all lights, added
    SCATTERING = 2 ///< the rays alone
  };

  ///@{
  /**
   * Set/Get what the picture shows, one of OutputMode. Default is COMPOSITE.
   */
  void SetOutput(int output);
  vtkGetMacro(Output, int);
  ///@}

  /// Storage of the layers and the sum.
  enum PrecisionMode
  {
    HALF = 0,  ///< 16-bit floats: values to 65504, relative error 5e-4
    SINGLE = 1 ///< 32-bit floats
  };

  ///@{
  /**
   * Set/Get how the layers and the sum are stored, one of PrecisionMode. Default is HALF.
   */
  void SetPrecision(int precision);
  vtkGetMacro(Precision, int);
  ///@}

  ///@{
  /**
   * Attach: put this pass among those of a renderer and keep how the renderer draws. Passes that work on a
   * finished picture and leave no depth (vtkSSAAPass, vtkOpenGLFXAAPass, vtkGaussianBlurPass,
   * vtkDepthOfFieldPass, vtkToneMappingPass and other vtkImageProcessingPasses) get this pass for their
   * delegate. Any other pass that the renderer has, such as vtkSSAOPass, vtkEDLShading or a vtkCameraPass
   * with shadow maps, becomes the delegate of this one; without one the renderer's own steps draw the
   * scene, with its depth peeling, SSAO, FXAA, shadows and hidden-line removal.
   * From then on, the rays stay: when somebody sets another pass on the renderer, or none, this one is put
   * among the passes again as the renderer starts to render, until Detach(). The renderer keeps this pass
   * alive. One that the renderer's passes have for a delegate already stays where it is.
   * Detach: release everything on the graphics card and restore the renderer's former pass; a
   * renderer that got this pass by SetPass() has none then. For any other renderer nothing happens.
   * Attaching to another renderer detaches from the one before. A null renderer is an error.
   * Find: the first, outermost vtkGodRaysPass among a renderer's passes, null if there is none.
   */
  void Attach(vtkRenderer* renderer);
  void Detach(vtkRenderer* renderer);
  static vtkGodRaysPass* Find(vtkRenderer* renderer);
  ///@}

  ///@{
  /**
   * Copy a layer of the last frame drawn: 32-bit float RGB, linear light (display-referred for
   * published sums of shown colours), one value a pixel of the viewport (the occlusion layer:
   * of the viewport and its margin), origin at the lower left. With several lights the occlusion
   * layers are added, for which the window is rendered once more unless Output is OCCLUSION. The
   * scattering is before Intensity.
   * Returns false, and empties the image, when the last frame had no rays, when what it left is gone with its
   * integrator, model or graphics resources, or when it is asked for the layers of several lights while the
   * window renders.
   */
  bool GetOcclusionImage(vtkImageData* image);
  bool GetScatteringImage(vtkImageData* image);
  ///@}

  ///@{
  /**
   * Fill an image with what the medium of the last frame is in numbers: 32-bit floats, one value a pixel of
   * the viewport, origin at the lower left. They are computed when they are asked for, in double precision,
   * from the depth that is read back.
   *
   * | array                 | unit               | what                                                          |
   * |-----------------------|--------------------|---------------------------------------------------------------|
   * | Radiance              | sr-1, or W m-2 sr-1 | scattered towards the eye, three components; the scalars      |
   * | Transmittance         | 1                  | of the way to the visible surface, or to the end of the medium |
   * | OpticalDepth          | 1                  | alike, three components                                       |
   * | Depth                 | scene unit         | view depth of the visible surface; infinite for the background |
   * | Distance_m            | m                  | from the eye to it                                            |
   * | Contrast              | 1                  | what is left of that of the surface with the horizon, in green |
   * | MeteorologicalRange_m | m                  | at which 2 % of a contrast are left, in the mean of the way   |
   *
   * Radiance is before Intensity and exposure, divided by the irradiance of a light of colour and intensity
   * 1; times irradiance, for red, green and blue [W m^-2], if that is given. Valid range: [0, 1e30]. The
   * units are under vtkDataArray::UNITS_LABEL(). The field data have <array>_Error, a bound of the error or,
   * of Radiance, ErrorTolerance, or what was measured of it if the integrator has VerifyPixels; its
   * UNITS_LABEL says of what it is a part. A WorldUnitInMeters of 0 counts as 1.
   *
   * With volumes tagged MEDIUM the field data have DataExtinction_per_m_Error [m^-1], too: how far extinction
   * is from that of their grids at the centres of at most 20 000 cells, root mean square, and
   * DataExtinction_per_m_MaxError, the largest difference there; both of the volume that is worst, and 0
   * for images of points, which are taken as they are.
   *
   * Returns false, and empties the image, when the model is no medium, and in the cases of
   * GetScatteringImage(). An irradiance out of its range is an error.
   */
  bool GetMediumImage(vtkImageData* image);
  bool GetMediumImage(vtkImageData* image, const double irradiance[3]) VTK_SIZEHINT(irradiance, 3);
  ///@}

  /**
   * What the last frame needed, as text: one line each for the scene, the lights, the occlusion
   * layer, the model and integrator, and the blend; what was skipped, and why.
   */
  std::string GetPlan() const;

  /**
   * What in the last still frame is probably not meant, with its number and a remedy, a line each; empty if
   * there is nothing: a medium that hides the scene, with an optical depth across it above 5, or hardly
   * shows, with one below 0.01; no light that reaches the picture, and why; parameters that scatter nothing;
   * rays that change nothing that can be seen. The plan has it, too. Each kind is also a warning, once; an
   * Intensity of 0 is none.
   */
  std::string GetAdvice() const;

  /**
   * How often the last frame rendered the scene's geometry: 1 when the scene's own depth gave the
   * occluders, 2 when tagged occluders were rendered into the layer.
   */
  vtkGetMacro(NumberOfGeometryPasses, int);

  ///@{
  /**
   * Set/Get whether the stages are timed. Default is off.
   */
  vtkSetMacro(MeasureTimes, bool);
  vtkGetMacro(MeasureTimes, bool);
  vtkBooleanMacro(MeasureTimes, bool);
  ///@}

  /**
   * The time that the last frame spent in the scene, the occlusion layers, the scattering and the
   * blend [seconds on the graphics card]; waits for them to finish. All 0 unless MeasureTimes was
   * on and the driver has timer queries.
   */
  void GetStageTimes(double seconds[4]);

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  vtkMTimeType GetMTime() override;

protected:
  vtkGodRaysPass();
  ~vtkGodRaysPass() override;

private:
  vtkGodRaysPass(const vtkGodRaysPass&) = delete;
  void operator=(const vtkGodRaysPass&) = delete;

  // Render(), step by step. Reasons and plans are for GetPlan().
  const char* FindReasonForNothing(const vtkRenderState* s, vtkOpenGLRenderWindow* window);
  const char* FindReasonForNoRays(const vtkRenderState* s);
  std::string FindFault(vtkRenderer* renderer, const vtkGodRaysView& view, const int size[2],
    std::vector<vtkGodRaysLight>& lights);
  void FindLights(
    vtkRenderer* renderer, const vtkGodRaysView& view, std::vector<vtkGodRaysLight>& lights);
  void RenderScene(const vtkRenderState* s);
  bool DrawShadows(const vtkRenderState* s);
  void TakeWindow(vtkOpenGLRenderWindow* window);
  bool RenderRays(
    const vtkRenderState* s, const vtkGodRaysView& view, std::vector<vtkGodRaysLight>& lights);
  bool LookAtPicture(
    const vtkRenderState* s, const vtkGodRaysView& view, std::vector<vtkGodRaysLight>& lights);
  bool FindOccluders(const vtkRenderState* s, const vtkGodRaysView& view,
    const vtkGodRaysFramebuffer& bound, const int viewport[4]);
  bool DrawLights(const vtkRenderState* s, const vtkGodRaysView& view,
    const std::vector<vtkGodRaysLight>& lights);
  unsigned int GetLayerFormat() const;
  double FindMargin(vtkOpenGLRenderWindow* window, const int size[2]) const;
  bool DimsScene() const;
  bool MetersPicture() const;
  bool DrawOutput(
    const vtkRenderState* s, const vtkGodRaysFramebuffer& bound, const int viewport[4]);
  void ShowNoLight(const vtkRenderState* s, vtkOpenGLState* state);
  void Advise(const std::string& concern);
  void AdviseOnLights();
  void FindConcerns();
  void DescribeStages(bool screen);
  std::string DescribeErrors() const;
  bool IsSunMissing() const;
  bool MovesSun() const;
  void LightTheData(vtkRenderer* renderer);
  bool SeesNewPicture(vtkRenderer* renderer);
  void MoveSun(vtkRenderer* renderer, bool isBlue);
  vtkLight* PlaceSunOrLamp(vtkRenderer* renderer, double x, double y, bool isInAir);
  void Complain(const std::string& complaint);

  struct Internals;
  std::unique_ptr<Internals> Internal;

  double Intensity = 1.0;
  bool AutomaticExposure = true;
  bool HighlightShoulder = true;
  bool DarkenLightBackground = true;
  bool DataFirst = false;
  bool LightData = false;
  bool SurfaceShadows = false;
  bool SoftShadows = true;
  double MostDataShadow = 0.5;
  double MostDataLightness = 10.0;
  int SunPlacement = SUN_BY_HAND;
  double ErrorTolerance = 1.0 / 255.0;
  double InteractiveErrorTolerance = 0.01;
  bool UntaggedPropsOcclude = true;
  double SourceRadius = 0.0;
  double BackgroundGlow = 1.0;
  double BackgroundGlowRadius = 0.75;
  double BackgroundGlowFalloff = 3.6;
  double LayerMargin = 0.0;
  int Blend = MODEL_BLEND;
  int DisplayTransfer = AUTOMATIC_TRANSFER;
  int Output = COMPOSITE;
  int Precision = HALF;
  int NumberOfGeometryPasses = 0;
  bool MeasureTimes = false;
};

#endif
