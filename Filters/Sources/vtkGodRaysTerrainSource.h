// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysTerrainSource
 * @brief   heights of a fractal terrain, with normals, colours and a hint of shadow
 *
 * Fractal Brownian motion over gradient noise [MusgraveKolbMace1989] [Perlin2002]:
 *
 *     h(x, y) = Height sum_k g^k n_k(l^k R^k (x, y) Features/Width) / sum_k g^k,   k < Octaves
 *
 * with g = Gain, l = Lacunarity, n noise within [-1, 1], and R a turn by atan(3/4). A typical height is
 * 0.15 Height; none is beyond +-Height.
 *
 * Output: vtkImageData of one slice, centred at the origin, with float and unsigned char point data:
 * - "Height", the active scalars [world unit];
 * - "Normals" of the surface (x, y, h), of length 1, from derivatives and not from neighbouring points;
 * - "SmoothNormals", those of the first SmoothOctaves alone;
 * - "SelfShadow", 1 - Normals.SmoothNormals, from 0 to below 2: where the two disagree, a point is likely to
 *   be in the shadow of its surroundings [Quilez2009] [no unit];
 * - "Color", RGB: grass, rock where it is steep, snow where it is high.
 *
 * Any extent can be asked for, and only that is computed: a terrain of any size can be streamed. Points do
 * not depend on the extent, nor on the number of threads. A surface is made by VTK's filters:
 *
 *     source -> vtkWarpScalar -> vtkAssignAttribute (Normals, NORMALS) -> vtkDataSetSurfaceFilter
 *
 * Octaves whose hills are narrower than two points are noise of the points: take fewer. Progress is told 20
 * times; after AbortExecute the output is empty.
 *
 * @sa vtkWarpScalar vtkAssignAttribute vtkDataSetSurfaceFilter vtkImageDataStreamer
 */

#ifndef vtkGodRaysTerrainSource_h
#define vtkGodRaysTerrainSource_h

#include "vtkGodRaysSourcesModule.h" // For export macro
#include "vtkImageAlgorithm.h"

class VTKGODRAYSSOURCES_EXPORT vtkGodRaysTerrainSource : public vtkImageAlgorithm
{
public:
  static vtkGodRaysTerrainSource* New();
  vtkTypeMacro(vtkGodRaysTerrainSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get the number of points along x and y. Valid range: [2, 1000000] each. Default is 513 and 513.
   */
  void SetDimensions(int x, int y);
  void SetDimensions(const int dimensions[2]) { this->SetDimensions(dimensions[0], dimensions[1]); }
  vtkGetVector2Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Set/Get the width along x [world unit]; points are as far apart along y. Valid range: [1e-6, 1e9].
   * Default is 100.
   */
  void SetWidth(double width);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /**
   * Set/Get the bound of heights above and below 0 [world unit]; a typical height is 0.15 of it. Valid
   * range: [0, 1e9]. Default is 30.
   */
  void SetHeight(double height);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Set/Get how many of the largest hills and valleys lie along the width. Valid range: [0.01, 1000].
   * Default is 4.
   */
  void SetFeatures(double features);
  vtkGetMacro(Features, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of octaves of noise. Valid range: [1, 16]. Default is 9.
   */
  vtkSetClampMacro(Octaves, int, 1, 16);
  vtkGetMacro(Octaves, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of octaves of the smooth normals, never more than those of noise. Valid range: [1,
   * 16]. Default is 4.
   */
  vtkSetClampMacro(SmoothOctaves, int, 1, 16);
  vtkGetMacro(SmoothOctaves, int);
  ///@}

  ///@{
  /**
   * Set/Get the height of an octave as a fraction of the one before. Valid range: [0, 1]. Default is 0.5.
   */
  void SetGain(double gain);
  vtkGetMacro(Gain, double);
  ///@}

  ///@{
  /**
   * Set/Get how many times finer an octave is than the one before. Valid range: [1, 4]. Default is 2.
   */
  void SetLacunarity(double lacunarity);
  vtkGetMacro(Lacunarity, double);
  ///@}

  ///@{
  /**
   * Set/Get the height from which there is snow [fraction of Height]. Valid range: [-1, 1]. Default is 0.15.
   */
  void SetSnowHeight(double fraction);
  vtkGetMacro(SnowHeight, double);
  ///@}

  ///@{
  /**
   * Set/Get the slope from which there is rock [degrees]. Valid range: [0, 90]. Default is 35.
   */
  void SetRockSlope(double degrees);
  vtkGetMacro(RockSlope, double);
  ///@}

  ///@{
  /**
   * Set/Get which of many terrains. Valid range: [0, 1000000000]. Default is 1.
   */
  vtkSetClampMacro(Seed, int, 0, 1000000000);
  vtkGetMacro(Seed, int);
  ///@}

protected:
  vtkGodRaysTerrainSource();
  ~vtkGodRaysTerrainSource() override = default;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysTerrainSource(const vtkGodRaysTerrainSource&) = delete;
  void operator=(const vtkGodRaysTerrainSource&) = delete;

  void GetGrid(double origin[3], double spacing[3]) const;
  void GetColor(double height, double upNormal, unsigned char color[3]) const;

  int Dimensions[2] = { 513, 513 };
  double Width = 100.0;
  double Height = 30.0;
  double Features = 4.0;
  int Octaves = 9;
  int SmoothOctaves = 4;
  double Gain = 0.5;
  double Lacunarity = 2.0;
  double SnowHeight = 0.15;
  double RockSlope = 35.0;
  int Seed = 1;
};

#endif
