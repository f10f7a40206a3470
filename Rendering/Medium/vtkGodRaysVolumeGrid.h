// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysVolumeGrid
 * @brief   a volume as a medium of data; private to this module
 *
 * Extinction and tint of a vtkVolume at the points of its image, by its transfer functions there, in the
 * place where its matrix puts it. Points that cropping or clipping planes cut off have none. Colours are
 * shown values, of sRGB's transfer.
 */

#ifndef vtkGodRaysVolumeGrid_h
#define vtkGodRaysVolumeGrid_h

#include "vtkGodRaysGrid.h"

#include <string>

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
  };

  static constexpr double MostPoints = 1024.0 * 1024.0 * 1024.0;

  /**
   * Read a prop whose pipeline is up to date. Returns what is wrong, and what to do; empty if nothing is.
   */
  static std::string Read(vtkProp* prop, const Numbers& numbers, vtkGodRaysGrid& grid);
};

#endif
