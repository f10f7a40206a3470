// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What VTK's importer of glTF needs to have looked at before it reads a file.
 */

#ifndef GltfFile_h
#define GltfFile_h

#include "Temporary.h"

#include <cstddef> // For std::size_t
#include <optional>
#include <string> // For std::string
#include <vector> // For std::vector

class GltfFile
{
public:
  /**
   * Look at a .gltf or .glb file. Throws Failure when it is glTF 1, is compressed in a way that VTK
   * cannot read, was cut off, or lacks a buffer.
   */
  explicit GltfFile(const std::string& path);
  ~GltfFile();

  GltfFile(const GltfFile&) = delete;
  void operator=(const GltfFile&) = delete;

  /**
   * The file to read: this one, or a copy that lives as long as this object. In a copy, pictures
   * that are missing are white, and files that VTK would not find by their URIs have other names.
   */
  const std::string& GetPathToRead() const { return this->PathToRead; }

  /**
   * The pictures that are missing, as the file names them.
   */
  const std::vector<std::string>& GetMissingPictures() const { return this->MissingPictures; }

private:
  void ReplaceUris();
  void WriteCopy();

  std::string Path;
  std::string PathToRead;
  std::string Json;
  std::size_t Rest = 0;            ///< where in a .glb what follows the JSON begins
  std::optional<Temporary> Folder; ///< of the copy, if there is one
  std::optional<Temporary> Copy;
  std::vector<std::string> MissingPictures;
};

#endif
