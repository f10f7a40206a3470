// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysPublishedModel.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysPresetTable.h"
#include "vtkGodRaysSetGet.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <iterator>
#include <sstream>

vtkStandardNewMacro(vtkGodRaysPublishedModel);

vtkGodRaysSetFiniteMacro(vtkGodRaysPublishedModel, ClampMaximum, 0.0, 65504.0);

namespace
{
using vtkGodRays::TapSum;
using TapSums = std::vector<TapSum>;

struct Parameters
{
  double Density;
  double Decay;
  double Weight;
  double Exposure;
  int NumberOfSamples;
  double ClampMaximum;
};

// gain (originWeight s_0 + sum_{k=first}^{last} firstWeight decay^(k-first) s_k)
TapSum MakeTapSum(
  const Parameters& p, int first, int last, double originWeight, double firstWeight, double gain)
{
  TapSum sum = {};
  sum.FirstTap = first;
  sum.LastTap = last;
  sum.OriginWeight = originWeight;
  sum.FirstWeight = firstWeight;
  sum.Decay = p.Decay;
  sum.Step = p.Density / p.NumberOfSamples;
  sum.InputGain = 1.0;
  sum.OutputGain = gain;
  return sum;
}

TapSums SumMitchell(const Parameters& p)
{
  return { MakeTapSum(p, 1, p.NumberOfSamples, 1.0, p.Weight, p.Exposure) };
}

// The weight decays before it is used, and the loop starts at 1.
TapSums SumGianassi(const Parameters& p)
{
  return { MakeTapSum(p, 1, p.NumberOfSamples - 1, 1.0, p.Weight * p.Decay, p.Exposure) };
}

// The decay starts at 0.1, not 1.
TapSums SumLayers(const Parameters& p)
{
  TapSum sum = MakeTapSum(p, 1, p.NumberOfSamples, 0.0, 0.1 * p.Weight, p.Exposure);
  sum.Maximum = p.ClampMaximum;
  return { sum };
}

TapSums SumLayersAsPublished(const Parameters& p)
{
  TapSums sums = SumLayers(p);
  sums[0].RedToGrey = 1;
  return sums;
}

// n + 1 terms over n, as printed.
TapSums SumEquation(const Parameters& p)
{
  return { MakeTapSum(p, 0, p.NumberOfSamples, 0.0, p.Weight, p.Exposure / p.NumberOfSamples) };
}

TapSums SumPostprocessing(const Parameters& p)
{
  TapSum sum = MakeTapSum(p, 1, p.NumberOfSamples, 0.0, p.Weight, p.Exposure);
  sum.Maximum = p.ClampMaximum;
  return { sum };
}

// The occluders, 1 - s, are blurred three times with 6 taps, 1/6, 1/36 and 1/216 of the picture apart;
// what is left of the light is e (1 - blur).
TapSums SumThreeJS(const Parameters& p)
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

TapSums SumBabylon(const Parameters& p)
{
  return { MakeTapSum(p, 1, p.NumberOfSamples, 1.0, p.Weight, 0.4 * p.Exposure) };
}

// The loop ends one tap late, but never after 100.
TapSums SumErkaman(const Parameters& p)
{
  const int last = std::min(p.NumberOfSamples + 1, 100);
  return { MakeTapSum(p, 1, last, 0.0, p.Weight, p.Exposure) };
}

// All that distinguishes the formulations, in the order of FormulationType; the numbers are their
// authors'.
using Model = vtkGodRaysPublishedModel;
constexpr int Zero = Model::ZERO_BORDER;
constexpr int Edge = Model::EDGE_BORDER;
constexpr bool Shown = false;
constexpr bool Light = true;

struct Row
{
  const char* Name;
  const char* Description;
  int Border;
  bool LinearLight;
  int Blend;
  double SceneGain;
  bool Clamps;
  TapSums (*Sum)(const Parameters&);
  Parameters Authors;
};

const Row Rows[] = {
  { "mitchell", "Listing of GPU Gems 3, which states no numbers, with those of gianassi", Edge,
    Shown, Model::ADD, 1.0, false, SumMitchell, { 0.8, 0.99, 0.8, 0.05, 100, 1.0 } },
  { "gianassi", "Crepuscular rays with three.js by Gianassi and Gigli", Edge, Shown, Model::ADD,
    1.0, false, SumGianassi, { 0.8, 0.99, 0.8, 0.05, 100, 1.0 } },
  { "layers", "React Three Fiber tutorial, its slip in green and blue mended", Edge, Shown,
    Model::ADD, 1.0, true, SumLayers, { 0.54, 0.99, 4.75, 0.055, 100, 1.0 } },
  { "layers-as-published", "React Three Fiber tutorial, red in all three channels", Edge, Shown,
    Model::ADD, 1.0, true, SumLayersAsPublished, { 0.54, 0.99, 4.75, 0.055, 100, 1.0 } },
  { "equation", "Equation 4 of GPU Gems 3 as printed, faint by 1/n, with the numbers of gianassi",
    Zero, Light, Model::ADD, 1.0, false, SumEquation, { 0.8, 0.99, 0.8, 0.05, 100, 1.0 } },
  { "postprocessing", "GodRaysEffect of pmndrs postprocessing", Edge, Light, Model::SCREEN, 1.0,
    true, SumPostprocessing, { 0.96, 0.9, 0.4, 0.6, 60, 1.0 } },
  { "three.js", "GodRaysShader of three.js: three passes of six taps", Edge, Shown, Model::ADD, 1.0,
    false, SumThreeJS, { 1.0, 1.0, 1.0, 0.69, 6, 1.0 } },
  { "babylon", "VolumetricLightScatteringPostProcess of Babylon.js", Edge, Shown, Model::ADD, 1.1,
    false, SumBabylon, { 0.926, 0.96815, 0.58767, 0.3, 100, 1.0 } },
  { "erkaman", "glsl-godrays by Erkaman", Edge, Shown, Model::ADD, 1.0, false, SumErkaman,
    { 1.0, 1.0, 0.01, 1.0, 100, 1.0 } },
  { "araujo", "screen-space-godrays by Araujo", Edge, Shown, Model::ADD, 1.0, false, SumMitchell,
    { 1.0, 1.0, 0.01, 1.0, 100, 1.0 } },
};
static_assert(std::size(Rows) == Model::ARAUJO + 1, "one row for each formulation");
}

vtkGodRaysPublishedModel::vtkGodRaysPublishedModel()
{
  this->ApplyPreset(Rows[MITCHELL].Name);
}

void vtkGodRaysPublishedModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Formulation: " << this->GetFormulationAsString() << "\n";
  os << indent << "ClampMaximum: " << this->ClampMaximum << "\n";
}

void vtkGodRaysPublishedModel::SetFormulation(int formulation)
{
  if (formulation < MITCHELL || formulation > ARAUJO)
  {
    vtkErrorMacro("Formulation must be one of 0 (MITCHELL) to "
      << ARAUJO << " (ARAUJO), not " << formulation << "; it stays " << this->Formulation << ".");
    return;
  }
  if (this->Formulation != formulation)
  {
    this->Formulation = formulation;
    this->Modified();
  }
}

const char* vtkGodRaysPublishedModel::GetFormulationAsString() const
{
  return Rows[this->Formulation].Name;
}

bool vtkGodRaysPublishedModel::ApplyPreset(const char* name)
{
  const Row* row = vtkGodRaysFindPreset(this, Rows, name);
  if (row)
  {
    const Parameters& p = row->Authors;
    this->SetFormulation(static_cast<int>(row - Rows));
    this->SetParameters(p.Density, p.Decay, p.Weight, p.Exposure, p.NumberOfSamples);
    this->SetClampMaximum(p.ClampMaximum);
  }
  return row != nullptr;
}

int vtkGodRaysPublishedModel::GetNumberOfPresets()
{
  return static_cast<int>(std::size(Rows));
}

const char* vtkGodRaysPublishedModel::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? Rows[index].Name : nullptr;
}

const char* vtkGodRaysPublishedModel::GetPresetDescription(int index)
{
  return index >= 0 && index < GetNumberOfPresets() ? Rows[index].Description : nullptr;
}

// Always the authors' own number of taps.
void vtkGodRaysPublishedModel::GetTapSums(std::vector<TapSum>& passes, int) const
{
  passes = Rows[this->Formulation].Sum({ this->Density, this->Decay, this->Weight, this->Exposure,
    this->NumberOfSamples, this->ClampMaximum });
}

int vtkGodRaysPublishedModel::GetBorder() const
{
  return Rows[this->Formulation].Border;
}

bool vtkGodRaysPublishedModel::GetLinearLight() const
{
  return Rows[this->Formulation].LinearLight;
}

int vtkGodRaysPublishedModel::GetBlend() const
{
  return Rows[this->Formulation].Blend;
}

double vtkGodRaysPublishedModel::GetSceneGain() const
{
  return Rows[this->Formulation].SceneGain;
}

bool vtkGodRaysPublishedModel::CanScatter() const
{
  return this->Superclass::CanScatter() &&
    (this->ClampMaximum > 0.0 || !Rows[this->Formulation].Clamps);
}

std::string vtkGodRaysPublishedModel::Describe() const
{
  std::ostringstream text;
  text << "radial sum, " << this->GetFormulationAsString() << ": ";
  if (this->Formulation == THREE_JS)
  {
    text << "exposure " << this->Exposure;
  }
  else
  {
    text << this->DescribeParameters();
  }
  if (Rows[this->Formulation].Clamps)
  {
    text << ", at most " << this->ClampMaximum;
  }
  return text.str();
}
