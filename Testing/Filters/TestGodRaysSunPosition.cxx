// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The sun's position against published values, on polar days and nights, and with bad input.

#include "GodRaysFiltersTesting.h"
#include "vtkGodRaysSunPosition.h"

#include "vtkMath.h"

#include <limits>

using namespace GodRaysFiltersTesting;
using Sun = vtkGodRaysSunPosition;

namespace
{
vtkSmartPointer<Sun> MakeSun(const std::string& dateTime, double latitude, double longitude)
{
  vtkSmartPointer<Sun> sun = vtkSmartPointer<Sun>::New();
  EXPECT_TRUE(sun->SetDateTime(dateTime));
  sun->SetLatitude(latitude);
  sun->SetLongitude(longitude);
  return sun;
}

constexpr double Clock(double hours, double minutes, double seconds)
{
  return hours + (minutes + seconds / 60.0) / 60.0;
}

const double second = 1.0 / 3600.0;
}

//------------------------------------------------------------------------------
// [RedaAndreas2004], appendix A.5. Its sunset is that of the UTC date: of the evening before.
TEST(SunPosition, IsTheWorkedExample)
{
  const vtkSmartPointer<Sun> sun = MakeSun("2003-10-17T12:30:30-07:00", 39.742476, -105.1786);
  sun->SetHeight(1830.14);
  sun->SetPressure(82000.0);
  sun->SetTemperature(11.0);
  EXPECT_NEAR(sun->GetAzimuth(), 194.34024, 1e-3);
  EXPECT_NEAR(90.0 - sun->GetElevation(), 50.11162, 1e-3);
  EXPECT_NEAR(90.0 - sun->GetTrueElevation(), 50.1279, 1e-3);
  EXPECT_NEAR(sun->GetDistance(), 0.9965422974, 1e-4);
  EXPECT_EQ(sun->GetDayType(), Sun::RISES_AND_SETS);
  EXPECT_NEAR(sun->GetSunrise(), Clock(6, 12, 43), second);
  EXPECT_NEAR(sun->GetTransit(), Clock(11, 46, 4), second);
  EXPECT_NEAR(sun->GetSunset(), Clock(17, 18, 51), second);
  sun->SetDate(2003, 10, 16);
  EXPECT_NEAR(sun->GetSunset(), Clock(17, 20, 19), second);
}

//------------------------------------------------------------------------------
// Positions of NREL's program, some with 1000 hPa and 10 degrees.
TEST(SunPosition, IsThatOfTheSolarPositionAlgorithm)
{
  struct Row
  {
    const char* DateTime;
    double Latitude, Longitude, Temperature, Azimuth, Zenith;
  };
  const Row rows[] = {
    { "1910-03-15T00:30:00Z", -36.840556, 174.74, 10.0, 0.188643, 34.269919 },
    { "1910-03-15T03:30:00Z", -36.840556, 174.74, 10.0, 298.894756, 53.637925 },
    { "1910-03-15T06:30:00Z", -36.840556, 174.74, 10.0, 268.082350, 88.143823 },
    { "1910-03-15T09:30:00Z", -36.840556, 174.74, 10.0, 237.156205, 122.642657 },
    { "1910-03-15T12:30:00Z", -36.840556, 174.74, 10.0, 180.112832, 140.797480 },
    { "2015-06-12T09:34:11-04", -3.107, -60.025, 20.0, 51.608, 44.1425 },
    { "2012-12-22T12:00Z", -41.0, 0.0, 20.0, 359.08592, 17.5658 },
    { "2012-12-22T12:00Z", -3.0, 0.0, 20.0, 180.790356, 20.4285 },
  };
  for (const Row& row : rows)
  {
    const vtkSmartPointer<Sun> sun = MakeSun(row.DateTime, row.Latitude, row.Longitude);
    sun->SetPressure(100000.0);
    sun->SetTemperature(row.Temperature);
    const double sine = std::sin(vtkMath::RadiansFromDegrees(row.Zenith));
    // Below the horizon ours has some refraction left, so that the path is continuous.
    const double zenith =
      90.0 - (row.Zenith > 91.0 ? sun->GetTrueElevation() : sun->GetElevation());
    EXPECT_NEAR(zenith, row.Zenith, 0.003) << row.DateTime;
    EXPECT_NEAR(std::remainder(sun->GetAzimuth() - row.Azimuth, 360.0) * sine, 0.0, 0.003)
      << row.DateTime;
  }
}

//------------------------------------------------------------------------------
TEST(SunPosition, RisesAndSetsWhenTablesSay)
{
  struct Row
  {
    const char* DateTime;
    double Latitude, Longitude, Rise, Transit, Set;
  };
  const Row rows[] = {
    { "1996-07-05T00:00Z", -35.0, 0.0, Clock(7, 8, 15), Clock(12, 4, 36), Clock(17, 1, 4) },
    { "2004-12-04T00:00Z", -35.0, 0.0, Clock(4, 38, 57), Clock(11, 50, 22), Clock(19, 2, 3) },
    { "2015-06-17T12:30+12", -36.8406, 174.74, Clock(7, 32, 26), Clock(12, 21, 46),
      Clock(17, 11, 3) },
    { "2016-03-27T12:00+02", 52.33, 13.3, Clock(6, 52, 19), Clock(13, 12, 2), Clock(19, 32, 49) },
    { "2015-10-25T12:00+01", 52.33, 13.3, Clock(6, 49, 2), Clock(11, 50, 55), Clock(16, 51, 59) },
    { "2015-09-27T12:00+13", -36.84, 174.74, Clock(7, 4, 14), Clock(13, 12, 17),
      Clock(19, 20, 56) },
  };
  for (const Row& row : rows)
  {
    const vtkSmartPointer<Sun> sun = MakeSun(row.DateTime, row.Latitude, row.Longitude);
    EXPECT_NEAR(sun->GetSunrise(), row.Rise, 2.0 * second) << row.DateTime;
    EXPECT_NEAR(sun->GetTransit(), row.Transit, 2.0 * second) << row.DateTime;
    EXPECT_NEAR(sun->GetSunset(), row.Set, 2.0 * second) << row.DateTime;
  }
}

//------------------------------------------------------------------------------
TEST(SunPosition, KnowsPolarDaysAndNights)
{
  const vtkSmartPointer<Sun> sun = MakeSun("2015-01-20T12:00Z", 78.2222, 15.6316); // Longyearbyen
  EXPECT_EQ(sun->GetDayType(), Sun::POLAR_NIGHT);
  EXPECT_TRUE(std::isnan(sun->GetSunrise()));
  EXPECT_TRUE(std::isnan(sun->GetSunset()));
  sun->SetDate(2015, 6, 20);
  EXPECT_EQ(sun->GetDayType(), Sun::POLAR_DAY);
  EXPECT_TRUE(std::isnan(sun->GetSunrise()));
  EXPECT_NEAR(sun->GetTransit(), Clock(10, 58, 57), 2.0 * second);
  sun->SetDate(2015, 3, 21);
  EXPECT_EQ(sun->GetDayType(), Sun::RISES_AND_SETS);
  EXPECT_LT(sun->GetSunrise(), sun->GetTransit());
  EXPECT_GT(sun->GetSunset(), sun->GetTransit());
}

//------------------------------------------------------------------------------
TEST(SunPosition, MovesWithoutJumps)
{
  for (const double latitude : { -90.0, -35.0, 0.0, 23.44, 66.6, 90.0 })
  {
    const vtkSmartPointer<Sun> sun = MakeSun("2024-06-20T00:00Z", latitude, 10.0);
    const double up[3] = { 0.0, 0.0, 1.0 };
    const double north[3] = { 0.0, 1.0, 0.0 };
    double before[3];
    ASSERT_TRUE(sun->GetDirection(up, north, before));
    for (int minute = 1; minute <= 1440; ++minute)
    {
      sun->SetTimeOfDay(minute / 60.0);
      double direction[3];
      ASSERT_TRUE(sun->GetDirection(up, north, direction));
      ASSERT_NEAR(vtkMath::Norm(direction), 1.0, 1e-12);
      // A quarter of a degree, and 3/4 of that where refraction fades: 0.0076. A cut would be 0.011.
      ASSERT_LT(std::sqrt(vtkMath::Distance2BetweenPoints(direction, before)), 0.0077) << minute;
      vtkMath::Assign(direction, before);
    }
  }
}

//------------------------------------------------------------------------------
TEST(SunPosition, PointsIntoAnyWorld)
{
  const vtkSmartPointer<Sun> sun = MakeSun("2003-10-17T09:00-07:00", 39.742476, -105.1786);
  const double azimuth = vtkMath::RadiansFromDegrees(sun->GetAzimuth());
  const double elevation = vtkMath::RadiansFromDegrees(sun->GetElevation());
  // y up, -z north: x is east. Only the horizontal part of north counts.
  const double up[3] = { 0.0, 3.0, 0.0 };
  const double north[3] = { 0.0, 5.0, -0.1 };
  double direction[3];
  ASSERT_TRUE(sun->GetDirection(up, north, direction));
  EXPECT_NEAR(direction[0], std::cos(elevation) * std::sin(azimuth), 1e-12);
  EXPECT_NEAR(direction[1], std::sin(elevation), 1e-12);
  EXPECT_NEAR(direction[2], -std::cos(elevation) * std::cos(azimuth), 1e-12);

  const ErrorListener errors(sun);
  EXPECT_FALSE(sun->GetDirection(up, up, direction));
  EXPECT_EQ(direction[1], 1.0);
  const double nothing[3] = { 0.0, 0.0, 0.0 };
  EXPECT_FALSE(sun->GetDirection(nothing, north, direction));
  EXPECT_EQ(direction[2], 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double unknown[3] = { nan, 0.0, 1.0 };
  EXPECT_FALSE(sun->GetDirection(unknown, north, direction));
  EXPECT_FALSE(sun->GetDirection(up, unknown, direction));
  EXPECT_EQ(errors.Texts.size(), 4u);
}

//------------------------------------------------------------------------------
TEST(SunPosition, ReadsWhatItWrites)
{
  vtkNew<Sun> sun;
  EXPECT_TRUE(sun->SetDateTime("2024-02-29T23:59:59.25+05:30"));
  EXPECT_EQ(sun->GetDateTime(), "2024-02-29T23:59:59.250+05:30");
  EXPECT_TRUE(sun->SetDateTime("1999-01-02 03:04"));
  EXPECT_EQ(sun->GetDateTime(), "1999-01-02T03:04:00.000+05:30");
  EXPECT_TRUE(sun->SetDateTime("2100-12-31T24:00:00-0930"));
  EXPECT_EQ(sun->GetDateTime(), "2100-12-31T24:00:00.000-09:30");
}

//------------------------------------------------------------------------------
TEST(SunPosition, RefusesWhatIsNoDate)
{
  vtkNew<Sun> sun;
  const ErrorListener errors(sun);
  const vtkMTimeType time = sun->GetMTime();
  const char* const texts[] = { "", "noon", "2023-02-29T12:00", "2024-13-01T12:00",
    "1899-12-31T12:00", "2024-01-01T24:01", "2024-01-01T12:60", "2024-01-01T12:00:61",
    "2024-01-01T12:00+19", "2024-01-01T12:00+01:60", "2024-01-01T12:00 and more" };
  for (const char* text : texts)
  {
    EXPECT_FALSE(sun->SetDateTime(text)) << text;
  }
  EXPECT_EQ(errors.Texts.size(), std::size(texts));
  EXPECT_NE(errors.Texts.back().find("Write it like"), std::string::npos);
  sun->SetDate(2023, 4, 31);
  sun->SetLatitude(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(errors.Texts.size(), std::size(texts) + 2);
  EXPECT_EQ(sun->GetMTime(), time);
}
