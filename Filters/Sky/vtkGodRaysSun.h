// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSun
 * @brief   the sun of a scene: where it stands, how large it looks, its colour
 *
 * One object for all that the sun shines on: a vtkGodRaysSkyPass and a vtkGodRaysSkySource draw its sky, a
 * vtkGodRaysPass takes its AngularRadius, UpdateLight() makes a vtkLight that of the sun.
 *
 * @code
 * vtkNew<vtkGodRaysSun> sun;
 * sun->SetFrame(vtkGodRaysSun::Z_UP);
 * sun->SetAzimuth(250.0);
 * sun->SetElevation(8.0);
 * sky->SetSun(sun);        // a vtkGodRaysSkyPass
 * sky->UpdateLight(light); // a vtkLight, in the colour that the air leaves the sun
 * rays->SetSun(sun);       // a vtkGodRaysPass
 * rays->AddLight(light);
 * @endcode
 *
 * Numbers beyond a valid range are clamped to it. NaN, infinities and unknown modes are errors and change
 * nothing.
 *
 * @sa vtkGodRaysSunPosition vtkGodRaysAtmosphere vtkGodRaysSkyPass
 */

#ifndef vtkGodRaysSun_h
#define vtkGodRaysSun_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkCamera;
class vtkGodRaysSunPosition;
class vtkLight;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysSun : public vtkObject
{
public:
  static vtkGodRaysSun* New();
  vtkTypeMacro(vtkGodRaysSun, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What azimuth and elevation refer to.
  enum FrameType
  {
    CAMERA = 0,      ///< azimuth 0 is the direction of view, elevation is up in the picture
    X_UP = 1,        ///< north is +z, east +y
    Y_UP = 2,        ///< north is -z, east +x
    Z_UP = 3,        ///< north is +y, east +x, as on a map
    UP_AND_NORTH = 4 ///< as Up and North say
  };

  ///@{
  /**
   * Set/Get what azimuth and elevation refer to, one of FrameType. Default is CAMERA.
   */
  void SetFrame(int frame);
  vtkGetMacro(Frame, int);
  ///@}

  ///@{
  /**
   * Set/Get where up is in the world, for UP_AND_NORTH [no unit]: a direction of any length but 0, not
   * parallel to North, which is an error when the direction of the sun is asked for. Valid range: [-1e30,
   * 1e30] each. Default is (0, 0, 1), as on a map.
   */
  void SetUp(double x, double y, double z);
  void SetUp(const double direction[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * Set/Get where north is in the world, for UP_AND_NORTH [no unit]: a direction of any length but 0. Only
   * the part of it at right angles to Up counts. Valid range: [-1e30, 1e30] each. Default is (0, 1, 0), as
   * on a map.
   */
  void SetNorth(double x, double y, double z);
  void SetNorth(const double direction[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(North, double);
  ///@}

  /// What says where the sun stands.
  enum PositionType
  {
    AZIMUTH_AND_ELEVATION = 0,
    DATE_AND_PLACE = 1
  };

  ///@{
  /**
   * Set/Get what says where the sun stands in Frame, one of PositionType. By date and place, for which a
   * frame of the world is best, it does not shine while it is below the horizon. Default is
   * AZIMUTH_AND_ELEVATION.
   */
  void SetPosition(int position);
  vtkGetMacro(Position, int);
  ///@}

  ///@{
  /**
   * Set/Get the azimuth for AZIMUTH_AND_ELEVATION, clockwise from north seen from above [degrees]; north is
   * 0, east 90. Any finite number is valid. Default is 0.
   */
  void SetAzimuth(double degrees);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /**
   * Set/Get the elevation above the horizontal plane for AZIMUTH_AND_ELEVATION [degrees]. Valid range:
   * [-90, 90]. Default is 10.
   */
  void SetElevation(double degrees);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /**
   * Set/Get date, time and place for DATE_AND_PLACE. They can be changed in place. Null makes the default.
   */
  void SetEphemeris(vtkGodRaysSunPosition* ephemeris);
  vtkGodRaysSunPosition* GetEphemeris();
  ///@}

  /**
   * Azimuth and elevation [degrees], however they are set.
   */
  double* GetAngles() VTK_SIZEHINT(2);

  /**
   * Whether some of the disc is above the horizontal plane.
   */
  bool IsAboveHorizon();

  /**
   * Whether the sun lights a scene without a sky: by date and place while IsAboveHorizon(); by azimuth and
   * elevation always, since a scene may well be lit from below.
   */
  bool Shines();

  ///@{
  /**
   * Set/Get the radius of the disc as it is seen from the earth [degrees]. Valid range: [0.01, 90]. Default
   * is 0.2678, that of the real sun on average.
   */
  void SetAngularRadius(double degrees);
  vtkGetMacro(AngularRadius, double);
  ///@}

  ///@{
  /**
   * Set/Get the colour of the light, as shown on the display [no unit]; a sky has it from the air instead.
   * Valid range: [0, 1] each. Default is (1, 1, 1).
   */
  void SetColor(double red, double green, double blue);
  void SetColor(const double color[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(Color, double);
  ///@}

  /**
   * Up and north of the frame in the world. CAMERA takes those of the camera, which looks to the north; a
   * null camera is one that looks along -z, with +y up. Neither is of a certain length.
   */
  void GetAxes(vtkCamera* camera, double up[3], double north[3]);

  /**
   * The direction to the sun in the world, of length 1; for the camera see GetAxes(). Returns false if Up
   * and North are 0 or parallel, with an error that is told once until the sun is changed.
   */
  bool GetDirection(vtkCamera* camera, double direction[3]);

  /**
   * Set Position, Azimuth and Elevation so that the sun is seen in this direction of the world, of any length
   * but 0, in the present frame; for the camera see GetAxes(). Returns false, and changes nothing, if the
   * direction is 0 or not finite, or if Up and North are 0 or parallel.
   */
  bool MoveTo(vtkCamera* camera, const double direction[3]);

  /**
   * Make a light that of the sun: directional, in Color, of intensity 1. It is a scene light, or a camera
   * light for CAMERA. Returns false, after an error, for a null light or as GetDirection() does; the light
   * stays as it is then.
   */
  bool UpdateLight(vtkLight* light);

  /**
   * The ephemeris' changes count.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkGodRaysSun();
  ~vtkGodRaysSun() override;

private:
  vtkGodRaysSun(const vtkGodRaysSun&) = delete;
  void operator=(const vtkGodRaysSun&) = delete;

  vtkSmartPointer<vtkGodRaysSunPosition> Ephemeris;
  int Frame = CAMERA;
  double Up[3] = { 0.0, 0.0, 1.0 };
  double North[3] = { 0.0, 1.0, 0.0 };
  int Position = AZIMUTH_AND_ELEVATION;
  double Azimuth = 0.0;
  double Elevation = 10.0;
  double Angles[2] = { 0.0, 0.0 };
  double AngularRadius = 0.2678;
  double Color[3] = { 1.0, 1.0, 1.0 };
  vtkMTimeType ErrorTime = 0; // of the sun whose error has been told
};

#endif
