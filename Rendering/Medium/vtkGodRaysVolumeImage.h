// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysVolumeImage
 * @brief   a volume's data as an image with a value at each point; private to this module
 *
 * Data of a vtkImageData's points are taken as they are. Data of its cells go to its points, each the mean of
 * the cells about it that are not hidden, as by vtkCellDataToPointData; those of other grids, then, by
 * vtkResampleToImage. What was resampled is kept until the data, their array or the resolution change.
 */

#ifndef vtkGodRaysVolumeImage_h
#define vtkGodRaysVolumeImage_h

#include "vtkGodRaysGridTable.h" // For vtkGodRaysGridBits
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkAbstractVolumeMapper;
class vtkDataArray;
class vtkDataObject;
class vtkImageData;

class vtkGodRaysVolumeImage
{
public:
  static constexpr double MostPoints = 1024.0 * 1024.0 * 1024.0;
  static constexpr vtkIdType MostSamples = 20000;

  /// What data are at the centre of one of their cells.
  struct Sample
  {
    std::array<double, 3> Place;
    double Value;
  };

  /**
   * Take the data of a mapper whose pipeline is up to date, with at most so many points along an axis if they
   * are resampled. Of several components at an image's points the first or the last one is copied, if so
   * chosen. Returns what is wrong, and what to do; empty if nothing is.
   */
  enum Component
  {
    ONLY,
    FIRST,
    LAST
  };
  std::string Update(vtkAbstractVolumeMapper* mapper, int resolution, Component choice = ONLY);

  ///@{
  /// The image, its numbers, and whether each point is in the data and not hidden; empty: all are. Until
  /// Forget().
  vtkImageData* GetImage() const { return this->Image; }
  vtkDataArray* GetScalars() const { return this->Scalars; }
  const vtkGodRaysGridBits& GetMask() const { return this->Shown; }
  ///@}

  /**
   * What the data are in some of their cells if they were resampled, else nothing.
   */
  const std::vector<Sample>& GetSamples() const { return this->Samples; }

  /**
   * Let go of what is not resampled.
   */
  void Forget();

  /// When data, or any part of them, changed last.
  static vtkMTimeType GetTime(vtkDataObject* data);

private:
  void Resample(vtkDataObject* data, const char* name, bool ofCells, int resolution);

  vtkImageData* Image = nullptr;
  vtkDataArray* Scalars = nullptr;
  vtkGodRaysGridBits Shown;
  vtkSmartPointer<vtkDataArray> Part; // one of several components
  vtkSmartPointer<vtkImageData> Resampled;
  std::vector<Sample> Samples;
  const void* Data = nullptr; // that it is of
  vtkMTimeType Time = 0;
  std::string Array;
  bool OfCells = false;
  int Resolution = 0;
};

#endif
