// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A user of an example's window who is a program. Include it, then the example with its main() renamed
 * to ExampleMain.
 */

#ifndef ExampleUser_h
#define ExampleUser_h

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkGodRaysPass.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVersion.h"
#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

int ExampleMain(int argc, char* argv[]);

namespace
{
/// Has no event loop: Start() calls a function that sends the events.
class User : public vtkGenericRenderWindowInteractor
{
public:
  static User* New();
  vtkTypeMacro(User, vtkGenericRenderWindowInteractor);
  static std::function<void(User*)> Act;

  void Start() override { Act(this); }

  vtkRenderer* GetRenderer() { return this->RenderWindow->GetRenderers()->GetFirstRenderer(); }
  vtkGodRaysPass* GetRays() { return vtkGodRaysPass::SafeDownCast(this->GetRenderer()->GetPass()); }

  /// The name of the key, or null for one that has none.
  void Press(const char* key)
  {
    this->SetKeySym(key);
    this->InvokeEvent(vtkCommand::KeyPressEvent);
  }

  /// The light scattered into each pixel and colour, of the last frame; empty without rays.
  std::vector<float> GetLight()
  {
    vtkNew<vtkImageData> image;
    if (!this->GetRays()->GetScatteringImage(image))
    {
      return {};
    }
    auto values = static_cast<float*>(image->GetScalarPointer());
    return { values, values + 3 * image->GetNumberOfPoints() };
  }

  void Write(const char* file)
  {
    vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(this->RenderWindow);
    picture->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(picture->GetOutputPort());
    writer->SetFileName(file);
    writer->Write();
  }
};
vtkStandardNewMacro(User);
std::function<void(User*)> User::Act;

VTK_CREATE_CREATE_FUNCTION(User);

/// Makes all interactors users.
class UserFactory : public vtkObjectFactory
{
public:
  static UserFactory* New();
  vtkTypeMacro(UserFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "an interactor that a program acts on"; }

protected:
  UserFactory()
  {
    this->RegisterOverride(
      "vtkRenderWindowInteractor", "User", "a program acts", 1, vtkObjectFactoryCreateUser);
  }
};
vtkStandardNewMacro(UserFactory);

/// Run the example without a picture, and the user in its window.
inline void RunExample(std::function<void(User*)> act)
{
  vtkObjectFactory::SetAllEnableFlags(false, "vtkRenderWindowInteractor");
  vtkNew<UserFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);
  User::Act = std::move(act);
  std::string name = "example";
  std::string size = "400x300";
  char* arguments[] = { &name[0], &size[0], nullptr };
  EXPECT_EQ(ExampleMain(2, arguments), EXIT_SUCCESS);
  vtkObjectFactory::UnRegisterFactory(factory);
}

inline double GetSum(const std::vector<float>& light)
{
  return std::accumulate(light.begin(), light.end(), 0.0);
}
}

#endif
