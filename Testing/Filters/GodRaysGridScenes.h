// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    GodRaysGridScenes.h
 * @brief   media of data for tests
 */

#ifndef GodRaysGridScenes_h
#define GodRaysGridScenes_h

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <functional>

namespace GodRaysGridScenes
{
using Field = std::function<double(double, double, double)>;

// An image of a field's values, of so many points along each axis of a box of bounds.
inline vtkSmartPointer<vtkImageData> MakeImage(
  const double bounds[6], const int points[3], const Field& field, int type = VTK_FLOAT)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points);
  image->SetOrigin(bounds[0], bounds[2], bounds[4]);
  double spacing[3];
  for (int i = 0; i < 3; ++i)
  {
    spacing[i] = (bounds[2 * i + 1] - bounds[2 * i]) / (points[i] - 1);
  }
  image->SetSpacing(spacing);
  image->AllocateScalars(type, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    scalars->SetTuple1(i, field(p[0], p[1], p[2]));
  }
  return image;
}

// A plume that rises before a camera in the origin that looks along -z: lumps that grow and thin out.
inline double Plume(double x, double y, double z)
{
  const double rise = y + 1.5;
  const double wide = 0.25 + 0.22 * rise;
  const double aside = x - 0.3 * std::sin(1.3 * rise);
  const double away = z + 6.0 - 0.25 * std::cos(1.7 * rise);
  const double lumps = 1.0 + 0.6 * std::sin(5.0 * x + 1.0) * std::sin(4.0 * y) * std::cos(6.0 * z);
  const double density =
    2.5 * std::exp(-(aside * aside + away * away) / (wide * wide)) * lumps * std::exp(-0.3 * rise);
  return density > 0.02 ? density - 0.02 : 0.0;
}
inline vtkSmartPointer<vtkImageData> MakePlume(int n)
{
  const double bounds[6] = { -1.5, 1.5, -1.5, 1.5, -7.5, -4.5 };
  const int points[3] = { n, n, n };
  return MakeImage(bounds, points, Plume);
}
}

#endif
