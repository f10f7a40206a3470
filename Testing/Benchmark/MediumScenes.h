// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Twelve scenes that a medium is measured on: those of the filters' tests, and others.

#ifndef MediumScenes_h
#define MediumScenes_h

#include "GodRaysMediumScenes.h"

#include <vector>

/// In view coordinates, all in front of the eye; closed surfaces with normals outwards.
std::vector<GodRaysMediumScenes::Scene> MakeMediumScenes(int sphereParts);

#endif
