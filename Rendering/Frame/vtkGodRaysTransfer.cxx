// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysTransfer.h"

#include "vtkGodRaysAttachment.h"
#include "vtkRenderer.h"
#include "vtkToneMappingPass.h"

vtkGodRaysTransfer vtkGodRaysFindTransfer(
  int type, vtkRenderer* renderer, const vtkRenderPass* pass)
{
  constexpr int automatic = 0;
  constexpr int power = 2;
  if (type != automatic)
  {
    return type == power ? vtkGodRaysTransfer::POWER : vtkGodRaysTransfer::SRGB;
  }
  vtkRenderPass* const first = vtkGodRaysAttachment::FindFirst(renderer,
    [pass](vtkRenderPass* each) { return each == pass || vtkToneMappingPass::SafeDownCast(each); });
  return first && first != pass ? vtkGodRaysTransfer::POWER : vtkGodRaysTransfer::SRGB;
}
