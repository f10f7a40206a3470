// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What of data is looked at once they are read, before filters and mappers take them. Each throws Failure,
 * beginning with the path.
 */

#ifndef DataChecks_h
#define DataChecks_h

#include <string> // For std::string

class vtkDataObject;
class vtkDataSet;

/**
 * Readers do not see whether the points of a cell are there; filters and mappers crash where not.
 */
void CheckCells(const std::string& path, vtkDataObject* data);

/**
 * Readers believe sizes that cannot be, and go on where values are missing; filters then read beyond the end.
 */
void CheckSizes(const std::string& path, vtkDataSet* data);

#endif
