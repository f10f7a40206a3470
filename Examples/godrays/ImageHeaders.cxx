// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageHeaders.h"

#include "Failure.h"
#include "FileChecks.h"
#include "Vectors.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageFlip.h"
#include "vtkImageShiftScale.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

namespace
{
/// The steps between samples along the axes I, J and K.
using Axes = std::array<Vector3, 3>;

//------------------------------------------------------------------------------
/// Returns the fields of a text header, up to its end: an empty line, or the one that names the data.
std::map<std::string, std::string> ReadFields(
  const std::string& path, const std::string& separator, const std::string& last)
{
  std::map<std::string, std::string> fields;
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line) && !line.empty() && line != "\r";)
  {
    const auto end = line.find(separator);
    const auto name = line.substr(0, line.find_last_not_of(' ', end - 1) + 1);
    if (end != std::string::npos)
    {
      fields[name] = line.substr(end + separator.size());
    }
    if (name == last)
    {
      break;
    }
  }
  return fields;
}

//------------------------------------------------------------------------------
/// Returns the numbers of a text, whatever stands between them.
std::vector<double> ReadNumbers(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char letter) { return letter && std::strchr("(),", letter); },
    ' ');
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (*end == '\0')
    {
      numbers.push_back(number);
    }
  }
  return numbers;
}

//------------------------------------------------------------------------------
/// Returns the names below the line of a header that says LIST, one a line.
std::vector<std::string> ReadList(const std::string& path, const std::string& field)
{
  std::vector<std::string> names;
  std::ifstream file(path, std::ios::binary);
  bool isListed = false;
  for (std::string line; std::getline(file, line);)
  {
    line.resize(line.find_last_not_of(" \r") + 1);
    if (isListed)
    {
      names.push_back(line);
    }
    isListed = isListed || line.rfind(field, 0) == 0;
  }
  return names;
}

//------------------------------------------------------------------------------
/// Returns the names that a pattern such as slice%03d.raw stands for, with the first number, the last one and
/// the step behind it; or the one name that is no such pattern.
std::vector<std::string> ExpandPattern(const std::string& path, const std::string& text)
{
  const auto percent = text.find('%');
  const auto letter = text.find_first_not_of("0123456789", percent + 1);
  int range[3] = { 1, 1, 1 };
  if (percent == std::string::npos || letter == std::string::npos || text[letter] != 'd')
  {
    return { text };
  }
  const auto end = text.find(' ', letter);
  std::istringstream(end < text.size() ? text.substr(end) : "") >> range[0] >> range[1] >> range[2];
  constexpr int most = 100000;
  constexpr int largest = 1000000000;
  const std::string digits = text.substr(percent + 1, letter - percent - 1);
  const auto width = static_cast<std::size_t>(std::strtol(digits.c_str(), nullptr, 10));
  if (range[0] < 0 || range[1] > largest || range[2] < 1 || range[2] > largest ||
    range[1] / range[2] > most || width > most)
  {
    throw Failure(path + ": says a number of files that cannot be; write it again");
  }
  std::vector<std::string> names;
  for (int i = range[0]; i <= range[1]; i += range[2])
  {
    std::string number = std::to_string(i);
    const std::size_t missing = width - std::min(width, number.size());
    number.insert(0, missing, digits[0] == '0' ? '0' : ' ');
    names.push_back(text.substr(0, percent) + number + text.substr(letter + 1, end - letter - 1));
  }
  return names;
}

//------------------------------------------------------------------------------
/// Places an image of at least two samples along each axis.
vtkSmartPointer<vtkImageData> Place(
  const std::string& path, vtkImageData* read, Axes axes, Vector3 origin)
{
  vtkSmartPointer<vtkImageData> image = read;
  const int* size = image->GetDimensions();
  if (std::min({ size[0], size[1], size[2] }) < 2)
  {
    return image;
  }
  std::array<double, 3> spacing;
  double direction[3][3];
  for (int i = 0; i < 3; ++i)
  {
    spacing[i] = vtkMath::Norm(axes[i].data());
    for (int j = 0; j < 3; ++j)
    {
      direction[j][i] = axes[i][j] / spacing[i];
    }
  }
  double volume = vtkMath::Determinant3x3(direction);
  constexpr double least = 1e-6; // of a cube's
  if (!(std::fabs(volume) > least && std::fabs(volume) < 1.0 + least) ||
    !std::all_of(origin.begin(), origin.end(), [](double value) { return std::isfinite(value); }))
  {
    throw Failure(path + ": the directions or the origin in its header cannot be; write it again");
  }
  if (volume < 0.0)
  {
    vtkNew<vtkImageFlip> flip;
    flip->SetInputData(image);
    flip->SetFilteredAxis(2);
    flip->Update();
    image = flip->GetOutput();
    for (int j = 0; j < 3; ++j)
    {
      origin[j] += (size[2] - 1) * axes[2][j];
      direction[j][2] *= -1.0;
    }
  }
  image->SetSpacing(spacing.data());
  image->SetOrigin(origin.data());
  image->SetDirectionMatrix(&direction[0][0]);
  return image;
}

//------------------------------------------------------------------------------
/// Returns the image with its values times the slope, plus the intercept. Colours and slopes of 0, which say
/// that there is none, change nothing.
vtkSmartPointer<vtkImageData> Rescale(
  const std::string& path, vtkImageData* read, double slope, double intercept)
{
  if (slope == 0.0 || (slope == 1.0 && intercept == 0.0) || read->GetNumberOfScalarComponents() > 1)
  {
    return read;
  }
  if (!std::isfinite(slope) || !std::isfinite(intercept))
  {
    throw Failure(path + ": the slope or intercept in its header is no number; write it again");
  }
  vtkNew<vtkImageShiftScale> filter;
  filter->SetInputData(read);
  filter->SetShift(intercept / slope);
  filter->SetScale(slope);
  filter->SetOutputScalarType(read->GetScalarType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
  filter->Update();
  filter->GetOutput()->GetPointData()->GetScalars()->SetName(
    read->GetPointData()->GetScalars()->GetName());
  return filter->GetOutput();
}
}

//------------------------------------------------------------------------------
void CheckDataFiles(const std::string& path)
{
  auto fields = ReadFields(path, ": ", "data file");
  const std::string known[] = { "", "raw", "ascii", "txt", "text", "gzip", "gz" };
  std::string encoding;
  std::istringstream(fields["encoding"]) >> encoding;
  if (std::find(std::begin(known), std::end(known), encoding) == std::end(known))
  {
    throw Failure(path + ": has the encoding " + encoding +
      ", which VTK cannot read; save it with the encoding gzip or raw");
  }
  fields.merge(ReadFields(path, "=", "ElementDataFile"));
  for (const char* name : { "data file", "datafile", "ElementDataFile" })
  {
    std::istringstream words(fields[name]);
    std::string file;
    std::getline(words >> std::ws, file);
    file.resize(file.find_last_not_of(" \r") + 1);
    const bool isList = file.rfind("LIST", 0) == 0;
    for (const std::string& part : isList ? ReadList(path, name) : ExpandPattern(path, file))
    {
      if (!part.empty() && part != "LOCAL")
      {
        CheckRegular((std::filesystem::path(path).parent_path() / part).string());
      }
    }
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ApplyHeader(const std::string& path, vtkMetaImageReader* reader)
{
  const auto image =
    Rescale(path, reader->GetOutput(), reader->GetRescaleSlope(), reader->GetRescaleOffset());
  const auto fields = ReadFields(path, "=", "ElementDataFile");
  for (const char* name : { "TransformMatrix", "Rotation", "Orientation" })
  {
    const auto field = fields.find(name);
    const auto numbers = field != fields.end() ? ReadNumbers(field->second) : std::vector<double>();
    if (numbers.size() == 9)
    {
      Axes axes;
      for (int i = 0; i < 9; ++i)
      {
        axes[i / 3][i % 3] = numbers[i] * reader->GetDataSpacing()[i / 3];
      }
      const double* origin = reader->GetDataOrigin();
      return Place(path, image, axes, { origin[0], origin[1], origin[2] });
    }
  }
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ApplyHeader(const std::string& path, vtkNIFTIImageReader* reader)
{
  const auto image =
    Rescale(path, reader->GetOutput(), reader->GetRescaleSlope(), reader->GetRescaleIntercept());
  const vtkMatrix4x4* form =
    reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  if (!form)
  {
    return image;
  }
  Axes axes;
  Vector3 origin;
  for (int j = 0; j < 3; ++j)
  {
    const double sign = j < 2 ? -1.0 : 1.0; // NIfTI's x is to the right, and its y to the front
    for (int i = 0; i < 3; ++i)
    {
      axes[i][j] = sign * form->GetElement(j, i) * reader->GetDataSpacing()[i];
    }
    origin[j] = sign * form->GetElement(j, 3);
  }
  return Place(path, image, axes, origin);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> ApplyHeader(const std::string& path, vtkNrrdReader* reader)
{
  auto fields = ReadFields(path, ": ", "data file");
  const auto numbers = ReadNumbers(fields["space directions"]);
  auto origin = ReadNumbers(fields["space origin"]);
  origin.resize(3);
  if (numbers.size() != 9)
  {
    return reader->GetOutput();
  }
  const std::string& space = fields["space"];
  const auto says = [&space](const char* word) { return space.find(word) != std::string::npos; };
  const bool toRight = says("right-ant") || says("right-post") || says("RA") || says("RP");
  const bool toFront = says("anterior") || says("RA") || says("LA") || says("left-handed");
  Axes axes;
  for (int i = 0; i < 9; ++i)
  {
    const bool turns = (i % 3 == 0 && toRight) || (i % 3 == 1 && toFront);
    axes[i / 3][i % 3] = turns ? -numbers[i] : numbers[i];
  }
  origin[0] *= toRight ? -1.0 : 1.0;
  origin[1] *= toFront ? -1.0 : 1.0;
  if (!reader->GetFileLowerLeft() && fields["encoding"].find("raw") != std::string::npos)
  {
    // VTK reads the rows of raw data in left-handed spaces from the last to the first.
    for (int j = 0; j < 3; ++j)
    {
      origin[j] += (reader->GetOutput()->GetDimensions()[1] - 1) * axes[1][j];
      axes[1][j] *= -1.0;
    }
  }
  return Place(path, reader->GetOutput(), axes, { origin[0], origin[1], origin[2] });
}
