// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysHDRWriter.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkGodRaysMath.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtksys/FStream.hxx"

#include <string>

vtkStandardNewMacro(vtkGodRaysHDRWriter);

namespace
{
// Why an image cannot be written, and what to do; empty if it can.
std::string FindFault(vtkImageData* image, const char* fileName)
{
  if (!fileName || !*fileName)
  {
    return "there is no file name. Set FileName.";
  }
  if (!image || image->GetNumberOfPoints() == 0 || !image->GetPointData()->GetScalars())
  {
    return "there is no picture. Give vtkImageData with scalars as the input.";
  }
  int size[3];
  image->GetDimensions(size);
  const int components = image->GetPointData()->GetScalars()->GetNumberOfComponents();
  if (size[2] != 1)
  {
    return "the image has " + std::to_string(size[2]) +
      " slices. Extract one: vtkExtractVOI does that.";
  }
  if (components == 2)
  {
    return "the scalars have 2 components. Give 1 (grey) or 3 (red, green, blue).";
  }
  return {};
}

// A row of the file, without run lengths: light is hardly ever the same in two pixels. The format tells rows
// with and without by their first bytes, which light has not: of its mantissas, one is 128 at least.
std::string EncodeRow(vtkDataArray* scalars, vtkIdType first, int width)
{
  const int green = scalars->GetNumberOfComponents() > 1 ? 1 : 0;
  std::string row;
  for (vtkIdType i = first; i < first + width; ++i)
  {
    const vtkGodRays::Vec3 light(scalars->GetComponent(i, 0), scalars->GetComponent(i, green),
      scalars->GetComponent(i, 2 * green));
    const vtkGodRays::Vec4 bytes = vtkGodRays::EncodeSharedExponent(1, light);
    for (int c = 0; c < 4; ++c)
    {
      row += static_cast<char>(static_cast<unsigned char>(bytes[c]));
    }
  }
  return row;
}
}

void vtkGodRaysHDRWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->UpdateWholeExtent();
  }
  vtkImageData* image = this->GetInput();
  const std::string fault = FindFault(image, this->FileName);
  if (!fault.empty())
  {
    this->SetErrorCode(this->FileName && *this->FileName ? vtkErrorCode::FileFormatError
                                                         : vtkErrorCode::NoFileNameError);
    vtkErrorMacro("Cannot write a .hdr file: " << fault);
    return;
  }
  int size[3];
  image->GetDimensions(size);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtksys::ofstream file(this->FileName, std::ios::out | std::ios::binary);
  file << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " << size[1] << " +X " << size[0] << "\n";
  for (int y = size[1] - 1; y >= 0 && file; --y) // from the top
  {
    file << EncodeRow(scalars, static_cast<vtkIdType>(y) * size[0], size[0]);
    this->UpdateProgress(1.0 - static_cast<double>(y) / size[1]);
  }
  file.close();
  if (!file)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro("Cannot write " << this->FileName
                                  << ". Is there such a folder, may it be written, is there room?");
  }
}
