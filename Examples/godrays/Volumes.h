// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Opacities and colours of volumes by name.
 */

#ifndef Volumes_h
#define Volumes_h

#include <string>
#include <vector>

class vtkVolumeProperty;

/// All names.
std::vector<std::string> GetVolumePresets();

/**
 * Give a volume the opacities and colours of a name; values are Hounsfield units. The opacity is a
 * factor.
 */
void ApplyVolumePreset(const std::string& name, double opacity, vtkVolumeProperty* property);

#endif
