// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGrid.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"

std::string vtkGodRaysGrid::Read(
  vtkImageData* image, const char* extinction, const char* scattering)
{
  const int* size = image->GetDimensions();
  if (size[0] < 2 || size[1] < 2 || size[2] < 2)
  {
    return "data of a medium have no volume. Give an image of at least 2 points along each axis.";
  }
  const auto find = [&](const char* name) -> vtkDataArray*
  {
    return name && *name ? image->GetPointData()->GetArray(name)
                         : image->GetPointData()->GetScalars();
  };
  vtkDataArray* arrays[2] = { find(extinction), nullptr };
  if (scattering && *scattering)
  {
    arrays[1] = find(scattering);
  }
  if (!arrays[0] || (scattering && *scattering && !arrays[1]))
  {
    return std::string("data of a medium have no array ") +
      (!arrays[0] ? (extinction && *extinction ? extinction : "of scalars") : scattering) +
      " at their points. Name one that they have, or convert data of cells with "
      "vtkCellDataToPointData.";
  }
  for (int i = 0; i < 2 && arrays[i]; ++i)
  {
    if (arrays[i]->GetNumberOfTuples() != image->GetNumberOfPoints())
    {
      return "an array of a medium has " + std::to_string(arrays[i]->GetNumberOfTuples()) +
        " values for an image of " + std::to_string(image->GetNumberOfPoints()) +
        " points. Give one value, or three, for each point.";
    }
    const int bands = arrays[i]->GetNumberOfComponents();
    if (bands != 1 && bands != 3)
    {
      return "an array of a medium has neither one nor three components. Give one for all colours, "
             "or "
             "red, green and blue.";
    }
    (i == 0 ? this->Bands : this->ScatteringBands) = bands;
  }
  auto table = std::make_shared<vtkGodRaysGridTable>();
  if (!table->SetCoefficients(arrays[0], arrays[1]))
  {
    return "data of a medium are negative or not finite. Give extinction and scattering "
           "coefficients in [0, 1e30].";
  }
  this->Table = table;
  std::copy_n(size, 3, this->Points);
  const int* extent = image->GetExtent();
  vtkMatrix4x4* matrix = image->GetIndexToPhysicalMatrix();
  for (int i = 0; i < 3; ++i)
  {
    this->Origin[i] = matrix->GetElement(i, 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Axes[axis][i] = matrix->GetElement(i, axis);
      this->Origin[i] += extent[2 * axis] * this->Axes[axis][i];
    }
  }
  return this->Invert()
    ? ""
    : "data of a medium have no volume. Set the image's spacing to numbers that "
      "are not 0.";
}
