// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// How much memory a volume takes that is a medium of data.

#include "../Filters/GodRaysMemory.h"
#include "GodRaysMediumTesting.h"

#include "vtkGodRaysVolumeModel.h"

#include "vtkColorTransferFunction.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cstdlib>
#include <iostream>

using namespace GodRaysTesting;

namespace
{
using GodRaysVolumeMemory = MediumTest;

vtkSmartPointer<vtkImageData> MakeSlab(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetOrigin(-1.5, -1.5, -1.5);
  image->SetSpacing(3.0 / (n - 1), 3.0 / (n - 1), 3.0 / (n - 1));
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  const std::size_t count = static_cast<std::size_t>(n) * n * n;
  for (std::size_t i = 0; i < count; ++i)
  {
    values[i] = i / n % n < static_cast<std::size_t>(n) / 2 ? 0.5f : 0.0f;
  }
  return image;
}
}

//------------------------------------------------------------------------------
// Beside its image of floats a volume takes an eighth of that at most, with colours of its own and half of it
// cut off, while it is read and drawn, too. With GODRAYS_LONG: of 512^3 points.
TEST_F(GodRaysVolumeMemory, IsAnEighthOfTheData)
{
  const int n = std::getenv("GODRAYS_LONG") ? 512 : 256;
  this->Scene.Window->SetSize(64, 48);
  vtkNew<vtkGodRaysVolumeModel> alone;
  alone->SetFarLimit(30.0);
  this->Rays->SetModel(alone);
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetInputData(MakeSlab(24)); // threads, textures and shaders are there from now on
  mapper->CroppingOn();
  mapper->SetCroppingRegionPlanes(-9.0, 0.0, -9.0, 9.0, -9.0, 9.0);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(1.0, 0.5);
  volume->GetProperty()->SetScalarOpacity(opacities);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  colors->AddRGBPoint(1.0, 1.0, 0.5, 0.2);
  volume->GetProperty()->SetColor(colors);
  vtkGodRaysPass::SetRole(volume, vtkGodRaysPass::MEDIUM);
  this->Renderer->AddVolume(volume);
  this->SetLight({ 0.3, 1.0, 0.2, 0.0 });
  this->Scene.Window->Render();
  this->Scene.Window->Render();
  auto image = MakeSlab(n);
  mapper->SetInputData(image);
  const double before = GodRaysMemory::Start();
  if (before < 0.0)
  {
    GTEST_SKIP() << "there is no /proc/self/status";
  }
  this->Scene.Window->Render();
  const double after = GodRaysMemory::Get("VmRSS");
  const double most = GodRaysMemory::Get("VmHWM");
  EXPECT_TRUE(Says(this->Rays->GetPlan(), "data of 1 volumes")) << this->Rays->GetPlan();
  EXPECT_GT(GetMean(this->GetScattering()), 1e-4);
  const double data = static_cast<double>(image->GetNumberOfPoints()) * sizeof(float);
  std::cout << n << " points along an axis, " << data / 1048576.0
            << " MiB: " << (after - before) / data << " of the data's memory beside them, "
            << (most - before) / data << " at most\n";
  RecordProperty("part", std::to_string((most - before) / data));
  EXPECT_LE(most - before, data / 8.0);
  EXPECT_GE(after - before, data / 64.0); // the control: depths are kept
}
