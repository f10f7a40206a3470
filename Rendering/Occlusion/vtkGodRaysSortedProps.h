// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysSortedProps.h
 * @brief   the props of a renderer, by what they do to light; private to this module
 */

#ifndef vtkGodRaysSortedProps_h
#define vtkGodRaysSortedProps_h

#include "vtkGodRaysOcclusionPass.h" // For Request

#include <vector>

class vtkProp;

/// The visible three-dimensional props of a renderer, in or out of its frustum, by what they do.
struct vtkGodRaysSortedProps
{
  std::vector<vtkProp*> OccludingProps; // opaque parts; lights block the light of others
  std::vector<vtkProp*> Dimming;        // translucent parts and volumes
  int NotOccluding = 0;
  int Emitters = 0;
  bool Labels = false; // some have labels, which are in the scene's depth and block no light

  /// Anew, in the memory of those before.
  void Sort(const vtkGodRaysOcclusionPass::Request& request);

  /// Whether the scene's own depth is that of its occluders.
  bool SceneDepthServes(const vtkGodRaysOcclusionPass::Request& request) const;

  /// Those with translucent parts or volumes that are drawn, in their order, whatever they do to light.
  static void FindShown(
    const vtkGodRaysOcclusionPass::Request& request, std::vector<vtkProp*>& shown);
};

#endif
