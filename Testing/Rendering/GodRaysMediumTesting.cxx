// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GodRaysMediumTesting.h"

namespace GodRaysTesting
{
//------------------------------------------------------------------------------
MediumTest::MediumTest()
{
  this->Model->SetScatteringCoefficient(0.05, 0.05, 0.05);
  this->Model->SetFarLimit(30.0);
  this->Rays->SetModel(this->Model);
  this->Rays->SetPrecision(vtkGodRaysPass::SINGLE);
  this->Rays->Attach(this->Renderer);
}

//------------------------------------------------------------------------------
void MediumTest::TearDown()
{
  for (const std::string& text : this->VTKMessages.Take())
  {
    EXPECT_TRUE(Says(text, "its optical depth across it is") || Says(text, "scatter nothing"))
      << text;
  }
}

//------------------------------------------------------------------------------
void MediumTest::AddPillars(double depth)
{
  for (int i = -3; i <= 3; ++i)
  {
    this->Renderer->AddActor(MakeBox({ 1.2 * i, 0.0, 0.0 }, { 0.5, 4.0, depth }));
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> MediumTest::AddSun(
  std::array<double, 3> towards, std::array<double, 3> color)
{
  auto sun = MakeSun(towards, color);
  this->Rays->AddLight(sun);
  return sun;
}

//------------------------------------------------------------------------------
void MediumTest::SetLight(std::array<double, 4> light)
{
  this->Rays->RemoveAllLights();
  this->Rays->AddLight(light[3] == 0.0 ? MakeSun({ light[0], light[1], light[2] })
                                       : MakeLamplight({ light[0], light[1], light[2] }));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MediumTest::GetScattering()
{
  this->Scene.Window->Render();
  auto image = vtkSmartPointer<vtkImageData>::New();
  EXPECT_TRUE(this->Rays->GetScatteringImage(image)) << this->Rays->GetPlan();
  return image;
}

//------------------------------------------------------------------------------
double MediumTest::GetError(std::array<double, 4> light)
{
  this->SetLight(light);
  return GetErrorOfMedium(this->Renderer, this->Model, light, this->GetScattering());
}

//------------------------------------------------------------------------------
void MediumTest::CheckErrors(const std::vector<Case>& cases)
{
  for (const Case& each : cases)
  {
    const double error = this->GetError(each.Light);
    std::cout << each.Name << ": " << error << "\n";
    RecordProperty(each.Name, std::to_string(error));
    EXPECT_LT(error, each.Bound) << each.Name;
    auto wrong = each.Light;
    wrong[0] += 0.2;
    wrong[2] += 0.2;
    const double control =
      GetErrorOfMedium(this->Renderer, this->Model, wrong, this->GetScattering());
    EXPECT_GT(control, 2.0 * each.Bound) << each.Name;
  }
}
}
