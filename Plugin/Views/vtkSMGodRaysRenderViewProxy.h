// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMGodRaysRenderViewProxy
 * @brief   pictures of a vtkGodRaysRenderView that are larger than it
 *
 * ParaView makes a screenshot that is larger than its view of tiles, one after the other. Shafts
 * reach from one tile into the next, so that this view is made as large as the picture instead, for
 * the time of the screenshot.
 */

#ifndef vtkSMGodRaysRenderViewProxy_h
#define vtkSMGodRaysRenderViewProxy_h

#include "vtkGodRaysViewsModule.h" // For export macro
#include "vtkSMRenderViewProxy.h"

class VTKGODRAYSVIEWS_EXPORT vtkSMGodRaysRenderViewProxy : public vtkSMRenderViewProxy
{
public:
  static vtkSMGodRaysRenderViewProxy* New();
  vtkTypeMacro(vtkSMGodRaysRenderViewProxy, vtkSMRenderViewProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMGodRaysRenderViewProxy();
  ~vtkSMGodRaysRenderViewProxy() override;

  /**
   * Overridden to draw the picture in one piece. One that is larger than the graphics card can hold
   * is made of tiles after all, with a warning: shafts then end at the tiles' edges.
   */
  vtkImageData* CaptureWindowInternal(int magnificationX, int magnificationY) override;

private:
  vtkSMGodRaysRenderViewProxy(const vtkSMGodRaysRenderViewProxy&) = delete;
  void operator=(const vtkSMGodRaysRenderViewProxy&) = delete;
};

#endif
