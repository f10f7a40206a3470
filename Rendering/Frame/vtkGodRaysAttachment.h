// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysAttachment
 * @brief   a pass among those of a renderer, and what both had before; private to this module
 *
 * A renderer has one pass, which may have others for its delegates. Passes that work on a finished picture
 * (anti-aliasing, blur, depth of field, tone mapping) leave no depth behind: ours is put under them. It is
 * put over all others: what draws the scene, SSAO, shadows. God rays are over a sky.
 *
 * Whoever sets a pass on the renderer later, as PyVista and vedo do for every effect, does not know of
 * ours. So the renderer is watched: when it starts to render and its passes are without ours, ours is put
 * among them anew, until it is detached. If ours has another delegate than it was given here, somebody who
 * knows of it has put it where we do not look, and it is left there.
 */

#ifndef vtkGodRaysAttachment_h
#define vtkGodRaysAttachment_h

#include "vtkRenderPass.h"   // For vtkSmartPointer
#include "vtkRenderer.h"     // For vtkWeakPointer
#include "vtkSmartPointer.h" // For vtkSmartPointer
#include "vtkWeakPointer.h"  // For vtkWeakPointer

#include <functional> // For std::function
#include <vector>     // For std::vector

class vtkImageProcessingPass;
class vtkInformationObjectBaseKey;

class vtkGodRaysAttachment
{
public:
  /**
   * Put the pass on a renderer, if its passes are without it, and watch that it stays. It must not be on
   * another one. The renderer keeps the pass alive.
   */
  void Attach(vtkImageProcessingPass* pass, vtkRenderer* renderer);

  /**
   * Take the pass off a renderer that has it, and give both what they had before. A renderer that got it by
   * SetPass() has none then. A pass that was made the delegate of another by hand stays there.
   */
  void Detach(vtkImageProcessingPass* pass, vtkRenderer* renderer);

  /**
   * The renderer that the pass was attached to, null if there is none.
   */
  vtkRenderer* GetRenderer() const { return this->Renderer; }

  /**
   * Whether Detach() does anything for a renderer.
   */
  bool Has(vtkImageProcessingPass* pass, vtkRenderer* renderer) const;

  /**
   * The passes of a renderer from its own to the first, outermost one that is of some kind: each draws the
   * next. Empty if there is none. It is looked for in image passes, camera passes and sequences.
   */
  static std::vector<vtkRenderPass*> FindPath(
    vtkRenderer* renderer, const std::function<bool(vtkRenderPass*)>& is);

  /**
   * The last of FindPath(), the one that is of that kind; null if there is none.
   */
  static vtkRenderPass* FindFirst(
    vtkRenderer* renderer, const std::function<bool(vtkRenderPass*)>& is);

  /**
   * Of what a delegate draws, the pass that works on a finished picture and leaves no depth of the scene
   * behind, so that it belongs around rays and sky, not under them; null if there is none.
   */
  static vtkRenderPass* FindWithoutDepth(vtkRenderPass* delegate);

  /**
   * The outermost pass of a type, or one that is attached and will be put among the renderer's passes again.
   */
  template <typename Pass>
  static Pass* Find(vtkRenderer* renderer)
  {
    const auto is = [](vtkRenderPass* each) { return Pass::SafeDownCast(each) != nullptr; };
    return Pass::SafeDownCast(FindPass(renderer, is));
  }

private:
  class Passes;
  class Watch;

  static vtkRenderPass* FindPass(
    vtkRenderer* renderer, const std::function<bool(vtkRenderPass*)>& is);
  /// A renderer's collection of the passes that are attached to it.
  static vtkInformationObjectBaseKey* PASSES();
  static Passes* GetPasses(vtkRenderer* renderer);
  void ComeBack(vtkImageProcessingPass* pass, vtkRenderer* renderer);
  void Insert(vtkImageProcessingPass* pass, vtkRenderer* renderer);
  void Put(vtkRenderPass* pass, vtkRenderer* renderer);
  int CountReferences(vtkRenderPass* pass, vtkRenderPass* other) const;

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkRenderPass> Over;    // the pass that ours was put under, null: the renderer
  vtkSmartPointer<vtkRenderPass> Former; // what one or the other had
  vtkRenderPass* Delegate = nullptr;     // that ours was given here; only compared
  vtkSmartPointer<vtkRenderPass> FormerDelegate;
  unsigned long WatchTag = 0;
};

#endif
