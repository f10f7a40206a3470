// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Files of light: what VTK reads back, their rows, and what cannot be written.

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysHDRWriter.h"

#include "vtkErrorCode.h"
#include "vtkHDRReader.h"

#include <cstdio>
#include <fstream>
#include <limits>

using namespace GodRaysFiltersTesting;

namespace
{
const char* const fileName = "TestGodRaysHDRWriter.hdr";

vtkSmartPointer<vtkImageData> MakeImage(int width, int height, int components, int type = VTK_FLOAT)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  return image;
}

vtkSmartPointer<vtkImageData> WriteAndRead(vtkImageData* image)
{
  vtkNew<vtkGodRaysHDRWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(fileName);
  writer->Write();
  EXPECT_EQ(writer->GetErrorCode(), vtkErrorCode::NoError);
  // VTK 9.6 loses its place in a file that is shorter than its buffer. What follows the picture is not read.
  std::ofstream(fileName, std::ios::binary | std::ios::app) << std::string(1 << 16, ' ');
  vtkNew<vtkHDRReader> reader;
  EXPECT_TRUE(reader->CanReadFile(fileName));
  reader->SetFileName(fileName);
  reader->Update();
  std::remove(fileName);
  return reader->GetOutput();
}
}

//------------------------------------------------------------------------------
// Widths with and without compression; noise, runs of all lengths, and both.
TEST(HDRWriter, VTKReadsItBack)
{
  std::mt19937 generator = MakeGenerator(5);
  for (const int width : { 1, 7, 8, 127, 128, 129, 300, 1000 })
  {
    for (const int runs : { 1, 2, 3, 130, 1000 })
    {
      const int height = 5;
      const vtkSmartPointer<vtkImageData> image = MakeImage(width, height, 3);
      double value = 0.0;
      for (vtkIdType i = 0; i < 3 * width * height; ++i)
      {
        if (i % (3 * runs) < 3)
        {
          value = std::exp2(generator() / 4294967296.0 * 60.0 - 30.0);
        }
        image->GetPointData()->GetScalars()->SetComponent(i / 3, static_cast<int>(i % 3), value);
      }
      const vtkSmartPointer<vtkImageData> back = WriteAndRead(image);
      int size[3];
      back->GetDimensions(size);
      ASSERT_EQ(size[0], width);
      ASSERT_EQ(size[1], height);
      for (vtkIdType i = 0; i < width * height; ++i)
      {
        const double* expected = image->GetPointData()->GetScalars()->GetTuple3(i);
        const double before[3] = { expected[0], expected[1], expected[2] };
        const double brightest = *std::max_element(before, before + 3);
        for (int c = 0; c < 3; ++c)
        {
          ASSERT_NEAR(back->GetPointData()->GetScalars()->GetComponent(i, c), before[c],
            brightest * 0.5 / 127.5)
            << width << " " << runs << " " << i;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(HDRWriter, TakesAnyNumber)
{
  const vtkSmartPointer<vtkImageData> image = MakeImage(8, 1, 1, VTK_DOUBLE);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const double values[8] = { 0.0, -1.0, nan, infinity, 1e-300, 1.0, 1e-30, 1e30 };
  const double expected[8] = { 0.0, 0.0, 0.0, 1.69e38, 0.0, 1.0, 1e-30, 1e30 };
  for (int i = 0; i < 8; ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i, 0, values[i]);
  }
  const vtkSmartPointer<vtkImageData> back = WriteAndRead(image);
  for (int i = 0; i < 8; ++i)
  {
    for (int c = 0; c < 3; ++c) // grey
    {
      EXPECT_NEAR(
        back->GetPointData()->GetScalars()->GetComponent(i, c), expected[i], 0.004 * expected[i]);
    }
  }
}

//------------------------------------------------------------------------------
TEST(HDRWriter, SaysWhatCannotBeWritten)
{
  vtkNew<vtkGodRaysHDRWriter> writer;
  const ErrorListener errors(writer);
  const auto expectError = [&](unsigned long code, const char* text)
  {
    writer->Write();
    EXPECT_EQ(writer->GetErrorCode(), code);
    ASSERT_FALSE(errors.Texts.empty());
    EXPECT_NE(errors.Texts.back().find(text), std::string::npos) << errors.Texts.back();
  };
  writer->SetInputData(MakeImage(2, 2, 3));
  expectError(vtkErrorCode::NoFileNameError, "Set FileName");
  writer->SetFileName(fileName);
  writer->SetInputData(MakeImage(2, 2, 2));
  expectError(vtkErrorCode::FileFormatError, "2 components");
  vtkNew<vtkImageData> stack;
  stack->SetDimensions(2, 2, 6);
  stack->AllocateScalars(VTK_FLOAT, 3);
  writer->SetInputData(stack);
  expectError(vtkErrorCode::FileFormatError, "6 slices");
  writer->SetInputData(vtkNew<vtkImageData>());
  expectError(vtkErrorCode::FileFormatError, "no picture");
  EXPECT_FALSE(std::ifstream(fileName).good());
  writer->SetInputData(MakeImage(2, 2, 3));
  writer->SetFileName("/nowhere/at/all.hdr");
  expectError(vtkErrorCode::CannotOpenFileError, "such a folder");
  EXPECT_EQ(errors.Texts.size(), 5u);
}
