// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Output.h"

#include "Failure.h"
#include "Temporary.h"

#include "vtkCallbackCommand.h"
#include "vtkGodRaysEXRWriter.h"
#include "vtkGodRaysPass.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRenderingOpenGLConfigure.h"
#include "vtkWindowToImageFilter.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <filesystem>
#include <unistd.h>

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
 * Whether a file can be written, for an option of this name.
 */
void CheckFile(
  const std::string& option, const std::string& path, const std::vector<std::string>& inputs)
{
  std::error_code error;
  const fs::path parent = fs::path(path).parent_path();
  const fs::path folder = parent.empty() ? fs::path(".") : parent;
  if (!fs::is_directory(folder, error))
  {
    throw Failure(
      option + ": there is no folder " + folder.string() + "; make it first, with mkdir -p");
  }
  if (fs::is_directory(path, error))
  {
    throw Failure(option + ": " + path + " is a directory; give the name of a file");
  }
  for (const fs::path& written : { folder, fs::path(path) })
  {
    if (fs::exists(written, error) && access(written.c_str(), W_OK) != 0)
    {
      throw Failure(option + ": " + written.string() +
        " may not be written; change its permissions, or write elsewhere");
    }
  }
  const bool isInput = std::any_of(inputs.begin(), inputs.end(),
    [&](const std::string& input) { return fs::equivalent(path, input, error); });
  if (isInput)
  {
    throw Failure(option + ": " + path + " is a file to be read; give it another name");
  }
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
  const fs::path part =
    final.parent_path() / ("." + std::to_string(getpid()) + "-" + final.filename().string());
  const Temporary temporary(part.string());
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
    throw Failure(option + ": " + path + " could not be written; is the disk full?");
  }
}

//------------------------------------------------------------------------------
/**
 * What the keys of the window change.
 */
struct Session
{
  vtkRenderWindow* Window;
  vtkRenderer* Renderer;
  vtkGodRaysPass* Rays;
  std::string Preset; // its name
  std::function<void(const ::Preset&)> SetPreset;
  bool Attached = true;

  void SwitchRays()
  {
    if (this->Attached)
    {
      this->Rays->Detach(this->Renderer);
    }
    else
    {
      this->Rays->Attach(this->Renderer);
    }
    this->Attached = !this->Attached;
  }

  void TakeNextPreset()
  {
    const auto& presets = GetPresets();
    const auto now = std::find_if(presets.begin(), presets.end(),
      [this](const ::Preset& preset) { return preset.Name == this->Preset; });
    const auto next = std::find_if(now == presets.end() ? now : now + 1, presets.end(),
      [](const ::Preset& preset) { return !preset.IsPublished; });
    const ::Preset& preset = next == presets.end() ? presets.front() : *next;
    this->Preset = preset.Name;
    this->SetPreset(preset);
    this->Window->SetWindowName(("godrays: " + preset.Name).c_str());
  }

  void ShowRaysAlone()
  {
    const bool alone = this->Rays->GetOutput() == vtkGodRaysPass::SCATTERING;
    this->Rays->SetOutput(alone ? vtkGodRaysPass::COMPOSITE : vtkGodRaysPass::SCATTERING);
  }

  void OnKey(char key)
  {
    switch (key)
    {
      case 'g':
      case 'G':
        this->SwitchRays();
        break;
      case 'n':
      case 'N':
        this->TakeNextPreset();
        break;
      case 'o':
      case 'O':
        this->ShowRaysAlone();
        break;
      default:
        return;
    }
    this->Window->Render();
  }
};
}

//------------------------------------------------------------------------------
void CheckOutput(const std::string& path, const std::vector<std::string>& inputs)
{
  const std::string extension = GetExtension(path);
  if (extension != ".png" && extension != ".jpg" && extension != ".jpeg")
  {
    throw Failure("--output: " + path + " should end in .png or .jpg");
  }
  CheckFile("--output", path, inputs);
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
  CheckFile("--numbers", path, inputs);
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
    throw Failure("there is no X display to draw on (DISPLAY is not set)" + remedy);
  }
  Display* display = XOpenDisplay(name);
  if (!display)
  {
    throw Failure("the X display " + std::string(name) + " cannot be opened" + remedy);
  }
  int numbers[3];
  const bool hasOpenGL = XQueryExtension(display, "GLX", numbers, numbers + 1, numbers + 2) != 0;
  XCloseDisplay(display);
  if (!hasOpenGL)
  {
    throw Failure("the X display " + std::string(name) + " has no OpenGL (GLX)" + remedy);
  }
#endif
}

//------------------------------------------------------------------------------
void WritePicture(vtkRenderWindow* window, const std::string& path)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkSmartPointer<vtkImageWriter> writer;
  if (GetExtension(path) == ".png")
  {
    writer = vtkSmartPointer<vtkPNGWriter>::New();
  }
  else
  {
    writer = vtkSmartPointer<vtkJPEGWriter>::New();
  }
  writer->SetInputConnection(picture->GetOutputPort());
  WriteWhole(writer.Get(), "--output", path);
}

//------------------------------------------------------------------------------
void WriteNumbers(
  vtkGodRaysPass* rays, const std::optional<Vector3>& irradiance, const std::string& path)
{
  vtkNew<vtkImageData> image;
  if (!(irradiance ? rays->GetMediumImage(image, irradiance->data()) : rays->GetMediumImage(image)))
  {
    throw Failure("--numbers: the picture has no light in a medium");
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
void Interact(vtkRenderWindow* window, vtkRenderer* renderer, vtkGodRaysPass* rays,
  const Preset& preset, const std::function<void(const Preset&)>& setPreset)
{
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  interactor->SetRenderWindow(window);
  Session session{ window, renderer, rays, preset.Name, setPreset, renderer->GetPass() == rays };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&session);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* session, void*)
    {
      static_cast<Session*>(session)->OnKey(
        static_cast<vtkRenderWindowInteractor*>(caller)->GetKeyCode());
    });
  interactor->AddObserver(vtkCommand::CharEvent, command);
  // Without this observer, VTK 9.1 closes the display at the end, while its loop still reads events.
  vtkNew<vtkCallbackCommand> end;
  end->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkRenderWindowInteractor*>(caller)->SetDone(true); });
  interactor->AddObserver(vtkCommand::ExitEvent, end);
  interactor->Initialize();
  interactor->Start();
  interactor->RemoveAllObservers();
}
