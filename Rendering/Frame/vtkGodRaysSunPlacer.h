// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSunPlacer
 * @brief   where in a picture a sun behind the scene makes the most shafts
 *
 * A place is judged by the shafts that a light would make there. The light's glow is followed along 160
 * directions past the coverage of the picture, and the lightness of the rays is compared on three rings about
 * the place. Each local maximum of lightness by angle counts by its prominence, at most 25 L*, so that many
 * shafts count more than one strong wedge. The sum is lowered for places in the open, places deep behind the
 * data, places below the data, and places near the edge of the picture.
 *
 * The coverage is an image, such as the one that vtkGodRaysPass makes of its first frame. No OpenGL is
 * needed.
 *
 * @sa vtkGodRaysPass
 */

#ifndef vtkGodRaysSunPlacer_h
#define vtkGodRaysSunPlacer_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"
#include "vtkWrappingHints.h" // For VTK_SIZEHINT

#include <memory> // For std::unique_ptr

class vtkCamera;
class vtkImageData;
class vtkLight;
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
   * Valid range: [0, 1]. Default is 0.
   */
  vtkSetClampMacro(Lowest, double, 0.0, 1.0);
  vtkGetMacro(Lowest, double);
  ///@}

  ///@{
  /**
   * Set the coverage, and find the best place for it. coverage: one 32-bit float a cell, the fraction of
   * it that is covered, in [0, 1];
   * rows from the picture's lower edge; cells are square. 50 to 70 rows are enough. SetCoverageImage()
   * returns false, after an error, and changes nothing for any other image. Find() returns whether there is a
   * place that makes shafts; if not, Place is the most open one, or the usual one if nothing is covered.
   * With a
   * renderer, places below the far edge of its ground are left out, where a sun would stand under it: that
   * of a flat box of visible props that is seen from above.
   */
  bool SetCoverageImage(vtkImageData* coverage);
  bool Find(vtkRenderer* renderer = nullptr);
  ///@}

  ///@{
  /**
   * The score of one place of the coverage, 0 if it is more than 0.08 outside the picture; and the number of
   * shafts that the data make of a light there, on average over the three rings.
   */
  double GetScoreAt(double x, double y) const;
  double GetShaftsAt(double x, double y) const;
  ///@}

  ///@{
  /**
   * The result: a place, from (0, 0) at the picture's lower left to (1, 1), by default (0.35, 0.75), up to
   * 0.08 outside; its score [L*], 0 if there is none and some 80 at best; the fraction of the picture that is
   * covered; the box of what is covered, its left, right, lower and upper edge, the whole picture if nothing
   * is.
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
   * A place behind a renderer's visible props that is seen at a place of the picture, for a lamp in the place
   * of a sun: in a parallel projection, and in air. Returns false, and leaves it alone, as GetDirection().
   */
  static bool GetPosition(vtkRenderer* renderer, double x, double y, double position[3]);

  /**
   * Where a light that shines from afar, or a lamp, is seen in a renderer's picture. Returns false, and
   * leaves the place alone, if it is behind the camera.
   */
  static bool FindPlace(vtkRenderer* renderer, vtkLight* light, double place[2]);

  /**
   * The place for a sun where nothing says a better one: (0.35, 0.75).
   */
  static const double* GetUsualPlace() VTK_SIZEHINT(2);

protected:
  vtkGodRaysSunPlacer();
  ~vtkGodRaysSunPlacer() override;

private:
  vtkGodRaysSunPlacer(const vtkGodRaysSunPlacer&) = delete;
  void operator=(const vtkGodRaysSunPlacer&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;

  double Lowest = 0.0;
  double Place[2] = { 0.35, 0.75 };
  double Score = 0.0;
  double Coverage = 0.0;
  double CoveredBounds[4] = { 0.0, 1.0, 0.0, 1.0 };
};

#endif
