// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Output.h"

#include "Failure.h"
#include "Files.h"
#include "LinearPicture.h"
#include "System.h"
#include "Temporary.h"

#include "vtkGodRaysEXRWriter.h"
#include "vtkGodRaysHDRWriter.h"
#include "vtkGodRaysPass.h"
#include "vtkImageData.h"
#include "vtkImageDifference.h"
#include "vtkImageExtractComponents.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderingOpenGLConfigure.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>

#ifdef VTK_USE_X
#include <X11/Xlib.h>
#endif

namespace
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
std::string GetExtension(const std::string& path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

//------------------------------------------------------------------------------
/**
 * Write a file, for an option of this name: beside it at first, so that what is there is whole at any time.
 */
template <typename Writer>
void WriteWhole(Writer* writer, const std::string& option, const std::string& path)
{
  std::error_code error;
  const fs::path final = fs::weakly_canonical(path, error);
  const std::string part = Temporary::MakeNameBeside(path);
  const Temporary temporary(part);
  writer->SetFileName(part.c_str());
  writer->Write();
  const auto size = fs::file_size(part, error);
  bool isWritten = writer->GetErrorCode() == 0 && !error && size > 0;
  if (isWritten)
  {
    fs::rename(part, final, error);
    isWritten = !error;
  }
  if (!isWritten)
  {
    throw Failure(option + ": " + path + " could not be written; is the disk full?", Failure::File);
  }
}

//------------------------------------------------------------------------------
/**
 * Give rays before no background the opacity with which they look over black as they do here: of a
 * pixel, the brightest colour. Colours are as PNG has them, not multiplied by opacity.
 */
void SetOpacityOfRays(vtkImageData* picture)
{
  auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (vtkIdType i = 0; i < picture->GetNumberOfPoints(); ++i, pixel += 4)
  {
    const int opacity = *std::max_element(pixel, pixel + 4);
    for (int j = 0; j < 3 && opacity > 0; ++j)
    {
      pixel[j] = static_cast<unsigned char>((255 * pixel[j] + opacity / 2) / opacity);
    }
    pixel[3] = static_cast<unsigned char>(opacity);
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> TakePicture(vtkRenderWindow* window, bool transparent)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  if (transparent)
  {
    picture->SetInputBufferTypeToRGBA();
  }
  picture->Update();
  vtkSmartPointer<vtkImageData> result = picture->GetOutput();
  return result;
}

//------------------------------------------------------------------------------
void PrintPicture(vtkImageData* picture, std::FILE* file, const std::string& option)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  const auto size = static_cast<std::size_t>(bytes->GetNumberOfValues());
  if (std::fwrite(bytes->GetPointer(0), 1, size, file) != size || std::fflush(file) != 0)
  {
    throw Failure(option + ": the picture could not be written", Failure::File);
  }
}

//------------------------------------------------------------------------------
void CheckPictureName(const std::string& path, bool transparent)
{
  const std::string extension = GetExtension(path);
  const std::string types = " .png .jpg .jpeg .exr .hdr ";
  if (path != "-" && (extension.empty() || types.find(" " + extension + " ") == std::string::npos))
  {
    throw Failure("--output: " + path +
      " should end in .png, .jpg, .exr or .hdr, or be - for a PNG to the standard output");
  }
  if (extension == ".exr" && !vtkGodRaysEXRWriter::IsAvailable())
  {
    throw Failure("--output: the library was built without OpenEXR; give a name that ends in .hdr");
  }
  if (transparent && path != "-" && extension != ".png" && extension != ".exr")
  {
    throw Failure("--transparent: a " + extension +
      " has no opacity; give --output a name that ends in .png or .exr");
  }
}

//------------------------------------------------------------------------------
void CheckOutput(
  const std::string& option, const std::string& path, const std::vector<std::string>& inputs)
{
  std::error_code error;
  const fs::path parent = fs::path(path).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder, error))
  {
    throw Failure(
      option + ": there is no folder " + folder.string() + "; make it first, with mkdir -p",
      Failure::File);
  }
  const fs::file_status status = fs::status(path, error);
  if (error && status.type() != fs::file_type::not_found)
  {
    throw Failure(option + ": " + path + " cannot be: " + error.message(), Failure::File);
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw Failure(option + ": " + path + " is a directory or a device; give the name of a file" +
        (option == "--output" ? ", or - for the standard output" : ""),
      Failure::File);
  }
  for (const fs::path& written : { folder, fs::path(path) })
  {
    if (fs::exists(written, error) && !System::Has(System::MayWrite, written))
    {
      throw Failure(option + ": " + written.string() +
          " may not be written; change its permissions, or write elsewhere",
        Failure::File);
    }
  }
  for (const std::string& input : inputs)
  {
    if (fs::equivalent(path, input, error))
    {
      throw Failure(option + ": " + path + " is a file to be read; give the picture another name",
        Failure::File);
    }
  }
}

//------------------------------------------------------------------------------
void CheckNumbers(const std::string& path, const std::vector<std::string>& inputs)
{
  const std::string extension = GetExtension(path);
  if (extension != ".vti" && extension != ".exr")
  {
    throw Failure("--numbers: " + path + " should end in .vti or .exr");
  }
  if (extension == ".exr" && !vtkGodRaysEXRWriter::IsAvailable())
  {
    throw Failure(
      "--numbers: the library was built without OpenEXR; give a name that ends in .vti");
  }
  CheckOutput("--numbers", path, inputs);
}

//------------------------------------------------------------------------------
void CheckDisplay()
{
#ifdef VTK_USE_X
  const char* name = std::getenv("DISPLAY");
  const std::string remedy =
    "; run the program in a desktop session, or under xvfb-run -a -s \"-screen 0 1280x1024x24 "
    "-noreset\"";
  if (!name || !*name)
  {
    throw Failure(
      "there is no X display to draw on (DISPLAY is not set)" + remedy, Failure::Display);
  }
  // Held until the program ends: a server without -noreset resets when its last connection is closed, as
  // between two windows of VTK, and refuses further ones meanwhile.
  static Display* display = nullptr;
  for (int attempt = 0; !display && attempt < 20; ++attempt)
  {
    if (attempt > 0)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(50)); // it may reset just now
    }
    display = XOpenDisplay(name);
  }
  if (!display)
  {
    throw Failure(
      "the X display " + std::string(name) + " cannot be opened" + remedy, Failure::Display);
  }
  int numbers[3];
  const bool hasOpenGL = XQueryExtension(display, "GLX", numbers, numbers + 1, numbers + 2) != 0;
  if (!hasOpenGL)
  {
    throw Failure(
      "the X display " + std::string(name) + " has no OpenGL (GLX)" + remedy, Failure::Display);
  }
#endif
}

//------------------------------------------------------------------------------
void WritePicture(vtkRenderWindow* window, const std::string& path, bool transparent)
{
  const std::string extension = GetExtension(path);
  if (extension == ".exr" || extension == ".hdr")
  {
    vtkSmartPointer<vtkImageWriter> writer;
    if (extension == ".exr")
    {
      writer = vtkSmartPointer<vtkGodRaysEXRWriter>::New();
    }
    else
    {
      writer = vtkSmartPointer<vtkGodRaysHDRWriter>::New();
    }
    writer->SetInputData(TakeLinearPicture(window, transparent));
    WriteWhole(writer.Get(), "--output", path);
    return;
  }
  const bool isPng = path == "-" || extension == ".png";
  const auto picture = TakePicture(window, transparent);
  if (transparent)
  {
    SetOpacityOfRays(picture);
  }
  if (path == "-")
  {
    PrintPicture(picture, stdout, "--output");
    return;
  }
  vtkSmartPointer<vtkImageWriter> writer;
  if (isPng)
  {
    writer = vtkSmartPointer<vtkPNGWriter>::New();
  }
  else
  {
    writer = vtkSmartPointer<vtkJPEGWriter>::New();
  }
  writer->SetInputData(picture);
  WriteWhole(writer.Get(), "--output", path);
}

//------------------------------------------------------------------------------
void WriteNumbers(
  vtkGodRaysPass* rays, const std::optional<Vector3>& irradiance, const std::string& path)
{
  vtkNew<vtkImageData> image;
  if (!(irradiance ? rays->GetMediumImage(image, irradiance->data()) : rays->GetMediumImage(image)))
  {
    throw Failure(
      "--numbers: the picture has no light in a medium; give a --preset that is one, such as fog");
  }
  if (GetExtension(path) == ".exr")
  {
    vtkNew<vtkGodRaysEXRWriter> writer;
    writer->SetInputData(image);
    WriteWhole(writer.Get(), "--numbers", path);
    return;
  }
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetDataModeToBinary(); // some readers take no appended data
  writer->SetInputData(image);
  WriteWhole(writer.Get(), "--numbers", path);
}

//------------------------------------------------------------------------------
double CompareWithReference(vtkRenderWindow* window, const std::string& path)
{
  const auto reference = ReadPicture("--reference", path);
  const auto picture = TakePicture(window, false);
  int sizes[2][3];
  reference->GetDimensions(sizes[0]);
  picture->GetDimensions(sizes[1]);
  if (!std::equal(sizes[0], sizes[0] + 3, sizes[1]) ||
    reference->GetScalarType() != VTK_UNSIGNED_CHAR || reference->GetNumberOfScalarComponents() < 3)
  {
    throw Failure("--reference: " + path + " has " + std::to_string(sizes[0][0]) + " x " +
        std::to_string(sizes[0][1]) + " pixels, the picture " + std::to_string(sizes[1][0]) +
        " x " + std::to_string(sizes[1][1]) +
        " of three colours in bytes; give --size, or another file",
      Failure::Difference);
  }
  vtkNew<vtkImageExtractComponents> colors; // without opacity
  colors->SetInputData(reference);
  colors->SetComponents(0, 1, 2);
  colors->Update();
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(picture);
  difference->SetImageConnection(colors->GetOutputPort());
  difference->Update();
  return difference->GetThresholdedError();
}
