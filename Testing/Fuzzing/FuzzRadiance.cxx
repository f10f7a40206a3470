// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures of light written as .hdr, and read again as the format's author has it: each is as it was, to what
// eight bits and a common exponent can hold.

#include "GodRaysFuzzing.h"

#include "vtkDataArray.h"
#include "vtkGodRaysHDRWriter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <vector>

namespace
{
/// The bytes of a row, a channel after the other; moves at.
std::vector<std::uint8_t> ReadRow(const std::string& file, std::size_t& at, int width)
{
  std::vector<std::uint8_t> row(4 * static_cast<std::size_t>(width));
  Require(at + row.size() <= file.size(), "a row ends within the file");
  Require(width < 8 || file[at] != 2 || file[at + 1] != 2 || (file[at + 2] & 0x80),
    "a row does not look like one of run lengths");
  for (int x = 0; x < width; ++x)
  {
    for (int c = 0; c < 4; ++c)
    {
      row[static_cast<std::size_t>(c * width + x)] = static_cast<std::uint8_t>(file[at++]);
    }
  }
  return row;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < 2)
  {
    return 0;
  }
  const int width = 1 + data[0];
  const int components = data[1] % 2 ? 3 : 1;
  data += 2;
  size -= 2;
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(width, 1, 1);
  picture->AllocateScalars(VTK_FLOAT, components);
  auto* values = static_cast<float*>(picture->GetScalarPointer());
  const auto number = static_cast<std::size_t>(width * components);
  std::fill_n(values, number, 0.0f);
  std::memcpy(values, data, std::min(size, number * sizeof(float)));

  const std::string& path = WriteBytes(nullptr, 0);
  vtkNew<vtkGodRaysHDRWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(path.c_str());
  writer->Write();
  Require(writer->GetErrorCode() == 0, "it is written");
  std::ifstream stream(path, std::ios::binary);
  const std::string file((std::istreambuf_iterator<char>(stream)), {});
  const std::string sizes = "-Y 1 +X " + std::to_string(width) + "\n";
  std::size_t at = file.find(sizes);
  Require(at != std::string::npos, "the header says its size");
  at += sizes.size();
  const auto row = ReadRow(file, at, width);
  Require(at == file.size(), "nothing follows the rows");
  for (int x = 0; x < width; ++x)
  {
    double wanted[3];
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const float value = values[x * components + (components == 3 ? c : 0)];
      wanted[c] = value > 0.0f ? std::min<double>(value, 1e38) : 0.0; // not NaN
      largest = std::max(largest, wanted[c]);
    }
    const int exponent = row[static_cast<std::size_t>(3 * width + x)];
    for (int c = 0; c < 3; ++c)
    {
      const double got =
        exponent ? std::ldexp(row[static_cast<std::size_t>(c * width + x)], exponent - 136) : 0.0;
      Require(largest >= 1e38 || largest < 1e-37 || std::fabs(got - wanted[c]) <= largest / 127.0,
        "light is as it was");
    }
  }
  return 0;
}
