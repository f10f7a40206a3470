// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysVisibilityFilter
 * @brief   what a medium leaves of the sight of points, and of the light on them, in numbers
 *
 * CameraPosition is the observer, the points of the input are the targets. The medium between is that of
 * vtkGodRaysMediumFilter: homogeneous, or with exponential densities over a plane or a planet. Each way is
 * integrated in closed form: no steps, no OpenGL. The output is the input with these arrays of its points;
 * three components are red, green and blue, numbers alone are those of green:
 *
 * | array                 | unit                | what                                                       |
 * |-----------------------|---------------------|------------------------------------------------------------|
 * | Distance_m            | m                   | from the observer                                          |
 * | OpticalDepth          | 1                   | tau of the way, three components                           |
 * | Transmittance         | 1                   | e^-tau, three components                                   |
 * | Contrast              | 1                   | of the target against the horizon, by Koschmieder's law    |
 * | MeteorologicalRange_m | m                   | -ln(ContrastThreshold) distance/tau; infinite for tau = 0   |
 * | Hidden                | 1                   | 1: an occluder or the planet's ground is before the target |
 * | Visible               | 1                   | 1: not Hidden, and Contrast is at least ContrastThreshold  |
 * | Irradiance            | W m-2, see LightColor | of the light after the medium, across it, three components |
 *
 * Units are in the arrays' information, under vtkDataArray::UNITS_LABEL(). The field data have, for each of
 * them but the flags, <name>_Error: a bound of the error of the method, whose UNITS_LABEL says of what it is
 * a part. The arrays of the input keep their names; one of the same name is replaced.
 *
 * LightColor is in W m^-2 for a directional light and in W sr^-1 for a point light; Irradiance is in
 * other units if it is. With LightColor 1, it is that of a light of 1: relative.
 * WorldUnitInMeters is for Distance_m, the range, and the square of the distance from a point light.
 * Coefficients and scale heights are in scene units, as those of all filters of a medium.
 *
 * Second input, optional: vtkPolyData that hide targets and cast shadows, both sides of their polygons and
 * strips. What is nearer than 1e-6 of the scene's size to a target, the observer or a point light is not in
 * the way: targets may lie on occluders. In a server of several processes each has its own occluders.
 *
 * Bytes do not depend on the number of threads. A parameter that cannot be used is one error that says what
 * to do, and the output is empty. CameraFocalPoint, CameraViewUp, ViewAngle, ParallelProjection and
 * ParallelScale are not read. The medium goes on beyond FarLimit.
 *
 * @sa vtkGodRaysSingleScatteringReference
 */

#ifndef vtkGodRaysVisibilityFilter_h
#define vtkGodRaysVisibilityFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMediumFilter.h"

class vtkPointSet;
class vtkPolyData;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysVisibilityFilter : public vtkGodRaysMediumFilter
{
public:
  static vtkGodRaysVisibilityFilter* New();
  vtkTypeMacro(vtkGodRaysVisibilityFilter, vtkGodRaysMediumFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get how long the scene's unit is [m], for distances, ranges and the irradiance of a point light.
   * Coefficients are in 1/scene unit. Valid range: [1e-12, 1e12]. Default is 1.
   */
  void SetWorldUnitInMeters(double meters);
  vtkGetMacro(WorldUnitInMeters, double);
  ///@}

  ///@{
  /**
   * Set/Get the contrast of a target with the horizon from near by, without its sign [no unit]. 1 is that of
   * a black target. Valid range: [0, 1e6]. Default is 1.
   */
  void SetInherentContrast(double contrast);
  vtkGetMacro(InherentContrast, double);
  ///@}

  ///@{
  /**
   * Set/Get the contrast from which on a target is seen [no unit]: 0.02 is Koschmieder's, 0.05 that of the
   * meteorological optical range of the WMO. Valid range: [1e-6, 0.999]. Default is 0.02.
   */
  void SetContrastThreshold(double threshold);
  vtkGetMacro(ContrastThreshold, double);
  ///@}

  ///@{
  /**
   * Set/Get whether there is the array Irradiance: of the light after the medium. Default is on.
   */
  vtkSetMacro(ComputeIrradiance, bool);
  vtkGetMacro(ComputeIrradiance, bool);
  vtkBooleanMacro(ComputeIrradiance, bool);
  ///@}

  ///@{
  /**
   * Set what hides targets and casts shadows: the second input.
   */
  void SetOccludersConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetOccludersData(vtkPolyData* occluders);
  ///@}

  /**
   * The output: of the class of the input.
   */
  vtkPointSet* GetOutput();

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

protected:
  vtkGodRaysVisibilityFilter();
  ~vtkGodRaysVisibilityFilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysVisibilityFilter(const vtkGodRaysVisibilityFilter&) = delete;
  void operator=(const vtkGodRaysVisibilityFilter&) = delete;

  class vtkInternals;

  std::string FindFaultOfAll() const;

  double WorldUnitInMeters = 1.0;
  double InherentContrast = 1.0;
  double ContrastThreshold = 0.02;
  bool ComputeIrradiance = true;
};

#endif
