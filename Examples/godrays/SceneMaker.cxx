// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "Coloring.h"
#include "Failure.h"
#include "Outliers.h"
#include "UpAxis.h"
#include "Volumes.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourFilter.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGodRaysPass.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkImageMagnitude.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkStaticPointLocator.h"
#include "vtkVertexGlyphFilter.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
bool IsOfPoints(vtkPolyData* data)
{
  return data->GetNumberOfVerts() > 0 && data->GetNumberOfVerts() == data->GetNumberOfCells();
}

//------------------------------------------------------------------------------
/**
 * A radius with which spheres at the points of a surface cover it, and those of a sparse cloud are
 * to be seen.
 */
double ChooseRadius(vtkPolyData* cloud)
{
  // The sixth neighbour is 1.4 times as far as points of a surface are from each other.
  constexpr int neighbor = 6;
  constexpr double ofItsDistance = 0.35;
  constexpr vtkIdType enough = 1000;
  constexpr double least = 1e-3; // of the diagonal: a pixel
  constexpr double most = 0.02;
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(cloud);
  locator->BuildLocator();
  vtkNew<vtkIdList> nearest;
  std::vector<double> distances;
  const vtkIdType count = cloud->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; i += 1 + count / enough)
  {
    double point[3];
    cloud->GetPoint(i, point);
    locator->FindClosestNPoints(neighbor + 1, point, nearest);
    double other[3];
    cloud->GetPoint(nearest->GetId(nearest->GetNumberOfIds() - 1), other);
    distances.push_back(std::sqrt(vtkMath::Distance2BetweenPoints(point, other)));
  }
  const auto median = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), median, distances.end());
  const double length = cloud->GetLength();
  return length > 0.0 ? std::clamp(ofItsDistance * *median, least * length, most * length) : most;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyDataMapper> MakeSphereMapper(vtkPolyData* cloud)
{
  auto mapper = vtkSmartPointer<vtkOpenGLSphereMapper>::New();
  mapper->SetInputData(cloud);
  mapper->SetRadius(static_cast<float>(ChooseRadius(cloud)));
  return mapper;
}

//------------------------------------------------------------------------------
/**
 * Give voxels whose value is no number the lowest one, which is clear; infinite ones and outliers are kept
 * as the lowest or highest. False if there is no number at all.
 */
bool LeaveOutNonNumbers(vtkImageData* image, bool& hasOutliers)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  double range[2];
  hasOutliers = FindUsualRange(values, 0, range);
  if (range[0] > range[1])
  {
    return false;
  }
  const auto isFinite = [](double value) { return std::isfinite(value); };
  auto all = vtk::DataArrayValueRange<1>(values);
  if (hasOutliers || !std::all_of(all.begin(), all.end(), isFinite))
  {
    auto numbers = vtk::TakeSmartPointer(values->NewInstance());
    numbers->DeepCopy(values);
    for (auto&& value : vtk::DataArrayValueRange<1>(numbers.Get()))
    {
      const double number = value;
      value = std::isnan(number) ? range[0] : std::clamp(number, range[0], range[1]);
    }
    image->GetPointData()->SetScalars(numbers);
  }
  return true;
}

//------------------------------------------------------------------------------
/**
 * Makes props of files. Colours are given last, when the range of all values is known.
 */
class SceneMaker
{
public:
  explicit SceneMaker(const Options& options)
    : Settings(options)
    , Colors(options)
  {
  }

  void Add(const FileContents& file)
  {
    const vtkIdType before = this->Result.NumberOfCells + this->Result.NumberOfVoxels;
    for (const auto& data : file.DataSets)
    {
      this->AddDataSet(file, data);
    }
    for (const auto& actor : file.Actors)
    {
      auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
      if (data && IsOfPoints(data))
      {
        actor->SetMapper(MakeSphereMapper(data));
      }
      this->Result.NumberOfCells += actor->GetMapper()->GetInput()->GetNumberOfCells();
      this->Result.Props.emplace_back(actor);
    }
    if (this->Result.NumberOfCells + this->Result.NumberOfVoxels == before)
    {
      throw Failure(
        file.Path + ": holds nothing to draw; give a file with points and cells", Failure::File);
    }
  }

  Scene Finish(char up)
  {
    this->Colors.CheckFound();
    if (this->Settings.Isosurface && !this->HasIsosurface)
    {
      throw Failure("--isosurface: no file holds a 3-D image with values; leave it out");
    }
    for (Part& part : this->Parts)
    {
      if (part.Actor)
      {
        part.Choice = this->Colors.TellsNothing(part.Choice) ? ColorArray() : part.Choice;
        this->Colors.Apply(part.Choice, part.Actor);
      }
      else
      {
        this->ColorVolume(part);
      }
      const std::string name = part.Choice.GetName();
      auto& names = this->Result.Arrays;
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
      {
        names.push_back(name);
      }
    }
    this->SetAxes(up);
    this->StretchElevations();
    this->Measure();
    this->FindGround();
    return this->Result;
  }

private:
  struct Part
  {
    vtkActor* Actor = nullptr;
    vtkVolume* Volume = nullptr;
    ColorArray Choice;
  };

  //----------------------------------------------------------------------------
  void AddDataSet(const FileContents& file, vtkDataSet* data)
  {
    vtkSmartPointer<vtkImageData> picture = vtkImageData::SafeDownCast(data);
    int size[3] = {};
    this->Place = nullptr;
    if (picture)
    {
      picture->GetDimensions(size);
      picture = this->Straighten(picture);
      data = picture;
    }
    const ColorArray choice = picture ? this->Colors.Choose(data) : ColorArray();
    const bool isElevation = choice.Array && !choice.OfCells && size[2] == 1 && size[0] > 1 &&
      size[1] > 1 && choice.Array->GetNumberOfComponents() < 3;
    if (std::min({ size[0], size[1], size[2] }) > 1 && choice.Array && !choice.IsColor())
    {
      this->AddVolume(picture, choice);
    }
    else if (isElevation && !this->Settings.Flat)
    {
      this->AddElevation(file, picture, choice.Array);
    }
    else
    {
      this->AddSurface(data);
    }
  }

  //----------------------------------------------------------------------------
  /// Moves the directions of an image to the matrix of its props: VTK 9.1 neither shades volumes nor makes
  /// surfaces by those of images.
  vtkSmartPointer<vtkImageData> Straighten(vtkImageData* image)
  {
    if (image->GetDirectionMatrix()->IsIdentity())
    {
      return image;
    }
    this->Place = vtkSmartPointer<vtkMatrix4x4>::New();
    for (int i = 0; i < 9; ++i)
    {
      this->Place->SetElement(i / 3, i % 3, image->GetDirectionMatrix()->GetData()[i]);
      this->Place->SetElement(i / 3, 3, image->GetOrigin()[i / 3]);
    }
    auto straight = vtkSmartPointer<vtkImageData>::New();
    straight->ShallowCopy(image);
    straight->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);
    straight->SetOrigin(0, 0, 0);
    return straight;
  }

  //----------------------------------------------------------------------------
  void AddElevation(const FileContents& file, vtkImageData* picture, vtkDataArray* elevations)
  {
    double spacing[3];
    picture->GetSpacing(spacing);
    const bool pictureHasLengths = spacing[0] != 1.0 || spacing[1] != 1.0;
    bool hasOutliers = false;
    const auto unscaled = MakeElevationSurface(picture, elevations, file.Place, 1.0, hasOutliers);
    if (hasOutliers)
    {
      this->Result.Notes.push_back(file.Path + ": some heights cannot be, and are left out");
    }
    double bounds[6];
    unscaled->GetCellsBounds(bounds);
    const double scale = this->Settings.ElevationScale.value_or(ChooseElevationScale(
      bounds[5] - bounds[4], std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]),
      file.Place.Known || pictureHasLengths));
    this->Result.ElevationScale = scale;
    this->HasElevation = true;
    const auto surface = scale == 1.0
      ? unscaled
      : MakeElevationSurface(picture, elevations, file.Place, scale, hasOutliers);
    this->Colors.SetTerrain(
      surface->GetPointData()->GetScalars()->GetName(), !file.Place.Known && pictureHasLengths);
    this->AddPolyData(surface);
  }

  //----------------------------------------------------------------------------
  void AddSurface(vtkDataSet* data)
  {
    vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
    if (!surface)
    {
      vtkNew<vtkDataSetSurfaceFilter> filter;
      filter->SetInputData(data);
      filter->Update();
      surface = filter->GetOutput();
    }
    auto* points = vtkPointSet::SafeDownCast(data);
    if (surface->GetNumberOfCells() == 0 && points)
    {
      vtkNew<vtkVertexGlyphFilter> filter;
      filter->SetInputData(points);
      filter->Update();
      surface = filter->GetOutput();
    }
    const bool polygonsAlone = surface->GetNumberOfLines() == 0 && surface->GetNumberOfVerts() == 0;
    if (polygonsAlone && !surface->GetPointData()->GetNormals() &&
      !surface->GetCellData()->GetNormals())
    {
      vtkNew<vtkPolyDataNormals> filter;
      filter->SetInputData(surface);
      filter->SetFeatureAngle(30.0);
      filter->ConsistencyOff();
      filter->Update();
      surface = filter->GetOutput();
    }
    this->AddPolyData(surface);
  }

  //----------------------------------------------------------------------------
  void AddPolyData(vtkPolyData* surface)
  {
    const bool isSeen = IsOfPoints(surface) || surface->GetLength() > 0.0;
    if (surface->GetNumberOfCells() == 0 || !isSeen)
    {
      return;
    }
    this->Result.NumberOfCells += surface->GetNumberOfCells();
    vtkSmartPointer<vtkPolyDataMapper> mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(surface);
    if (IsOfPoints(surface))
    {
      mapper = MakeSphereMapper(surface);
    }
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    vtkProperty* property = actor->GetProperty();
    property->SetAmbient(0.05);
    property->SetSpecular(0.1);
    property->SetSpecularPower(15.0);
    property->SetPointSize(3.0);
    property->SetLineWidth(2.0);
    property->SetOpacity(this->Settings.Opacity);
    property->SetEdgeVisibility(this->Settings.Edges);
    const ColorArray choice = this->Colors.Choose(surface);
    double lengths[3];
    vtkBoundingBox(surface->GetBounds()).GetLengths(lengths);
    if (lengths[2] < Scene::LowestOfShapes * std::min(lengths[0], lengths[1]))
    {
      this->Colors.SetTerrain(choice.GetName(), true);
    }
    this->AddPart({ actor, nullptr, choice });
  }

  //----------------------------------------------------------------------------
  void AddVolume(vtkImageData* picture, ColorArray choice)
  {
    vtkSmartPointer<vtkImageData> image = vtkSmartPointer<vtkImageData>::New();
    image->ShallowCopy(picture);
    if (choice.OfCells)
    {
      vtkNew<vtkCellDataToPointData> filter;
      filter->SetInputData(image);
      filter->Update();
      image = vtkImageData::SafeDownCast(filter->GetOutput());
    }
    image->GetPointData()->SetActiveScalars(choice.GetName().c_str());
    if (choice.Array->GetNumberOfComponents() > 1)
    {
      vtkNew<vtkImageMagnitude> filter;
      filter->SetInputData(image);
      filter->Update();
      image = filter->GetOutput();
      image->GetPointData()->GetScalars()->SetName(choice.GetName().c_str());
    }
    if (this->Settings.Isosurface)
    {
      this->AddIsosurface(image, *this->Settings.Isosurface);
      return;
    }
    bool hasOutliers = false;
    if (!LeaveOutNonNumbers(image, hasOutliers))
    {
      return;
    }
    if (hasOutliers)
    {
      this->TellOfOutliers(choice);
    }
    vtkNew<vtkSmartVolumeMapper> mapper;
    mapper->SetInputData(image);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    if (this->Settings.VolumeMedium)
    {
      vtkGodRaysPass::SetRole(volume, vtkGodRaysPass::MEDIUM);
    }
    this->Result.NumberOfVoxels += image->GetNumberOfPoints();
    this->AddPart({ nullptr, volume, this->Colors.Choose(image) });
  }

  //----------------------------------------------------------------------------
  void AddIsosurface(vtkImageData* image, double value)
  {
    vtkNew<vtkContourFilter> filter;
    filter->SetInputData(image);
    filter->SetValue(0, value);
    filter->Update();
    if (filter->GetOutput()->GetNumberOfCells() == 0)
    {
      double range[2];
      image->GetScalarRange(range);
      throw Failure("--isosurface: nothing has the value " + std::to_string(value) +
        "; values are from " + std::to_string(range[0]) + " to " + std::to_string(range[1]));
    }
    this->HasIsosurface = true;
    this->AddPolyData(filter->GetOutput());
  }

  //----------------------------------------------------------------------------
  void ColorVolume(const Part& part)
  {
    double range[2];
    this->Colors.GetRange(part.Choice.GetName(), range);
    vtkNew<vtkPiecewiseFunction> opacity;
    const auto at = [&range](double part) { return range[0] + part * (range[1] - range[0]); };
    opacity->AddPoint(at(0.0), 0.0);
    if (!this->Settings.Window) // which says itself where values become of interest
    {
      opacity->AddPoint(at(0.3), 0.0);
      opacity->AddPoint(at(0.5), 0.25 * this->Settings.Opacity);
    }
    opacity->AddPoint(at(1.0), 0.9 * this->Settings.Opacity);
    vtkVolumeProperty* property = part.Volume->GetProperty();
    property->SetScalarOpacity(opacity);
    property->SetColor(this->Colors.MakeColors(part.Choice.GetName()));
    ApplyVolumePreset(this->Settings.VolumePreset, this->Settings.Opacity, property);
    property->SetInterpolationTypeToLinear();
    property->ShadeOn();
    property->SetScalarOpacityUnitDistance(part.Volume->GetLength() / 60.0);
  }

  //----------------------------------------------------------------------------
  void AddPart(const Part& part)
  {
    if (this->Colors.AddToRange(part.Choice))
    {
      this->TellOfOutliers(part.Choice);
    }
    this->Parts.push_back(part);
    this->Result.Props.emplace_back(part.Actor ? static_cast<vtkProp3D*>(part.Actor) : part.Volume);
    this->Result.Props.back()->SetUserMatrix(this->Place);
  }

  //----------------------------------------------------------------------------
  void TellOfOutliers(const ColorArray& choice)
  {
    const std::string note = choice.GetName() +
      ": some values are far beyond all others, and have no part in the range of the colours; "
      "--range gives another one";
    auto& notes = this->Result.Notes;
    if (!this->Settings.Range && std::find(notes.begin(), notes.end(), note) == notes.end())
    {
      notes.push_back(note);
    }
  }

  //----------------------------------------------------------------------------
  void SetAxes(char up)
  {
    const Vector3 x = { 1.0, 0.0, 0.0 };
    const Vector3 y = { 0.0, 1.0, 0.0 };
    const Vector3 z = { 0.0, 0.0, 1.0 };
    const std::array<Vector3, 3> axes = up == 'X' ? std::array{ y, z, x }
      : up == 'Y'                                 ? std::array{ x, Vector3{ 0.0, 0.0, -1.0 }, y }
                                                  : std::array{ x, y, z };
    this->Result.East = axes[0];
    this->Result.North = axes[1];
    this->Result.Up = axes[2];
  }

  //----------------------------------------------------------------------------
  void StretchElevations()
  {
    if (this->HasElevation || !this->Settings.ElevationScale)
    {
      return;
    }
    const double scale = *this->Settings.ElevationScale;
    this->Result.ElevationScale = scale;
    const Vector3& up = this->Result.Up;
    for (const auto& prop : this->Result.Props)
    {
      prop->SetScale(
        up[0] != 0.0 ? scale : 1.0, up[1] != 0.0 ? scale : 1.0, up[2] != 0.0 ? scale : 1.0);
    }
  }

  //----------------------------------------------------------------------------
  void FindGround()
  {
    const auto isGround = [this](const vtkSmartPointer<vtkProp3D>& prop)
    {
      auto* actor = vtkActor::SafeDownCast(prop);
      auto* surface = actor ? vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()) : nullptr;
      return surface && IsGround(surface, this->Result.Up);
    };
    const auto& props = this->Result.Props;
    this->Result.HasGround = this->HasElevation ||
      (this->Result.IsLow() && std::any_of(props.begin(), props.end(), isGround));
  }

  //----------------------------------------------------------------------------
  void Measure()
  {
    for (const auto& prop : this->Result.Props)
    {
      const double* bounds = prop->GetBounds();
      if (bounds && vtkMath::AreBoundsInitialized(bounds))
      {
        this->Result.Bounds.AddBounds(bounds);
      }
    }
    if (!this->Result.Bounds.IsValid())
    {
      throw Failure("nothing to draw; give files with points and cells");
    }
    double bounds[6];
    this->Result.Bounds.GetBounds(bounds);
    if (!std::all_of(bounds, bounds + 6, [](double value) { return std::isfinite(value); }) ||
      !std::isfinite(this->Result.Bounds.GetDiagonalLength()))
    {
      throw Failure("a coordinate is infinite or no number; write the file again");
    }
    if (this->Result.Bounds.GetMaxLength() > LargestSize ||
      *std::max_element(bounds, bounds + 6) > LargestSize ||
      *std::min_element(bounds, bounds + 6) < -LargestSize)
    {
      throw Failure(
        "a coordinate is beyond 1e14, too far for VTK's cameras; write the file again, or in a "
        "larger unit");
    }
    if (this->Result.Bounds.GetDiagonalLength() < LeastSize &&
      this->Result.Bounds.GetDiagonalLength() > 0.0)
    {
      throw Failure("all points lie within 1e-15 of each other, too near for VTK's cameras; write "
                    "the file in a smaller unit");
    }
  }

  static constexpr double LeastSize = 1e-15;
  static constexpr double LargestSize = 1e14;

  const Options& Settings;
  Coloring Colors;
  Scene Result;
  std::vector<Part> Parts;
  vtkSmartPointer<vtkMatrix4x4> Place; ///< of the image that is added, if it has directions
  bool HasElevation = false;
  bool HasIsosurface = false;
};
}

//------------------------------------------------------------------------------
Scene MakeScene(const std::vector<FileContents>& files, const Options& options)
{
  SceneMaker maker(options);
  for (const FileContents& file : files)
  {
    maker.Add(file);
  }
  return maker.Finish(options.Up ? options.Up : files.front().Up);
}
