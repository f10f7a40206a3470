// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysScene.h
 * @brief   how the scene itself is drawn; private to this module
 */

#ifndef vtkGodRaysScene_h
#define vtkGodRaysScene_h

#include "vtkNew.h"
#include "vtkProp.h" // For vtkSmartPointer
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

class vtkCameraPass;
class vtkInformation;

/// The renderer's own steps, as it takes them when it has no pass: with its depth peeling, SSAO,
/// FXAA, shadows and hidden-line removal.
class vtkGodRaysScene : public vtkRenderPass
{
public:
  static vtkGodRaysScene* New();
  vtkTypeMacro(vtkGodRaysScene, vtkRenderPass);

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Call a function, in each frame, when the background is there and nothing else: it draws what is behind
   * the scene.
   */
  void SetBackdrop(std::function<void()> draw);

  /**
   * Origin and size of the part of the bound framebuffer that a state is for [pixels].
   */
  static void GetViewport(const vtkRenderState* s, int viewport[4]);

  /**
   * Give the renderer's camera the window's stereo. A camera learns of it from its own Render(),
   * but the first frame after a change needs its matrices before that.
   */
  static void UpdateStereo(vtkRenderer* renderer);

protected:
  vtkGodRaysScene();
  ~vtkGodRaysScene() override;

private:
  vtkGodRaysScene(const vtkGodRaysScene&) = delete;
  void operator=(const vtkGodRaysScene&) = delete;

  vtkNew<vtkCameraPass> InFramebuffer;
};

/// While it lives, some props are taken out of a state's props: others draw them. Each has a stand-in of its
/// own: vtkOpenGLRenderPass keeps a reference to itself for each prop that a state has more than once.
class vtkGodRaysHiddenProps
{
public:
  vtkGodRaysHiddenProps(const vtkRenderState* s, const std::vector<vtkProp*>& props);
  ~vtkGodRaysHiddenProps();
  vtkGodRaysHiddenProps(const vtkGodRaysHiddenProps&) = delete;
  void operator=(const vtkGodRaysHiddenProps&) = delete;

  /// Whether a prop is hidden in any state, as by a pass around this one.
  static bool IsHidden(vtkProp* prop);

private:
  const vtkRenderState* State;
  std::vector<std::pair<int, vtkProp*>> Hidden;
  std::size_t Former; // how many are hidden by others
  std::vector<vtkSmartPointer<vtkProp>> StandIns;
};

/// While it lives, passes around this one, such as vtkSSAOPass, add nothing to shaders of a state's props;
/// those of this module do.
class vtkGodRaysOwnShaders
{
public:
  explicit vtkGodRaysOwnShaders(const vtkRenderState* s);
  ~vtkGodRaysOwnShaders();
  vtkGodRaysOwnShaders(const vtkGodRaysOwnShaders&) = delete;
  void operator=(const vtkGodRaysOwnShaders&) = delete;

private:
  std::vector<std::pair<vtkSmartPointer<vtkProp>, vtkSmartPointer<vtkInformation>>>
    Passes; ///< by prop
};

/// While it lives, 2-D props are taken out of a state's props; then they can be drawn.
class vtkGodRaysOverlays
{
public:
  explicit vtkGodRaysOverlays(const vtkRenderState* s);
  ~vtkGodRaysOverlays();
  vtkGodRaysOverlays(const vtkGodRaysOverlays&) = delete;
  void operator=(const vtkGodRaysOverlays&) = delete;

  void Draw();

private:
  const vtkRenderState* State;
  std::vector<std::pair<int, vtkProp*>> Overlays;
  std::vector<vtkSmartPointer<vtkProp>> StandIns;
};

#endif
