// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlyStrips.h"

#include "Failure.h"

#include "vtkCellArray.h"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace
{
/// One value of an element, or a list of them.
struct Property
{
  std::string CountType; ///< of a list; empty for one value
  std::string Type;
  std::string Name;
};

/// Things of one kind: vertices, faces, strips.
struct Element
{
  std::string Name;
  std::uint64_t Number = 0;
  std::vector<Property> Properties;
};

//------------------------------------------------------------------------------
std::size_t GetSize(const std::string& type)
{
  static const std::map<std::string, std::size_t> sizes = { { "char", 1 }, { "int8", 1 },
    { "uchar", 1 }, { "uint8", 1 }, { "short", 2 }, { "int16", 2 }, { "ushort", 2 },
    { "uint16", 2 }, { "int", 4 }, { "int32", 4 }, { "uint", 4 }, { "uint32", 4 }, { "float", 4 },
    { "float32", 4 }, { "double", 8 }, { "float64", 8 } };
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

//------------------------------------------------------------------------------
class StripReader
{
public:
  explicit StripReader(const std::string& path)
    : Path(path)
    , File(path, std::ios::binary)
  {
  }

  vtkSmartPointer<vtkCellArray> Read()
  {
    this->ReadHeader();
    bool isWanted = false;
    for (const Element& element : this->Elements)
    {
      isWanted = isWanted || element.Name == "tristrips";
    }
    for (std::size_t i = 0; isWanted && i < this->Elements.size(); ++i)
    {
      const Element& element = this->Elements[i];
      for (std::uint64_t j = 0; !element.Properties.empty() && j < element.Number; ++j)
      {
        this->ReadElement(element);
      }
    }
    return this->Strips;
  }

private:
  //----------------------------------------------------------------------------
  void ReadHeader()
  {
    std::string line;
    while (std::getline(this->File, line) && line.rfind("end_header", 0) != 0)
    {
      std::istringstream words(line);
      std::string word;
      words >> word;
      if (word == "format")
      {
        words >> word;
        this->IsText = word == "ascii";
        this->IsBigEndian = word == "binary_big_endian";
      }
      else if (word == "element")
      {
        Element element;
        words >> element.Name >> element.Number;
        this->Elements.push_back(element);
      }
      else if (word == "property" && !this->Elements.empty())
      {
        Property property;
        words >> property.Type;
        if (property.Type == "list")
        {
          words >> property.CountType >> property.Type;
        }
        words >> property.Name;
        this->Elements.back().Properties.push_back(property);
      }
    }
  }

  //----------------------------------------------------------------------------
  void ReadElement(const Element& element)
  {
    for (const Property& property : element.Properties)
    {
      const bool isList = !property.CountType.empty();
      const std::int64_t count = isList ? this->ReadValue(property.CountType) : 1;
      const bool isStrips = element.Name == "tristrips" && isList &&
        (property.Name == "vertex_indices" || property.Name == "vertex_index");
      for (std::int64_t i = 0; i < count; ++i)
      {
        const std::int64_t value = this->ReadValue(property.Type);
        if (isStrips)
        {
          this->AddPoint(value);
        }
      }
      if (isStrips)
      {
        this->AddPoint(-1);
      }
    }
  }

  //----------------------------------------------------------------------------
  /// The next value, if it is an integer; of others, something.
  std::int64_t ReadValue(const std::string& type)
  {
    const std::size_t size = GetSize(type);
    std::int64_t value = 0;
    if (size == 0)
    {
      throw Failure(this->Path + ": has values of an unknown type, '" + type + "'; write it again");
    }
    if (this->IsText)
    {
      double number = 0.0;
      this->File >> number;
      value = std::abs(number) < 1e15 ? static_cast<std::int64_t>(number) : 0;
    }
    else
    {
      char bytes[8] = {};
      this->File.read(bytes, static_cast<std::streamsize>(size));
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < size; ++i)
      {
        const char byte = bytes[this->IsBigEndian ? i : size - 1 - i];
        bits = bits << 8 | static_cast<unsigned char>(byte);
      }
      const bool isNegative = type.front() != 'u' && size < 8 && bits >> (8 * size - 1) != 0;
      value = static_cast<std::int64_t>(isNegative ? bits | ~std::uint64_t(0) << 8 * size : bits);
    }
    if (!this->File)
    {
      throw Failure(this->Path + ": ends before its triangle strips do; copy it again");
    }
    return value;
  }

  //----------------------------------------------------------------------------
  /// A negative number ends a strip.
  void AddPoint(std::int64_t point)
  {
    if (point >= 0)
    {
      this->Strip.push_back(point);
      return;
    }
    if (this->Strip.size() > 2)
    {
      this->Strips->InsertNextCell(static_cast<vtkIdType>(this->Strip.size()), this->Strip.data());
    }
    this->Strip.clear();
  }

  std::string Path;
  std::ifstream File;
  bool IsText = false;
  bool IsBigEndian = false;
  std::vector<Element> Elements;
  std::vector<vtkIdType> Strip;
  vtkSmartPointer<vtkCellArray> Strips = vtkSmartPointer<vtkCellArray>::New();
};
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> ReadPlyStrips(const std::string& path)
{
  return StripReader(path).Read();
}
