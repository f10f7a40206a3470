// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSmokeSource
 * @brief   smoke that rises from a source, on a grid, in time
 *
 * The density of smoke, by diffusion and advection in the velocity v:
 *
 *     dF/dt = D div grad F - div(v F) - k F + S
 *     v = (SwaySpeed sin(2 pi t/SwayPeriod), 0, RiseSpeed)
 *       + Turbulence (n_x(y, z, t), n_y(x, z, t), n_z(x, y, t))
 *
 * where D is Diffusivity, k Dissipation, S the source and n gradient noise within [-1, 1]. Cells
 * exchange smoke with their neighbours, four in a plane and six in space, and what one gives another
 * gets: with ClosedBoundaries and without Dissipation the mass is what the source has given. Method and
 * figures: vtkGodRaysSmokeSolver.h, Documentation/Sources.md. It is good to look at and to light, and no
 * simulation of a flow: the smoke does not move the air.
 *
 * Output: vtkImageData, float point data "Density". Up is z. The box is centred in x and y, and its lowest
 * points have z = 0; each point stands for a cube of Spacing. Dimensions of 1 along x or y make a plane.
 *
 * Time: multiples of TimeStep from 0, where there is no smoke, to EndTime; the last one that is not after
 * the time asked for. Without one it is 0: in a script, ask by UpdateTimeStep(). A later time goes on from
 * the last one; an earlier one, and any change of a parameter, begins again. Bytes are the same, for each
 * number of threads.
 *
 * In parallel each process computes the whole grid, and gives away the piece that is asked for. A setup
 * that is not possible is one error that says what to do, and the output is empty; so it is after
 * AbortExecute. Progress is told once a step.
 *
 * @sa vtkGodRaysPass vtkSmartVolumeMapper
 */

#ifndef vtkGodRaysSmokeSource_h
#define vtkGodRaysSmokeSource_h

#include "vtkGodRaysSourcesModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKGODRAYSSOURCES_EXPORT vtkGodRaysSmokeSource : public vtkImageAlgorithm
{
public:
  static vtkGodRaysSmokeSource* New();
  vtkTypeMacro(vtkGodRaysSmokeSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the number of points along each axis, at most 2^28 in all; 1 along x or y makes a plane. Valid
   * range: [1, 1024] each. Default is 64, 64, 96.
   */
  void SetDimensions(int x, int y, int z);
  void SetDimensions(const int dimensions[3])
  {
    this->SetDimensions(dimensions[0], dimensions[1], dimensions[2]);
  }
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Set/Get the distance of points [world unit]. Valid range: [1e-6, 1e6]. Default is 0.05.
   */
  void SetSpacing(double spacing);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Set/Get the step of time [s]. One that is too long for the speeds is an error that names the longest.
   * GetLargestTimeStep() tells it before. Valid range: [1e-6, 1000]. Default is 0.02.
   */
  void SetTimeStep(double seconds);
  vtkGetMacro(TimeStep, double);
  ///@}

  /**
   * The longest time step for which the exchange is stable, with the other parameters as they are [s].
   */
  double GetLargestTimeStep() const;

  ///@{
  /**
   * Set/Get the last time that can be asked for [s]. Valid range: [0, 1e6]. Default is 10.
   */
  void SetEndTime(double seconds);
  vtkGetMacro(EndTime, double);
  ///@}

  ///@{
  /**
   * Set/Get how fast smoke spreads by itself [world unit^2/s]. Valid range: [0, 1e6]. Default is 0.01.
   */
  void SetDiffusivity(double diffusivity);
  vtkGetMacro(Diffusivity, double);
  ///@}

  ///@{
  /**
   * Set/Get how fast smoke rises [world unit/s]; it sinks below 0. Valid range: [-1e6, 1e6]. Default is 1.
   */
  void SetRiseSpeed(double speed);
  vtkGetMacro(RiseSpeed, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest speed at which smoke sways along x [world unit/s]. Valid range: [0, 1e6]. Default is
   * 0.25.
   */
  void SetSwaySpeed(double speed);
  vtkGetMacro(SwaySpeed, double);
  ///@}

  ///@{
  /**
   * Set/Get the time from one swing to the next [s]. Valid range: [1e-3, 1e6]. Default is 4.
   */
  void SetSwayPeriod(double seconds);
  vtkGetMacro(SwayPeriod, double);
  ///@}

  ///@{
  /**
   * Set/Get the bound of the speed of eddies along each axis [world unit/s]. Valid range: [0, 1e6]. Default
   * is 0.4.
   */
  void SetTurbulence(double speed);
  vtkGetMacro(Turbulence, double);
  ///@}

  ///@{
  /**
   * Set/Get the size of the largest eddies [world unit]. Valid range: [1e-6, 1e6]. Default is 0.4.
   */
  void SetTurbulenceSize(double size);
  vtkGetMacro(TurbulenceSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the part of the smoke that vanishes in time [1/s]. Valid range: [0, 1000]. Default is 0.1.
   */
  void SetDissipation(double rate);
  vtkGetMacro(Dissipation, double);
  ///@}

  ///@{
  /**
   * Set/Get the density below which there is none. Without it, cells would never be empty again, and
   * processors compute slowly with the smallest numbers. Valid range: [1e-30, 1]. Default is 1e-9.
   */
  void SetMinimumDensity(double density);
  vtkGetMacro(MinimumDensity, double);
  ///@}

  ///@{
  /**
   * Set/Get the centre of the sphere from which smoke comes [world unit]. Valid range: [-1e9, 1e9] each.
   * Default is (0, 0, 0.4).
   */
  void SetSourceCenter(double x, double y, double z);
  void SetSourceCenter(const double center[3]);
  vtkGetVector3Macro(SourceCenter, double);
  ///@}

  ///@{
  /**
   * Set/Get the radius of the sphere from which smoke comes [world unit]. Valid range: [0, 1e9]. Default is
   * 0.2.
   */
  void SetSourceRadius(double radius);
  vtkGetMacro(SourceRadius, double);
  ///@}

  ///@{
  /**
   * Set/Get the density that the source adds [1/s]. Valid range: [0, 1e6]. Default is 3.
   */
  void SetSourceRate(double rate);
  vtkGetMacro(SourceRate, double);
  ///@}

  ///@{
  /**
   * Set/Get until when the source adds smoke [s]. Valid range: [0, 1e6]. Default is 1e6.
   */
  void SetSourceDuration(double seconds);
  vtkGetMacro(SourceDuration, double);
  ///@}

  ///@{
  /**
   * Set/Get whether smoke stays in the box. Without, it leaves through all sides. Default is off.
   */
  vtkSetMacro(ClosedBoundaries, bool);
  vtkGetMacro(ClosedBoundaries, bool);
  vtkBooleanMacro(ClosedBoundaries, bool);
  ///@}

  ///@{
  /**
   * Set/Get which of many eddies. Valid range: [0, 1000000000]. Default is 1.
   */
  vtkSetClampMacro(Seed, int, 0, 1000000000);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkGodRaysSmokeSource();
  ~vtkGodRaysSmokeSource() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysSmokeSource(const vtkGodRaysSmokeSource&) = delete;
  void operator=(const vtkGodRaysSmokeSource&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  void GetOrigin(double origin[3]) const;
  std::string FindFault() const;

  int Dimensions[3] = { 64, 64, 96 };
  double Spacing = 0.05;
  double TimeStep = 0.02;
  double EndTime = 10.0;
  double Diffusivity = 0.01;
  double RiseSpeed = 1.0;
  double SwaySpeed = 0.25;
  double SwayPeriod = 4.0;
  double Turbulence = 0.4;
  double TurbulenceSize = 0.4;
  double Dissipation = 0.1;
  double MinimumDensity = 1e-9;
  double SourceCenter[3] = { 0.0, 0.0, 0.4 };
  double SourceRadius = 0.2;
  double SourceRate = 3.0;
  double SourceDuration = 1e6;
  bool ClosedBoundaries = false;
  int Seed = 1;
};

#endif
