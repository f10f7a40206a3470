// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGlyphs.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkQuaternion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr vtkIdType MostGlyphs = 100000;

/// Whose arrays can be asked for: VTK leaves that to derived classes.
struct Arrays : vtkGlyph3DMapper
{
  using vtkGlyph3DMapper::GetMaskArray;
  using vtkGlyph3DMapper::GetOrientationArray;
  using vtkGlyph3DMapper::GetScaleArray;
  using vtkGlyph3DMapper::GetSourceIndexArray;
};

/// What a glyph is turned by, as vtkGlyph3DMapper says it: an array's values at a point.
vtkQuaterniond FindRotation(int mode, const double* values)
{
  vtkQuaterniond rotation; // none
  if (mode == vtkGlyph3DMapper::QUATERNION)
  {
    rotation.Set(values[0], values[1], values[2], values[3]);
  }
  else if (mode == vtkGlyph3DMapper::ROTATION)
  {
    vtkQuaterniond about[3];
    for (int i = 0; i < 3; ++i)
    {
      double axis[3] = { i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0 };
      about[i].SetRotationAngleAndAxis(vtkMath::RadiansFromDegrees(values[i]), axis);
    }
    rotation = about[2] * about[0] * about[1];
  }
  else
  {
    // half a turn about what is between X and the direction
    const double between[3] = { values[0] + vtkMath::Norm(values), values[1], values[2] };
    const double length = vtkMath::Norm(between);
    if (length > 0.0)
    {
      rotation.Set(0.0, between[0] / length, between[1] / length, between[2] / length);
    }
    else if (values[0] < 0.0)
    {
      rotation.Set(0.0, 0.0, 1.0, 0.0);
    }
  }
  return rotation;
}

/// The factors on a glyph, from an array's values at a point; null for none.
void FindScale(vtkGlyph3DMapper* mapper, const double* values, int components, double scale[3])
{
  std::fill_n(scale, 3, 1.0);
  const int mode = mapper->GetScaleMode();
  const bool byComponents = mode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS && components == 3;
  if (values && (mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE || byComponents))
  {
    const double* range = mapper->GetRange();
    const double width = range[1] == range[0] ? 1.0 : range[1] - range[0];
    for (int i = 0; i < 3; ++i)
    {
      scale[i] = byComponents ? values[i] : vtkMath::Norm(values, components);
      if (mapper->GetClamping())
      {
        scale[i] =
          (std::clamp(scale[i], range[0], std::max(range[0], range[1])) - range[0]) / width;
      }
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    scale[i] *= mapper->GetScaleFactor();
  }
}

std::vector<vtkBoundingBox> FindSources(vtkGlyph3DMapper* mapper)
{
  const int count = mapper->GetNumberOfInputConnections(1);
  std::vector<vtkBoundingBox> boxes;
  for (int i = 0; i < count; ++i)
  {
    mapper->GetInputAlgorithm(1, i)->Update();
    vtkPolyData* source = mapper->GetSource(i);
    boxes.emplace_back();
    if (source && source->GetNumberOfPoints() > 0)
    {
      boxes.back().AddBounds(source->GetBounds());
    }
  }
  if (boxes.empty())
  {
    const double line[6] = { 0.0, 1.0, 0.0, 0.0, 0.0, 0.0 }; // what VTK draws without a source
    boxes.emplace_back(line);
  }
  return boxes;
}

/// Add a box to points, faces and diagonals.
void AddBox(const double corners[8][3], vtkPolyData* result)
{
  constexpr vtkIdType faces[6][4] = { { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
    { 2, 3, 7, 6 }, { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
  const vtkIdType first = result->GetPoints()->GetNumberOfPoints();
  for (int i = 0; i < 8; ++i)
  {
    result->GetPoints()->InsertNextPoint(corners[i]);
  }
  for (const auto& face : faces)
  {
    const vtkIdType ids[4] = { first + face[0], first + face[1], first + face[2], first + face[3] };
    result->GetPolys()->InsertNextCell(4, ids);
  }
  const vtkIdType diagonal[2] = { first, first + 7 }; // of a thin one, it is all that is seen
  result->GetLines()->InsertNextCell(2, diagonal);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkGodRaysMakeGlyphBoxes(vtkGlyph3DMapper* mapper, vtkDataSet* data)
{
  const vtkIdType count = data->GetNumberOfPoints();
  if (mapper->GetUseSourceTableTree() || count > MostGlyphs)
  {
    return nullptr;
  }
  const std::vector<vtkBoundingBox> sources = FindSources(mapper);
  const auto last = static_cast<double>(sources.size() - 1);
  vtkDataArray* mask = mapper->GetMasking() ? (mapper->*&Arrays::GetMaskArray)(data) : nullptr;
  vtkDataArray* indices = (mapper->*&Arrays::GetSourceIndexArray)(data);
  vtkDataArray* scales = (mapper->*&Arrays::GetScaleArray)(data);
  vtkDataArray* rotations = (mapper->*&Arrays::GetOrientationArray)(data);
  const int mode = mapper->GetOrientationMode();
  if (rotations &&
    rotations->GetNumberOfComponents() != (mode == vtkGlyph3DMapper::QUATERNION ? 4 : 3))
  {
    rotations = nullptr; // an error of VTK, which draws none
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(vtkNew<vtkPoints>());
  result->SetPolys(vtkNew<vtkCellArray>());
  result->SetLines(vtkNew<vtkCellArray>());
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (mask && mask->GetTuple1(i) == 0.0)
    {
      continue;
    }
    double place = 0.0; // in the table of sources
    if (indices)
    {
      const double* range = mapper->GetRange();
      const double width = range[1] == range[0] ? 1.0 : range[1] - range[0];
      const double value = vtkMath::Norm(indices->GetTuple(i), indices->GetNumberOfComponents());
      place = std::clamp(std::floor((value - range[0]) * (last + 1.0) / width), 0.0, last);
    }
    const vtkBoundingBox& source = sources[static_cast<std::size_t>(place)];
    if (!source.IsValid())
    {
      continue;
    }
    double scale[3] = { 1.0, 1.0, 1.0 };
    if (mapper->GetScaling())
    {
      FindScale(mapper, scales ? scales->GetTuple(i) : nullptr,
        scales ? scales->GetNumberOfComponents() : 0, scale);
    }
    double turn[3][3];
    (rotations ? FindRotation(mode, rotations->GetTuple(i)) : vtkQuaterniond()).ToMatrix3x3(turn);
    double corners[8][3];
    for (int corner = 0; corner < 8; ++corner)
    {
      source.GetCorner(corner, corners[corner]);
      for (int c = 0; c < 3; ++c)
      {
        corners[corner][c] *= scale[c];
      }
      vtkMath::Multiply3x3(turn, corners[corner], corners[corner]);
      vtkMath::Add(corners[corner], data->GetPoint(i), corners[corner]);
    }
    AddBox(corners, result);
  }
  return result;
}
