// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysTransfer.h"

#include "vtkGodRaysPass.h"
#include "vtkRenderer.h"
#include "vtkToneMappingPass.h"

//------------------------------------------------------------------------------
vtkGodRaysTransfer vtkGodRaysFindTransfer(
  int type, vtkRenderer* renderer, const vtkRenderPass* pass)
{
  if (type != vtkGodRaysPass::AUTOMATIC_TRANSFER)
  {
    return type == vtkGodRaysPass::POWER_TRANSFER ? vtkGodRaysTransfer::POWER
                                                  : vtkGodRaysTransfer::SRGB;
  }
  auto outer = vtkImageProcessingPass::SafeDownCast(renderer->GetPass());
  while (outer && outer != pass)
  {
    if (vtkToneMappingPass::SafeDownCast(outer))
    {
      return vtkGodRaysTransfer::POWER;
    }
    outer = vtkImageProcessingPass::SafeDownCast(outer->GetDelegatePass());
  }
  return vtkGodRaysTransfer::SRGB;
}
