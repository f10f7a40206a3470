// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysResponse.h
 * @brief   how the sum of one light of a look is shown; private to this module
 *
 * The numbers of RadialResponse() in the formulas. Lengths are heights of the whole picture, also where one
 * tile of it is drawn.
 */

#ifndef vtkGodRaysResponse_h
#define vtkGodRaysResponse_h

struct vtkGodRaysResponse
{
  double Light[2] = { 0.5, 0.5 };   ///< its place in the picture of the sum, from 0 to 1
  double Heights[2] = { 1.0, 1.0 }; ///< width and height of that picture
  double Nearest = 0.0;             ///< distance from the light to the picture
  double Reach = 0.0;               ///< over which rays fade to 1/e; 0: they do not
  double Streaks = 0.0;             ///< amplitude

  bool IsLinear() const { return this->Reach <= 0.0 && this->Streaks <= 0.0; }
};

#endif
