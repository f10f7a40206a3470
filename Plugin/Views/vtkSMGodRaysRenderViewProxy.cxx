// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMGodRaysRenderViewProxy.h"

#include "vtkCommand.h"
#include "vtkGodRaysSun.h"
#include "vtkGodRaysSunInformation.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPVPluginLoader.h"
#include "vtkPVPluginTracker.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"
#include "vtkTextureObject.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cstring>
#include <string>

vtkStandardNewMacro(vtkSMGodRaysRenderViewProxy);

namespace
{
// Load the plugin GodRaysPanel, which needs Qt, from beside this one, if it was built and there is a window:
// only a program with a window has a stack of what can be undone.
void LoadPanel()
{
  if (!vtkSMProxyManager::GetProxyManager()->GetUndoStackBuilder())
  {
    return;
  }
  vtkPVPluginTracker* plugins = vtkPVPluginTracker::GetInstance();
  std::string file;
  for (unsigned int i = 0; i < plugins->GetNumberOfPlugins(); ++i)
  {
    const std::string name = plugins->GetPluginName(i);
    if (name == "GodRaysPanel" && plugins->GetPluginLoaded(i))
    {
      return;
    }
    if (name == "GodRays" && plugins->GetPluginLoaded(i))
    {
      file = plugins->GetPluginFileName(i); // <folder>/GodRays/GodRays.so
    }
  }
  const std::string folder = vtksys::SystemTools::GetFilenamePath(file);
  const std::string panel = vtksys::SystemTools::GetParentDirectory(folder) +
    "/GodRaysPanel/GodRaysPanel" + vtksys::SystemTools::GetFilenameLastExtension(file);
  if (!file.empty() && vtksys::SystemTools::FileExists(panel))
  {
    vtkNew<vtkPVPluginLoader> loader;
    loader->LoadPlugin(panel.c_str());
  }
}
}

vtkSMGodRaysRenderViewProxy::vtkSMGodRaysRenderViewProxy()
{
  this->AddObserver(
    vtkCommand::PropertyModifiedEvent, this, &vtkSMGodRaysRenderViewProxy::OnPropertyModified);
}

vtkSMGodRaysRenderViewProxy::~vtkSMGodRaysRenderViewProxy() = default;

void vtkSMGodRaysRenderViewProxy::OnPropertyModified(vtkObject*, unsigned long, void* name)
{
  for (const char* own : { "SunFrame", "SunPosition", "SunAzimuth", "SunElevation" })
  {
    if (name && std::strcmp(static_cast<const char*>(name), own) == 0 &&
      !this->GetProperty(own)->IsValueDefault())
    {
      vtkSMPropertyHelper(this, "PlaceSun").Set(0);
    }
  }
}

void vtkSMGodRaysRenderViewProxy::CreateVTKObjects()
{
  if (!this->ObjectsCreated && this->Location != 0) // 0: a prototype
  {
    LoadPanel();
  }
  this->Superclass::CreateVTKObjects();
}

void vtkSMGodRaysRenderViewProxy::PostRender(bool interactive)
{
  this->Superclass::PostRender(interactive);
  if (interactive || vtkSMPropertyHelper(this, "PlaceSun").GetAsInt() == 0)
  {
    return;
  }
  vtkNew<vtkGodRaysSunInformation> information;
  const double* sun = information->GetPlacedSun();
  information->CopyFromObject(vtkObject::SafeDownCast(this->GetClientSideObject()));
  if (sun[2] == 0.0) // by the server, if at all
  {
    this->GetSession()->GatherInformation(
      vtkPVSession::RENDER_SERVER_ROOT, information, this->GetGlobalID());
  }
  if (sun[2] != 0.0)
  {
    vtkSMPropertyHelper(this, "SunPosition").Set(vtkGodRaysSun::AZIMUTH_AND_ELEVATION);
    vtkSMPropertyHelper(this, "SunAzimuth").Set(sun[0]);
    vtkSMPropertyHelper(this, "SunElevation").Set(sun[1]);
    vtkSMPropertyHelper(this, "SunColor").Set(sun + 3, 3);
    vtkSMPropertyHelper(this, "PlaceSun").Set(0);
    this->UpdateVTKObjects();
  }
}

vtkImageData* vtkSMGodRaysRenderViewProxy::CaptureWindowInternal(
  int magnificationX, int magnificationY)
{
  if (magnificationX <= 1 && magnificationY <= 1)
  {
    return this->Superclass::CaptureWindowInternal(magnificationX, magnificationY);
  }
  int size[2] = { 0, 0 };
  vtkSMPropertyHelper viewSize(this, "ViewSize");
  viewSize.Get(size, 2);
  const int picture[2] = { size[0] * magnificationX, size[1] * magnificationY };
  auto window = vtkOpenGLRenderWindow::SafeDownCast(this->GetRenderWindow());
  if (window)
  {
    if (window->GetNeverRendered())
    {
      this->StillRender(); // only then has it an OpenGL context to ask
    }
    window->MakeCurrent();
  }
  const int largest = window ? vtkTextureObject::GetMaximumTextureSize(window) : 0;
  if (largest > 0 && std::max(picture[0], picture[1]) > largest)
  {
    vtkWarningMacro("The picture of " << picture[0] << " x " << picture[1]
                                      << " pixels is made of tiles, at whose edges rays end: "
                                      << "the graphics card draws at most " << largest
                                      << " pixels in one piece. Ask for a smaller one.");
    return this->Superclass::CaptureWindowInternal(magnificationX, magnificationY);
  }

  vtkSMPropertyHelper pixelsPerInch(this, "PPI", true);
  const int density = pixelsPerInch.GetAsInt();
  viewSize.Set(picture, 2);
  pixelsPerInch.Set(density * std::min(magnificationX, magnificationY));
  this->UpdateVTKObjects();
  vtkImageData* capture = this->Superclass::CaptureWindowInternal(1, 1);
  viewSize.Set(size, 2);
  pixelsPerInch.Set(density);
  this->UpdateVTKObjects();
  return capture;
}

void vtkSMGodRaysRenderViewProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
