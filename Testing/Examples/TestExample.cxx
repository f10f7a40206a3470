// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// An example, run off screen: its light against the processor's, or that of a medium against the ground
// truth; its picture against the baseline; and the same picture without rays, which must not pass. Compiled
// once for each example, with EXAMPLE_SOURCE and EXAMPLE_NAME.

#include "GodRaysMediumTruth.h"

#include "vtkGodRaysEpipolarIntegrator.h"
#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysModel.h"
#include "vtkGodRaysPass.h"
#include "vtkGodRaysRadialModel.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGReader.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace
{
int Checked = 0;
double WorstError = 0.0;
double ErrorOfMedium = 0.0;

/// Compares each light that is scattered with the sum of 1000 taps in double precision.
class CheckedIntegrator : public vtkGodRaysEpipolarIntegrator
{
public:
  static CheckedIntegrator* New();
  vtkTypeMacro(CheckedIntegrator, vtkGodRaysEpipolarIntegrator);

  bool Integrate(const Request& request) override
  {
    vtkNew<vtkImageData> before;
    vtkNew<vtkImageData> after;
    vtkNew<vtkImageData> layer;
    vtkNew<vtkImageData> expected;
    const bool hasLight = request.Result->IsLinear() && request.Result->Download(before);
    if (!this->Superclass::Integrate(request))
    {
      return false;
    }
    request.Result->DownloadLinear(after);
    request.Layer->Download(layer, request.Light->Color);
    const int size[2] = { request.Result->GetWidth(), request.Result->GetHeight() };
    auto model = vtkGodRaysRadialModel::SafeDownCast(request.Model);
    model->Evaluate(layer, request.Light->Clip, request.Light->MarchScale, request.ViewScale, size,
      expected, 1000);
    double peak = 0.0;
    double squares = 0.0;
    for (int i = 0; i < 3 * size[0] * size[1]; ++i)
    {
      // of the sum so far, since that is what is rounded to 16 bits
      const double value = static_cast<double*>(expected->GetScalarPointer())[i] +
        (hasLight ? static_cast<float*>(before->GetScalarPointer())[i] : 0.0f);
      const double got = static_cast<float*>(after->GetScalarPointer())[i];
      peak = std::max(peak, value);
      squares += (value - got) * (value - got);
    }
    if (peak > 0.0)
    {
      ++Checked;
      WorstError = std::max(WorstError, std::sqrt(squares / (3.0 * size[0] * size[1])) / peak);
    }
    return true;
  }
};
vtkStandardNewMacro(CheckedIntegrator);

/// What the example takes for a vtkGodRaysPass.
class CheckedPass : public vtkGodRaysPass
{
public:
  static CheckedPass* New();
  vtkTypeMacro(CheckedPass, vtkGodRaysPass);

  void Render(const vtkRenderState* s) override
  {
    if (!this->GetIntegrator()->Supports(this->GetModel()))
    {
      this->SetIntegrator(nullptr); // the model's own
    }
    this->Superclass::Render(s);
    auto medium = vtkGodRaysHomogeneousModel::SafeDownCast(this->GetModel());
    vtkNew<vtkImageData> light;
    if (medium && this->GetScatteringImage(light))
    {
      vtkLight* sun = this->GetLight(0);
      const double* place = sun->GetPosition();
      const double* color = sun->GetDiffuseColor();
      ++Checked;
      ErrorOfMedium = GodRaysTesting::GetErrorOfMedium(s->GetRenderer(), medium,
        { place[0], place[1], place[2], sun->GetPositional() ? 1.0 : 0.0 }, light,
        { vtkGodRays::DecodeDisplay(color[0]), vtkGodRays::DecodeDisplay(color[1]),
          vtkGodRays::DecodeDisplay(color[2]) });
    }
  }

protected:
  CheckedPass()
  {
    vtkNew<CheckedIntegrator> integrator;
    this->SetIntegrator(integrator);
  }
};
vtkStandardNewMacro(CheckedPass);

/// Largest difference of a picture from the baseline, in levels of 255.
int GetDifference(const std::string& picture, const std::string& baseline)
{
  vtkNew<vtkPNGReader> readers[2];
  const std::string files[2] = { picture, baseline };
  for (int i = 0; i < 2; ++i)
  {
    readers[i]->SetFileName(files[i].c_str());
    readers[i]->Update();
  }
  vtkImageData* a = readers[0]->GetOutput();
  vtkImageData* b = readers[1]->GetOutput();
  if (a->GetNumberOfPoints() == 0 ||
    !std::equal(a->GetDimensions(), a->GetDimensions() + 3, b->GetDimensions()) ||
    a->GetNumberOfScalarComponents() != b->GetNumberOfScalarComponents())
  {
    return 255;
  }
  int worst = 0;
  const vtkIdType count = a->GetNumberOfPoints() * a->GetNumberOfScalarComponents();
  for (vtkIdType i = 0; i < count; ++i)
  {
    worst = std::max(worst,
      std::abs(static_cast<unsigned char*>(a->GetScalarPointer())[i] -
        static_cast<unsigned char*>(b->GetScalarPointer())[i]));
  }
  return worst;
}

/// From the nearest baseline: name_1.png is another one, as newer VTK places a sun a little elsewhere.
int GetLeastDifference(const std::string& picture, const std::string& baseline)
{
  const std::string other = baseline.substr(0, baseline.rfind(".png")) + "_1.png";
  const int difference = GetDifference(picture, baseline);
  return std::ifstream(other).good() ? std::min(difference, GetDifference(picture, other))
                                     : difference;
}
}

#define vtkGodRaysPass CheckedPass
#define main ExampleMain
#include EXAMPLE_SOURCE
#undef main
#undef vtkGodRaysPass

namespace
{
/// variant: the example's third argument, or null.
int Run(const std::string& picture, char* variant)
{
  std::string name = EXAMPLE_NAME;
  std::string file = picture;
  std::string size = "400x300"; // of the baselines
  char* arguments[] = { &name[0], &file[0], &size[0], variant, nullptr };
  return ExampleMain(variant ? 4 : 3, arguments);
}
}

int main(int argc, char* argv[])
{
  if (argc != 3 && argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " picture.png baseline.png [variant]\n";
    return EXIT_FAILURE;
  }
  const std::string picture = argv[1];
  const std::string baseline = argv[2];
  constexpr int levels = 2;

  const int status = Run(picture, argv[3]);
  const int difference = GetLeastDifference(picture, baseline);
  std::cout << EXAMPLE_NAME << ": " << Checked << " layers checked, root mean square error "
            << WorstError << " of the peak, of a medium " << ErrorOfMedium << "; picture within "
            << difference << " levels of its baseline\n";

  setenv("GODRAYS_DISABLE", "1", 1);
  Run(picture + ".without-rays.png", argv[3]);
  const int without = GetLeastDifference(picture + ".without-rays.png", baseline);
  std::cout << "without rays: " << without << " levels\n";

  const bool good = status == 0 && Checked > 0 && WorstError <= 2e-3 && ErrorOfMedium <= 1e-2 &&
    difference <= levels;
  if (!good)
  {
    std::cerr << "The example failed, or its light or picture is wrong. If the picture " << picture
              << " is right, copy it to " << baseline << "\n";
  }
  if (without <= 10 * levels)
  {
    std::cerr << "The picture without rays passes for the one with them: the test is blind.\n";
  }
  return good && without > 10 * levels ? EXIT_SUCCESS : EXIT_FAILURE;
}
