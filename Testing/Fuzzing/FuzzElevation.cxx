// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The tags of a GeoTIFF, and the surface of elevations on them.

#include "GodRaysFuzzing.h"

#include "Elevation.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const Georeference place = ReadGeoTiffTags(WriteBytes(data, size));
  if (place.Known)
  {
    const double lengths[2] = { std::hypot(place.Column[0], place.Column[1]),
      std::hypot(place.Row[0], place.Row[1]) };
    Require(lengths[0] > 0.0 && lengths[1] > 0.0 && lengths[0] < 1e21 && lengths[1] < 1e21,
      "lengths are lengths");
  }
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(3, 2, 1);
  picture->AllocateScalars(VTK_FLOAT, 1);
  for (int i = 0; i < 6; ++i)
  {
    picture->GetPointData()->GetScalars()->SetTuple1(i, i < static_cast<int>(size) ? data[i] : i);
  }
  bool hasOutliers = false;
  const auto surface =
    MakeElevationSurface(picture, picture->GetPointData()->GetScalars(), place, 1.0, hasOutliers);
  Require(surface->GetNumberOfPoints() == 6, "each sample has a point");
  return 0;
}
