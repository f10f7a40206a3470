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

#include <algorithm>
#include <string>
#include <vector>

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

// Radiance's run lengths: a count above 128 repeats the byte that follows, one below goes before as many.
void AppendRuns(const std::vector<unsigned char>& bytes, std::string& to)
{
  constexpr std::size_t shortestRun = 3;
  std::size_t start = 0;
  while (start < bytes.size())
  {
    // From start, the next run that is worth while.
    std::size_t run = start;
    std::size_t length = 0;
    for (; run < bytes.size(); run += length)
    {
      length = 1;
      while (run + length < bytes.size() && length < 127 && bytes[run + length] == bytes[run])
      {
        ++length;
      }
      if (length >= shortestRun)
      {
        break;
      }
    }
    while (start < run)
    {
      const std::size_t count = std::min<std::size_t>(run - start, 128);
      to += static_cast<char>(count);
      to.append(reinterpret_cast<const char*>(bytes.data() + start), count);
      start += count;
    }
    if (run < bytes.size())
    {
      to += static_cast<char>(128 + length);
      to += static_cast<char>(bytes[run]);
      start = run + length;
    }
  }
}

// A row of the file.
std::string EncodeRow(vtkDataArray* scalars, vtkIdType first, int width)
{
  const int green = scalars->GetNumberOfComponents() > 1 ? 1 : 0;
  std::vector<unsigned char> channels[4];
  for (int x = 0; x < width; ++x)
  {
    const vtkGodRays::Vec3 light(scalars->GetComponent(first + x, 0),
      scalars->GetComponent(first + x, green), scalars->GetComponent(first + x, 2 * green));
    const vtkGodRays::Vec4 bytes = vtkGodRays::EncodeSharedExponent(1, light);
    for (int c = 0; c < 4; ++c)
    {
      channels[c].push_back(static_cast<unsigned char>(bytes[c]));
    }
  }
  std::string row;
  if (width < 8 || width > 32767)
  {
    for (int x = 0; x < width; ++x)
    {
      for (const std::vector<unsigned char>& channel : channels)
      {
        row += static_cast<char>(channel[x]);
      }
    }
    return row;
  }
  row = { 2, 2, static_cast<char>(width / 256), static_cast<char>(width % 256) };
  for (const std::vector<unsigned char>& channel : channels)
  {
    AppendRuns(channel, row);
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
