// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysGridMediumFilter
 * @brief   what filters of physical single scattering share that know media of data
 *
 * Besides the medium of formulas there may be media whose coefficients are numbers at the points of an image,
 * any number of them, one in another if need be: smoke in haze. They add up. At a place in a cell the
 * coefficients are trilinear between its corners; outside of the image they are 0. Light is dimmed by data on
 * its way to the place where it is scattered, and on its way to the eye.
 *
 * The scalars of each image are its extinction coefficient [1/scene unit], for all colours or, with three
 * components, for red, green and blue. Fields of other kinds of data (rectilinear, AMR, unstructured) are
 * made images of by vtkResampleToImage; what that leaves out is the error of that filter.
 *
 * Numbers that are negative or not finite, an image of one slice, and one without scalars at its points
 * are an error, and the output is empty.
 */

#ifndef vtkGodRaysGridMediumFilter_h
#define vtkGodRaysGridMediumFilter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysMediumFilter.h"

#include <string> // For std::string
#include <vector> // For std::vector

struct vtkGodRaysGrid;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysGridMediumFilter : public vtkGodRaysMediumFilter
{
public:
  vtkTypeMacro(vtkGodRaysGridMediumFilter, vtkGodRaysMediumFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the picture's width and height [pixels]. Valid range: [1, 32768]. Default is 256 and 256.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * Set/Get what the scalars of data are times, to be an extinction coefficient [1/scene unit for each of
   * their units]: say, a mass density's extinction for each unit of mass and area. Valid range: [0, 1e9].
   * Default is 1.
   */
  void SetDataScale(double scale);
  vtkGetMacro(DataScale, double);
  ///@}

  ///@{
  /**
   * Set/Get the single-scattering albedo of data, for red, green and blue: what part of extinction is
   * scattering. Valid range: [0, 1]. Default is 1: nothing is absorbed.
   */
  void SetDataAlbedo(const double albedo[3]);
  void SetDataAlbedo(double red, double green, double blue);
  vtkGetVector3Macro(DataAlbedo, double);
  ///@}

  ///@{
  /**
   * Set/Get into which directions data scatter light, one of PhaseFunctionType. Default is
   * HENYEY_GREENSTEIN.
   */
  vtkSetClampMacro(DataPhaseFunction, int, ISOTROPIC, vtkGodRaysLastPhaseFunction);
  vtkGetMacro(DataPhaseFunction, int);
  ///@}

  ///@{
  /**
   * Set/Get the asymmetry g of the phase function of data [no unit]: above 0, light goes on rather than
   * back. Valid range: [-0.99, 0.99]. Default is 0.6.
   */
  void SetDataAsymmetry(double g);
  vtkGetMacro(DataAsymmetry, double);
  ///@}

protected:
  vtkGodRaysGridMediumFilter() = default;
  ~vtkGodRaysGridMediumFilter() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /**
   * The images of a port as numbers. Returns what is wrong with Size, or which image cannot be used, and what
   * to do; empty if all is well.
   */
  std::string ReadGrids(vtkInformationVector* input, std::vector<vtkGodRaysGrid>& grids) const;

  int ScalarType = VTK_FLOAT; // of the output
  int Size[2] = { 256, 256 };
  double DataScale = 1.0;
  double DataAlbedo[3] = { 1.0, 1.0, 1.0 };
  int DataPhaseFunction = HENYEY_GREENSTEIN;
  double DataAsymmetry = 0.6;

private:
  vtkGodRaysGridMediumFilter(const vtkGodRaysGridMediumFilter&) = delete;
  void operator=(const vtkGodRaysGridMediumFilter&) = delete;
};

#endif
