// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TiffPicture.h"

#include "Failure.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtk_tiff.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
/// Keeps the library from printing; what is wrong is told by one Failure.
struct Hush
{
  TIFFErrorHandler Error = TIFFSetErrorHandler(nullptr);
  TIFFErrorHandler Warning = TIFFSetWarningHandler(nullptr);
  Hush() = default;
  ~Hush()
  {
    TIFFSetErrorHandler(this->Error);
    TIFFSetWarningHandler(this->Warning);
  }
  Hush(const Hush&) = delete;
  void operator=(const Hush&) = delete;
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ReadCompressedTiff(const std::string& path)
{
  const Hush hush;
  const std::unique_ptr<TIFF, decltype(&TIFFClose)> file(TIFFOpen(path.c_str(), "rm"), &TIFFClose);
  if (!file)
  {
    return nullptr;
  }
  const auto get = [&file](int tag)
  {
    std::uint16_t value = 0;
    TIFFGetFieldDefaulted(file.get(), tag, &value);
    return value;
  };
  const std::uint16_t compression = get(TIFFTAG_COMPRESSION);
  if (!TIFFIsCODECConfigured(compression))
  {
    throw Failure(path + ": has the compression " + std::to_string(compression) +
      " of TIFF, which cannot be read here; save it with deflate or LZW");
  }
  const bool isJpeg = compression == COMPRESSION_JPEG || compression == COMPRESSION_OJPEG;
  const int channels = get(TIFFTAG_SAMPLESPERPIXEL);
  std::uint32_t size[2] = {};
  if (compression == COMPRESSION_NONE || get(TIFFTAG_BITSPERSAMPLE) != 8 ||
    !(isJpeg || channels > 2) || !TIFFGetField(file.get(), TIFFTAG_IMAGEWIDTH, &size[0]) ||
    !TIFFGetField(file.get(), TIFFTAG_IMAGELENGTH, &size[1]))
  {
    return nullptr;
  }
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(size[0]) * size[1]);
  constexpr int stopOnError = 1;
  if (!TIFFReadRGBAImageOriented(
        file.get(), size[0], size[1], pixels.data(), ORIENTATION_BOTLEFT, stopOnError))
  {
    throw Failure(
      path + ": cannot be read; the file is damaged, or not what its name says: write it again");
  }
  const int components = channels < 3 ? 1 : channels == 4 ? 4 : 3;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(size[0]), static_cast<int>(size[1]), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  image->GetPointData()->GetScalars()->SetName("Tiff Scalars"); // as those of VTK's reader
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const std::uint32_t pixel : pixels)
  {
    for (int c = 0; c < components; ++c)
    {
      *value++ = static_cast<unsigned char>(pixel >> 8 * c & 255);
    }
  }
  return image;
}
