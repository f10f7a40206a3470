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

#include <array>
#include <string>
#include <vector>

class vtkAbstractVolumeMapper;
class vtkGodRaysVolumeImage;
class vtkMatrix4x4;
class vtkProp;
class vtkVolume;

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

  /// Cropping and clipping planes cut this off a volume, in coordinates of its data.
  class Cut
  {
  public:
    Cut(vtkAbstractVolumeMapper* mapper, vtkMatrix4x4* toWorld);
    bool IsNone() const { return !this->Cropped && this->Planes.empty(); }
    bool Takes(const double place[3]) const;
    /// Returns the parts of a line, start + s change, between begin and end that are not cut off.
    std::vector<std::array<double, 2>> GetParts(const vtkGodRays::Vec3& start,
      const vtkGodRays::Vec3& change, double begin, double end) const;

  private:
    bool Cropped = false;
    double Crop[6] = {};
    int Flags = 0;
    std::vector<std::array<double, 4>> Planes; // a x + b y + c z + d >= 0 is kept
  };

  /**
   * Read a prop whose pipeline is up to date. data are those that the last call left for it. Of what is whole
   * no points are cut off. Returns what is wrong, and what to do; empty if nothing is.
   */
  static std::string Read(vtkProp* prop, const Numbers& numbers, vtkGodRaysVolumeImage& data,
    vtkGodRaysGrid& grid, Error& error, bool isWhole = false);

  /**
   * Return by how much a volume's matrix scales lengths: those of a cube of the same volume.
   */
  static double GetScale(vtkVolume* volume);
};

#endif
