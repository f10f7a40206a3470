// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The scattering stage alone, on a given layer, by any method; and how far it is from the reference.

#ifndef Scattering_h
#define Scattering_h

#include "Device.h"
#include "GodRaysPictures.h"
#include "Methods.h"

#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <map>
#include <vector>

/// Errors as fractions of the largest value of the reference.
struct Errors
{
  double RMS = 0.0;
  double Permille = 0.0; // the 99.9th percentile of the absolute errors
  double Largest = 0.0;
  double Bias = 0.0; // the mean error
};

class Scattering
{
public:
  /// What a layer holds.
  enum Content
  {
    ONE_COLOR, ///< of one channel, if the integrator can use that
    RGB        ///< of three
  };

  explicit Scattering(Device& device);
  ~Scattering();

  vtkGodRaysRadialModel* GetModel() const { return this->Model; }

  /// Make the layer of a light behind a picture.
  void SetCase(
    const GodRaysPictures::Mask& mask, const GodRaysPictures::Light& light, int referenceRows);

  /// Whether there is a layer of one channel for this method.
  bool HasOneChannel(const Method& method);

  /// Integrate once; the time that it took [s], with all that it copies to and from the card.
  double Run(const Method& method, Content content);

  /// How far the result of the last Run() is from the reference.
  Errors Compare(Content content);

  /// The layer as an image of one component.
  vtkImageData* GetLayer() const { return this->Layer; }
  const double* GetLightClip() const { return this->LightClip; }
  double GetMarchScale() const { return this->MarchScale; }

private:
  vtkGodRaysTarget& GetTarget(const Method& method, Content content);
  const std::vector<double>& GetReference();

  Device& OpenGL;
  vtkNew<vtkGodRaysRadialModel> Model;
  vtkNew<vtkImageData> Layer;
  std::map<unsigned int, vtkGodRaysTarget> Targets; // by format; as long as the case lasts
  vtkGodRaysSum Result;
  double LightClip[3] = { 0.0, 0.0, 1.0 };
  double MarchScale = 1.0;
  std::vector<int> Rows;         // that are compared
  std::vector<double> Reference; // of those rows, once it was asked for
};

#endif
