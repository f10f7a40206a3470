// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Environment.h"

#include "Failure.h"
#include "Files.h"

#include "vtkActor.h"
#include "vtkGodRaysPass.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkSkybox.h"
#include "vtkTexture.h"

#include <algorithm>

namespace
{
constexpr double Roughness = 0.6; // a dull surface: the light is to be seen, not its picture
// As dull surfaces need: VTK's own take seconds where the processor draws.
constexpr int PrefilterSamples = 64;
constexpr int IrradianceSize = 32;
constexpr int TableSize = 128;
constexpr int TableSamples = 128;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> ReadEnvironment(const std::string& path)
{
  const auto image = ReadPicture("--hdri", path);
  if (image->GetScalarType() != VTK_FLOAT)
  {
    throw Failure("--hdri: " + path + " is no .hdr; give one", Failure::File);
  }
  int size[3];
  image->GetDimensions(size);
  if (size[0] != 2 * size[1])
  {
    throw Failure("--hdri: " + path + " has " + std::to_string(size[0]) + " x " +
        std::to_string(size[1]) +
        " pixels; give one of all directions, which is twice as wide as high",
      Failure::File);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetColorModeToDirectScalars();
  texture->MipmapOn();
  texture->InterpolateOn();
  return texture;
}
}

//------------------------------------------------------------------------------
void AddEnvironment(vtkRenderer* renderer, const Scene& scene, const std::string& path)
{
  const auto texture = ReadEnvironment(path);
  double up[3];
  double east[3];
  double north[3];
  std::copy(scene.Up.begin(), scene.Up.end(), up);
  std::copy(scene.East.begin(), scene.East.end(), east);
  vtkMath::Cross(up, east, north);
  renderer->SetEnvironmentTexture(texture);
  // The picture's middle is in the direction that VTK calls right, for its light, and from 9.6 on for the
  // background. Before that the background's middle is a quarter turn from what it calls right.
  renderer->SetEnvironmentUp(up);
  renderer->SetEnvironmentRight(north);
  renderer->UseImageBasedLightingOn();
  if (auto* drawn = vtkOpenGLRenderer::SafeDownCast(renderer))
  {
    drawn->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(PrefilterSamples);
    drawn->GetEnvMapIrradiance()->SetIrradianceSize(IrradianceSize);
    drawn->GetEnvMapLookupTable()->SetLUTSize(TableSize);
    drawn->GetEnvMapLookupTable()->SetLUTSamples(TableSamples);
  }
  for (const auto& prop : scene.Props)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (!actor || !actor->GetProperty()->GetLighting())
    {
      continue;
    }
    actor->GetProperty()->SetInterpolationToPBR();
    actor->GetProperty()->SetMetallic(0.0);
    actor->GetProperty()->SetRoughness(Roughness);
    // VTK takes colours for linear light there, raises the sum to 1 / 2.2, and leaves out actors' textures.
    actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
      "//VTK::Color::Impl\n  diffuseColor = pow(max(diffuseColor, vec3(0.0)), vec3(2.2));\n",
      false);
    if (vtkTexture* picture = actor->GetTexture())
    {
      picture->UseSRGBColorSpaceOn();
      actor->GetProperty()->SetBaseColorTexture(picture);
      actor->SetTexture(nullptr);
    }
  }
  vtkNew<vtkSkybox> box;
  box->SetProjectionToSphere();
  box->SetTexture(texture);
  box->SetFloorPlane(
    static_cast<float>(up[0]), static_cast<float>(up[1]), static_cast<float>(up[2]), 0.0F);
  box->SetFloorRight(
    static_cast<float>(east[0]), static_cast<float>(east[1]), static_cast<float>(east[2]));
  box->GammaCorrectOn();
  vtkGodRaysPass::SetRole(box, vtkGodRaysPass::IGNORED);
  renderer->AddActor(box);
}
