// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Dates: refused, or one that is told in other words and read again is the same.

#include "GodRaysFuzzing.h"

#include "vtkGodRaysSunPosition.h"
#include "vtkNew.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkObject::GlobalWarningDisplayOff();
  const std::string text(reinterpret_cast<const char*>(data), size);
  vtkNew<vtkGodRaysSunPosition> sun;
  if (!sun->SetDateTime(text))
  {
    return 0;
  }
  sun->SetLatitude(51.5);
  sun->SetLongitude(-0.1);
  Require(std::isfinite(sun->GetAzimuth()) && std::fabs(sun->GetElevation()) <= 90.0,
    "the sun is somewhere");
  Require(
    std::isfinite(sun->GetSunrise()) || sun->GetDayType() != vtkGodRaysSunPosition::RISES_AND_SETS,
    "the sun rises on days on which it does");
  vtkNew<vtkGodRaysSunPosition> again;
  Require(again->SetDateTime(sun->GetDateTime()), "what it tells is a date");
  Require(again->GetDateTime() == sun->GetDateTime(), "and the same one");
  return 0;
}
