// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVerification.h"

#include "vtkGodRaysIntegrator.h"
#include "vtkGodRaysSum.h"
#include "vtkImageData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace
{
/// One pixel at random of each of as many parts of the picture, the same ones every time.
std::vector<std::int64_t> ChoosePixels(std::int64_t total, std::int64_t wanted)
{
  const std::int64_t pixels = std::min(wanted, total);
  std::mt19937 generator(5489);
  std::vector<std::int64_t> places;
  for (std::int64_t i = 0; i < pixels; ++i)
  {
    const std::int64_t first = i * total / pixels;
    const std::int64_t next = (i + 1) * total / pixels;
    places.push_back(first + static_cast<std::int64_t>(generator()) % (next - first));
  }
  return places;
}
}

vtkGodRaysVerification::vtkGodRaysVerification(vtkGodRaysIntegrator* integrator, vtkGodRaysSum& sum)
  : Integrator(integrator)
  , Sum(sum)
{
  if (this->IsWanted() && !sum.IsEmpty() && sum.IsLinear())
  {
    sum.Download(this->Before);
  }
}

vtkGodRaysVerification::~vtkGodRaysVerification() = default;

bool vtkGodRaysVerification::IsWanted() const
{
  return this->Integrator->IsVerified();
}

void vtkGodRaysVerification::Measure(
  const std::function<std::array<double, 3>(int x, int y)>& exact)
{
  vtkNew<vtkImageData> after;
  if (!this->Sum.DownloadLinear(after))
  {
    return;
  }
  const auto* values = static_cast<const float*>(after->GetScalarPointer());
  const float* former = this->Before->GetNumberOfPoints() > 0
    ? static_cast<const float*>(this->Before->GetScalarPointer())
    : nullptr;
  const auto get = [=](std::size_t i) { return values[i] - (former ? former[i] : 0.0); };
  const int width = this->Sum.GetWidth();
  const std::int64_t total = static_cast<std::int64_t>(width) * this->Sum.GetHeight();
  auto places = ChoosePixels(total, this->Integrator->GetVerifyPixels());
  const std::size_t compared = places.size();
  // And the brightest one, to know how bright rays are.
  std::int64_t brightest = 0;
  for (std::int64_t i = 0; i < 3 * total; ++i)
  {
    brightest = get(i) > get(brightest) ? i : brightest;
  }
  places.push_back(brightest / 3);
  std::vector<double> errors(places.size(), 0.0); // of the worst channel
  std::vector<double> lights(places.size(), 0.0); // of the brightest one
  vtkSMPTools::For(0, static_cast<vtkIdType>(places.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto light =
          exact(static_cast<int>(places[i] % width), static_cast<int>(places[i] / width));
        for (int c = 0; c < 3; ++c)
        {
          const double got = get(3 * static_cast<std::size_t>(places[i]) + c);
          errors[i] = std::max(errors[i], std::abs(got - light[c]));
          lights[i] = std::max(lights[i], light[c]);
        }
      }
    });
  errors.pop_back();
  double squares = 0.0;
  double largest = 0.0;
  for (const double error : errors)
  {
    squares += error * error;
    largest = std::max(largest, error);
  }
  const double peak = *std::max_element(lights.begin(), lights.end());
  const double scale = peak > 0.0 ? 1.0 / peak : 1.0;
  this->Integrator->TakeErrors(std::sqrt(squares / compared) * scale, largest * scale);
}
