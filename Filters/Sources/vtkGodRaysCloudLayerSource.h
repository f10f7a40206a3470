// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysCloudLayerSource
 * @brief   a layer of clouds in the wind: translucent geometry, and a texture
 *
 * The opacity of the layer at (x, y) is that of noise above a threshold:
 *
 *     n = fractal Brownian motion of ((x, y) - wind t)/CloudSize, t/EvolutionTime    [MusgraveKolbMace1989]
 *     opacity = Opacity smoothstep(c - 2 sigma Softness, c + 2 sigma Softness, n)
 *
 * where sigma is the standard deviation of n, and c follows from Coverage: n, nearly normally distributed,
 * is above c on that part of the layer. Over a layer of few clouds, chance makes it more or less.
 *
 * Output port 0: vtkPolyData, a square of Width at Altitude, or a dome above it, as quads with point data
 * - "Color", RGBA, the active scalars;
 * - "TextureCoordinates", (0, 0) to (1, 1), by which the texture of port 1 fits.
 * Output port 1: vtkImageData, the same clouds seen from above, RGBA, as a texture of finer detail. With it,
 * turn the mapper's ScalarVisibility off. In both cases turn the property's Lighting off: colours are final.
 *
 * Time: any from 0 to EndTime; without one asked for it is 0: in a script, ask by UpdateTimeStep(). It has
 * no memory: bytes depend neither on what was asked for before, nor on the number of threads. Progress is
 * told 20 times for each output; after AbortExecute both are empty. In parallel, the first process has the
 * geometry.
 *
 * @sa vtkGodRaysPass vtkTexture
 */

#ifndef vtkGodRaysCloudLayerSource_h
#define vtkGodRaysCloudLayerSource_h

#include "vtkGodRaysSourcesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class vtkImageData;

class VTKGODRAYSSOURCES_EXPORT vtkGodRaysCloudLayerSource : public vtkPolyDataAlgorithm
{
public:
  static vtkGodRaysCloudLayerSource* New();
  vtkTypeMacro(vtkGodRaysCloudLayerSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The form of the layer.
  enum ShapeType
  {
    PLANE = 0, ///< z = Altitude
    DOME = 1   ///< the upper half of an ellipsoid: Altitude above the centre, 0 at the four corners
  };

  ///@{
  /**
   * Set/Get the form of the layer, one of ShapeType. Others are an error. Default is PLANE.
   */
  void SetShape(int shape);
  vtkGetMacro(Shape, int);
  ///@}

  ///@{
  /**
   * Set/Get the width of the layer along x and y [world unit]. Valid range: [1e-6, 1e9]. Default is 1000.
   */
  void SetWidth(double width);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /**
   * Set/Get the height of the layer above the ground [world unit]. Valid range: [-1e9, 1e9]. Default is 100.
   */
  void SetAltitude(double altitude);
  vtkGetMacro(Altitude, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of points along a side of the geometry. Valid range: [2, 4096]. Default is 129.
   */
  vtkSetClampMacro(Resolution, int, 2, 4096);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of points along a side of the texture. Valid range: [2, 16384]. Default is 512.
   */
  vtkSetClampMacro(TextureResolution, int, 2, 16384);
  vtkGetMacro(TextureResolution, int);
  ///@}

  ///@{
  /**
   * Set/Get the size of the largest clouds [world unit]. Valid range: [1e-6, 1e9]. Default is 150.
   */
  void SetCloudSize(double size);
  vtkGetMacro(CloudSize, double);
  ///@}

  ///@{
  /**
   * Set/Get the number of octaves of noise, each twice as fine. Valid range: [1, 16]. Default is 6.
   */
  vtkSetClampMacro(Octaves, int, 1, 16);
  vtkGetMacro(Octaves, int);
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
   * Set/Get the part of the sky that is behind clouds of at least half the Opacity. 0 is a clear sky, 1 an
   * overcast one, whatever the other parameters. Valid range: [0, 1]. Default is 0.5.
   */
  void SetCoverage(double fraction);
  vtkGetMacro(Coverage, double);
  ///@}

  ///@{
  /**
   * Set/Get how softly clouds end: 0 is a hard edge. Valid range: [0, 1]. Default is 0.4.
   */
  void SetSoftness(double softness);
  vtkGetMacro(Softness, double);
  ///@}

  ///@{
  /**
   * Set/Get over which part of the way from the centre to the sides the layer fades away, so that it has no
   * border. Valid range: [0, 1]. Default is 0.3.
   */
  void SetEdgeFade(double fraction);
  vtkGetMacro(EdgeFade, double);
  ///@}

  ///@{
  /**
   * Set/Get the largest opacity. Valid range: [0, 1]. Default is 0.95.
   */
  void SetOpacity(double opacity);
  vtkGetMacro(Opacity, double);
  ///@}

  ///@{
  /**
   * Set/Get the colour of clouds. Valid range: [0, 1] each. Default is (1, 1, 1).
   */
  void SetColor(double red, double green, double blue);
  void SetColor(const double color[3]);
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /**
   * Set/Get how fast the wind blows [world unit/s]. Valid range: [0, 1e6]. Default is 10.
   */
  void SetWindSpeed(double speed);
  vtkGetMacro(WindSpeed, double);
  ///@}

  ///@{
  /**
   * Set/Get whereto the wind blows [degrees from x, counterclockwise seen from above]. Valid range: [-360,
   * 360]. Default is 0.
   */
  void SetWindDirection(double degrees);
  vtkGetMacro(WindDirection, double);
  ///@}

  ///@{
  /**
   * Set/Get in what time the largest clouds become others [s]. Valid range: [1e-3, 1e9]. Default is 60.
   */
  void SetEvolutionTime(double seconds);
  vtkGetMacro(EvolutionTime, double);
  ///@}

  ///@{
  /**
   * Set/Get the last time that can be asked for [s]. Valid range: [0, 1e6]. Default is 60.
   */
  void SetEndTime(double seconds);
  vtkGetMacro(EndTime, double);
  ///@}

  ///@{
  /**
   * Set/Get which of many skies. Valid range: [0, 1000000000]. Default is 1.
   */
  vtkSetClampMacro(Seed, int, 0, 1000000000);
  vtkGetMacro(Seed, int);
  ///@}

  /**
   * The texture, output port 1.
   */
  vtkImageData* GetTexture();

protected:
  vtkGodRaysCloudLayerSource();
  ~vtkGodRaysCloudLayerSource() override = default;

  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkGodRaysCloudLayerSource(const vtkGodRaysCloudLayerSource&) = delete;
  void operator=(const vtkGodRaysCloudLayerSource&) = delete;

  // The clouds at one time.
  class Clouds;
  bool MakeGeometry(const Clouds& clouds, vtkPolyData* geometry);
  bool MakeTexture(const Clouds& clouds, const int extent[6], vtkImageData* texture);

  int Shape = PLANE;
  double Width = 1000.0;
  double Altitude = 100.0;
  int Resolution = 129;
  int TextureResolution = 512;
  double CloudSize = 150.0;
  int Octaves = 6;
  double Gain = 0.5;
  double Coverage = 0.5;
  double Softness = 0.4;
  double EdgeFade = 0.3;
  double Opacity = 0.95;
  double Color[3] = { 1.0, 1.0, 1.0 };
  double WindSpeed = 10.0;
  double WindDirection = 0.0;
  double EvolutionTime = 60.0;
  double EndTime = 60.0;
  int Seed = 1;
};

#endif
