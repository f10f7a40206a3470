// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The yardstick of the benchmarks: the customary 100 plain bilinear taps a pixel.

#ifndef PlainTaps_h
#define PlainTaps_h

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <vector>

//------------------------------------------------------------------------------
// Least time of a call [seconds].
template <typename Function>
double Measure(int repeats, const Function& function)
{
  double best = 1e30;
  for (int i = 0; i < repeats; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    function();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    best = std::min(best, time.count());
  }
  return best;
}

//------------------------------------------------------------------------------
// The same of the processor's time, on however many threads: others on the machine matter less.
template <typename Function>
double MeasureProcessor(int repeats, const Function& function)
{
  double best = 1e30;
  for (int i = 0; i < repeats; ++i)
  {
    const std::clock_t start = std::clock();
    function();
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

//------------------------------------------------------------------------------
// 100 taps of one component, as a shader takes them: the yardstick. Written so that the compiler
// makes vectors of it (target_clones: for what the processor has).
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
__attribute__((target_clones("default", "avx2", "arch=x86-64-v4"), optimize("O3")))
#endif
inline void
SumPlainTaps(const float* padded, int stride, int width, int height, float lightX, float lightY,
  float density, float decay, int y, float* result)
{
  const int taps = 100;
  constexpr int Lanes = 64;
  for (int first = 0; first < width; first += Lanes)
  {
    float sum[Lanes] = {};
    float weight = 1.0f;
    for (int i = 0; i < taps; ++i)
    {
      const float t = density * (i + 0.5f) / taps;
      for (int lane = 0; lane < Lanes; ++lane)
      {
        float px = first + lane + t * (lightX - first - lane);
        float py = y + t * (lightY - y);
        px = std::min(std::max(px, -1.0f), static_cast<float>(width)) + 1.0f;
        py = std::min(std::max(py, -1.0f), static_cast<float>(height)) + 1.0f;
        const int column = static_cast<int>(px);
        const int row = static_cast<int>(py);
        const float fx = px - column;
        const float fy = py - row;
        const int index = row * stride + column;
        const float a = padded[index];
        const float b = padded[index + 1];
        const float c = padded[index + stride];
        const float d = padded[index + stride + 1];
        const float lower = a + fx * (b - a);
        const float upper = c + fx * (d - c);
        sum[lane] += weight * (lower + fy * (upper - lower));
      }
      weight *= decay;
    }
    std::copy_n(sum, std::min(Lanes, width - first), result + first);
  }
}

//------------------------------------------------------------------------------
inline double MeasurePlainTaps(int width, int height, bool processor = false)
{
  const int stride = width + 80;
  std::vector<float> padded(static_cast<std::size_t>(stride) * (height + 4), 0.5f);
  std::vector<float> result(static_cast<std::size_t>(width) * height);
  const auto sum = [&]()
  {
    for (int y = 0; y < height; ++y)
    {
      SumPlainTaps(padded.data(), stride, width, height, 0.51f * width, 0.48f * height, 0.97f,
        0.99f, y, result.data() + static_cast<std::size_t>(y) * width);
    }
  };
  return processor ? MeasureProcessor(4, sum) : Measure(2, sum);
}

#endif
