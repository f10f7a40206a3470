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

vtkGodRays::Vec2 vtkGodRaysGrid::FindShadow(const Vec3& place, const Vec3& steps, double end,
  const Vec3& light, bool directional, double margin) const
{
  using vtkGodRays::Vec2;
  constexpr double begin = 0.0;
  const Vec3 size(this->Points[0] - 1.0, this->Points[1] - 1.0, this->Points[2] - 1.0);
  Vec3 corner, across;
  Vec2 vertices[16];
  int count = 0;
  if (directional) // place = corner + x steps + y across
  {
    corner = place;
    across = light;
    const double reach = vtkGodRays::length(corner + begin * steps) +
      vtkGodRays::length(corner + end * steps) + 2.0 * vtkGodRays::length(size) + 10.0;
    const double most = reach / std::max(vtkGodRays::length(across), 1e-300);
    for (const Vec2& each :
      { Vec2(begin, 0.0), Vec2(end, 0.0), Vec2(end, most), Vec2(begin, most) })
    {
      vertices[count++] = each;
    }
  }
  else // the same, with y the part of the way from the light, and x that of the ray times it
  {
    corner = light;
    across = place - corner;
    for (const Vec2& each : { Vec2(0.0, 0.0), Vec2(begin, 1.0), Vec2(end, 1.0) })
    {
      vertices[count++] = each;
    }
  }
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const auto inside = [&](const Vec2& v)
    {
      const double at = corner[axis] + v.x * steps[axis] + v.y * across[axis];
      return face % 2 == 0 ? at + margin : size[axis] + margin - at;
    };
    Vec2 kept[16];
    int number = 0;
    for (int k = 0; k < count; ++k)
    {
      const Vec2& from = vertices[k];
      const Vec2& to = vertices[(k + 1) % count];
      const double before = inside(from);
      const double after = inside(to);
      if (before >= 0.0)
      {
        kept[number++] = from;
      }
      if ((before >= 0.0) != (after >= 0.0))
      {
        kept[number++] = from + before / (before - after) * (to - from);
      }
    }
    count = number;
    std::copy_n(kept, count, vertices);
  }
  Vec2 range(end, begin);
  for (int k = 0; k < count; ++k)
  {
    const double part = directional ? 1.0 : vertices[k].y;
    if (!(part > 1e-9)) // the light is in the grid
    {
      return Vec2(begin, end);
    }
    range.x = std::min(range.x, vertices[k].x / part);
    range.y = std::max(range.y, vertices[k].x / part);
  }
  return Vec2(std::clamp(range.x, begin, end), std::clamp(range.y, begin, end));
}
