// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialSumModel.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysRadialEffect.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

vtkGodRaysSetFiniteMacro(vtkGodRaysRadialSumModel, Density, 0.0, 2.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialSumModel, Decay, 0.0, 1.05);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialSumModel, Weight, 0.0, 100.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialSumModel, Exposure, 0.0, 100.0);

namespace
{
using vtkGodRays::TapSum;
using vtkGodRays::Vec2;
using vtkGodRays::Vec3;

// Evaluate one pass on all pixels of an image that covers the part extent of the layer about its
// centre.
template <typename Scalar>
std::vector<double> EvaluatePass(const vtkGodRays::ImageLayerOf<Scalar>& layer, const TapSum& taps,
  const Vec3& lightClip, double marchScale, double extent, int width, int height)
{
  std::vector<double> result(3 * static_cast<std::size_t>(width) * height);
  vtkSMPTools::For(0, height,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType y = begin; y < end; ++y)
      {
        for (int x = 0; x < width; ++x)
        {
          const Vec2 fromCentre = extent * (Vec2(x + 0.5, y + 0.5) / Vec2(width, height) - 0.5);
          const Vec2 march = vtkGodRays::MarchVector(lightClip, 2.0 * fromCentre, marchScale);
          const Vec3 sum = vtkGodRays::SumTaps(layer, taps, fromCentre + 0.5, march);
          double* pixel = result.data() + 3 * (y * static_cast<std::size_t>(width) + x);
          pixel[0] = sum.x;
          pixel[1] = sum.y;
          pixel[2] = sum.z;
        }
      }
    });
  return result;
}

// Why the arguments of Evaluate() cannot be used; empty if they can.
std::string FindFault(vtkImageData* layer, const double lightClip[3], double marchScale,
  double viewScale, const int size[2], vtkImageData* scattering)
{
  if (!layer || !scattering)
  {
    return "the layer and the result must not be null";
  }
  int dimensions[3];
  layer->GetDimensions(dimensions);
  if (dimensions[0] < 1 || dimensions[1] < 1 || dimensions[2] != 1 || !layer->GetScalarPointer() ||
    layer->GetScalarType() != VTK_FLOAT || layer->GetNumberOfScalarComponents() != 3)
  {
    return "the layer must be a 2-D image of 32-bit floats with 3 components";
  }
  if (!std::isfinite(lightClip[0]) || !std::isfinite(lightClip[1]) ||
    !std::isfinite(lightClip[2]) || !std::isfinite(marchScale))
  {
    return "the light's position and the march scale must be finite; is w of the light 0?";
  }
  if (!(viewScale > 0.0 && viewScale <= 1.0))
  {
    return "the view scale must be above 0 and at most 1";
  }
  if (size[0] < 1 || size[1] < 1)
  {
    return "the size must be 1 or more in each direction";
  }
  return {};
}
}

void vtkGodRaysRadialSumModel::SetParameters(
  double density, double decay, double weight, double exposure, int numberOfSamples)
{
  this->SetDensity(density);
  this->SetDecay(decay);
  this->SetWeight(weight);
  this->SetExposure(exposure);
  this->SetNumberOfSamples(numberOfSamples);
}

std::string vtkGodRaysRadialSumModel::DescribeParameters() const
{
  std::ostringstream text;
  text << "exposure " << this->Exposure << ", density " << this->Density << ", decay "
       << this->Decay << ", weight " << this->Weight << ", " << this->NumberOfSamples << " samples";
  return text.str();
}

void vtkGodRaysRadialSumModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "Decay: " << this->Decay << "\n";
  os << indent << "Weight: " << this->Weight << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "FlatGain: " << this->GetFlatGain() << "\n";
  os << indent << "LinearLight: " << this->GetLinearLight() << "\n";
  os << indent << "Blend: " << this->GetBlend() << "\n";
  os << indent << "SceneGain: " << this->GetSceneGain() << "\n";
}

bool vtkGodRaysRadialSumModel::Evaluate(vtkImageData* layer, const double lightClip[3],
  double marchScale, double viewScale, const int size[2], vtkImageData* scattering, int taps)
{
  const std::string fault = FindFault(layer, lightClip, marchScale, viewScale, size, scattering);
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot evaluate the radial sum: " << fault << ".");
    return false;
  }

  std::vector<TapSum> passes;
  this->GetTapSums(passes, taps);
  for (TapSum& pass : passes)
  {
    pass.FixedLength *= viewScale; // from the picture's uv to the layer's
  }
  int dimensions[3];
  layer->GetDimensions(dimensions);
  const Vec3 light(lightClip[0], lightClip[1], lightClip[2]);
  auto evaluate = [&](const auto& source, std::size_t index)
  {
    const bool last = index + 1 == passes.size();
    return EvaluatePass(source, passes[index], light, marchScale, last ? viewScale : 1.0,
      last ? size[0] : dimensions[0], last ? size[1] : dimensions[1]);
  };

  std::vector<double> result(3 * static_cast<std::size_t>(size[0]) * size[1], 0.0);
  if (this->CanScatter())
  {
    const int border = this->GetBorder();
    const auto* pixels = static_cast<const float*>(layer->GetScalarPointer());
    result = evaluate(vtkGodRays::ImageLayer{ pixels, dimensions[0], dimensions[1], border }, 0);
    for (std::size_t index = 1; index < passes.size(); ++index)
    {
      result = evaluate(
        vtkGodRays::ImageLayerOf<double>{ result.data(), dimensions[0], dimensions[1], border },
        index);
    }
  }

  scattering->Initialize();
  scattering->SetDimensions(size[0], size[1], 1);
  scattering->AllocateScalars(VTK_DOUBLE, 3);
  std::copy(result.begin(), result.end(), static_cast<double*>(scattering->GetScalarPointer()));
  return true;
}

bool vtkGodRaysRadialSumModel::CanScatter() const
{
  return this->Density > 0.0 && this->Weight > 0.0 && this->Exposure > 0.0;
}

double vtkGodRaysRadialSumModel::GetFlatGain() const
{
  std::vector<TapSum> passes;
  this->GetTapSums(passes, 0);
  double value = 1.0;
  for (const TapSum& pass : passes)
  {
    double sum = pass.OriginWeight;
    double weight = pass.FirstWeight;
    for (int k = pass.FirstTap; k <= pass.LastTap; ++k)
    {
      sum += weight;
      weight *= pass.Decay;
    }
    value = pass.OutputBias + pass.OutputGain * sum * (pass.InputBias + pass.InputGain * value);
  }
  return value;
}

vtkGodRaysIntegrator* vtkGodRaysRadialSumModel::MakeIntegrator() const
{
  return vtkGodRaysEpipolarIntegrator::New();
}

std::unique_ptr<vtkGodRaysEffect> vtkGodRaysRadialSumModel::MakeEffect()
{
  return std::make_unique<vtkGodRaysRadialEffect>(this);
}
