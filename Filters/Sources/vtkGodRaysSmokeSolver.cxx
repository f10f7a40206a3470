// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSmokeSolver.h"

#include "vtkGodRaysNoise.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
// Shares are whole multiples of this, so that what a cell keeps, 1 minus its shares, has no rounding
// error in single precision. Otherwise each step would lose or make the same part of the mass.
constexpr double ShareUnit = 1.0 / 16777216.0;

float RoundShare(double share)
{
  return static_cast<float>(ShareUnit * std::floor(share / ShareUnit));
}

double GetRateAhead(double velocity, double diffusivity, double spacing)
{
  const double drift = velocity / spacing;
  return std::max({ drift, diffusivity / (spacing * spacing) + 0.5 * drift, 0.0 });
}
}

double vtkGodRaysSmokeSolver::GetLargestTimeStep(const Parameters& p)
{
  const double speeds[3] = { std::abs(p.SwaySpeed), 0.0, std::abs(p.RiseSpeed) };
  double rate = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (p.Dimensions[axis] > 1)
    {
      const double speed = speeds[axis] + p.Turbulence;
      rate += GetRateAhead(speed, p.Diffusivity, p.Spacing) +
        GetRateAhead(-speed, p.Diffusivity, p.Spacing);
    }
  }
  return 1.0 / rate;
}

void vtkGodRaysSmokeSolver::Start(const Parameters& parameters)
{
  this->Setup = parameters;
  this->Step = 0;
  const auto& size = parameters.Dimensions;
  const std::size_t cells = static_cast<std::size_t>(size[0]) * size[1] * size[2];
  this->Density.assign(cells, 0.0f);
  this->Next.assign(cells, 0.0f);
  this->Zeros.assign(size[0], 0.0f);
  for (int axis = 0; axis < 3; ++axis)
  {
    // An axis of one cell has no neighbours: nothing is exchanged along it.
    const std::size_t faces = cells / size[axis];
    this->Given[axis].Ahead.assign(faces, 0.0f);
    this->Given[axis].Back.assign(faces, 0.0f);
  }
  this->FindSource();
}

// The sphere's cells, with an edge one cell wide.
void vtkGodRaysSmokeSolver::FindSource()
{
  const Parameters& p = this->Setup;
  this->Source.clear();
  int begin[3];
  int end[3];
  for (int i = 0; i < 3; ++i)
  {
    const double reach = p.SourceRadius + p.Spacing;
    const double last = p.Dimensions[i];
    begin[i] = static_cast<int>(
      vtkMath::ClampValue(std::floor((p.SourceCenter[i] - reach) / p.Spacing), 0.0, last));
    end[i] = static_cast<int>(
      vtkMath::ClampValue(std::ceil((p.SourceCenter[i] + reach) / p.Spacing) + 1.0, 0.0, last));
  }
  for (int z = begin[2]; z < end[2]; ++z)
  {
    for (int y = begin[1]; y < end[1]; ++y)
    {
      for (int x = begin[0]; x < end[0]; ++x)
      {
        const double distance = std::hypot(p.SourceCenter[0] - x * p.Spacing,
          p.SourceCenter[1] - y * p.Spacing, p.SourceCenter[2] - z * p.Spacing);
        const double coverage =
          vtkMath::ClampValue(0.5 + (p.SourceRadius - distance) / p.Spacing, 0.0, 1.0);
        if (coverage > 0.0)
        {
          const std::size_t row = y + static_cast<std::size_t>(p.Dimensions[1]) * z;
          this->Source.push_back({ x + row * p.Dimensions[0], coverage });
        }
      }
    }
  }
}

void vtkGodRaysSmokeSolver::ComputeShares(int axis)
{
  const Parameters& p = this->Setup;
  if (p.Dimensions[axis] == 1)
  {
    return;
  }
  const double time = this->Step * p.TimeStep;
  const double sway =
    p.SwaySpeed * std::sin(2.0 * vtkMath::Pi() * std::fmod(time / p.SwayPeriod, 1.0));
  const double mean[3] = { sway, 0.0, p.RiseSpeed };
  const vtkGodRaysNoise::Fractal eddies{ 2, 0.5, 2.0,
    vtkGodRaysNoise::MakeSeed(p.Seed, static_cast<unsigned int>(axis)) };
  const double scale = p.Spacing / p.TurbulenceSize;
  const double age = time * p.Turbulence / p.TurbulenceSize; // eddies live for one turn or so
  Shares& shares = this->Given[axis];
  const int width = p.Dimensions[axis == 0 ? 1 : 0];
  const auto rows = static_cast<vtkIdType>(shares.Ahead.size() / width);
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        for (int column = 0; column < width; ++column)
        {
          double velocity = mean[axis];
          if (p.Turbulence > 0.0)
          {
            velocity += p.Turbulence * eddies.Evaluate({ column * scale, row * scale, age }).Value;
          }
          const std::size_t i = static_cast<std::size_t>(row) * width + column;
          shares.Ahead[i] =
            RoundShare(p.TimeStep * GetRateAhead(velocity, p.Diffusivity, p.Spacing));
          shares.Back[i] =
            RoundShare(p.TimeStep * GetRateAhead(-velocity, p.Diffusivity, p.Spacing));
        }
      }
    });
}

void vtkGodRaysSmokeSolver::Exchange(vtkIdType beginRow, vtkIdType endRow)
{
  const Parameters& p = this->Setup;
  const int nx = p.Dimensions[0];
  const int ny = p.Dimensions[1];
  const int nz = p.Dimensions[2];
  const std::size_t slice = static_cast<std::size_t>(nx) * ny;
  const float* const none = this->Zeros.data();
  const auto fade = static_cast<float>(std::exp(-p.Dissipation * p.TimeStep));
  const auto floor = static_cast<float>(p.MinimumDensity);
  for (vtkIdType row = beginRow; row < endRow; ++row)
  {
    const int y = static_cast<int>(row % ny);
    const int z = static_cast<int>(row / ny);
    const float* const here = this->Density.data() + row * nx;
    // Rows of neighbours; beyond the grid there is nothing.
    const float* const south = y > 0 ? here - nx : none;
    const float* const north = y < ny - 1 ? here + nx : none;
    const float* const below = z > 0 ? here - slice : none;
    const float* const above = z < nz - 1 ? here + slice : none;
    // Shares that arrive, and those that are given: none through a wall.
    const float xAhead = this->Given[0].Ahead[row];
    const float xBack = this->Given[0].Back[row];
    const float* const yAhead = this->Given[1].Ahead.data() + static_cast<std::size_t>(z) * nx;
    const float* const yBack = this->Given[1].Back.data() + static_cast<std::size_t>(z) * nx;
    const float* const zAhead = this->Given[2].Ahead.data() + static_cast<std::size_t>(y) * nx;
    const float* const zBack = this->Given[2].Back.data() + static_cast<std::size_t>(y) * nx;
    const bool closed = p.ClosedBoundaries;
    const float* const toNorth = closed && y == ny - 1 ? none : yAhead;
    const float* const toSouth = closed && y == 0 ? none : yBack;
    const float* const toAbove = closed && z == nz - 1 ? none : zAhead;
    const float* const toBelow = closed && z == 0 ? none : zBack;

    auto exchange = [=](int x, float west, float east, float toEast, float toWest)
    {
      const float kept = 1.0f - toEast - toWest - toNorth[x] - toSouth[x] - toAbove[x] - toBelow[x];
      const float density = kept * here[x] + xAhead * west + xBack * east + yAhead[x] * south[x] +
        yBack[x] * north[x] + zAhead[x] * below[x] + zBack[x] * above[x];
      const float left = fade * density;
      return left < floor ? 0.0f : left;
    };
    // Compilers cannot see that this row is not one of those that are read.
    float* __restrict next = this->Next.data() + row * nx;
    const int last = nx - 1;
    for (int x = 1; x < last; ++x)
    {
      next[x] = exchange(x, here[x - 1], here[x + 1], xAhead, xBack);
    }
    next[0] = exchange(0, 0.0f, last > 0 ? here[1] : 0.0f, xAhead, closed ? 0.0f : xBack);
    if (last > 0)
    {
      next[last] = exchange(last, here[last - 1], 0.0f, closed ? 0.0f : xAhead, xBack);
    }
  }
}

void vtkGodRaysSmokeSolver::Emit()
{
  const Parameters& p = this->Setup;
  const double left = p.SourceDuration - this->Step * p.TimeStep;
  const double amount = p.SourceRate * vtkMath::ClampValue(left, 0.0, p.TimeStep);
  for (const SourceCell& cell : this->Source)
  {
    this->Density[cell.Index] += static_cast<float>(cell.Coverage * amount);
  }
}

void vtkGodRaysSmokeSolver::Advance()
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->ComputeShares(axis);
  }
  this->Emit();
  const vtkIdType rows =
    static_cast<vtkIdType>(this->Setup.Dimensions[1]) * this->Setup.Dimensions[2];
  vtkSMPTools::For(0, rows, [this](vtkIdType begin, vtkIdType end) { this->Exchange(begin, end); });
  this->Density.swap(this->Next);
  ++this->Step;
}
