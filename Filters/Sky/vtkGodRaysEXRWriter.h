// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysEXRWriter
 * @brief   writes all arrays of an image, by name, as an OpenEXR file
 *
 * Channels are 32-bit floats, without loss but for numbers of more figures. The scalars of 3 components are
 * R, G and B, what programs show as the picture; those of 4 are R, G, B and A; those of 1 are Y. Every other
 * array of points is a layer: <name>.R, .G, .B, .A, or, of one component, <name>. Numbers are written as they
 * are. In OpenEXR, colours are multiplied by A (premultiplied): give them so.
 * Arrays of the field data of one number are attributes of the header under their names, and units of
 * arrays, vtkDataArray::UNITS_LABEL(), attributes <name>_Unit.
 *
 * Input: vtkImageData of one slice with arrays of points of 1, 3 or 4 components; others are left out. Rows
 * go from the top, as in all such files. What cannot be written is one error that says what to do, with an
 * error code: nothing is written. It needs OpenEXR while it is built: see IsAvailable().
 *
 * @sa vtkGodRaysHDRWriter
 */

#ifndef vtkGodRaysEXRWriter_h
#define vtkGodRaysEXRWriter_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkImageWriter.h"

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysEXRWriter : public vtkImageWriter
{
public:
  static vtkGodRaysEXRWriter* New();
  vtkTypeMacro(vtkGodRaysEXRWriter, vtkImageWriter);

  /**
   * Whether this library was built with OpenEXR. If not, Write() is an error.
   */
  static bool IsAvailable();

  /**
   * Update the input, and write it to FileName.
   */
  void Write() override;

protected:
  vtkGodRaysEXRWriter() = default;
  ~vtkGodRaysEXRWriter() override = default;

private:
  vtkGodRaysEXRWriter(const vtkGodRaysEXRWriter&) = delete;
  void operator=(const vtkGodRaysEXRWriter&) = delete;
};

#endif
