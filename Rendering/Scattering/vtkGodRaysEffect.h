// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysEffect
 * @brief   what vtkGodRaysPass asks of an effect; private to this module
 *
 * A vtkGodRaysModel makes its effect: vtkGodRaysRadialEffect or vtkGodRaysMediumEffect. The pass knows no
 * other difference between models. In each frame it calls, in this order, the questions, SetUp(), Begin(),
 * DrawLight() for each light, Join(), and End().
 */

#ifndef vtkGodRaysEffect_h
#define vtkGodRaysEffect_h

#include "vtkGodRaysBlendPass.h"     // For Request
#include "vtkGodRaysOcclusionPass.h" // For Request

#include <string>
#include <vector>

class vtkGodRaysCompositor;
class vtkGodRaysIntegrator;
class vtkGodRaysLightFinder;
class vtkGodRaysSceneSize;
class vtkGodRaysSunPlacer;
class vtkGodRaysSum;
class vtkGodRaysTimers;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;
struct vtkGodRaysLight;
struct vtkGodRaysMedium;
struct vtkGodRaysView;

class vtkGodRaysEffect
{
public:
  /// What the pass has made ready.
  struct Frame
  {
    vtkOpenGLRenderWindow* Window = nullptr;
    vtkRenderer* Renderer = nullptr;
    const vtkGodRaysView* View = nullptr;
    const vtkGodRaysSceneSize* Scene = nullptr;
    vtkGodRaysIntegrator* Integrator = nullptr; ///< one that supports the model
    vtkGodRaysOcclusionPass* Occlusion = nullptr;
    vtkTextureObject* SceneDepth = nullptr;     ///< window depths of the picture
    vtkGodRaysCompositor* Compositor = nullptr; ///< of a scene on several processes
    vtkGodRaysTimers* Timers = nullptr;
    vtkGodRaysSum* Light = nullptr; ///< the light scattered by all lights: add to it
    unsigned int Format = 0;        ///< of layers: GL_RGBA16F or GL_RGBA32F
    int NumberOfLights = 0;
    double Picture[4] = { 0.0, 0.0, 1.0,
      1.0 }; ///< the whole picture, where this is a tile: corner and size
    const vtkGodRaysSunPlacer* Placer =
      nullptr;                  ///< with the coverage of this picture, if that is known
    bool InventsStreaks = true; ///< a look may have streaks that are not of the data
    double ErrorTolerance = 1.0 / 255.0;
    bool Interactive = false; ///< the user drags the camera, or the like
    bool KeepsLayers = false; ///< the occlusion layers of all lights are asked for
    bool Scatters = true;     ///< the scattered light is asked for
  };

  /// What is read back of a frame that has been drawn.
  struct Reading
  {
    std::vector<float> WindowDepths; ///< of the picture
    int Size[2] = { 0, 0 };          ///< of the picture [pixels]
    vtkImageData* Light = nullptr;   ///< what is scattered, of that size; null if there is no light
    const double* Irradiance =
      nullptr;               ///< of a light of 1, for each colour; null for relative radiance
    double LightError = 0.0; ///< of the scattered light [fraction of the brightest]
    bool LightErrorIsMeasured = false;
  };

  virtual ~vtkGodRaysEffect() = default;

  ///@{
  /**
   * Questions: why a view of this size [pixels], or its scene, cannot be evaluated, with the remedy, or none;
   * whether shown values are summed instead of light; whether the scene is dimmed where no light is
   * scattered; whether Begin() reads the scene's depth.
   */
  virtual std::string FindObstacle(vtkRenderer* renderer, vtkGodRaysCompositor* compositor,
    const vtkGodRaysSceneSize& scene, const vtkGodRaysView& view, const int size[2]) = 0;
  virtual bool SumsShownValues() const = 0;
  virtual bool DimsScene() const = 0;
  virtual bool ReadsSceneDepth() const = 0;
  ///@}

  /**
   * Returns true if the effect depends on the frame's Placer.
   */
  virtual bool UsesCoverage() const { return false; }

  ///@{
  /**
   * Props that the effect draws in place of their mappers: whether there are any, and those of the frame for
   * which FindObstacle() found none.
   */
  virtual bool HasOwnProps(vtkRenderer*) const { return false; }
  virtual const std::vector<vtkProp*>& GetOwnProps() const
  {
    static const std::vector<vtkProp*> none;
    return none;
  }
  ///@}

  ///@{
  /**
   * Say which lights and which occluders the effect needs.
   */
  virtual void SetUp(vtkGodRaysLightFinder& finder) const = 0;
  virtual void SetUp(
    vtkGodRaysOcclusionPass::Request& request, vtkGodRaysIntegrator* integrator) const = 0;
  ///@}

  /**
   * Find the medium that light comes through in a view. Returns false if there is none.
   */
  virtual bool FindMedium(
    vtkRenderer*, const vtkGodRaysSceneSize&, const vtkGodRaysView&, vtkGodRaysMedium&) const
  {
    return false;
  }

  /**
   * Start a frame, whose occluders are known.
   */
  virtual void Begin(const Frame& frame) = 0;

  /**
   * Add a light's rays to the sum. All processes of a compositor call it; only its root has a sum. Returns
   * false, after an error, if that failed.
   */
  virtual bool DrawLight(const Frame& frame, const vtkGodRaysLight& light) = 0;

  /**
   * Say how the sum and the picture are joined.
   */
  virtual void Join(vtkGodRaysBlendPass::Request& request) const = 0;

  /**
   * Forget what is of this frame alone.
   */
  virtual void End() = 0;

  ///@{
  /**
   * Whether the last frame had occlusion layers; those of all lights, added, or null if they were not
   * kept.
   */
  virtual bool HasLayers() const = 0;
  virtual vtkGodRaysSum* GetLayers() = 0;
  ///@}

  /**
   * Fill an image with the numbers of the last frame. False, and the image is left alone, if the effect has
   * none.
   */
  virtual bool FillNumbers(const Reading&, vtkImageData*) const { return false; }

  /**
   * What the plan adds to the model's description, or nothing.
   */
  virtual std::string Describe() const { return ""; }

  /**
   * What of the effect in this frame is probably not what was meant, and what to do about it, or nothing.
   */
  virtual std::string FindConcern() const { return ""; }

  /**
   * What measured errors leave out, or nothing.
   */
  virtual std::string DescribeErrors() const { return ""; }

  /**
   * Free what is on the graphics card.
   */
  virtual void Release(vtkWindow* window) = 0;
};

#endif
