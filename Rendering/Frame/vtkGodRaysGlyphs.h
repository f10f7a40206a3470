// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysGlyphs.h
 * @brief   where the glyphs of a mapper are; private to this module
 */

#ifndef vtkGodRaysGlyphs_h
#define vtkGodRaysGlyphs_h

#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkGlyph3DMapper;
class vtkPolyData;

/**
 * The boxes of the glyphs that a mapper draws at the points of a data set, each the box of its source, scaled
 * and turned as the mapper does it, with a diagonal. Null where there are more than 100,000 points, and where
 * the table of sources is a tree.
 */
vtkSmartPointer<vtkPolyData> vtkGodRaysMakeGlyphBoxes(vtkGlyph3DMapper* mapper, vtkDataSet* data);

#endif
