// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a window shows as linear light, without the limits of its 8 bits.
 */

#ifndef LinearPicture_h
#define LinearPicture_h

#include "vtkSmartPointer.h" // For vtkSmartPointer

class vtkImageData;
class vtkRenderWindow;

/**
 * Three floats for a pixel: linear light of the primaries of sRGB, of which 1 is shown as white. Light that
 * is more than white is kept. With transparent a fourth one: the opacity of the scene, from 0 to 1. The light
 * is that over black then, which OpenEXR calls premultiplied; that of rays comes with no opacity of its own.
 * The window is drawn again if it was drawn in 8 bits, and has colours in 32 bits from then on. Throws
 * Failure when it cannot have those.
 */
vtkSmartPointer<vtkImageData> TakeLinearPicture(vtkRenderWindow* window, bool transparent);

#endif
