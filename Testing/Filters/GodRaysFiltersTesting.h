// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    GodRaysFiltersTesting.h
 * @brief   pictures for the tests of image filters
 */

#ifndef GodRaysFiltersTesting_h
#define GodRaysFiltersTesting_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace GodRaysFiltersTesting
{
// Random numbers: a test's own, others with the environment variable GODRAYS_SEED.
inline std::mt19937 MakeGenerator(unsigned int seed)
{
  const char* offset = std::getenv("GODRAYS_SEED");
  seed += offset ? 1000u * static_cast<unsigned int>(std::atoi(offset)) : 0u;
  std::cout << "seed " << seed << "\n";
  return std::mt19937(seed);
}

// How often a function allocates memory; in TestGodRaysRadialSweep.cxx.
int CountAllocations(const std::function<void()>& function);

// Collects the text of errors instead of printing it.
class ErrorListener
{
public:
  explicit ErrorListener(vtkObject* object)
  {
    this->Command->SetClientData(&this->Texts);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* texts, void* text) {
        static_cast<std::vector<std::string>*>(texts)->push_back(static_cast<const char*>(text));
      });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  std::vector<std::string> Texts;

private:
  vtkNew<vtkCallbackCommand> Command;
};

// An image, rows from the bottom up.
struct Picture
{
  int Width = 0;
  int Height = 0;
  int Components = 1;
  std::vector<double> Values;

  Picture() = default;
  Picture(int width, int height, int components = 1)
    : Width(width)
    , Height(height)
    , Components(components)
    , Values(static_cast<std::size_t>(width) * height * components)
  {
  }

  double& At(int x, int y, int c = 0)
  {
    return this->Values[(static_cast<std::size_t>(y) * this->Width + x) * this->Components + c];
  }
  double Get(int x, int y, int c = 0) const
  {
    if (x < 0 || y < 0 || x >= this->Width || y >= this->Height)
    {
      return 0.0;
    }
    return this->Values[(static_cast<std::size_t>(y) * this->Width + x) * this->Components + c];
  }
  // Bilinear; x and y count pixels, whole numbers being their centres.
  template <typename Real>
  Real Read(Real x, Real y, int c = 0) const
  {
    if (!(x > -1 && y > -1 && x < this->Width && y < this->Height))
    {
      return 0;
    }
    const int left = static_cast<int>(std::floor(x));
    const int low = static_cast<int>(std::floor(y));
    Real sum = 0;
    for (int i = 0; i < 4; ++i)
    {
      const int column = left + i % 2;
      const int row = low + i / 2;
      sum += (1 - std::abs(x - column)) * (1 - std::abs(y - row)) * this->Get(column, row, c);
    }
    return sum;
  }
  double GetMaximum() const { return *std::max_element(this->Values.begin(), this->Values.end()); }
};

inline Picture MakePicture(int width, int height, const std::function<double(int, int)>& function)
{
  Picture picture(width, height);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      picture.At(x, y) = function(x, y);
    }
  }
  return picture;
}

inline Picture MakeNoise(int width, int height, int components, std::mt19937& generator)
{
  Picture picture(width, height, components);
  for (double& value : picture.Values)
  {
    const double uniform = generator() / 4294967296.0;
    value = uniform < 0.3 ? 0.0 : uniform; // hard edges, too
  }
  return picture;
}

template <typename Scalar>
void FillImage(vtkImageData* image, const Picture& picture)
{
  auto* scalars = static_cast<Scalar*>(image->GetScalarPointer());
  std::transform(picture.Values.begin(), picture.Values.end(), scalars,
    [](double value) { return static_cast<Scalar>(value); });
}

inline vtkSmartPointer<vtkImageData> MakeImage(const Picture& picture, int type = VTK_DOUBLE)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->AllocateScalars(type, picture.Components);
  switch (type)
  {
    case VTK_UNSIGNED_CHAR:
      FillImage<unsigned char>(image, picture);
      break;
    case VTK_FLOAT:
      FillImage<float>(image, picture);
      break;
    default:
      FillImage<double>(image, picture);
  }
  return image;
}

inline Picture FromImage(vtkImageData* image)
{
  Picture picture(image->GetDimensions()[0], image->GetDimensions()[1],
    std::max(image->GetNumberOfScalarComponents(), 1));
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (std::size_t i = 0; i < picture.Values.size(); ++i)
  {
    picture.Values[i] = scalars->GetComponent(
      static_cast<vtkIdType>(i) / picture.Components, static_cast<int>(i) % picture.Components);
  }
  return picture;
}

// What the filter makes of a picture.
inline Picture Scatter(vtkImageAlgorithm* filter, const Picture& picture, int type = VTK_DOUBLE)
{
  filter->SetInputData(MakeImage(picture, type));
  filter->Update();
  return FromImage(filter->GetOutput());
}

// The largest difference of two values in the same place.
inline double GetLargestDifference(const Picture& a, const Picture& b)
{
  EXPECT_EQ(a.Values.size(), b.Values.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.Values.size(), b.Values.size()); ++i)
  {
    largest = std::max(largest, std::abs(a.Values[i] - b.Values[i]));
  }
  return largest;
}
}

#endif
