// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysGridPicture
 * @brief   what media of data do to a picture, fast and to a tolerance
 *
 * Private. For each pixel: the light that data scatter once, plus what they take from the light that the
 * medium of formulas scatters, before, in and behind them; and what they leave of what is behind. The
 * light's optical depths through data are computed once and kept (vtkGodRaysGridLight). A view ray skips
 * blocks of cells that are empty; in others its steps are the shorter the more extinction changes there
 * and the more light still comes from there. Pixels are evaluated 8 apart, and nearer to each other where
 * the middle of a square is not the mean of its corners, or where the depths that end rays are not
 * linear.
 *
 * vtkGodRaysSingleScattering is the truth.
 */

#ifndef vtkGodRaysGridPicture_h
#define vtkGodRaysGridPicture_h

#include "vtkGodRaysFiltersModule.h" // For export macro
#include "vtkGodRaysFroxels.h"
#include "vtkGodRaysGrid.h"
#include "vtkGodRaysShadowGrids.h"
#include "vtkGodRaysSingleScattering.h" // For Parameters

#include <memory>
#include <vector>

class vtkGodRaysGridLight;

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysGridPicture
{
public:
  struct Picture
  {
    int Size[2] = { 0, 0 };
    double PixelSize = 1.0; // at depth 1, or of a parallel projection
    double Center[2] = { 0.0,
      0.0 };                        // where the axis of view is [pixels from the lower left corner]
    const float* Depths = nullptr;  // view depths that end rays; null: FarLimit does
    float* Radiance = nullptr;      // result, RGB: to be added to that of the medium without data
    float* Transmittance = nullptr; // result, RGB: of data alone
  };

  vtkGodRaysGridPicture();
  ~vtkGodRaysGridPicture();
  vtkGodRaysGridPicture(const vtkGodRaysGridPicture&) = delete;
  void operator=(const vtkGodRaysGridPicture&) = delete;

  /**
   * Take at most MaximumGrids media, whose data must stay; again whenever they change. With sameExtinction
   * only what they scatter does: depths are kept.
   */
  void SetGrids(const std::vector<vtkGodRaysGrid>& grids, bool sameExtinction = false);
  static constexpr std::size_t MaximumGrids = 32;

  /**
   * What surfaces hide from the light, in view coordinates; null: nothing. It must stay while a picture
   * is drawn.
   */
  void SetShadows(const vtkGodRaysShadowGrids* shadows);

  /**
   * Add light of two and more scatterings, from these, which must stay while a picture is drawn: that of air
   * along view rays without data, null without air; and what data scatter of it. Null: none is added.
   */
  void SetDiffuse(const vtkGodRaysFroxels* air, const vtkGodRaysFroxels::Source* data);

  /**
   * Find the light's depths through data, as Draw() does.
   */
  void Prepare(const vtkGodRaysSingleScattering::Parameters& parameters);

  /**
   * Draw a picture. Tolerance of the parameters is the accepted error [fraction of the largest radiance].
   */
  void Draw(const vtkGodRaysSingleScattering::Parameters& parameters, const Picture& picture);

  /**
   * The light's depths in each grid, valid until the next Draw() or Prepare().
   */
  std::vector<const vtkGodRaysGridLight*> GetLights() const;

  ///@{
  /// Of the last picture: how many view rays were evaluated, with how many steps; whether the light's
  /// depths were kept; how many bytes are, beside data.
  std::size_t GetNumberOfRays() const;
  std::size_t GetNumberOfSteps() const;
  bool KeptLight() const;
  std::size_t GetKeptSize() const;
  ///@}

private:
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
