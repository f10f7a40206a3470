// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysVolumeGrid
 * @brief   a volume as a medium of data; private to this module
 *
 * Extinction and tint of a vtkVolume at the points of its image, or of that to which its grid is
 * resampled, by its transfer functions there, in the place where its matrix puts it. Points that cropping or
 * clipping planes cut off have none. Colours are shown values, of sRGB's transfer.
 */

#ifndef vtkGodRaysVolumeGrid_h
#define vtkGodRaysVolumeGrid_h

#include "vtkGodRaysGrid.h"

#include <string>

class vtkGodRaysVolumeImage;
class vtkProp;

class vtkGodRaysVolumeGrid
{
public:
  /// What all volumes of a model share; see vtkGodRaysMediumModel.
  struct Numbers
  {
    double Scale = 1.0;
    double Albedo[3] = { 1.0, 1.0, 1.0 };
    int PhaseFunction = 0;
    double Asymmetry = 0.0;
    int Resolution = 128;
  };

  /// Of extinction at the centres of cells that were resampled [fraction of the largest there].
  struct Error
  {
    double Mean = 0.0; // root mean square
    double Largest = 0.0;
    double Whole = 0.0; // what they are fractions of [1/scene unit]
  };

  /**
   * Read a prop whose pipeline is up to date. data are those that the last call left for it. Returns what is
   * wrong, and what to do; empty if nothing is.
   */
  static std::string Read(vtkProp* prop, const Numbers& numbers, vtkGodRaysVolumeImage& data,
    vtkGodRaysGrid& grid, Error& error);
};

#endif
