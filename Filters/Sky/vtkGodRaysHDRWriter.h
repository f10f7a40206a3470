// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysHDRWriter
 * @brief   writes pictures of light as Radiance .hdr files
 *
 * A pixel is four bytes: three mantissas and their exponent of 2 [Ward1991]. The error of each channel is
 * at most 0.39 % of the pixel's brightest one; values from 2^-127 to 1.69e38 can be written, others count
 * as 0 or as that, and so do negative ones and NaN as 0. vtkHDRReader reads the file. Programs of Radiance
 * add half a unit of the mantissa, 0.2 to 0.4 %, as they read: VTK does not, and this is written for it.
 *
 * Input: vtkImageData of one slice, with scalars of 1 component (grey) or 3 and more (red, green, blue),
 * of any type, taken as they are. Rows of 8 to 32767 pixels are compressed. What cannot be written is one
 * error that says what to do, with an error code: nothing is written.
 *
 * @sa vtkGodRaysSkySource
 */

#ifndef vtkGodRaysHDRWriter_h
#define vtkGodRaysHDRWriter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkImageWriter.h"

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysHDRWriter : public vtkImageWriter
{
public:
  static vtkGodRaysHDRWriter* New();
  vtkTypeMacro(vtkGodRaysHDRWriter, vtkImageWriter);

  /**
   * Update the input, and write it to FileName.
   */
  void Write() override;

protected:
  vtkGodRaysHDRWriter() = default;
  ~vtkGodRaysHDRWriter() override = default;

private:
  vtkGodRaysHDRWriter(const vtkGodRaysHDRWriter&) = delete;
  void operator=(const vtkGodRaysHDRWriter&) = delete;
};

#endif
