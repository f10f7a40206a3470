// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How the colours of a picture stand for light. Internal.
 */

#ifndef vtkGodRaysTransfer_h
#define vtkGodRaysTransfer_h

class vtkRenderer;
class vtkRenderPass;

enum class vtkGodRaysTransfer
{
  NONE, ///< values are summed as they are
  SRGB, ///< sRGB's transfer
  POWER ///< a power of 2.2
};

/**
 * The transfer of vtkGodRaysPass::DisplayTransferType for a pass of the renderer. AUTOMATIC_TRANSFER is
 * POWER if a vtkToneMappingPass has the pass for its delegate, also by way of other vtkImageProcessingPass.
 */
vtkGodRaysTransfer vtkGodRaysFindTransfer(
  int type, vtkRenderer* renderer, const vtkRenderPass* pass);

#endif
