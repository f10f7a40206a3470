// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The range of an array without broken numbers.
 */

#ifndef Outliers_h
#define Outliers_h

class vtkDataArray;

/**
 * Finds the range of the finite values of a component, or of the magnitudes where it is -1, without outliers:
 * values that are farther from the range of all others than 1000 times as much as these range over, as 1e299
 * among temperatures. The others are at least 98 % of the values. Returns whether there are outliers. The
 * range is [1, -1] if there is no finite value.
 */
bool FindUsualRange(vtkDataArray* values, int component, double range[2]);

#endif
