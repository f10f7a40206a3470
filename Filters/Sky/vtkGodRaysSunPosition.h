// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSunPosition
 * @brief   where the sun stands in the sky, from date, time and place
 *
 * The direction of the sun for an observer on the Earth, in 1900 to 2100, with refraction and without,
 * and when it rises, culminates and sets. The sun's longitude is that of [Meeus1988] chapter 18 with its
 * perturbations by Venus, Jupiter and the Moon; nutation, sidereal time and parallax are those of
 * [Meeus1998] chapters 12, 22 and 40, refraction is its equation 16.4. All terms below 0.0005 degrees
 * are left out. The error is below 0.005 degrees, 0.001 on average; near the horizon, the refraction of
 * the day's atmosphere differs by far more. Rise and set are within a second of those of the solar
 * position algorithm [RedaAndreas2004]. Documentation/Decisions/0007-sun-position.md tells why no library
 * is used.
 *
 * Values are computed when they are asked for. An object is for one thread at a time.
 *
 * @sa vtkGodRaysSkySource
 */

#ifndef vtkGodRaysSunPosition_h
#define vtkGodRaysSunPosition_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For std::string

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysSunPosition : public vtkObject
{
public:
  static vtkGodRaysSunPosition* New();
  vtkTypeMacro(vtkGodRaysSunPosition, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the date at the place: year, month and day, a day of the calendar from 1900-01-01 to 2100-12-31.
   * Others are an error, and the date stays. Default is 2000-06-21.
   */
  void SetDate(int year, int month, int day);
  vtkGetMacro(Year, int);
  vtkGetMacro(Month, int);
  vtkGetMacro(Day, int);
  ///@}

  ///@{
  /**
   * Set/Get the time of the clock at the place since midnight [hours]. Valid range: [0, 24]. Default is
   * 12.
   */
  void SetTimeOfDay(double hours);
  vtkGetMacro(TimeOfDay, double);
  ///@}

  ///@{
  /**
   * Set/Get how far the clock is ahead of UTC, daylight saving included [hours]. Valid range: [-18, 18].
   * Default is 0.
   */
  void SetTimeZone(double hours);
  vtkGetMacro(TimeZone, double);
  ///@}

  /**
   * Set date, time and, if it is given, the time zone from a text like 2003-10-17T12:30:30-07:00
   * (ISO 8601): seconds and their fraction can be left out, and so can the zone, which is Z, +hh or
   * +hh:mm. Returns false after an error, and nothing is changed. Default is 2000-06-21T12:00:00Z.
   */
  bool SetDateTime(const std::string& text);

  /**
   * Date, time (rounded to milliseconds) and zone as SetDateTime() takes them.
   */
  std::string GetDateTime() const;

  ///@{
  /**
   * Set/Get the latitude of the place, positive to the north [degrees]. Valid range: [-90, 90]. Default is
   * 0.
   */
  void SetLatitude(double degrees);
  vtkGetMacro(Latitude, double);
  ///@}

  ///@{
  /**
   * Set/Get the longitude of the place, positive to the east [degrees]. Valid range: [-180, 180]. Default is
   * 0.
   */
  void SetLongitude(double degrees);
  vtkGetMacro(Longitude, double);
  ///@}

  ///@{
  /**
   * Set/Get the height of the place above sea level [m], for the parallax. It does not lower the horizon.
   * Valid range: [-500, 100000]. Default is 0.
   */
  void SetHeight(double metres);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Set/Get the pressure of the air at the place, for the refraction [Pa]; 0 for none. Valid range:
   * [0, 200000]. Default is 101325.
   */
  void SetPressure(double pascals);
  vtkGetMacro(Pressure, double);
  ///@}

  ///@{
  /**
   * Set/Get the temperature of the air at the place, for the refraction [degrees Celsius]. Valid range:
   * [-100, 100]. Default is 15.
   */
  void SetTemperature(double degrees);
  vtkGetMacro(Temperature, double);
  ///@}

  /**
   * The sun's azimuth [degrees]: 0 north, 90 east, below 360.
   */
  double GetAzimuth();

  ///@{
  /**
   * The height of the sun's centre above the horizontal plane [degrees], as it is seen and as it would be
   * without refraction. Below -0.8333 degrees, where nothing of the sun is seen, the refraction fades, so
   * that its path is continuous.
   */
  double GetElevation();
  double GetTrueElevation();
  ///@}

  /**
   * The distance of the sun [astronomical units]: the irradiance is as 1/distance^2.
   */
  double GetDistance();

  ///@{
  /**
   * The direction to the sun as it is seen, or to any azimuth and elevation [degrees], of length 1, in a
   * world where up and north are as given, of any length but 0. Only the part of north that is horizontal
   * counts. Returns false if the two are parallel or not finite, the first of them with an error, and
   * then gives up or (0, 0, 1) as the direction.
   */
  bool GetDirection(const double up[3], const double north[3], double direction[3]);
  static bool ComputeDirection(double azimuth, double elevation, const double up[3],
    const double north[3], double direction[3]);
  ///@}

  /**
   * The inverse of ComputeDirection(): azimuth, from -180 to 180, and elevation [degrees] of a direction
   * of any length but 0. Returns false, with 0, where that does.
   */
  static bool ComputeAngles(
    const double direction[3], const double up[3], const double north[3], double angles[2]);

  ///@{
  /**
   * When the sun passes the meridian on this date, when it rises before that, and when it sets after:
   * the time of the clock [hours]. Rising and setting is when the sun's centre is 0.8333 degrees below
   * the horizon, without refraction and parallax: the upper limb is then seen at the horizon through an
   * average atmosphere. Rise and set are NaN if there is none within half a day of the transit, and below
   * 0 or above 24 if they belong to the day before or after by the clock.
   */
  double GetSunrise();
  double GetTransit();
  double GetSunset();
  ///@}

  /// What kind of day it is.
  enum DayType
  {
    RISES_AND_SETS = 0,
    POLAR_DAY = 1,  ///< sunrise, sunset or both are missing, as the sun stays up
    POLAR_NIGHT = 2 ///< the sun stays below
  };

  /**
   * What kind of day this date is, one of DayType.
   */
  int GetDayType();

protected:
  vtkGodRaysSunPosition() = default;
  ~vtkGodRaysSunPosition() override = default;

  int Year = 2000;
  int Month = 6;
  int Day = 21;
  double TimeOfDay = 12.0;
  double TimeZone = 0.0;
  double Latitude = 0.0;
  double Longitude = 0.0;
  double Height = 0.0;
  double Pressure = 101325.0;
  double Temperature = 15.0;

private:
  vtkGodRaysSunPosition(const vtkGodRaysSunPosition&) = delete;
  void operator=(const vtkGodRaysSunPosition&) = delete;

  // Where the sun is: angles in degrees.
  struct Position
  {
    double HourAngle; // -180 to 180
    double Azimuth;
    double GeocentricElevation;
    double TrueElevation;
    double Distance; // [astronomical units]
  };
  // The position at a time of the clock [hours], which can be before or after this day.
  Position GetPosition(double timeOfDay) const;
  bool IsUp(double timeOfDay) const;
  // The time between two at which the sun crosses the horizon; NaN if it does not.
  double FindHorizon(double below, double above) const;
  void FindEvents();

  double Sunrise = 0.0;
  double Transit = 0.0;
  double Sunset = 0.0;
  int Type = RISES_AND_SETS;
  vtkTimeStamp EventTime;
};

#endif
