// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSunPosition.h"

#include "vtkGodRaysSetGet.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

vtkStandardNewMacro(vtkGodRaysSunPosition);

vtkGodRaysSetFiniteMacro(vtkGodRaysSunPosition, TimeOfDay, 0.0, 24.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysSunPosition, TimeZone, -18.0, 18.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysSunPosition, Latitude, -90.0, 90.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysSunPosition, Longitude, -180.0, 180.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysSunPosition, Height, -500.0, 100000.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysSunPosition, Pressure, 0.0, 200000.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysSunPosition, Temperature, -100.0, 100.0);

// The formulas of astronomy are here and not with those of the pictures: they take double precision.
namespace
{
constexpr double HorizonElevation = -0.8333; // refraction 34', radius of the sun 16'

double Sine(double degrees)
{
  return std::sin(vtkMath::RadiansFromDegrees(degrees));
}

double Cosine(double degrees)
{
  return std::cos(vtkMath::RadiansFromDegrees(degrees));
}

double Direction(double y, double x)
{
  return vtkMath::DegreesFromRadians(std::atan2(y, x));
}

/// The axes of an observer, of length 1, and false if there are none: then zenith is up or (0, 0, 1).
bool GetFrame(
  const double up[3], const double north[3], double zenith[3], double ahead[3], double east[3])
{
  vtkMath::Assign(up, zenith);
  vtkMath::Assign(north, ahead);
  const bool hasZenith = vtkMath::Normalize(zenith) > 0.0 && std::isfinite(vtkMath::Norm(zenith));
  vtkMath::Normalize(ahead);
  vtkMath::Cross(ahead, zenith, east);
  if (!hasZenith || !(vtkMath::Normalize(east) > 1e-9))
  {
    const double fallback[3] = { 0.0, 0.0, 1.0 };
    vtkMath::Assign(hasZenith ? zenith : fallback, zenith);
    return false;
  }
  vtkMath::Cross(zenith, east, ahead);
  return true;
}

double Wrap(double degrees, double low)
{
  return degrees - 360.0 * std::floor((degrees - low) / 360.0);
}

bool IsDay(int year, int month, int day)
{
  static const int days[12] = { 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31 };
  if (year < 1900 || year > 2100 || month < 1 || month > 12)
  {
    return false;
  }
  const bool leap = month == 2 && year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  return day >= 1 && day <= days[month - 1] + (leap ? 1 : 0);
}

// Days from noon of 2000-01-01 to the midnight that begins the day. [Meeus1998] 7.1
double DaysSinceJ2000(int year, int month, int day)
{
  if (month <= 2)
  {
    --year;
    month += 12;
  }
  const int century = year / 100;
  return std::floor(365.25 * (year + 4716)) + std::floor(30.6001 * (month + 1)) + day + 2 -
    century + century / 4 - 1524.5 - 2451545.0;
}

// The sun as seen from the Earth's centre: angles in degrees.
struct Sun
{
  double Ascension;
  double Declination;
  double Distance; // [astronomical units]
  double Sidereal; // apparent sidereal time at Greenwich
};

// t is the days of universal time since J2000.
Sun GetSun(double days)
{
  // Dynamical time is ahead by 0 s in 1900 and some 70 s today; the sun moves by 0.0008 degrees in 70 s.
  const double dynamical = (days + 69.0 / 86400.0) / 36525.0;

  // The sun's true longitude. [Meeus1988] chapter 18; its centuries count from 1900.
  const double t = dynamical + 1.0;
  const double meanLongitude = 279.69668 + t * (36000.76892 + t * 0.0003025);
  const double anomaly = 358.47583 + t * (35999.04975 - t * (0.000150 + t * 0.0000033));
  const double eccentricity = 0.01675104 - t * (0.0000418 + t * 0.000000126);
  const double center = (1.919460 - t * (0.004789 + t * 0.000014)) * Sine(anomaly) +
    (0.020094 - t * 0.000100) * Sine(2.0 * anomaly) + 0.000293 * Sine(3.0 * anomaly);
  const double elongation = 350.74 + t * (445267.1142 - t * 0.00144);   // of the Moon
  const double perturbation = 0.00134 * Cosine(153.23 + 22518.7541 * t) // Venus
    + 0.00154 * Cosine(216.57 + 45037.5082 * t)                         // Venus
    + 0.00200 * Cosine(312.69 + 32964.3577 * t)                         // Jupiter
    + 0.00179 * Sine(elongation)                                        // Moon
    + 0.00178 * Sine(231.19 + 20.20 * t);                               // of long period
  const double longitude = meanLongitude + center + perturbation;
  const double distance = 1.0000002 * (1.0 - eccentricity * eccentricity) /
    (1.0 + eccentricity * Cosine(anomaly + center));

  // Nutation and the obliquity of the ecliptic. [Meeus1998] chapter 22
  const double node = 125.04452 - 1934.136261 * dynamical;
  const double moon = 218.3165 + 481267.8813 * dynamical;
  const double inLongitude = (-17.20 * Sine(node) - 1.32 * Sine(2.0 * meanLongitude) -
                               0.23 * Sine(2.0 * moon) + 0.21 * Sine(2.0 * node)) /
    3600.0;
  const double inObliquity = (9.20 * Cosine(node) + 0.57 * Cosine(2.0 * meanLongitude) +
                               0.10 * Cosine(2.0 * moon) - 0.09 * Cosine(2.0 * node)) /
    3600.0;
  const double obliquity =
    23.0 + (26.0 + (21.448 - 46.8150 * dynamical) / 60.0) / 60.0 + inObliquity;

  const double apparent = longitude + inLongitude - 20.4898 / 3600.0 / distance; // and aberration
  Sun sun;
  sun.Ascension = Direction(Cosine(obliquity) * Sine(apparent), Cosine(apparent));
  sun.Declination = vtkMath::DegreesFromRadians(std::asin(Sine(obliquity) * Sine(apparent)));
  sun.Distance = distance;
  sun.Sidereal = 280.46061837 + 360.98564736629 * days + // [Meeus1998] 12.4
    0.000387933 * std::pow(days / 36525.0, 2) + inLongitude * Cosine(obliquity);
  return sun;
}

// Refraction [degrees] at a true elevation. [Meeus1998] 16.4; below the horizon, where that is not
// meant for, as 1/tan(elevation) from what it is there.
double GetRefraction(double elevation, double pressure, double temperature)
{
  const double seen = std::fmax(elevation, HorizonElevation);
  const double air = pressure / 101000.0 * 283.0 / (273.0 + temperature);
  const double angle = seen + 10.3 / (seen + 5.11);
  const double refraction = air * 1.02 / 60.0 * Cosine(angle) / Sine(angle);
  const double fade = Sine(seen) / Cosine(seen) * Cosine(elevation) / Sine(elevation);
  return elevation < seen ? refraction * fade : std::fmax(refraction, 0.0);
}
}

void vtkGodRaysSunPosition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DateTime: " << this->GetDateTime() << "\n";
  os << indent << "Latitude: " << this->Latitude << "\n";
  os << indent << "Longitude: " << this->Longitude << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "Pressure: " << this->Pressure << "\n";
  os << indent << "Temperature: " << this->Temperature << "\n";
}

void vtkGodRaysSunPosition::SetDate(int year, int month, int day)
{
  if (!IsDay(year, month, day))
  {
    vtkErrorMacro("There is no day " << year << "-" << month << "-" << day
                                     << " between 1900-01-01 and 2100-12-31; the date stays "
                                     << this->GetDateTime().substr(0, 10) << ".");
    return;
  }
  if (this->Year != year || this->Month != month || this->Day != day)
  {
    this->Year = year;
    this->Month = month;
    this->Day = day;
    this->Modified();
  }
}

namespace
{
/// A date and time as text: yyyy-mm-dd[T ]hh:mm[:ss[.s]][Z|(+|-)hh[[:]mm]], whatever the locale.
struct DateTime
{
  int Year = 0;
  int Month = 0;
  int Day = 0;
  int Hour = 0;
  int Minute = 0;
  double Second = 0.0;
  char Zone = '\0'; // Z, + or -
  int ZoneHour = 0;
  int ZoneMinute = 0;

  double GetHours() const { return this->Hour + this->Minute / 60.0 + this->Second / 3600.0; }
  double GetZone() const { return this->ZoneHour + this->ZoneMinute / 60.0; }

  bool Parse(const char* text)
  {
    const char* rest = text;
    const bool begins = Read(rest, 4, this->Year) && Skip(rest, "-") &&
      Read(rest, 2, this->Month) && Skip(rest, "-") && Read(rest, 2, this->Day) &&
      Skip(rest, "T ") && Read(rest, 2, this->Hour) && Skip(rest, ":") &&
      Read(rest, 2, this->Minute);
    return begins && (!Skip(rest, ":") || this->ParseSecond(rest)) && this->ParseZone(rest) &&
      *rest == '\0';
  }

private:
  /// As many digits, and no sign.
  static bool Read(const char*& rest, int digits, int& number)
  {
    number = 0;
    for (int i = 0; i < digits; ++i, ++rest)
    {
      if (*rest < '0' || *rest > '9')
      {
        return false;
      }
      number = 10 * number + (*rest - '0');
    }
    return true;
  }

  /// One of these characters, if it is next.
  static bool Skip(const char*& rest, const char* characters)
  {
    const bool found = *rest != '\0' && std::strchr(characters, *rest);
    rest += found ? 1 : 0;
    return found;
  }

  bool ParseSecond(const char*& rest)
  {
    int digit = 0;
    if (!Read(rest, 2, digit))
    {
      return false;
    }
    this->Second = digit;
    if (!Skip(rest, "."))
    {
      return true;
    }
    const char* const first = rest;
    for (double unit = 0.1; *rest >= '0' && *rest <= '9'; ++rest, unit *= 0.1)
    {
      this->Second += unit * (*rest - '0');
    }
    return rest > first;
  }

  bool ParseZone(const char*& rest)
  {
    const char* const first = rest;
    if (!Skip(rest, "Z+-"))
    {
      return true;
    }
    this->Zone = *first;
    if (this->Zone == 'Z')
    {
      return true;
    }
    if (!Read(rest, 2, this->ZoneHour))
    {
      return false;
    }
    return (!Skip(rest, ":") && *rest == '\0') || Read(rest, 2, this->ZoneMinute);
  }
};
}

bool vtkGodRaysSunPosition::SetDateTime(const std::string& text)
{
  DateTime parsed;
  if (!parsed.Parse(text.c_str()) || !IsDay(parsed.Year, parsed.Month, parsed.Day) ||
    parsed.Minute >= 60 || parsed.Second >= 61.0 || parsed.GetHours() > 24.0 ||
    parsed.ZoneMinute >= 60 || parsed.GetZone() > 18.0)
  {
    vtkErrorMacro("Not a date and time from 1900 to 2100: \""
      << text << "\". Write it like 2003-10-17T12:30:30-07:00; it stays " << this->GetDateTime()
      << ".");
    return false;
  }
  this->SetDate(parsed.Year, parsed.Month, parsed.Day);
  this->SetTimeOfDay(parsed.GetHours());
  if (parsed.Zone)
  {
    this->SetTimeZone(parsed.Zone == '-' ? -parsed.GetZone() : parsed.GetZone());
  }
  return true;
}

std::string vtkGodRaysSunPosition::GetDateTime() const
{
  const long milliseconds = std::lround(this->TimeOfDay * 3600e3);
  const long zone = std::lround(std::fabs(this->TimeZone) * 60.0);
  char text[80];
  std::snprintf(text, sizeof(text), "%04d-%02d-%02dT%02ld:%02ld:%02ld.%03ld%c%02ld:%02ld",
    this->Year, this->Month, this->Day, milliseconds / 3600000, milliseconds / 60000 % 60,
    milliseconds / 1000 % 60, milliseconds % 1000, this->TimeZone < 0.0 ? '-' : '+', zone / 60,
    zone % 60);
  return text;
}

vtkGodRaysSunPosition::Position vtkGodRaysSunPosition::GetPosition(double timeOfDay) const
{
  const Sun sun = GetSun(
    DaysSinceJ2000(this->Year, this->Month, this->Day) + (timeOfDay - this->TimeZone) / 24.0);
  Position position;
  position.Distance = sun.Distance;
  position.HourAngle = Wrap(sun.Sidereal + this->Longitude - sun.Ascension, -180.0);

  const double declination = sun.Declination;
  const double south = Sine(this->Latitude) * Cosine(declination) * Cosine(position.HourAngle) -
    Cosine(this->Latitude) * Sine(declination);
  const double west = Cosine(declination) * Sine(position.HourAngle);
  const double up = Sine(this->Latitude) * Sine(declination) +
    Cosine(this->Latitude) * Cosine(declination) * Cosine(position.HourAngle);
  position.Azimuth = Wrap(Direction(west, south) + 180.0, 0.0);
  position.GeocentricElevation = Direction(up, std::hypot(south, west));
  // The observer is at the Earth's surface, not in its centre. [Meeus1998] chapter 40
  const double parallax = 8.794 / 3600.0 / sun.Distance * (1.0 + this->Height / 6378140.0);
  position.TrueElevation =
    position.GeocentricElevation - parallax * Cosine(position.GeocentricElevation);
  return position;
}

double vtkGodRaysSunPosition::GetAzimuth()
{
  return this->GetPosition(this->TimeOfDay).Azimuth;
}

double vtkGodRaysSunPosition::GetElevation()
{
  const double elevation = this->GetTrueElevation();
  return elevation + GetRefraction(elevation, this->Pressure, this->Temperature);
}

double vtkGodRaysSunPosition::GetTrueElevation()
{
  return this->GetPosition(this->TimeOfDay).TrueElevation;
}

double vtkGodRaysSunPosition::GetDistance()
{
  return this->GetPosition(this->TimeOfDay).Distance;
}

bool vtkGodRaysSunPosition::GetDirection(
  const double up[3], const double north[3], double direction[3])
{
  if (!vtkGodRaysSunPosition::ComputeDirection(
        this->GetAzimuth(), this->GetElevation(), up, north, direction))
  {
    vtkErrorMacro("No direction to the sun: up and north must be finite, not 0 and not parallel.");
    return false;
  }
  return true;
}

bool vtkGodRaysSunPosition::ComputeDirection(
  double azimuth, double elevation, const double up[3], const double north[3], double direction[3])
{
  double zenith[3], ahead[3], east[3];
  if (!GetFrame(up, north, zenith, ahead, east))
  {
    vtkMath::Assign(zenith, direction);
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    direction[i] = Sine(elevation) * zenith[i] +
      Cosine(elevation) * (Cosine(azimuth) * ahead[i] + Sine(azimuth) * east[i]);
  }
  return true;
}

bool vtkGodRaysSunPosition::ComputeAngles(
  const double direction[3], const double up[3], const double north[3], double angles[2])
{
  double zenith[3], ahead[3], east[3];
  const bool found = GetFrame(up, north, zenith, ahead, east);
  const double level[2] = { vtkMath::Dot(direction, ahead), vtkMath::Dot(direction, east) };
  angles[0] = found ? Direction(level[1], level[0]) : 0.0;
  angles[1] =
    found ? Direction(vtkMath::Dot(direction, zenith), std::hypot(level[0], level[1])) : 0.0;
  return found;
}

bool vtkGodRaysSunPosition::IsUp(double timeOfDay) const
{
  return this->GetPosition(timeOfDay).GeocentricElevation >= HorizonElevation;
}

double vtkGodRaysSunPosition::FindHorizon(double below, double above) const
{
  if (this->IsUp(below) || !this->IsUp(above))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  while (std::fabs(above - below) > 1e-6)
  {
    const double middle = 0.5 * (below + above);
    (this->IsUp(middle) ? above : below) = middle;
  }
  return 0.5 * (below + above);
}

void vtkGodRaysSunPosition::FindEvents()
{
  if (this->EventTime > this->GetMTime())
  {
    return;
  }
  // The clock's noon is within half a day of the transit that belongs to this date.
  double transit = 12.0;
  for (int i = 0; i < 4; ++i)
  {
    transit -= this->GetPosition(transit).HourAngle / 15.0;
  }
  this->Transit = transit;
  this->Sunrise = this->FindHorizon(transit - 12.0, transit);
  this->Sunset = this->FindHorizon(transit + 12.0, transit);
  const bool complete = !std::isnan(this->Sunrise) && !std::isnan(this->Sunset);
  this->Type = complete ? RISES_AND_SETS : (this->IsUp(transit) ? POLAR_DAY : POLAR_NIGHT);
  this->EventTime.Modified();
}

double vtkGodRaysSunPosition::GetSunrise()
{
  this->FindEvents();
  return this->Sunrise;
}

double vtkGodRaysSunPosition::GetTransit()
{
  this->FindEvents();
  return this->Transit;
}

double vtkGodRaysSunPosition::GetSunset()
{
  this->FindEvents();
  return this->Sunset;
}

int vtkGodRaysSunPosition::GetDayType()
{
  this->FindEvents();
  return this->Type;
}
