// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialModel.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysRadialEffect.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

vtkStandardNewMacro(vtkGodRaysRadialModel);

vtkGodRaysSetFiniteMacro(vtkGodRaysRadialModel, Density, 0.0, 2.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialModel, Decay, 0.0, 1.05);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialModel, Weight, 0.0, 100.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialModel, Exposure, 0.0, 100.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysRadialModel, ClampMaximum, 0.0, 65504.0);

namespace
{
using vtkGodRays::TapSum;
using vtkGodRays::Vec2;
using vtkGodRays::Vec3;
using TapSums = std::vector<TapSum>;

struct Parameters
{
  double Density;
  double Decay;
  double Weight;
  double Exposure;
  double ClampMaximum;
  int NumberOfSamples;
};

//------------------------------------------------------------------------------
// gain (originWeight s_0 + sum_{k=first}^{last} firstWeight decay^(k-first) s_k)
TapSum MakeTapSum(
  const Parameters& p, int first, int last, double originWeight, double firstWeight, double gain)
{
  TapSum sum;
  sum.FirstTap = first;
  sum.LastTap = last;
  sum.TapOffset = 0.0;
  sum.OriginWeight = originWeight;
  sum.FirstWeight = firstWeight;
  sum.Decay = p.Decay;
  sum.Step = p.Density / p.NumberOfSamples;
  sum.FixedLength = 0.0;
  sum.InputBias = 0.0;
  sum.InputGain = 1.0;
  sum.OutputBias = 0.0;
  sum.OutputGain = gain;
  sum.Maximum = 0.0;
  sum.RedToGrey = 0;
  return sum;
}

//------------------------------------------------------------------------------
// The weight is w (1 - d_N)/(1 - d).
TapSums SumInvariant(const Parameters& p, int taps)
{
  const int count = taps > 0 ? taps : p.NumberOfSamples;
  const double ratio = static_cast<double>(p.NumberOfSamples) / count;
  const double weight = p.Weight * vtkGodRays::GeometricSum(p.Decay, ratio);
  TapSum sum = MakeTapSum(p, 1, count, 0.0, weight, p.Exposure);
  sum.TapOffset = 0.5;
  sum.Decay = std::pow(p.Decay, ratio);
  sum.Step = p.Density / count;
  return { sum };
}

//------------------------------------------------------------------------------
TapSums SumMitchell(const Parameters& p, int)
{
  return { MakeTapSum(p, 1, p.NumberOfSamples, 1.0, p.Weight, p.Exposure) };
}

//------------------------------------------------------------------------------
// The weight decays before it is used, and the loop starts at 1.
TapSums SumGianassi(const Parameters& p, int)
{
  return { MakeTapSum(p, 1, p.NumberOfSamples - 1, 1.0, p.Weight * p.Decay, p.Exposure) };
}

//------------------------------------------------------------------------------
// The decay starts at 0.1, not 1.
TapSums SumLayers(const Parameters& p, int)
{
  TapSum sum = MakeTapSum(p, 1, p.NumberOfSamples, 0.0, 0.1 * p.Weight, p.Exposure);
  sum.Maximum = p.ClampMaximum;
  return { sum };
}

//------------------------------------------------------------------------------
TapSums SumLayersAsPublished(const Parameters& p, int taps)
{
  TapSums sums = SumLayers(p, taps);
  sums[0].RedToGrey = 1;
  return sums;
}

//------------------------------------------------------------------------------
// n + 1 terms over n, as printed.
TapSums SumEquation(const Parameters& p, int)
{
  return { MakeTapSum(p, 0, p.NumberOfSamples, 0.0, p.Weight, p.Exposure / p.NumberOfSamples) };
}

//------------------------------------------------------------------------------
TapSums SumPostprocessing(const Parameters& p, int)
{
  TapSum sum = MakeTapSum(p, 1, p.NumberOfSamples, 0.0, p.Weight, p.Exposure);
  sum.Maximum = p.ClampMaximum;
  return { sum };
}

//------------------------------------------------------------------------------
// The occluders, 1 - s, are blurred three times with 6 taps, 1/6, 1/36 and 1/216 of the picture apart;
// what is left of the light is e (1 - blur).
TapSums SumThreeJS(const Parameters& p, int)
{
  const int taps = 6;
  TapSums sums;
  double length = 1.0;
  for (int pass = 0; pass < 3; ++pass)
  {
    length /= taps;
    TapSum sum = MakeTapSum(p, 0, taps - 1, 0.0, 1.0, 1.0 / taps);
    sum.Decay = 1.0;
    sum.FixedLength = length;
    sum.RedToGrey = 1;
    sums.push_back(sum);
  }
  sums.front().InputBias = 1.0;
  sums.front().InputGain = -1.0;
  sums.back().OutputBias = p.Exposure;
  sums.back().OutputGain = -p.Exposure / taps;
  return sums;
}

//------------------------------------------------------------------------------
TapSums SumBabylon(const Parameters& p, int)
{
  return { MakeTapSum(p, 1, p.NumberOfSamples, 1.0, p.Weight, 0.4 * p.Exposure) };
}

//------------------------------------------------------------------------------
// The loop ends one tap late, but never after 100.
TapSums SumErkaman(const Parameters& p, int)
{
  const int last = std::min(p.NumberOfSamples + 1, 100);
  return { MakeTapSum(p, 1, last, 0.0, p.Weight, p.Exposure) };
}

//------------------------------------------------------------------------------
// All that distinguishes the formulations, in the order of vtkGodRaysRadialModel::Formulation.
struct FormulationRow
{
  const char* Name;
  int Border;
  bool LinearLight;
  int Blend;
  double SceneGain;
  bool Clamps;
  TapSums (*Sum)(const Parameters&, int taps);
};

using Model = vtkGodRaysRadialModel;
const FormulationRow Formulations[] = {
  { "invariant", Model::ZERO_BORDER, true, Model::ADD, 1.0, false, SumInvariant },
  { "mitchell", Model::EDGE_BORDER, false, Model::ADD, 1.0, false, SumMitchell },
  { "gianassi", Model::EDGE_BORDER, false, Model::ADD, 1.0, false, SumGianassi },
  { "layers", Model::EDGE_BORDER, false, Model::ADD, 1.0, true, SumLayers },
  { "layers-as-published", Model::EDGE_BORDER, false, Model::ADD, 1.0, true, SumLayersAsPublished },
  { "equation", Model::ZERO_BORDER, true, Model::ADD, 1.0, false, SumEquation },
  { "postprocessing", Model::EDGE_BORDER, true, Model::SCREEN, 1.0, true, SumPostprocessing },
  { "three.js", Model::EDGE_BORDER, false, Model::ADD, 1.0, false, SumThreeJS },
  { "babylon", Model::EDGE_BORDER, false, Model::ADD, 1.1, false, SumBabylon },
  { "erkaman", Model::EDGE_BORDER, false, Model::ADD, 1.0, false, SumErkaman },
  { "araujo", Model::EDGE_BORDER, false, Model::ADD, 1.0, false, SumMitchell },
};
const int NumberOfFormulations = sizeof(Formulations) / sizeof(Formulations[0]);
static_assert(NumberOfFormulations == Model::ARAUJO + 1, "one row for each formulation");

//------------------------------------------------------------------------------
struct PresetRow
{
  const char* Name;
  const char* Description;
  int Formulation;
  double Density;
  double Decay;
  double Weight;
  double Exposure;
  int NumberOfSamples;
};

// ClampMaximum is 1 in all of them.
const PresetRow Presets[] = {
  { "default", "Balanced shafts, for any scene", Model::INVARIANT, 0.97, 0.98, 0.03, 1.0, 100 },
  { "soft-haze", "Short, weak shafts that melt into a haze", Model::INVARIANT, 0.95, 0.97, 0.025,
    1.0, 100 },
  { "crisp-shafts", "Long, even shafts with clear edges", Model::INVARIANT, 1.0, 1.015, 0.0028, 1.0,
    100 },
  { "low-sun", "Strong, long shafts of a sun near the horizon", Model::INVARIANT, 0.98, 0.99, 0.028,
    1.0, 100 },
  { "underwater", "Shafts that are lost in murky water", Model::INVARIANT, 0.7, 0.96, 0.09, 1.0,
    100 },
  { "dusty-room", "Beams through a window into dust", Model::INVARIANT, 0.85, 0.98, 0.035, 1.0,
    100 },
  { "cathedral", "Broad beams that cross a tall room", Model::INVARIANT, 1.2, 0.985, 0.016, 1.0,
    100 },
  { "mitchell", "Listing of GPU Gems 3, which states no numbers, with those of gianassi",
    Model::MITCHELL, 0.8, 0.99, 0.8, 0.05, 100 },
  { "gianassi", "Crepuscular rays with three.js by Gianassi and Gigli", Model::GIANASSI, 0.8, 0.99,
    0.8, 0.05, 100 },
  { "layers", "React Three Fiber tutorial, its slip in green and blue mended", Model::LAYERS, 0.54,
    0.99, 4.75, 0.055, 100 },
  { "layers-as-published", "React Three Fiber tutorial, red in all three channels",
    Model::LAYERS_AS_PUBLISHED, 0.54, 0.99, 4.75, 0.055, 100 },
  { "equation", "Equation 4 of GPU Gems 3 as printed, faint by 1/n, with the numbers of gianassi",
    Model::EQUATION, 0.8, 0.99, 0.8, 0.05, 100 },
  { "postprocessing", "GodRaysEffect of pmndrs postprocessing", Model::POSTPROCESSING, 0.96, 0.9,
    0.4, 0.6, 60 },
  { "three.js", "GodRaysShader of three.js: three passes of six taps", Model::THREE_JS, 1.0, 1.0,
    1.0, 0.69, 6 },
  { "babylon", "VolumetricLightScatteringPostProcess of Babylon.js", Model::BABYLON, 0.926, 0.96815,
    0.58767, 0.3, 100 },
  { "erkaman", "glsl-godrays by Erkaman", Model::ERKAMAN, 1.0, 1.0, 0.01, 1.0, 100 },
  { "araujo", "screen-space-godrays by Araujo", Model::ARAUJO, 1.0, 1.0, 0.01, 1.0, 100 },
};
const int NumberOfPresets = sizeof(Presets) / sizeof(Presets[0]);

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
void vtkGodRaysRadialModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Density: " << this->Density << "\n";
  os << indent << "Decay: " << this->Decay << "\n";
  os << indent << "Weight: " << this->Weight << "\n";
  os << indent << "Exposure: " << this->Exposure << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "ClampMaximum: " << this->ClampMaximum << "\n";
  os << indent << "Formulation: " << this->GetFormulationAsString() << "\n";
  os << indent << "FlatGain: " << this->GetFlatGain() << "\n";
  os << indent << "LinearLight: " << this->GetLinearLight() << "\n";
  os << indent << "Blend: " << this->GetBlend() << "\n";
  os << indent << "SceneGain: " << this->GetSceneGain() << "\n";
}

//------------------------------------------------------------------------------
void vtkGodRaysRadialModel::SetFormulation(int formulation)
{
  if (formulation < 0 || formulation >= NumberOfFormulations)
  {
    vtkErrorMacro("Formulation must be one of 0 (INVARIANT) to "
      << ARAUJO << " (ARAUJO), not " << formulation << "; it stays " << this->Formulation << ".");
    return;
  }
  if (this->Formulation != formulation)
  {
    this->Formulation = formulation;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkGodRaysRadialModel::GetFormulationAsString() const
{
  return Formulations[this->Formulation].Name;
}

//------------------------------------------------------------------------------
bool vtkGodRaysRadialModel::ApplyPreset(const char* name)
{
  std::string names;
  for (const PresetRow& preset : Presets)
  {
    if (name && std::strcmp(name, preset.Name) == 0)
    {
      this->SetFormulation(preset.Formulation);
      this->SetDensity(preset.Density);
      this->SetDecay(preset.Decay);
      this->SetWeight(preset.Weight);
      this->SetExposure(preset.Exposure);
      this->SetNumberOfSamples(preset.NumberOfSamples);
      this->SetClampMaximum(1.0);
      return true;
    }
    names += names.empty() ? "" : ", ";
    names += preset.Name;
  }
  vtkErrorMacro(
    "There is no preset \"" << (name ? name : "") << "\". The presets are: " << names << ".");
  return false;
}

//------------------------------------------------------------------------------
int vtkGodRaysRadialModel::GetNumberOfPresets()
{
  return NumberOfPresets;
}

//------------------------------------------------------------------------------
const char* vtkGodRaysRadialModel::GetPresetName(int index)
{
  return index >= 0 && index < NumberOfPresets ? Presets[index].Name : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkGodRaysRadialModel::GetPresetDescription(int index)
{
  return index >= 0 && index < NumberOfPresets ? Presets[index].Description : nullptr;
}

//------------------------------------------------------------------------------
int vtkGodRaysRadialModel::GetBorder() const
{
  return Formulations[this->Formulation].Border;
}

//------------------------------------------------------------------------------
void vtkGodRaysRadialModel::GetTapSums(std::vector<TapSum>& passes, int taps) const
{
  const Parameters parameters = { this->Density, this->Decay, this->Weight, this->Exposure,
    this->ClampMaximum, this->NumberOfSamples };
  passes = Formulations[this->Formulation].Sum(parameters, taps);
}

//------------------------------------------------------------------------------
bool vtkGodRaysRadialModel::Evaluate(vtkImageData* layer, const double lightClip[3],
  double marchScale, double viewScale, const int size[2], vtkImageData* scattering, int taps)
{
  const std::string fault = FindFault(layer, lightClip, marchScale, viewScale, size, scattering);
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot evaluate the radial sum: " << fault << ".");
    return false;
  }

  TapSums passes;
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

//------------------------------------------------------------------------------
bool vtkGodRaysRadialModel::CanScatter() const
{
  return this->Density > 0.0 && this->Weight > 0.0 && this->Exposure > 0.0 &&
    (this->ClampMaximum > 0.0 || !Formulations[this->Formulation].Clamps);
}

//------------------------------------------------------------------------------
double vtkGodRaysRadialModel::GetFlatGain() const
{
  TapSums passes;
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

//------------------------------------------------------------------------------
vtkGodRaysIntegrator* vtkGodRaysRadialModel::MakeIntegrator() const
{
  return vtkGodRaysEpipolarIntegrator::New();
}

//------------------------------------------------------------------------------
std::unique_ptr<vtkGodRaysEffect> vtkGodRaysRadialModel::MakeEffect()
{
  return std::make_unique<vtkGodRaysRadialEffect>(this);
}

//------------------------------------------------------------------------------
std::string vtkGodRaysRadialModel::Describe() const
{
  std::ostringstream text;
  text << "radial sum, " << this->GetFormulationAsString() << ": exposure " << this->Exposure;
  if (this->Formulation != THREE_JS)
  {
    text << ", density " << this->Density << ", decay " << this->Decay << ", weight "
         << this->Weight << ", " << this->NumberOfSamples << " samples";
  }
  if (Formulations[this->Formulation].Clamps)
  {
    text << ", at most " << this->ClampMaximum;
  }
  return text.str();
}

//------------------------------------------------------------------------------
bool vtkGodRaysRadialModel::GetLinearLight() const
{
  return Formulations[this->Formulation].LinearLight;
}

//------------------------------------------------------------------------------
int vtkGodRaysRadialModel::GetBlend() const
{
  return Formulations[this->Formulation].Blend;
}

//------------------------------------------------------------------------------
double vtkGodRaysRadialModel::GetSceneGain() const
{
  return Formulations[this->Formulation].SceneGain;
}
