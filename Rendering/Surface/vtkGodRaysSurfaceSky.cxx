// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSurfaceSky.h"

#include "vtkCamera.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysSurfaceSkyFS.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkGodRaysSurfaceSky);

namespace
{
/// The sky that shines at this moment. A prop of several renderers has the pass of each, and one text in its
/// shader; these are its numbers.
thread_local const float* Shining = nullptr;

constexpr float Night[27] = {};
}

void vtkGodRaysSurfaceSky::Begin(vtkRenderer* renderer, const Request& request)
{
  this->TakeProps(renderer->GetViewProps());
  // n of the frame is A^T n of the camera, where A turns; it may mirror, too.
  double axes[3][3]; // east, north, up
  vtkMath::Cross(request.North, request.Up, axes[0]);
  std::copy_n(request.Up, 3, axes[2]);
  vtkMath::Normalize(axes[0]);
  vtkMath::Normalize(axes[2]);
  vtkMath::Cross(axes[2], axes[0], axes[1]);
  vtkMatrix4x4* view = renderer->GetActiveCamera()->GetViewTransformMatrix();
  const double scale = std::cbrt(std::abs(view->Determinant()));
  vtkNew<vtkMatrix4x4> turn;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      double along = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        along += view->GetElement(i, k) * axes[j][k] / scale;
      }
      turn->SetElement(i, j, along);
    }
  }
  vtkNew<vtkMatrix4x4> back;
  vtkMatrix4x4::Transpose(turn, back);
  double squares[16]; // the identity, but where the view scales by different factors
  vtkMatrix4x4::Multiply4x4(turn->GetData(), back->GetData(), squares);
  const double uneven = std::abs(squares[0] - squares[5]) + std::abs(squares[0] - squares[10]) +
    std::abs(squares[1]) + std::abs(squares[2]) + std::abs(squares[6]);
  if (uneven > 0.01 && !this->HasWarned)
  {
    this->HasWarned = true;
    vtkWarningMacro("Light of the sky on surfaces is not exact: the camera's user view transform "
                    "scales by different factors. Scale the scene's actors in its place.");
  }
  for (int c = 0; c < 3; ++c)
  {
    double half[16];
    double form[16];
    vtkMatrix4x4::Multiply4x4(turn->GetData(), request.Forms + 16 * c, half);
    vtkMatrix4x4::Multiply4x4(half, back->GetData(), form);
    const double factors[9] = { form[15] + form[10], 2.0 * form[3], 2.0 * form[7], 2.0 * form[11],
      2.0 * form[1], 2.0 * form[6], 2.0 * form[2], form[0] - form[10], form[5] - form[10] };
    for (int i = 0; i < 9; ++i)
    {
      this->Factors[3 * i + c] = static_cast<float>(request.Gain[c] * factors[i]);
    }
  }
  Shining = this->Factors;
}

void vtkGodRaysSurfaceSky::End()
{
  Shining = nullptr;
}

// Marks of our own: mappers fill in their tags and leave these.
bool vtkGodRaysSurfaceSky::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  if (fragmentShader.find("//VTK::GodRays::SkyDec") == std::string::npos)
  {
    vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::Light::Dec", "//VTK::Light::Dec\n//VTK::GodRays::SkyDec\n", false);
    vtkShaderProgram::Substitute(
      fragmentShader, "//VTK::Light::Impl", "//VTK::Light::Impl\n//VTK::GodRays::SkyImpl\n", false);
  }
  return true;
}

bool vtkGodRaysSurfaceSky::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  const auto has = [&](const std::string& text)
  { return fragmentShader.find(text) != std::string::npos; };
  std::string light;
  if (has("vec3 F0 = ") && has("1.0/2.2") && !has("uniform samplerCube prefilterTex"))
  {
    light = "    gl_FragData[0].rgb = pow(pow(gl_FragData[0].rgb, vec3(2.2)) +\n"
            "      mix(1.0, ao, aoStrengthUniform) *\n"
            "      GodRaysAddSky(albedo, metallic, roughness, F0, N, V), vec3(1.0/2.2));\n";
  }
  else if (has("ambientColor + diffuse + specular"))
  {
    light = "    gl_FragData[0].rgb += GodRaysAddSky(diffuse, diffuseColor, normalVCVSOutput);\n";
  }
  if (light.empty() || !has("//VTK::GodRays::SkyImpl"))
  {
    return true;
  }
  static const std::string formulas = vtkGodRaysQuad::Include(vtkGodRaysSurfaceSkyFS);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::GodRays::SkyDec", formulas);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::GodRays::SkyImpl",
    "  if (godraysSky[0].g > 0.0)\n  {\n" + light + "  }\n");
  return true;
}

bool vtkGodRaysSurfaceSky::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  if (program->IsUniformUsed("godraysSky"))
  {
    program->SetUniform3fv("godraysSky", 9, Shining ? Shining : Night);
  }
  return true;
}
