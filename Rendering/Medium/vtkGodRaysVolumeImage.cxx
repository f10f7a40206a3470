// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVolumeImage.h"

#include "vtkAbstractMapper.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCharArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkResampleToImage.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
constexpr const char* Name = "data";

/// The data sets that data consist of, those of finer levels last.
std::vector<vtkDataSet*> GetParts(vtkDataObject* data)
{
  std::vector<vtkDataSet*> parts;
  const auto add = [&](vtkDataObject* each)
  {
    auto part = vtkDataSet::SafeDownCast(each);
    if (part && part->GetNumberOfCells() > 0)
    {
      parts.push_back(part);
    }
  };
  add(data);
  if (auto composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      add(iterator->GetCurrentDataObject());
    }
  }
  return parts;
}

vtkDataArray* GetArray(vtkDataSet* part, const char* name, bool ofCells)
{
  vtkDataSetAttributes* arrays = part->GetPointData();
  if (ofCells)
  {
    arrays = part->GetCellData();
  }
  return name && *name ? arrays->GetArray(name) : arrays->GetScalars();
}

/// The cells of a part that are not there; null if all are. Those that finer ones stand for are there where
/// these are in other parts, which count before it.
vtkSmartPointer<vtkUnsignedCharArray> FindHidden(vtkDataSet* part, bool alone)
{
  vtkUnsignedCharArray* ghosts = part->GetCellGhostArray();
  if (!ghosts)
  {
    return nullptr;
  }
  const int absent =
    vtkDataSetAttributes::HIDDENCELL | (alone ? vtkDataSetAttributes::REFINEDCELL : 0);
  auto hidden = vtkSmartPointer<vtkUnsignedCharArray>::New();
  hidden->SetName(vtkDataSetAttributes::GhostArrayName());
  hidden->SetNumberOfTuples(ghosts->GetNumberOfTuples());
  bool any = false;
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    const bool hides = (ghosts->GetValue(i) & absent) != 0;
    hidden->SetValue(i, hides ? vtkDataSetAttributes::HIDDENCELL : 0);
    any = any || hides;
  }
  return any ? hidden : nullptr;
}

/// At each point the mean of the cells about it that are not hidden; 0 where all are.
vtkSmartPointer<vtkDataArray> FindMeans(
  vtkDataSet* part, vtkDataArray* values, vtkUnsignedCharArray* hidden)
{
  auto means = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
  means->SetName(values->GetName());
  means->SetNumberOfTuples(part->GetNumberOfPoints());
  means->Fill(0.0);
  std::vector<int> counts(static_cast<std::size_t>(part->GetNumberOfPoints()), 0);
  vtkNew<vtkIdList> points;
  for (vtkIdType i = 0; i < part->GetNumberOfCells(); ++i)
  {
    if (hidden->GetValue(i) != 0)
    {
      continue;
    }
    part->GetCellPoints(i, points);
    const double value = values->GetComponent(i, 0);
    for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k)
    {
      const vtkIdType point = points->GetId(k);
      means->SetComponent(point, 0, means->GetComponent(point, 0) + value);
      ++counts[point];
    }
  }
  for (vtkIdType point = 0; point < part->GetNumberOfPoints(); ++point)
  {
    means->SetComponent(point, 0, means->GetComponent(point, 0) / std::max(counts[point], 1));
  }
  return means;
}

/// A data set with one array, at its points.
vtkSmartPointer<vtkDataSet> MakePart(
  vtkDataSet* part, vtkDataArray* array, bool ofCells, bool alone)
{
  auto slim = vtkSmartPointer<vtkDataSet>::Take(part->NewInstance());
  slim->CopyStructure(part);
  // A copy with a name of its own shares the numbers, but for whole ones: their means are none.
  vtkSmartPointer<vtkDataArray> named;
  if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE)
  {
    named.TakeReference(array->NewInstance());
    named->ShallowCopy(array);
  }
  else
  {
    named = vtkSmartPointer<vtkFloatArray>::New();
    named->DeepCopy(array);
  }
  named->SetName(Name);
  const auto hidden = FindHidden(part, alone);
  if (hidden)
  {
    slim->GetCellData()->AddArray(hidden);
  }
  if (!ofCells)
  {
    slim->GetPointData()->SetScalars(named);
    return slim;
  }
  if (hidden)
  {
    slim->GetPointData()->SetScalars(
      FindMeans(part, named, hidden)); // VTK's filter takes all cells
    return slim;
  }
  slim->GetCellData()->SetScalars(named);
  vtkNew<vtkCellDataToPointData> toPoints;
  toPoints->SetInputData(slim);
  toPoints->Update();
  return vtkDataSet::SafeDownCast(toPoints->GetOutput());
}

/// What data are at the centres of cells, of which every so many-th is taken, from the next on; it goes on in
/// the next part.
void AddSamples(vtkDataSet* part, vtkDataArray* array, bool ofCells, vtkIdType stride,
  vtkIdType& next, std::vector<vtkGodRaysVolumeImage::Sample>& samples)
{
  constexpr unsigned char absent = vtkDataSetAttributes::DUPLICATECELL |
    vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
  vtkUnsignedCharArray* ghosts = part->GetCellGhostArray();
  vtkNew<vtkGenericCell> cell;
  std::vector<double> weights;
  vtkIdType i = next;
  for (; i < part->GetNumberOfCells(); i += stride)
  {
    part->GetCell(i, cell);
    if (cell->GetCellDimension() != 3 || (ghosts && (ghosts->GetValue(i) & absent) != 0))
    {
      continue;
    }
    vtkGodRaysVolumeImage::Sample sample;
    double center[3];
    int piece = cell->GetParametricCenter(center);
    weights.assign(cell->GetNumberOfPoints(), 0.0);
    cell->EvaluateLocation(piece, center, sample.Place.data(), weights.data());
    sample.Value = ofCells ? array->GetComponent(i, 0) : 0.0;
    for (std::size_t k = 0; k < weights.size() && !ofCells; ++k)
    {
      sample.Value += weights[k] * array->GetComponent(cell->GetPointId(static_cast<int>(k)), 0);
    }
    samples.push_back(sample);
  }
  next = i - part->GetNumberOfCells();
}

/// Whether each point of an image is shown, and in a cell that is; empty if all are.
vtkGodRaysGridBits FindShown(vtkImageData* image)
{
  vtkUnsignedCharArray* cells = image->GetCellGhostArray();
  vtkUnsignedCharArray* points = image->GetPointGhostArray();
  if (!cells && !points)
  {
    return {};
  }
  const int* size = image->GetDimensions();
  const vtkIdType row = size[0];
  const vtkIdType slice = row * size[1];
  vtkGodRaysGridBits shown;
  shown.Resize(static_cast<std::size_t>(slice) * size[2], !cells);
  vtkIdType cell = 0;
  for (int k = 0; cells && k + 1 < size[2]; ++k)
  {
    for (int j = 0; j + 1 < size[1]; ++j)
    {
      for (int i = 0; i + 1 < size[0]; ++i, ++cell)
      {
        constexpr unsigned char absent =
          vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::HIDDENCELL;
        const vtkIdType first = k * slice + j * row + i;
        for (int corner = 0; corner < 8 && (cells->GetValue(cell) & absent) == 0; ++corner)
        {
          shown.Set(first + (corner & 1) + (corner >> 1 & 1) * row + (corner >> 2) * slice, true);
        }
      }
    }
  }
  for (vtkIdType i = 0; points && i < slice * size[2]; ++i)
  {
    if ((points->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT) != 0)
    {
      shown.Set(i, false);
    }
  }
  return shown;
}

/// The least distance of neighbours along each axis; false for cells that have no such axes.
bool FindSpacing(const std::vector<vtkDataSet*>& parts, double spacing[3])
{
  std::fill_n(spacing, 3, VTK_DOUBLE_MAX);
  for (vtkDataSet* part : parts)
  {
    if (auto image = vtkImageData::SafeDownCast(part))
    {
      for (int i = 0; i < 3; ++i)
      {
        spacing[i] = std::min(spacing[i], std::abs(image->GetSpacing()[i]));
      }
      continue;
    }
    auto grid = vtkRectilinearGrid::SafeDownCast(part);
    if (!grid)
    {
      return false;
    }
    vtkDataArray* places[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    for (int i = 0; i < 3; ++i)
    {
      for (vtkIdType k = 1; k < places[i]->GetNumberOfTuples(); ++k)
      {
        const double gap = std::abs(places[i]->GetTuple1(k) - places[i]->GetTuple1(k - 1));
        spacing[i] = gap > 0.0 ? std::min(spacing[i], gap) : spacing[i];
      }
    }
  }
  return true;
}
}

vtkMTimeType vtkGodRaysVolumeImage::GetTime(vtkDataObject* data)
{
  vtkMTimeType time = data->GetMTime();
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    for (vtkDataSet* part : GetParts(data))
    {
      time = std::max(time, part->GetMTime());
    }
  }
  return time;
}

std::string vtkGodRaysVolumeImage::Update(
  vtkAbstractVolumeMapper* mapper, int resolution, Component choice)
{
  this->Forget();
  vtkDataObject* input = mapper && mapper->GetNumberOfInputConnections(0) > 0
    ? mapper->GetInputDataObject(0, 0)
    : nullptr;
  const std::vector<vtkDataSet*> parts = input ? GetParts(input) : std::vector<vtkDataSet*>();
  if (parts.empty())
  {
    return "has no data of cells. Give its mapper a grid: an image, or a rectilinear, unstructured "
           "or AMR grid";
  }
  int ofCells = 0;
  vtkDataArray* scalars = nullptr;
  vtkDataSet* first = nullptr; // that has any
  vtkBoundingBox box;
  for (vtkDataSet* part : parts)
  {
    if (!scalars)
    {
      first = part;
      scalars = vtkAbstractMapper::GetScalars(part, mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), ofCells);
    }
    box.AddBounds(part->GetBounds());
  }
  if (!scalars || ofCells > 1)
  {
    return "has no scalars at its points or in its cells. Name an array that is there";
  }
  const char* name = scalars->GetName();
  if (parts.size() > 1 && !(name && *name))
  {
    return "has several parts whose scalars have no name. Name them alike";
  }
  auto image = vtkImageData::SafeDownCast(input);
  const bool isPart =
    image && ofCells == 0 && choice != ONLY && scalars->GetNumberOfComponents() > 1;
  if ((scalars->GetNumberOfComponents() != 1 && !isPart) || scalars->GetDataType() == VTK_BIT)
  {
    return "has scalars of " + std::to_string(scalars->GetNumberOfComponents()) +
      " components, or of bits. Make an array of one number each, as by vtkArrayCalculator or "
      "vtkImageExtractComponents";
  }
  for (vtkDataSet* part : parts)
  {
    vtkDataArray* array = part == first ? scalars : GetArray(part, name, ofCells != 0);
    const vtkIdType count = ofCells ? part->GetNumberOfCells() : part->GetNumberOfPoints();
    if (array && array->GetNumberOfTuples() != count)
    {
      return "has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
        std::to_string(count) + (ofCells ? " cells" : " points") + ". Give it one for each";
    }
  }
  const int* size = image ? image->GetDimensions() : nullptr;
  const bool flat = image ? size[0] < 2 || size[1] < 2 || size[2] < 2
                          : !(box.IsValid() && box.GetLength(0) > 0.0 && box.GetLength(1) > 0.0 &&
                              box.GetLength(2) > 0.0);
  if (flat)
  {
    return "has data of no volume. Give it a grid of at least 2 points along each axis";
  }
  if (image && static_cast<double>(image->GetNumberOfPoints()) > MostPoints)
  {
    return "has more than 1024 x 1024 x 1024 points. Take fewer, as by vtkImageResample or "
           "vtkExtractVOI";
  }
  if (image && !ofCells)
  {
    this->Resampled = nullptr;
    this->Data = nullptr;
    this->Samples.clear();
    this->Image = image;
    this->Scalars = scalars;
    if (isPart)
    {
      this->Part.TakeReference(vtkDataArray::CreateDataArray(scalars->GetDataType()));
      this->Part->SetNumberOfTuples(scalars->GetNumberOfTuples());
      this->Part->CopyComponent(
        0, scalars, choice == FIRST ? 0 : scalars->GetNumberOfComponents() - 1);
      this->Scalars = this->Part;
    }
    this->Shown = FindShown(image);
    return "";
  }
  const vtkMTimeType time = GetTime(input);
  if (!this->Resampled || this->Data != input || this->Time != time ||
    this->Array != (name ? name : "") || this->OfCells != (ofCells != 0) ||
    this->Resolution != resolution)
  {
    this->Resample(input, name, ofCells != 0, resolution);
    this->Data = input;
    this->Time = time;
    this->Array = name ? name : "";
    this->OfCells = ofCells != 0;
    this->Resolution = resolution;
  }
  if (this->Resampled->GetNumberOfPoints() < 8 || this->Samples.empty())
  {
    return "has no cells of three dimensions. Give it a grid of hexahedra, tetrahedra or the like";
  }
  this->Image = this->Resampled;
  this->Scalars = this->Resampled->GetPointData()->GetArray(Name);
  auto mask =
    vtkCharArray::SafeDownCast(this->Resampled->GetPointData()->GetArray("vtkValidPointMask"));
  if (mask)
  {
    const vtkIdType count = mask->GetNumberOfValues();
    this->Shown.Resize(static_cast<std::size_t>(count), true);
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Shown.Set(i, mask->GetValue(i) != 0);
    }
  }
  if (auto whole = parts.size() == 1 ? vtkImageData::SafeDownCast(parts[0]) : nullptr)
  {
    this->Shown = FindShown(whole); // also the only part of a composite
  }
  return this->Scalars ? "" : "could not be resampled. Resample it with vtkResampleToImage";
}

void vtkGodRaysVolumeImage::Resample(
  vtkDataObject* data, const char* name, bool ofCells, int resolution)
{
  const std::vector<vtkDataSet*> parts = GetParts(data);
  this->Samples.clear();
  vtkIdType cells = 0;
  vtkBoundingBox box;
  for (vtkDataSet* part : parts)
  {
    cells += part->GetNumberOfCells();
    box.AddBounds(part->GetBounds());
  }
  const vtkIdType stride = cells / MostSamples + 1;
  vtkIdType next = stride / 2;
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkSmartPointer<vtkDataSet> only;
  for (vtkDataSet* part : parts)
  {
    vtkDataArray* array = GetArray(part, name, ofCells);
    if (!array || array->GetNumberOfComponents() != 1)
    {
      continue;
    }
    AddSamples(part, array, ofCells, stride, next, this->Samples);
    only = MakePart(part, array, ofCells, parts.size() == 1);
    blocks->SetBlock(blocks->GetNumberOfBlocks(), only);
  }
  if (auto image = parts.size() == 1 ? vtkImageData::SafeDownCast(only) : nullptr)
  {
    this->Resampled = image;
    return;
  }
  double lengths[3];
  box.GetLengths(lengths);
  double spacing[3];
  if (!FindSpacing(parts, spacing))
  {
    std::fill_n(spacing, 3, box.GetMaxLength() / (resolution - 1));
  }
  int size[3];
  for (int i = 0; i < 3; ++i)
  {
    size[i] =
      1 + static_cast<int>(std::clamp(std::round(lengths[i] / spacing[i]), 1.0, resolution - 1.0));
  }
  vtkNew<vtkResampleToImage> resample;
  resample->SetInputDataObject(
    blocks->GetNumberOfBlocks() == 1 ? static_cast<vtkDataObject*>(only) : blocks);
  resample->SetSamplingDimensions(size);
  resample->Update();
  this->Resampled = resample->GetOutput();
}

void vtkGodRaysVolumeImage::Forget()
{
  this->Image = nullptr;
  this->Scalars = nullptr;
  this->Part = nullptr;
  this->Shown = vtkGodRaysGridBits();
}
