// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysBlendPass
 * @brief   the third stage: join the rays and the picture
 *
 * Writes the sum over the colour of the framebuffer that the scene was drawn into, at the
 * viewport's place in it: the only stage that knows the viewport's origin. Depth and alpha are not
 * written, nor is any pixel that no ray reaches, so anti-aliased samples stay as they are there.
 * Rays are added in linear light: the picture's colours are decoded from and encoded to the sRGB
 * display transfer (IEC 61966-2-1), and dimmed by a medium that they are seen through.
 *
 * @sa vtkGodRaysPass
 */

#ifndef vtkGodRaysBlendPass_h
#define vtkGodRaysBlendPass_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkGodRaysTransfer.h"        // For vtkGodRaysTransfer
#include "vtkObject.h"

#include <memory> // For std::unique_ptr

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;
struct vtkGodRaysMedium;
struct vtkGodRaysView;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysBlendPass : public vtkObject
{
public:
  static vtkGodRaysBlendPass* New();
  vtkTypeMacro(vtkGodRaysBlendPass, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How rays darken a light background, see BlendSurround() and RingLight() in the formulas. Lengths are
  /// heights of the whole picture.
  struct Surround
  {
    double Part = 0.0; ///< of the way to grey; 0: the background is not light
    double Rays = 1.0; ///< part of the rays that is added, too
    double Light[3] = { 0.0, 0.0,
      0.0 };                        ///< of RingLight(): luminance of rays that leave it as it is
    double Place[2] = { 0.0, 0.0 }; ///< about which the rings are
  };

  /// How the sum of one light of a look is shown, see RadialResponse() in the formulas. Lengths are as above.
  struct LightResponse
  {
    double Light[2] = { 0.5, 0.5 };   ///< its place in the picture of the sum, from 0 to 1
    double Heights[2] = { 1.0, 1.0 }; ///< width and height of that picture
    double Nearest = 0.0;             ///< distance from the light to the picture
    double Reach = 0.0;               ///< over which rays fade to 1/e; 0: they do not
    double Streaks = 0.0;             ///< amplitude

    bool IsLinear() const { return this->Reach <= 0.0 && this->Streaks <= 0.0; }
  };

  /// What to join, and how.
  struct Request
  {
    vtkOpenGLRenderWindow* Window = nullptr;
    int Viewport[4] = { 0, 0, 0, 0 }; ///< origin and size in the bound framebuffer [pixels]
    int Tile[2] = { 0, 0 }; ///< corner of the viewport in a picture of several tiles [pixels]
    vtkTextureObject* Scene = nullptr; ///< colours of the viewport; not read when ShowRays
    vtkTextureObject* Rays = nullptr;  ///< null for none, with a Medium only
    const double* Tint = nullptr;      ///< if the rays have one channel: their colour where it is 1
    const LightResponse* Response = nullptr; ///< of the rays; null for none
    double ViewScale = 1.0; ///< fraction of the rays' size that is shown; 1 unless ShowRays
    vtkTextureObject* Backdrop = nullptr; ///< background that is put under the result later
    double Intensity = 1.0;
    double SceneGain = 1.0;
    double LargestExposure = 1.0; ///< factor by which an automatic exposure may strengthen the rays
    bool SparesData = true;       ///< it weakens them over data alone, if data ask for it
    vtkGodRaysTransfer Transfer = vtkGodRaysTransfer::SRGB;
    bool Screen = false;
    bool Bytes = false;    ///< whether the scene's and the framebuffer's values are of 8 bits
    bool Shoulder = false; ///< keep sums below white, unless Screen
    const Surround* Around = nullptr; ///< null: rays darken no background
    double PictureHeight = 0.0;       ///< of the whole picture, if there are tiles [pixels]
    double DataExposure = 1.0;        ///< factor on rays over data that are seen
    double DarkExposure = 1.0;        ///< factor on rays over data that are dark
    bool CapsData = false;            ///< rays over data have a cap, see CapLight() in the formulas
    double DataGain = 1.0;       ///< on data, at most as much as the medium takes of their light
    double MostLightness = -1.0; ///< by which data change, in L*, if only that may; else below 0
    bool AlphaShowsData = false; ///< it is 0 where nothing is drawn
    double AlphaLayers = 1.0;    ///< n: an alpha a counts as data by 1 - (1 - a)^n
    /// Opacity of what leaves no depth, in alpha, where the scene's alpha does not say it; null for none. It
    /// may be larger than the scene, by as much on either side.
    vtkTextureObject* Opacity = nullptr;
    double OpacityLayers = 1.0; ///< n for it, and for Coverage
    /// Of a scene of several samples a pixel: how much of it has a depth, in red; null for one sample.
    vtkTextureObject* Coverage = nullptr;
    bool ShowRays = false;
    bool Accumulate = false; ///< add to what the framebuffer holds

    int Cells[2] = { 0, 0 }; ///< of a vtkGodRaysLightMeter's pictures, instead of the result

    ///@{
    /// A medium that dims the scene; null for none.
    const vtkGodRaysMedium* Medium = nullptr;
    const vtkGodRaysView* View = nullptr;
    double SkyLight[3] = {}; ///< the mean radiance of a sky, in linear light
    ///@}

    vtkTextureObject* Veil = nullptr;  ///< what else the scene is times, of its size; null for none
    vtkTextureObject* Depth = nullptr; ///< window depth of the scene, for all but the plain sum
  };

  /**
   * Write into the framebuffer that is bound. Returns false, after an error, if that failed.
   */
  VTK_WRAPEXCLUDE bool Draw(const Request& request);

  void ReleaseGraphicsResources(vtkWindow* window);

protected:
  vtkGodRaysBlendPass();
  ~vtkGodRaysBlendPass() override;

private:
  vtkGodRaysBlendPass(const vtkGodRaysBlendPass&) = delete;
  void operator=(const vtkGodRaysBlendPass&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
