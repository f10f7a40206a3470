// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What the tests of the mathematics share.

#ifndef GodRaysMathTesting_h
#define GodRaysMathTesting_h

#include "vtkImageData.h"

#include <random>

/// Make a random RGB image of 32-bit floats, the same every time.
inline void MakeImage(vtkImageData* image, int width, int height)
{
  std::mt19937 generator(7);
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < 3 * width * height; ++i)
  {
    values[i] = static_cast<float>(generator() / 4294967296.0);
  }
}

#endif
