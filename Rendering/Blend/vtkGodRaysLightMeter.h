// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysLightMeter
 * @brief   how strong rays may be in a picture; private to this module
 *
 * Reads a few thousand pixels of what is to be joined, scene and rays, and finds the factors on the rays with
 * which
 * - data, the pixels that show something rather than a background, keep their colours: those that are lit,
 *   and, where most are, all of them, change by at most MostDifference on average, and keep at least
 *   LeastChroma of their chroma; in a look they also gain no more than they may lose, or MostTint if that is
 *   more; light before a silhouette is what one sees;
 * - rays are neither invisible nor a white sheet: see FindExposure().
 *
 * @sa vtkGodRaysBlendPass
 */

#ifndef vtkGodRaysLightMeter_h
#define vtkGodRaysLightMeter_h

#include "vtkGodRaysBlendPass.h" // For Request
#include "vtkGodRaysTarget.h"

#include <array>
#include <memory>
#include <vector>

class vtkImageData;
class vtkRenderer;
class vtkWindow;

class vtkGodRaysLightMeter
{
public:
  /// What is joined in a pixel [linear light].
  struct Sample
  {
    std::array<double, 3> Scene = {}; ///< without rays, and without what dims it
    std::array<double, 3> Base = {};  ///< to which rays are added
    std::array<double, 3> Rays = {};
    double DataPart = 0.0; ///< how much of it shows something rather than a background
  };

  ///@{
  /// What is promised, 9 and 0.9, with something to spare for the pixels that are not read.
  static constexpr double MostDifference = 7.0; ///< mean distance in CIE 1976 L*a*b*
  static constexpr double LeastChroma = 0.92;   ///< fraction of the mean chroma
  static constexpr double MostTint = 2.0;       ///< chroma that grey data may gain, just visible
  ///@}

  ///@{
  /// Of the rays of a look, which is dark between its shafts, and of a medium [linear light, 1 is white].
  static constexpr double MostBrightest[2] = { 1.2, 4.0 }; ///< 99th percentile
  static constexpr double MostMean[2] = { 0.08, 0.35 };    ///< mean
  static constexpr double MostQuartile = 0.3;              ///< 75th percentile, for a sky in smoke
  ///@}

  vtkGodRaysLightMeter();
  ~vtkGodRaysLightMeter();
  vtkGodRaysLightMeter(const vtkGodRaysLightMeter&) = delete;
  void operator=(const vtkGodRaysLightMeter&) = delete;

  /**
   * Read the pixels that a request joins, at intensity 1, into the samples. Returns false, after an error,
   * if that failed; the framebuffer that was bound is bound again.
   */
  bool Read(vtkGodRaysBlendPass* blending, const vtkGodRaysBlendPass::Request& request);

  /**
   * Read which part of the picture of a request is covered, into one float a cell, of 60 rows where the
   * picture
   * is not very wide or tall; and the mean colour of the rest [CIE 1976 L*a*b*], as far as the request has
   * scene's colours. Returns as Read().
   */
  bool ReadCoverage(vtkGodRaysBlendPass* blending, const vtkGodRaysBlendPass::Request& request,
    vtkImageData* coverage, double ground[3]);

  /**
   * The AlphaLayers of a request, for the props of a renderer: how translucent ones are drawn decides it.
   */
  static double FindAlphaLayers(vtkRenderer* renderer);

  /// The OpacityLayers of a request: of alpha that is opacity, two layers spare the colours of what is thin
  /// without an outline.
  static constexpr double TrueAlphaLayers = 2.0;

  /// Whether alpha is 0 where nothing is drawn, as far as was read; true before.
  bool AlphaShowsData() const { return this->HasAlpha; }

  /**
   * Whether rays with this factor change one of the samples by a lightness of 1 or more, half of what is
   * just visible.
   */
  bool ShowsRays(double exposure) const;

  /**
   * The fraction of the data's light that a medium leaves in the samples, on average; of the whole picture if
   * that has no data, 1 if it is black.
   */
  double FindTransmittance() const;

  /// Factors on the rays.
  struct Exposure
  {
    double Everywhere = 1.0;
    double OverData = 1.0; ///< a further one where data are seen, see SeenPart() in the formulas
    double OverDark = 1.0; ///< and where they are not
    double DataGain = 1.0; ///< on data behind a medium, see DataGain() in the formulas
  };

  /**
   * The surround for the samples, whose rays have this factor: from none, where the lightness of the
   * background is 55 [L*] on average, to all of it, from 78 on. Rays leave it as it is from the 90th
   * percentile of theirs before it, of the rings about a place of the picture, the light's, so that shafts
   * are told from what a light loses with distance. All rays are added up to a lightness of 75, none from
   * 90 on. Aspect is the picture's width over its height.
   */
  vtkGodRaysBlendPass::Surround FindSurround(double exposure, const double place[2], double aspect);

  /**
   * The exposure for the samples: the largest, at most largest, with which the mean of the rays is MostMean
   * or less, their 75th percentile MostQuartile, and their 99th percentile MostBrightest; largest, if there
   * are no rays. Then it is lowered so far that data keep their colours: over data alone, those that are
   * lit and dark ones each for themselves, if they are to be spared. Else, in a medium, they first gain
   * what it takes of their light on average, twice as much at most; its light is lowered over them alone
   * down to half, then everywhere, but a fifth of it is left beside data, as a medium that only dims would
   * be none; then over data alone, of which 1.5 % are left.
   */
  Exposure FindExposure(bool shoulder, double largest, bool sparesData);

  void Release(vtkWindow* window);

private:
  class Fidelity;

  bool Draw(vtkGodRaysBlendPass* blending, const vtkGodRaysBlendPass::Request& request, int columns,
    int rows);

  vtkGodRaysTarget Target;
  std::vector<Sample> Samples;
  std::vector<float> Pixels;               // as read; kept for its memory, as the next two
  std::vector<double> Ranked;              // to find a percentile of
  static constexpr int NumberOfRings = 24; // about a light; the last is all that is beyond
  static constexpr double RingsInHeight = 12.0;
  std::array<std::vector<double>, NumberOfRings> Rings; // the same
  std::unique_ptr<Fidelity> Data;                       // of the samples that show data
  bool HasAlpha = true;
};

#endif
