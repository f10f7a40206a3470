// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What the program reads of meshes by itself: the first byte chooses strips of .ply, colours of .obj, or the
// addresses in .gltf and .glb.

#include "GodRaysFuzzing.h"

#include "Failure.h"
#include "GltfFile.h"
#include "ObjMaterials.h"
#include "PlyStrips.h"

#include "vtkCellArray.h"
#include "vtkUnsignedCharArray.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
  {
    return 0;
  }
  const std::string& path = WriteBytes(data + 1, size - 1);
  try
  {
    std::vector<std::string> notes;
    switch (data[0] % 3)
    {
      case 0:
        ReadPlyStrips(path);
        break;
      case 1:
        ReadObjFaceColors(path, notes);
        break;
      default:
        const GltfFile file(path);
        Require(!file.GetPathToRead().empty(), "there is a file to read");
    }
  }
  catch (const Failure& failure)
  {
    Require(*failure.what() != '\0', "a failure has words");
  }
  return 0;
}
