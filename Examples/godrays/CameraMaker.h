// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Cameras that show the data from a direction; options that place a camera override it.
 */

#ifndef CameraMaker_h
#define CameraMaker_h

#include "Options.h"
#include "Scene.h"

#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkCamera;

class CameraMaker
{
public:
  CameraMaker(const Scene& scene, const Options& options);

  /**
   * A camera that looks to an azimuth and elevation in degrees: over terrain it stands above the ground,
   * else it sees all data.
   */
  vtkSmartPointer<vtkCamera> Make(double azimuth, double pitch) const;

  /**
   * Let a camera see from a thousandth of the distance of the farthest data to there.
   */
  void SetClippingRange(vtkCamera* camera) const;

  /**
   * Bring a place of the picture, from -1 to 1, to its middle.
   */
  void Turn(vtkCamera* camera, double x, double y) const;

  bool StandsOnTerrain() const;

  double Aspect;            ///< of the picture
  double Angle;             ///< height of the view in degrees
  double Diagonal;          ///< of the data
  Vector3 Center;           ///< of the data
  double StandHeight = 0.2; ///< above the ground, as a fraction of the relief

private:
  void StandOnTerrain(vtkCamera* camera, double azimuth, const Vector3& look) const;
  void ShowWhole(vtkCamera* camera, const Vector3& look) const;
  void ApplySettings(vtkCamera* camera) const;

  const Scene& Data;
  const Options& Settings;
};

#endif
