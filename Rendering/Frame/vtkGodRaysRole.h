// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysRole.h
 * @brief   what a prop does to the light, see vtkGodRaysPass::SetRole(); private to this module
 */

#ifndef vtkGodRaysRole_h
#define vtkGodRaysRole_h

class vtkInformationIntegerKey;
class vtkProp;

/// The values are those of vtkGodRaysPass::Role.
enum class vtkGodRaysRole
{
  AUTOMATIC = 0,
  OCCLUDER = 1,
  LIGHT = 2,
  IGNORED = 3,
  MEDIUM = 4
};

vtkInformationIntegerKey* vtkGodRaysGetRoleKey();
vtkGodRaysRole vtkGodRaysGetRole(vtkProp* prop);
void vtkGodRaysSetRole(vtkProp* prop, vtkGodRaysRole role);

/// Whether a prop lies over the picture: a vtkActor2D, or what has no place in the scene, such as a chart,
/// a scale or the 2-D representation of a widget.
bool vtkGodRaysIsOverlay(vtkProp* prop);

/// Whether a prop is a volume or an assembly that has one.
bool vtkGodRaysHasVolume(vtkProp* prop);

#endif
