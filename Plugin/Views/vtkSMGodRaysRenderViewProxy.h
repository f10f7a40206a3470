// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMGodRaysRenderViewProxy
 * @brief   a vtkGodRaysRenderView as its user has it
 *
 * Where the sun was placed is written into its properties SunAzimuth and SunElevation, and its colour into
 * SunColor, unless that was set, so that it stays there, also in state files. To set SunAzimuth, SunPosition,
 * SunElevation or SunFrame ends PlaceSun.
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

  /**
   * Overridden to load the plugin GodRaysPanel in a program with a window: it shows the property Preset with
   * pictures, and needs Qt, which this plugin does not.
   */
  void CreateVTKObjects() override;

  /**
   * Overridden to take over where the sun was placed.
   */
  void PostRender(bool interactive) override;

private:
  void OnPropertyModified(vtkObject*, unsigned long, void* name);

  vtkSMGodRaysRenderViewProxy(const vtkSMGodRaysRenderViewProxy&) = delete;
  void operator=(const vtkSMGodRaysRenderViewProxy&) = delete;
};

#endif
