// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Advice.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <cmath>

namespace
{
// [half of the picture's height or width] of what is farther out, a look has hardly any shafts
constexpr double FarthestOut = 1.3;

//------------------------------------------------------------------------------
bool IsNearPicture(const Viewpoint& view, double aspect)
{
  const Vector3& light = view.LightIsLamp ? view.LightPosition : view.LightDirection;
  double place[4] = { light[0], light[1], light[2], view.LightIsLamp ? 1.0 : 0.0 };
  view.Camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)
    ->MultiplyPoint(place, place);
  return place[3] > 0.0 && std::abs(place[0]) < FarthestOut * place[3] &&
    std::abs(place[1]) < FarthestOut * place[3];
}
}

//------------------------------------------------------------------------------
std::vector<std::string> GetAdvice(
  const Scene& scene, const Viewpoint& view, const Options& options, bool isMedium)
{
  std::vector<std::string> advice;
  double azimuth = 0.0;
  double elevation = 0.0;
  scene.GetAngles(view.LightDirection, azimuth, elevation);
  if (!view.LightIsLamp && elevation < 0.0 && options.Sky.empty())
  {
    advice.emplace_back(
      "--sun: it is below the horizon, and shines on the scene from below; give an "
      "elevation above 0");
  }
  const double aspect = static_cast<double>(options.Size[0]) / options.Size[1];
  if (!isMedium && !IsNearPicture(view, aspect))
  {
    const std::string name = view.LightIsLamp ? "lamp" : "sun";
    const std::string remedy = view.LightWasChosen ? "let the camera look to the horizon"
      : view.LightIsLamp                           ? "move --light, or leave it out"
      : options.Place ? "take a time of a lower sun, or leave out --date and --place"
                      : "take a lower --sun, or none";
    advice.push_back(
      "the " + name + " is out of the picture, where a look has no shafts of it; " + remedy);
  }
  return advice;
}
