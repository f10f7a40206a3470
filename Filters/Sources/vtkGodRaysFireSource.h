// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysFireSource
 * @brief   particles of a fire, at any time
 *
 * Particle b = 0, 1, 2, ... is born at b/SpawnRate, and lives for Lifetime. At age a, it is at
 *
 *     q = Center + PositionRandomness r_b + a (Velocity + VelocityRandomness w_b)
 *     p = q + a Turbulence n(q/TurbulenceSize, t/Lifetime)
 *
 * with r_b and w_b random points of the unit ball, and n three gradient noises, each within [-1, 1]. A
 * particle has no memory: any time is computed by itself, from the seed. If more than Capacity particles
 * live, the oldest are left out.
 *
 * Output: vtkPolyData, a vertex for each particle, the oldest first, with point data:
 * - "Color", RGBA, the active scalars: from StartColor to EndColor; alpha falls from Opacity to 0;
 * - "Size" [world unit], which falls to 0 as well;
 * - "Age" [s].
 * vtkPointGaussianMapper draws it, with SetScaleArray("Size"), EmissiveOn() for flames that add up, and
 * ScaleFactor 1.
 *
 * Time: any from 0, when the first is born, to EndTime; without one asked for it is 0: in a script, ask by
 * UpdateTimeStep(). TimeScale is applied to it. Bytes do not depend on the number of threads, nor on what was
 * asked for before. Progress is told 20 times; after AbortExecute the output is empty. In parallel, each
 * process computes its share of the particles.
 *
 * @sa vtkPointGaussianMapper vtkGodRaysSmokeSource
 */

#ifndef vtkGodRaysFireSource_h
#define vtkGodRaysFireSource_h

#include "vtkGodRaysSourcesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKGODRAYSSOURCES_EXPORT vtkGodRaysFireSource : public vtkPolyDataAlgorithm
{
public:
  static vtkGodRaysFireSource* New();
  vtkTypeMacro(vtkGodRaysFireSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the largest number of particles; the oldest are left out. Valid range: [1, 10000000]. Default is
   * 20000.
   */
  vtkSetClampMacro(Capacity, int, 1, 10000000);
  vtkGetMacro(Capacity, int);
  ///@}

  ///@{
  /**
   * Set/Get how many particles are born [1/s]. Valid range: [0, 1e9]. Default is 1500.
   */
  void SetSpawnRate(double rate);
  vtkGetMacro(SpawnRate, double);
  ///@}

  ///@{
  /**
   * Set/Get how long particles live [s]. Valid range: [1e-3, 1e6]. Default is 1.2.
   */
  void SetLifetime(double seconds);
  vtkGetMacro(Lifetime, double);
  ///@}

  ///@{
  /**
   * Set/Get how much faster than the time asked for the fire burns. Valid range: [0, 1000]. Default is 1.
   */
  void SetTimeScale(double scale);
  vtkGetMacro(TimeScale, double);
  ///@}

  ///@{
  /**
   * Set/Get the last time that can be asked for [s]. Valid range: [0, 1e6]. Default is 10.
   */
  void SetEndTime(double seconds);
  vtkGetMacro(EndTime, double);
  ///@}

  ///@{
  /**
   * Set/Get the centre of the ball where particles are born [world unit]. Valid range: [-1e9, 1e9] each.
   * Default is (0, 0, 0).
   */
  void SetCenter(double x, double y, double z);
  void SetCenter(const double center[3]);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * Set/Get the radius of the ball where particles are born [world unit]. Valid range: [0, 1e9]. Default is
   * 0.25.
   */
  void SetPositionRandomness(double radius);
  vtkGetMacro(PositionRandomness, double);
  ///@}

  ///@{
  /**
   * Set/Get the mean velocity of particles [world unit/s]. Valid range: [-1e6, 1e6] each. Default is (0, 0,
   * 1.2).
   */
  void SetVelocity(double x, double y, double z);
  void SetVelocity(const double velocity[3]);
  vtkGetVector3Macro(Velocity, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest deviation from the velocity [world unit/s]. Valid range: [0, 1e6]. Default is 0.25.
   */
  void SetVelocityRandomness(double speed);
  vtkGetMacro(VelocityRandomness, double);
  ///@}

  ///@{
  /**
   * Set/Get the bound of the speed at which eddies carry particles along each axis [world unit/s]. Valid
   * range: [0, 1e6]. Default is 0.4.
   */
  void SetTurbulence(double speed);
  vtkGetMacro(Turbulence, double);
  ///@}

  ///@{
  /**
   * Set/Get the size of eddies [world unit]. Valid range: [1e-6, 1e6]. Default is 0.4.
   */
  void SetTurbulenceSize(double size);
  vtkGetMacro(TurbulenceSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the size of particles at birth [world unit]. Valid range: [0, 1e9]. Default is 0.08.
   */
  void SetSize(double size);
  vtkGetMacro(Size, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest deviation of the size [fraction]. Valid range: [0, 1]. Default is 0.5.
   */
  void SetSizeRandomness(double fraction);
  vtkGetMacro(SizeRandomness, double);
  ///@}

  ///@{
  /**
   * Set/Get the colour at birth. Valid range: [0, 1] each. Default is (1, 0.62, 0.2).
   */
  void SetStartColor(double red, double green, double blue);
  void SetStartColor(const double color[3]);
  vtkGetVector3Macro(StartColor, double);
  ///@}

  ///@{
  /**
   * Set/Get the colour at the end. Valid range: [0, 1] each. Default is (0.75, 0.08, 0.01).
   */
  void SetEndColor(double red, double green, double blue);
  void SetEndColor(const double color[3]);
  vtkGetVector3Macro(EndColor, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest deviation of each component of the colour [fraction]. Valid range: [0, 1]. Default
   * is 0.2.
   */
  void SetColorRandomness(double fraction);
  vtkGetMacro(ColorRandomness, double);
  ///@}

  ///@{
  /**
   * Set/Get the opacity at birth. Valid range: [0, 1]. Default is 0.06.
   */
  void SetOpacity(double opacity);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /**
   * Set/Get which of many fires. Valid range: [0, 1000000000]. Default is 1.
   */
  vtkSetClampMacro(Seed, int, 0, 1000000000);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkGodRaysFireSource();
  ~vtkGodRaysFireSource() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysFireSource(const vtkGodRaysFireSource&) = delete;
  void operator=(const vtkGodRaysFireSource&) = delete;

  struct Particle;
  Particle ComputeParticle(vtkTypeInt64 birth, double time) const;

  int Capacity = 20000;
  double SpawnRate = 1500.0;
  double Lifetime = 1.2;
  double TimeScale = 1.0;
  double EndTime = 10.0;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double PositionRandomness = 0.25;
  double Velocity[3] = { 0.0, 0.0, 1.2 };
  double VelocityRandomness = 0.25;
  double Turbulence = 0.4;
  double TurbulenceSize = 0.4;
  double Size = 0.08;
  double SizeRandomness = 0.5;
  double StartColor[3] = { 1.0, 0.62, 0.2 };
  double EndColor[3] = { 0.75, 0.08, 0.01 };
  double ColorRandomness = 0.2;
  double Opacity = 0.06;
  int Seed = 1;
};

#endif
