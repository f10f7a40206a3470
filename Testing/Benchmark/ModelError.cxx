// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// How wrong vtkGodRaysCoverageFilter is, and what it costs: two Markdown tables.
//
// Usage: ModelError [--quick] [width height]
//
// Errors are against vtkGodRaysSingleScatteringReference, as fractions of its peak, without any fit, at
// 480 x 270 pixels unless told otherwise. Time is the processor's, of one thread, and, as machines differ
// and are shared, a ratio to 100 plain bilinear taps a pixel in the same run.

#include "GodRaysMediumScenes.h"
#include "PlainTaps.h"

#include "vtkSMPTools.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace GodRaysMediumScenes;

namespace
{
// Optical depths of the far limit straight ahead: 0.4, 2 and 6.
const double Scattering[] = { 0.02, 0.1, 0.3 };

struct Summary
{
  double Squares = 0.0;
  double Worst = 0.0;
  int Count = 0;
  void Add(double rms)
  {
    this->Squares += rms * rms;
    this->Worst = std::max(this->Worst, rms);
    ++this->Count;
  }
  double GetRms() const { return std::sqrt(this->Squares / std::max(this->Count, 1)); }
};

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeTruth(const Scene& scene, const NamedLight& light,
  const double* scattering, int width, int height, int layers)
{
  vtkNew<vtkGodRaysSingleScatteringReference> reference;
  Prepare(reference, light, 0.1);
  // Three media are three colours of one.
  reference->SetScatteringCoefficient(scattering[0], scattering[1], scattering[2]);
  reference->SetInputData(scene.Occluders);
  reference->SetSize(width, height);
  reference->SetTolerance(1e-6);
  reference->SetNumberOfLayers(layers);
  reference->Update();
  auto truth = vtkSmartPointer<vtkImageData>::New();
  truth->ShallowCopy(reference->GetOutput());
  return truth;
}

//------------------------------------------------------------------------------
// One colour of the truth, with all of its layers or the first front alone.
vtkSmartPointer<vtkImageData> Extract(vtkImageData* truth, int color, bool layers)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(truth->GetDimensions());
  vtkDataArray* radiance = truth->GetPointData()->GetArray("Radiance");
  vtkDataArray* depths = truth->GetPointData()->GetArray("Depth");
  const int components = layers ? depths->GetNumberOfComponents() : 1;
  for (const bool isDepth : { false, true })
  {
    vtkDataArray* from = isDepth ? depths : radiance;
    auto to = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
    to->SetName(from->GetName());
    to->SetNumberOfComponents(isDepth ? components : 1);
    to->SetNumberOfTuples(from->GetNumberOfTuples());
    for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < to->GetNumberOfComponents(); ++c)
      {
        to->SetComponent(i, c, from->GetComponent(i, isDepth ? c : color));
      }
    }
    image->GetPointData()->AddArray(to);
  }
  return image;
}

//------------------------------------------------------------------------------
void PrintErrors(int width, int height, int sphereParts)
{
  std::printf(
    "%d x %d, sigma_s 0.02, 0.1, 0.3 to a far limit of 20, g 0.6: RMSE of the peak, root mean "
    "square / worst of the three media\n\n| scene | light | depths | two layers |\n"
    "|---|---|---|---|\n",
    width, height);
  Summary flat[5];
  Summary layered[5];
  for (const Scene& scene : MakeScenes(sphereParts))
  {
    for (int l = 0; l < 5; ++l)
    {
      const auto truth = MakeTruth(scene, Lights[l], Scattering, width, height, 2);
      Summary one;
      Summary two;
      for (int color = 0; color < 3; ++color)
      {
        vtkNew<vtkGodRaysCoverageFilter> filter;
        Prepare(filter, Lights[l], Scattering[color]);
        one.Add(Compare(Extract(truth, color, false), filter).Rms);
        two.Add(Compare(Extract(truth, color, true), filter).Rms);
        layered[l].Add(Compare(Extract(truth, color, true), filter).Rms);
        flat[l].Add(Compare(Extract(truth, color, false), filter).Rms);
      }
      std::printf("| %s | %s | %.4f / %.4f | %.4f / %.4f |\n", scene.Name.c_str(), Lights[l].Name,
        one.GetRms(), one.Worst, two.GetRms(), two.Worst);
      std::fflush(stdout);
    }
  }
  for (int l = 0; l < 5; ++l)
  {
    std::printf("| all | %s | %.4f / %.4f | %.4f / %.4f |\n", Lights[l].Name, flat[l].GetRms(),
      flat[l].Worst, layered[l].GetRms(), layered[l].Worst);
  }
}

//------------------------------------------------------------------------------
double MeasureFilter(vtkGodRaysCoverageFilter* filter, int repeats)
{
  double time = 0.0;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "STDThread", false },
    [&]()
    {
      time = MeasureProcessor(repeats,
        [&]()
        {
          filter->Modified();
          filter->Update();
        });
    });
  return time;
}

//------------------------------------------------------------------------------
void PrintTimes(int width, int height, int sphereParts, int repeats)
{
  const double taps = MeasurePlainTaps(width, height, true);
  std::printf("\n%d x %d, one thread; 100 plain taps %.0f ms\n\n| scene | light | ms | of 100 taps "
              "| two layers, of 100 taps | overflows |\n|---|---|---|---|---|---|\n",
    width, height, 1e3 * taps);
  const auto scenes = MakeScenes(sphereParts);
  for (std::size_t i = 1; i < scenes.size(); ++i)
  {
    for (const int l : { 0, 2, 4 })
    {
      const auto truth = MakeTruth(scenes[i], Lights[l], Scattering, width, height, 2);
      double times[2] = {};
      long long overflows = 0;
      for (const bool layers : { true, false })
      {
        vtkNew<vtkGodRaysCoverageFilter> filter;
        Prepare(filter, Lights[l], 0.1);
        Compare(Extract(truth, 1, layers), filter);
        overflows = filter->GetNumberOfOverflows();
        times[layers] = MeasureFilter(filter, repeats);
      }
      std::printf("| %s | %s | %.1f | %.3f | %.3f | %lld |\n", scenes[i].Name.c_str(),
        Lights[l].Name, 1e3 * times[0], times[0] / taps, times[1] / taps, overflows);
      std::fflush(stdout);
    }
  }
}
}

//------------------------------------------------------------------------------
int main(int count, char* arguments[])
{
  const bool quick = count > 1 && std::strcmp(arguments[1], "--quick") == 0;
  const int next = quick ? 2 : 1;
  const bool sized = count > next + 1;
  const int width = sized ? std::max(1, std::atoi(arguments[next])) : quick ? 96 : 480;
  const int height = sized ? std::max(1, std::atoi(arguments[next + 1])) : quick ? 54 : 270;
  const int sphereParts = quick ? 8 : 24;
  PrintErrors(width, height, sphereParts);
  PrintTimes(quick ? 160 : 1920, quick ? 90 : 1080, quick ? 6 : 12, quick ? 2 : 7);
  return EXIT_SUCCESS;
}
