// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSunPlacer
 * @brief   where in a picture a sun behind the scene makes the most shafts
 *
 * What props cover of the picture is drawn on a grid of 128 rows, by the processor: no window and no
 * OpenGL are needed. A place is good if the light that leaves it changes much with direction, from edge to
 * gap, where the picture has open room for the shafts; if little of what is covered lies in its glare; and
 * if it is off the middle, a third of the picture from its sides. Places in the open, or behind something
 * wide, are not taken.
 *
 * Polygons, lines and points count as they are, other data sets by their surface, splats by their scale,
 * up to 100,000 glyphs of a mapper by their sources' boxes and more by their points, molecules as balls and
 * sticks, volumes where their opacity is above 0.1. Props tagged LIGHT or IGNORED do not count, nor do
 * invisible ones.
 *
 * @sa vtkGodRaysPass
 */

#ifndef vtkGodRaysSunPlacer_h
#define vtkGodRaysSunPlacer_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"

class vtkCamera;
class vtkGodRaysCompositor;
class vtkGodRaysSilhouette;
class vtkPropCollection;
class vtkRenderer;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysSunPlacer : public vtkObject
{
public:
  static vtkGodRaysSunPlacer* New();
  vtkTypeMacro(vtkGodRaysSunPlacer, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the lowest place that may be taken [fraction of the picture's height, from its lower edge].
   * Valid range: [0, 1]. Default is 0.25.
   */
  vtkSetClampMacro(Lowest, double, 0.0, 1.0);
  vtkGetMacro(Lowest, double);
  ///@}

  ///@{
  /**
   * Look at a renderer's props with its camera, or at props with a camera in a picture of this ratio of
   * width to height. A renderer whose camera was never set is seen as VTK would set it. With a compositor,
   * the props are those of all processes, each of which makes this call, with the same camera and ratio.
   * Returns whether there is a place that is partly covered; if not, Place is the default, or, where
   * something hides that, the place of all the picture that is least hidden. No renderer, or a ratio that is
   * not above 0, is an error.
   */
  bool Find(vtkRenderer* renderer, vtkGodRaysCompositor* compositor = nullptr);
  bool Find(vtkPropCollection* props, vtkCamera* camera, double aspect);
  ///@}

  ///@{
  /**
   * What was found: a place, from (0, 0) at the picture's lower left to (1, 1), by default (0.35, 0.75);
   * how good it is, 0 if there is none, some 3 at best; the fraction of the picture that is covered; the
   * box of what is covered, its left, right, lower and upper edge, the whole picture if nothing is.
   */
  vtkGetVector2Macro(Place, double);
  vtkGetMacro(Score, double);
  vtkGetMacro(Coverage, double);
  vtkGetVector4Macro(CoveredBounds, double);
  ///@}

  ///@{
  /**
   * The direction in which a sun is seen at a place of the picture: towards it, of length 1, in world
   * coordinates. A parallel projection sees one direction alone. Returns false, and leaves the direction
   * alone, if there is no camera or it has no inverse.
   */
  static bool GetDirection(vtkRenderer* renderer, double x, double y, double direction[3]);
  static bool GetDirection(
    vtkCamera* camera, double aspect, double x, double y, double direction[3]);
  ///@}

  /**
   * A place far behind a renderer's visible props that is seen at a place of the picture, for a lamp in the
   * place of a sun in a parallel projection. Returns false, and leaves the position alone, as GetDirection().
   */
  static bool GetPosition(vtkRenderer* renderer, double x, double y, double position[3]);

protected:
  vtkGodRaysSunPlacer() = default;
  ~vtkGodRaysSunPlacer() override = default;

private:
  bool Find(const vtkGodRaysSilhouette& silhouette);

  vtkGodRaysSunPlacer(const vtkGodRaysSunPlacer&) = delete;
  void operator=(const vtkGodRaysSunPlacer&) = delete;

  double Lowest = 0.25;
  double Place[2] = { 0.35, 0.75 };
  double Score = 0.0;
  double Coverage = 0.0;
  double CoveredBounds[4] = { 0.0, 1.0, 0.0, 1.0 };
};

#endif
