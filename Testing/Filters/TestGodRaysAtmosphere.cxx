// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Atmospheres: presets against what is published, and bad input.

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysAtmosphere.h"

#include <limits>

using namespace GodRaysFiltersTesting;
using Atmosphere = vtkGodRaysAtmosphere;

//------------------------------------------------------------------------------
TEST(Atmosphere, IsThatOfTheClearEarth)
{
  vtkNew<Atmosphere> air;
  const double rayleigh[3] = { 5.802e-6, 13.558e-6, 33.100e-6 };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(air->GetRayleighScattering()[i], rayleigh[i], 5e-10);
    EXPECT_NEAR(air->GetMieScattering()[i], 3.996e-6, 1e-12);
    EXPECT_NEAR(air->GetMieAbsorption()[i], 0.444e-6, 1e-12);
  }
  EXPECT_EQ(air->FindFault(), "");
}

//------------------------------------------------------------------------------
TEST(Atmosphere, PresetsHaveNamesAndTheirOpticalDepths)
{
  struct Row
  {
    const char* Name;
    int Preset;
    double AerosolDepth; // at 550 nm
  };
  const Row rows[] = { { "earth-clear", Atmosphere::EARTH_CLEAR, 0.005328 },
    { "earth-hazy", Atmosphere::EARTH_HAZY, 0.2 },
    { "earth-polluted", Atmosphere::EARTH_POLLUTED, 0.6 }, { "mars", Atmosphere::MARS, 0.5 },
    { "lodato-2015", Atmosphere::LODATO_2015, 0.024 } };
  for (const Row& row : rows)
  {
    vtkNew<Atmosphere> named;
    vtkNew<Atmosphere> numbered;
    EXPECT_TRUE(named->LoadPreset(std::string(row.Name)));
    numbered->LoadPreset(row.Preset);
    EXPECT_NEAR(
      (named->GetMieScattering()[1] + named->GetMieAbsorption()[1]) * named->GetMieHeight(),
      row.AerosolDepth, 1e-9)
      << row.Name;
    EXPECT_EQ(named->GetMieScattering()[0], numbered->GetMieScattering()[0]);
    EXPECT_EQ(named->GetTopHeight(), numbered->GetTopHeight());
    EXPECT_EQ(named->FindFault(), "");
    // Nothing of one preset stays in another.
    named->LoadPreset(Atmosphere::EARTH_CLEAR);
    vtkNew<Atmosphere> fresh;
    std::ostringstream one;
    std::ostringstream other;
    named->PrintSelf(one, vtkIndent());
    fresh->PrintSelf(other, vtkIndent());
    const auto parameters = [](const std::string& text)
    { return text.substr(text.find("GroundRadius")); };
    EXPECT_EQ(parameters(one.str()), parameters(other.str())) << row.Name;
  }
}

//------------------------------------------------------------------------------
TEST(Atmosphere, SaysWhatCannotBeUsed)
{
  vtkNew<Atmosphere> air;
  const ErrorListener errors(air);
  const vtkMTimeType time = air->GetMTime();
  EXPECT_FALSE(air->LoadPreset(std::string("venus")));
  air->LoadPreset(7);
  air->SetGroundRadius(std::numeric_limits<double>::quiet_NaN());
  ASSERT_EQ(errors.Texts.size(), 3u);
  EXPECT_NE(errors.Texts[0].find("lodato-2015"), std::string::npos);
  EXPECT_EQ(air->GetMTime(), time);
  air->SetMieAbsorption(0.0, -1e-6, 0.0);
  EXPECT_NE(air->FindFault().find("MieAbsorption"), std::string::npos);
  air->LoadPreset(Atmosphere::EARTH_CLEAR);
  air->SetSunIrradiance(1.0, std::numeric_limits<double>::infinity(), 1.0);
  EXPECT_NE(air->FindFault().find("SunIrradiance"), std::string::npos);
  air->LoadPreset(Atmosphere::EARTH_CLEAR);
  air->SetGroundAlbedo(0.0, 1.5, 0.0);
  EXPECT_NE(air->FindFault().find("GroundAlbedo"), std::string::npos);
}
