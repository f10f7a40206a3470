// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSilhouette.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkCutter.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysGlyphs.h"
#include "vtkGodRaysRole.h"
#include "vtkGraph.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace
{
constexpr int NumberOfDirections = 48;
constexpr double GlowReach = 0.2;   // [the shorter side of the picture] of the light about a sun
constexpr double FarGlare = 0.3;    // of that of data next to the sun
constexpr double LeastShafts = 0.3; // the sum of changes of light with direction, each from 0 to 1
constexpr double MostShafts = 4.0;  // more are not better
constexpr double ShaftsWeight = 4.0;
constexpr double GlareWeight = 7.0;
constexpr double BallOfBond =
  0.35; // radius of an atom's ball, as a part of the length of its bonds

double GetSide(const double a[2], const double b[2], double x, double y)
{
  return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}
}

//------------------------------------------------------------------------------
vtkGodRaysSilhouette::vtkGodRaysSilhouette(
  vtkPropCollection* props, vtkCamera* camera, double aspect, vtkGodRaysCompositor* compositor)
  : Columns(std::max(16, static_cast<int>(this->Rows * std::min(aspect, 64.0))))
  , ToClip(camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0))
  , Covered(static_cast<std::size_t>(this->Columns) * this->Rows)
{
  for (int i = 0; i < NumberOfDirections; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / NumberOfDirections;
    this->Directions.push_back({ std::cos(angle), std::sin(angle) });
  }
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    const vtkGodRaysRole role = vtkGodRaysGetRole(prop);
    if (!prop->GetVisibility() || role == vtkGodRaysRole::LIGHT || role == vtkGodRaysRole::IGNORED)
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      vtkProp* part = node->GetViewProp();
      if (auto actor = vtkActor::SafeDownCast(part))
      {
        this->DrawActor(actor, node->GetMatrix());
      }
      else if (auto volume = vtkVolume::SafeDownCast(part))
      {
        this->DrawVolume(volume, node->GetMatrix());
      }
      else if (auto slice = vtkImageSlice::SafeDownCast(part))
      {
        this->DrawSlice(slice, node->GetMatrix());
      }
    }
  }
  this->Join(compositor);
  this->CoveredCount = std::count(this->Covered.begin(), this->Covered.end(), 1);
}

//------------------------------------------------------------------------------
void vtkGodRaysSilhouette::Join(vtkGodRaysCompositor* compositor)
{
  if (compositor && compositor->IsDistributed())
  {
    std::vector<float> covered(this->Covered.begin(), this->Covered.end());
    compositor->Reduce(covered.data(), covered.size(), vtkGodRaysCompositor::GREATEST);
    std::transform(covered.begin(), covered.end(), this->Covered.begin(),
      [](float value) { return static_cast<unsigned char>(value > 0.0f); });
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysSilhouette::DrawActor(vtkActor* actor, vtkMatrix4x4* toWorld)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!actor->GetVisibility() || !mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  mapper->GetInputAlgorithm()->Update();
  auto splats = vtkPointGaussianMapper::SafeDownCast(mapper);
  const bool isSurface = !splats &&
    (vtkPolyDataMapper::SafeDownCast(mapper) || mapper->IsA("vtkDataSetMapper") ||
      mapper->IsA("vtkCompositePolyDataMapper"));
  const double radius = splats ? splats->GetScaleFactor() : 0.0;
  auto glyphs = vtkGlyph3DMapper::SafeDownCast(mapper);
  const auto draw = [&](vtkDataObject* object)
  {
    auto data = vtkDataSet::SafeDownCast(object);
    const auto boxes = glyphs && data ? vtkGodRaysMakeGlyphBoxes(glyphs, data) : nullptr;
    if (boxes)
    {
      this->DrawSurface(boxes, toWorld);
    }
    else if (auto surface = vtkPolyData::SafeDownCast(data))
    {
      isSurface ? this->DrawSurface(surface, toWorld) : this->DrawPoints(surface, toWorld, radius);
    }
    else if (data && isSurface)
    {
      vtkNew<vtkDataSetSurfaceFilter> surface;
      surface->SetInputData(data);
      surface->Update();
      this->DrawSurface(surface->GetOutput(), toWorld);
    }
    else if (data)
    {
      this->DrawPoints(data, toWorld, radius);
    }
    else if (auto graph = vtkGraph::SafeDownCast(object))
    {
      this->DrawGraph(graph, toWorld);
    }
  };
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    auto blocks = vtk::TakeSmartPointer(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      draw(blocks->GetCurrentDataObject());
    }
    return;
  }
  draw(input);
}

//------------------------------------------------------------------------------
// Of splats, and of glyphs that are too many to look at.
void vtkGodRaysSilhouette::DrawPoints(vtkDataSet* data, vtkMatrix4x4* toWorld, double radius)
{
  vtkNew<vtkMatrix4x4> matrix;
  vtkMatrix4x4::Multiply4x4(this->ToClip, toWorld, matrix);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    this->DrawBall(data->GetPoint(i), radius, matrix);
  }
}

//------------------------------------------------------------------------------
// Of a molecule, as balls and sticks: the mapper alone knows its atoms' radii.
void vtkGodRaysSilhouette::DrawGraph(vtkGraph* graph, vtkMatrix4x4* toWorld)
{
  vtkNew<vtkMatrix4x4> matrix;
  vtkMatrix4x4::Multiply4x4(this->ToClip, toWorld, matrix);
  double length = 0.0;
  const vtkIdType edges = graph->GetNumberOfEdges();
  for (vtkIdType i = 0; i < edges; ++i)
  {
    double ends[2][3];
    double pixels[2][2];
    graph->GetPoint(graph->GetSourceVertex(i), ends[0]);
    graph->GetPoint(graph->GetTargetVertex(i), ends[1]);
    length += std::sqrt(vtkMath::Distance2BetweenPoints(ends[0], ends[1])) / edges;
    if (this->Project(ends[0], matrix, pixels[0]) && this->Project(ends[1], matrix, pixels[1]))
    {
      this->DrawLine(pixels[0], pixels[1]);
    }
  }
  for (vtkIdType i = 0; i < graph->GetNumberOfVertices(); ++i)
  {
    double point[3];
    graph->GetPoint(i, point);
    this->DrawBall(point, BallOfBond * length, matrix);
  }
}

//------------------------------------------------------------------------------
// As a square of the ball's width in the picture, which is a cell at least.
void vtkGodRaysSilhouette::DrawBall(const double* center, double radius, vtkMatrix4x4* matrix)
{
  double pixel[2];
  if (!this->Project(center, matrix, pixel))
  {
    return;
  }
  double widest = 1.0;
  for (int i = 0; radius > 0.0 && i < 3; ++i)
  {
    double end[3] = { center[0], center[1], center[2] };
    double there[2];
    end[i] += radius;
    if (this->Project(end, matrix, there))
    {
      widest = std::max(widest, std::hypot(there[0] - pixel[0], there[1] - pixel[1]));
    }
  }
  this->DrawPoint(pixel, static_cast<int>(std::lround(std::min(widest, 1.0 * this->Rows))));
}

//------------------------------------------------------------------------------
bool vtkGodRaysSilhouette::Project(const double* point, vtkMatrix4x4* matrix, double pixel[2]) const
{
  double homogeneous[4] = { point[0], point[1], point[2], 1.0 };
  matrix->MultiplyPoint(homogeneous, homogeneous);
  if (homogeneous[3] <= 1e-9)
  {
    return false;
  }
  // Far outside is as good as outside, and keeps the numbers small.
  pixel[0] = std::clamp(homogeneous[0] / homogeneous[3], -9.0, 9.0);
  pixel[1] = std::clamp(homogeneous[1] / homogeneous[3], -9.0, 9.0);
  pixel[0] = 0.5 * (pixel[0] + 1.0) * this->Columns;
  pixel[1] = 0.5 * (pixel[1] + 1.0) * this->Rows;
  return true;
}

//------------------------------------------------------------------------------
void vtkGodRaysSilhouette::DrawSurface(vtkPolyData* surface, vtkMatrix4x4* toWorld)
{
  if (!surface || !surface->GetPoints())
  {
    return;
  }
  vtkNew<vtkMatrix4x4> matrix;
  vtkMatrix4x4::Multiply4x4(this->ToClip, toWorld, matrix);
  const vtkIdType count = surface->GetNumberOfPoints();
  std::vector<std::array<double, 2>> pixels(count);
  std::vector<char> inFront(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    surface->GetPoint(i, point);
    inFront[i] = this->Project(point, matrix, pixels[i].data());
  }
  const auto forEachCell = [](vtkCellArray* cells, auto&& draw)
  {
    auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      cell->GetCurrentCell(size, ids);
      draw(size, ids);
    }
  };
  const auto drawPoints = [&](vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (inFront[ids[i]])
      {
        this->DrawPoint(pixels[ids[i]].data(), 0);
      }
    }
  };
  const auto drawLine = [&](vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 1; i < size; ++i)
    {
      if (inFront[ids[i - 1]] && inFront[ids[i]])
      {
        this->DrawLine(pixels[ids[i - 1]].data(), pixels[ids[i]].data());
      }
    }
  };
  const auto drawTriangle = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  {
    if (inFront[a] && inFront[b] && inFront[c])
    {
      this->DrawTriangle(pixels[a].data(), pixels[b].data(), pixels[c].data());
    }
  };
  forEachCell(surface->GetVerts(), drawPoints);
  forEachCell(surface->GetLines(), drawLine);
  forEachCell(surface->GetPolys(),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      drawPoints(size, ids);
      for (vtkIdType i = 2; i < size; ++i)
      {
        drawTriangle(ids[0], ids[i - 1], ids[i]);
      }
    });
  forEachCell(surface->GetStrips(),
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 2; i < size; ++i)
      {
        drawTriangle(ids[i - 2], ids[i - 1], ids[i]);
      }
    });
}

//------------------------------------------------------------------------------
void vtkGodRaysSilhouette::DrawVolume(vtkVolume* volume, vtkMatrix4x4* toWorld)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  if (!volume->GetVisibility() || !mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  mapper->GetInputAlgorithm()->Update();
  auto image = vtkImageData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars)
  {
    return;
  }
  vtkNew<vtkMatrix4x4> matrix;
  vtkMatrix4x4::Multiply4x4(this->ToClip, toWorld, matrix);
  vtkPiecewiseFunction* opacity = volume->GetProperty()->GetScalarOpacity();
  constexpr double most = 64.0;
  constexpr double opaque = 0.1;
  int size[3];
  image->GetDimensions(size);
  int step[3];
  for (int i = 0; i < 3; ++i)
  {
    step[i] = static_cast<int>(std::ceil(size[i] / most));
  }
  for (int k = 0; k < size[2]; k += step[2])
  {
    for (int j = 0; j < size[1]; j += step[1])
    {
      for (int i = 0; i < size[0]; i += step[0])
      {
        const vtkIdType id =
          i + static_cast<vtkIdType>(size[0]) * (j + static_cast<vtkIdType>(size[1]) * k);
        double pixel[2];
        if (opacity->GetValue(scalars->GetComponent(id, 0)) > opaque &&
          this->Project(image->GetPoint(id), matrix, pixel))
        {
          this->DrawPoint(pixel, 2);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// As where its plane cuts the box of its image, which is a little larger than that: its faces are cut, too.
void vtkGodRaysSilhouette::DrawSlice(vtkImageSlice* slice, vtkMatrix4x4* toWorld)
{
  vtkImageMapper3D* mapper = slice->GetMapper();
  if (!slice->GetVisibility() || !mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  mapper->Update(); // its plane and its bounds need that, too
  vtkBoundingBox bounds(mapper->GetBounds());
  bounds.Inflate(1e-6 * bounds.GetDiagonalLength());
  double size[3];
  bounds.GetLengths(size);
  vtkNew<vtkImageData> box;
  box->SetDimensions(2, 2, 2);
  box->SetOrigin(bounds.GetMinPoint());
  box->SetSpacing(size);
  double coefficients[4];
  mapper->GetSlicePlaneInDataCoords(toWorld, coefficients);
  const double part = -coefficients[3] / vtkMath::Dot(coefficients, coefficients);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(coefficients);
  plane->SetOrigin(part * coefficients[0], part * coefficients[1], part * coefficients[2]);
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(box);
  cutter->SetCutFunction(plane);
  cutter->Update();
  this->DrawSurface(cutter->GetOutput(), toWorld);
}

//------------------------------------------------------------------------------
void vtkGodRaysSilhouette::DrawPoint(const double pixel[2], int radius)
{
  const int column = static_cast<int>(std::floor(pixel[0]));
  const int row = static_cast<int>(std::floor(pixel[1]));
  for (int y = std::max(row - radius, 0); y <= std::min(row + radius, this->Rows - 1); ++y)
  {
    for (int x = std::max(column - radius, 0); x <= std::min(column + radius, this->Columns - 1);
         ++x)
    {
      this->Covered[static_cast<std::size_t>(y) * this->Columns + x] = 1;
    }
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysSilhouette::DrawLine(const double a[2], const double b[2])
{
  const int steps = std::max(
    1, static_cast<int>(std::ceil(std::max(std::abs(b[0] - a[0]), std::abs(b[1] - a[1])))));
  for (int i = 0; i <= steps; ++i)
  {
    const double part = static_cast<double>(i) / steps;
    const double pixel[2] = { a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]) };
    this->DrawPoint(pixel, 0);
  }
}

//------------------------------------------------------------------------------
void vtkGodRaysSilhouette::DrawTriangle(const double a[2], const double b[2], const double c[2])
{
  const auto [left, right] = std::minmax({ a[0], b[0], c[0] });
  const auto [bottom, top] = std::minmax({ a[1], b[1], c[1] });
  const double area = GetSide(a, b, c[0], c[1]);
  if (area == 0.0)
  {
    return; // every place is on the right side of its edges
  }
  const int lastColumn = std::min(static_cast<int>(right), this->Columns - 1);
  const int lastRow = std::min(static_cast<int>(top), this->Rows - 1);
  for (int row = std::max(static_cast<int>(bottom), 0); row <= lastRow; ++row)
  {
    for (int column = std::max(static_cast<int>(left), 0); column <= lastColumn; ++column)
    {
      const double x = column + 0.5;
      const double y = row + 0.5;
      if (GetSide(a, b, x, y) * area >= 0.0 && GetSide(b, c, x, y) * area >= 0.0 &&
        GetSide(c, a, x, y) * area >= 0.0)
      {
        this->Covered[static_cast<std::size_t>(row) * this->Columns + column] = 1;
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkGodRaysSilhouette::IsCovered(double column, double row) const
{
  const int x = std::clamp(static_cast<int>(column), 0, this->Columns - 1);
  const int y = std::clamp(static_cast<int>(row), 0, this->Rows - 1);
  return this->Covered[static_cast<std::size_t>(y) * this->Columns + x] != 0;
}

//------------------------------------------------------------------------------
/**
 * Past what the light about a place goes in one direction, and what it falls on.
 */
vtkGodRaysSilhouette::Way vtkGodRaysSilhouette::Follow(
  double column, double row, const double direction[2]) const
{
  Way way;
  double light = 0.0;
  const double reach = GlowReach * std::min(this->Rows, this->Columns);
  for (double distance = 0.5;; distance += distance < reach ? 1.0 : 2.0)
  {
    const double x = column + distance * direction[0];
    const double y = row + distance * direction[1];
    if (x < 0.0 || y < 0.0 || x >= this->Columns || y >= this->Rows)
    {
      break;
    }
    const bool covered = this->IsCovered(x, y);
    const bool near = distance < reach;
    const double glow = near ? 1.0 - distance / reach : 0.0;
    const double step = near ? 1.0 : 2.0;
    light += glow;
    way.Light += covered ? 0.0 : glow;
    way.Data += covered ? std::max(glow, FarGlare) * distance * step : 0.0;
    way.Room += covered || near ? 0.0 : step / this->Rows;
  }
  way.Light /= std::max(light, 1.0);
  way.Room = std::min(way.Room, 1.0);
  return way;
}

//------------------------------------------------------------------------------
/**
 * How much the light that leaves a place varies with its direction, where the picture has room for
 * it, less the part of the data that it outshines. 0 if it does not vary.
 */
double vtkGodRaysSilhouette::GetScore(int column, int row) const
{
  double shafts = 0.0;
  double glare = 0.0;
  Way former = this->Follow(column + 0.5, row + 0.5, this->Directions.back().data());
  for (const auto& direction : this->Directions)
  {
    const Way way = this->Follow(column + 0.5, row + 0.5, direction.data());
    shafts += std::abs(way.Light - former.Light) * std::max(way.Room, former.Room);
    glare += way.Light * way.Data;
    former = way;
  }
  if (shafts < LeastShafts)
  {
    return 0.0; // in the open, or behind something
  }
  glare *= 2.0 * vtkMath::Pi() / static_cast<double>(this->Directions.size()) /
    static_cast<double>(std::max<std::ptrdiff_t>(this->CoveredCount, 1));
  const double x = 2.0 * (column + 0.5) / this->Columns - 1.0;
  const double y = 2.0 * (row + 0.5) / this->Rows - 1.0;
  const double offThird = std::min(std::abs(x - 0.33), std::abs(x + 0.33));
  const double score = ShaftsWeight * std::min(shafts, MostShafts) / MostShafts -
    GlareWeight * glare + 0.4 * (1.0 - offThird) + 0.3 * (1.0 - std::abs(y - 0.35));
  return std::max(score, 1e-3);
}

//------------------------------------------------------------------------------
double vtkGodRaysSilhouette::GetOpenness(double column, double row) const
{
  double light = 0.0;
  for (const auto& direction : this->Directions)
  {
    light += this->Follow(column, row, direction.data()).Light;
  }
  return light / static_cast<double>(this->Directions.size());
}

//------------------------------------------------------------------------------
/**
 * Where something hides a place, the one in all of the picture that is least hidden.
 */
void vtkGodRaysSilhouette::MoveIntoTheOpen(Place& place, double lowest) const
{
  constexpr double open = 0.2;
  constexpr int step = 4;
  double most = this->GetOpenness(place.X * this->Columns, place.Y * this->Rows);
  if (most >= open || this->CoveredCount == 0)
  {
    return;
  }
  for (int row = static_cast<int>(lowest * this->Rows); row < this->Rows; row += step)
  {
    for (int column = 0; column < this->Columns; column += step)
    {
      const double light = this->GetOpenness(column + 0.5, row + 0.5);
      if (light > most)
      {
        most = light;
        place.X = (column + 0.5) / this->Columns;
        place.Y = (row + 0.5) / this->Rows;
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkGodRaysSilhouette::Place vtkGodRaysSilhouette::FindSun(double lowest) const
{
  Place best;
  int bestColumn = 0;
  int bestRow = 0;
  const auto look = [&](int column, int row)
  {
    const double score = this->GetScore(column, row);
    if (score > best.Score)
    {
      best.Score = score;
      bestColumn = column;
      bestRow = row;
    }
  };
  constexpr int step = 3;
  const int firstRow = std::max(this->Rows / 4, static_cast<int>(lowest * this->Rows));
  for (int row = firstRow; row < this->Rows * 9 / 10; row += step)
  {
    for (int column = this->Columns / 8; column < this->Columns * 7 / 8; column += step)
    {
      look(column, row);
    }
  }
  const int middleColumn = bestColumn;
  const int middleRow = bestRow;
  for (int row = middleRow - step / 2; best.Score > 0.0 && row <= middleRow + step / 2; ++row)
  {
    for (int column = middleColumn - step / 2; column <= middleColumn + step / 2; ++column)
    {
      if (row >= firstRow)
      {
        look(column, row);
      }
    }
  }
  if (best.Score > 0.0)
  {
    best.X = (bestColumn + 0.5) / this->Columns;
    best.Y = (bestRow + 0.5) / this->Rows;
    return best;
  }
  best.Y = std::max(best.Y, lowest);
  this->MoveIntoTheOpen(best, lowest);
  return best;
}

//------------------------------------------------------------------------------
double vtkGodRaysSilhouette::GetCoveredFraction() const
{
  return this->CoveredCount / static_cast<double>(this->Covered.size());
}

//------------------------------------------------------------------------------
void vtkGodRaysSilhouette::GetCoveredBounds(double bounds[4]) const
{
  int box[4] = { this->Columns, 0, this->Rows, 0 };
  for (int row = 0; row < this->Rows; ++row)
  {
    for (int column = 0; column < this->Columns; ++column)
    {
      if (this->IsCovered(column, row))
      {
        box[0] = std::min(box[0], column);
        box[1] = std::max(box[1], column + 1);
        box[2] = std::min(box[2], row);
        box[3] = std::max(box[3], row + 1);
      }
    }
  }
  const bool isEmpty = this->CoveredCount == 0;
  for (int i = 0; i < 4; ++i)
  {
    const int all = i < 2 ? this->Columns : this->Rows;
    bounds[i] = isEmpty ? i % 2 : static_cast<double>(box[i]) / all;
  }
}
