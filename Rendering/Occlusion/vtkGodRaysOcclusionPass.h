// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysOcclusionPass
 * @brief   the first stage: for each light a layer of its emitter, less the occluders
 *
 * When every prop blocks light, the scene's own depth holds its occluders and no geometry is
 * rendered again. Otherwise, or with a margin about the picture, the props that block are rendered
 * into a depth of their own, each in its ordinary way, so that no shader is rebuilt. Translucent
 * props and volumes that block are rendered once more, into an opacity by which the light is
 * dimmed; they dim whatever is behind or, for a light at a finite distance, before them.
 * Props tagged LIGHT are rendered in their own colours, as lit as in the scene; volumes and
 * translucent ones as they show before black.
 *
 * With a vtkGodRaysCompositor, a scene on several processes is joined layer by layer: the least
 * depth of the occluders, the product of what translucent props and volumes let through, and the
 * nearest of the emitters. Translucent parts of emitters are added, whatever their order.
 *
 * @sa vtkGodRaysPass
 */

#ifndef vtkGodRaysOcclusionPass_h
#define vtkGodRaysOcclusionPass_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkGodRaysTransfer.h"        // For vtkGodRaysTransfer
#include "vtkOpenGLRenderPass.h"

#include <cstddef> // For std::size_t
#include <memory>  // For std::unique_ptr
#include <string>  // For std::string
#include <vector>  // For std::vector

class vtkGodRaysCompositor;
class vtkGodRaysTarget;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkTextureObject;
struct vtkGodRaysLight;
struct vtkGodRaysView;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysOcclusionPass : public vtkOpenGLRenderPass
{
public:
  static vtkGodRaysOcclusionPass* New();
  vtkTypeMacro(vtkGodRaysOcclusionPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What a frame is made of.
  struct Request
  {
    vtkOpenGLRenderWindow* Window = nullptr;
    vtkRenderer* Renderer = nullptr;
    const vtkGodRaysView* View = nullptr;
    vtkTextureObject* SceneDepth = nullptr; ///< of the viewport
    unsigned int DepthFormat = 0;           ///< its internal format
    bool Multisampled = false;    ///< whether it is of a sample, not the centre, of each pixel
    unsigned int ColorFormat = 0; ///< internal format of the layer
    /// Internal format of the layer of a light of one colour, which is one value a pixel, without
    /// the colour; 0 if it shall be as any other.
    unsigned int OneColorFormat = 0;
    double Margin = 0.0; ///< fraction of the picture on each side
    bool IsTile = false; ///< of a large picture; beyond that the layer is black
    int Beyond[4] = {};  ///< how much of it is left of, right of, below and above the tile [pixels]
    bool UntaggedPropsOcclude = true;
    bool LampsOcclude = true; ///< whether props tagged LIGHT block the light of others
    bool Dims = true;         ///< whether translucent props and volumes dim light
    vtkGodRaysTransfer Transfer = vtkGodRaysTransfer::SRGB;
    double Glow = 0.0;
    vtkGodRaysCompositor* Compositor = nullptr; ///< of a scene on several processes
  };

  /**
   * Whether the scene's own depth holds just the props that block light.
   */
  VTK_WRAPEXCLUDE bool SceneDepthServes(const Request& request);

  /**
   * Find and, where need be, render the occluders. Returns false if the driver refuses.
   */
  VTK_WRAPEXCLUDE bool Begin(const Request& request);

  /**
   * Forget the props of the frame.
   */
  void End();

  /**
   * Draw the layer of one light. Returns false, after an error, if that failed.
   */
  VTK_WRAPEXCLUDE bool Compose(const vtkGodRaysLight& light);

  /**
   * How much of what is behind them translucent props and volumes hide, in alpha, whatever their part in the
   * rays: where the background has alpha as well, the scene's does not say it. The texture is that of their
   * opacity for light, of the layer's size, where all of them block light; else they are rendered once more,
   * and it is of the viewport's size. Null if there are none, or the driver refuses. Call it after Begin() in
   * each frame that needs it.
   */
  VTK_WRAPEXCLUDE vtkTextureObject* FindOpacity();

  /**
   * How much of the light translucent props and volumes that block it take, in alpha, of the layer's size;
   * null if there are none. It is there from Begin() on.
   */
  VTK_WRAPEXCLUDE vtkTextureObject* GetDimming();

  /**
   * The layer last composed; null if there is none.
   */
  VTK_WRAPEXCLUDE vtkGodRaysTarget* GetLayer();

  /**
   * Window depth of the occluders, of the layer's size.
   */
  VTK_WRAPEXCLUDE vtkTextureObject* GetDepth();

  /**
   * The props whose opaque parts block light in this frame, in or out of the picture.
   */
  VTK_WRAPEXCLUDE const std::vector<vtkProp*>& GetOccludingProps() const;

  /**
   * Whether Begin() rendered the props that block light a second time.
   */
  bool GetRenderedOccluders() const { return this->RenderedOccluders; }

  /**
   * What Begin() and FindOpacity() did, in one line.
   */
  std::string Describe() const;

  /**
   * Render the props of a state as volumes, with this pass attached to them, which keeps the
   * volume mapper from choosing a viewport of its own. With an ImageSampleDistance other than 1 it
   * chooses one all the same, so that such a volume dims at the right place only without a margin
   * and in a viewport that starts at the window's lower left corner.
   */
  void Render(const vtkRenderState* s) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGodRaysOcclusionPass();
  ~vtkGodRaysOcclusionPass() override;

private:
  vtkGodRaysOcclusionPass(const vtkGodRaysOcclusionPass&) = delete;
  void operator=(const vtkGodRaysOcclusionPass&) = delete;

  void JoinEmitter();
  void RenderTranslucent(vtkProp* const* props, std::size_t count);
  enum Part
  {
    GLOW,
    DISC,
    PROP
  };
  bool Draw(const vtkGodRaysLight& light, Part part, bool hazy);

  struct Internals;
  std::unique_ptr<Internals> Internal;
  bool RenderedOccluders = false;
  bool RenderedOpacity = false;
  int NumberOfTranslucentProps = 0;
};

#endif
