// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads glTF with materials as they are shown without surroundings.
 */

#ifndef GltfImporter_h
#define GltfImporter_h

#include "vtkGLTFImporter.h"

/**
 * VTK's importer prepares PBR, in which metals are black where nothing surrounds them, vertices' colours
 * take the place of the factor, and an opacity is blended whatever alphaMode is. Here linear factors and
 * colours of vertices are multiplied and encoded, as VTK shows colours without PBR, and OPAQUE and MASK are
 * opaque.
 */
class GltfImporter : public vtkGLTFImporter
{
public:
  static GltfImporter* New();
  vtkTypeMacro(GltfImporter, vtkGLTFImporter);

protected:
  void ImportActors(vtkRenderer* renderer) override;
};

#endif
