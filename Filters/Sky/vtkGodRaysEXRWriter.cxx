// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysEXRWriter.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#ifdef GODRAYS_HAS_OPENEXR
#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#endif

#include <exception>
#include <list>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkGodRaysEXRWriter);

namespace
{
#ifdef GODRAYS_HAS_OPENEXR
// Why an image cannot be written, and what to do; empty if it can.
std::string FindFault(vtkImageData* image, const char* fileName)
{
  if (!fileName || !*fileName)
  {
    return "there is no file name. Set FileName.";
  }
  if (!image || image->GetNumberOfPoints() == 0)
  {
    return "there is no picture. Give vtkImageData with arrays of points as the input.";
  }
  const int slices = image->GetDimensions()[2];
  if (slices != 1)
  {
    return "the image has " + std::to_string(slices) +
      " slices. Extract one: vtkExtractVOI does that.";
  }
  return {};
}

// An image as OpenEXR takes it.
struct File
{
  Imf::Header Header;
  Imf::FrameBuffer Buffer;
  std::list<std::vector<float>> Pixels;

  File(int width, int height)
    : Header(width, height)
  {
  }

  // Rows from the top.
  void AddChannel(const std::string& name, vtkDataArray* array, int component, const int size[3])
  {
    this->Pixels.emplace_back(static_cast<std::size_t>(size[0]) * size[1]);
    std::vector<float>& pixels = this->Pixels.back();
    for (int y = 0; y < size[1]; ++y)
    {
      const vtkIdType row = static_cast<vtkIdType>(size[1] - 1 - y) * size[0];
      for (int x = 0; x < size[0]; ++x)
      {
        pixels[static_cast<std::size_t>(y) * size[0] + x] =
          static_cast<float>(array->GetComponent(row + x, component));
      }
    }
    this->Header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    this->Buffer.insert(name,
      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), sizeof(float),
        sizeof(float) * size[0]));
  }

  void AddArray(vtkDataArray* array, bool isScalars, const int size[3])
  {
    const int components = array->GetNumberOfComponents();
    const std::string name = array->GetName() ? array->GetName() : "";
    const bool isColor = components == 3 || components == 4;
    if ((components != 1 && !isColor) || (name.empty() && !isScalars))
    {
      return;
    }
    static const char* const colors[4] = { "R", "G", "B", "A" };
    for (int c = 0; c < components; ++c)
    {
      const std::string layer = isScalars ? "" : isColor ? name + "." : name;
      this->AddChannel(layer + (isColor ? colors[c] : isScalars ? "Y" : ""), array, c, size);
    }
    const char* unit =
      array->HasInformation() ? array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : nullptr;
    if (unit && !name.empty())
    {
      this->Header.insert((name + "_Unit").c_str(), Imf::StringAttribute(unit));
    }
  }

  void AddNumbers(vtkFieldData* fields)
  {
    for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = fields->GetArray(i);
      if (array && array->GetName() && array->GetNumberOfValues() == 1 &&
        this->Header.find(array->GetName()) == this->Header.end()) // else it is the format's own
      {
        this->Header.insert(
          array->GetName(), Imf::FloatAttribute(static_cast<float>(array->GetComponent(0, 0))));
      }
    }
  }
};
#endif
}

bool vtkGodRaysEXRWriter::IsAvailable()
{
#ifdef GODRAYS_HAS_OPENEXR
  return true;
#else
  return false;
#endif
}

void vtkGodRaysEXRWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
#ifndef GODRAYS_HAS_OPENEXR
  this->SetErrorCode(vtkErrorCode::UnrecognizedFileTypeError);
  vtkErrorMacro(
    "Cannot write a .exr file: this library was built without OpenEXR. Install it (Debian: "
    "libopenexr-dev) and build again, or write a .vti file with vtkXMLImageDataWriter.");
#else
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->UpdateWholeExtent();
  }
  vtkImageData* image = this->GetInput();
  const std::string fault = FindFault(image, this->FileName);
  if (!fault.empty())
  {
    this->SetErrorCode(this->FileName && *this->FileName ? vtkErrorCode::FileFormatError
                                                         : vtkErrorCode::NoFileNameError);
    vtkErrorMacro("Cannot write a .exr file: " << fault);
    return;
  }
  try
  {
    int size[3];
    image->GetDimensions(size);
    File file(size[0], size[1]);
    vtkPointData* arrays = image->GetPointData();
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      if (vtkDataArray* array = arrays->GetArray(i))
      {
        file.AddArray(array, array == arrays->GetScalars(), size);
      }
    }
    if (file.Pixels.empty())
    {
      this->SetErrorCode(vtkErrorCode::FileFormatError);
      vtkErrorMacro(
        "Cannot write a .exr file: no array has 1, 3 or 4 components. Give others as the input.");
      return;
    }
    file.AddNumbers(image->GetFieldData());
    Imf::OutputFile output(this->FileName, file.Header);
    output.setFrameBuffer(file.Buffer);
    output.writePixels(size[1]);
  }
  catch (const std::exception& failure)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro("Cannot write " << this->FileName << ": " << failure.what()
                                  << ". Is there such a folder, may it be written, is there room?");
  }
#endif
}
