// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysAttachment
 * @brief   a pass on a renderer, and what both had before; private to this module
 *
 * The pass that the renderer has becomes the delegate of the one that is attached, until that is taken off
 * again.
 */

#ifndef vtkGodRaysAttachment_h
#define vtkGodRaysAttachment_h

#include "vtkRenderPass.h"   // For vtkSmartPointer
#include "vtkRenderer.h"     // For vtkWeakPointer
#include "vtkSmartPointer.h" // For vtkSmartPointer
#include "vtkWeakPointer.h"  // For vtkWeakPointer

class vtkImageProcessingPass;

class vtkGodRaysAttachment
{
public:
  /**
   * Put the pass on a renderer. It must not be on another one.
   */
  void Attach(vtkImageProcessingPass* pass, vtkRenderer* renderer);

  /**
   * Take the pass off a renderer that has it, and give both what they had before. A renderer that got it by
   * SetPass() has none then.
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

private:
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderPass> FormerPass;
  vtkSmartPointer<vtkRenderPass> FormerDelegate;
};

#endif
