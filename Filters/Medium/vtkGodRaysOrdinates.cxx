// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysOrdinates.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <type_traits>

namespace
{
constexpr float Void = 1e-9f; // extinction below which a node counts as empty [1/cell, or so]

// Sets of directions: how many there are, to which degree they integrate in stretched cells, and weights in
// cubes. The first two are Lebedev's; the others are exact to degrees 6 and 10, and nearest to even weights.
struct Set
{
  int Count;
  int Degree;
  double Weights[6]; // of Moves [4 pi sr]
};
const Set Sets[] = { { 14, 2, { 1.0 / 15.0, 0.0, 3.0 / 40.0, 0.0, 0.0, 0.0 } },
  { 26, 4, { 1.0 / 21.0, 4.0 / 105.0, 9.0 / 280.0, 0.0, 0.0, 0.0 } },
  { 50, 6, { 0.007937, 0.002822, 0.032143, 0.027557, 0.0, 0.0 } },
  { 98, 8, { 0.018229, 0.006438, 0.002651, 0.014492, 0.012323, 0.006192 } } };
const std::array<int, 3> Moves[] = { { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 1 }, { 2, 1, 0 },
  { 2, 1, 1 }, { 2, 2, 1 } };

// Returns e^-t for t >= 0 in a form that compilers make vector code of: 1/P(t/8)^8, P being Taylor's
// polynomial of e^x of degree 5. The error is below 2e-6.
inline float FallOff(float t)
{
  const float x = 0.125f * t;
  const float p =
    1.0f + x * (1.0f + x * (0.5f + x * (1.0f / 6.0f + x * (1.0f / 24.0f + x * (1.0f / 120.0f)))));
  const float fourth = (p * p) * (p * p);
  return 1.0f / (fourth * fourth);
}

// Returns the radiance at the end of a straight way from that at its start. Along it, the ratio of emission
// to extinction is linear in the optical depth [KunaszAuer1988].
inline float Carry(float radiance, float extinction0, float emission0, float extinction1,
  float emission1, float length)
{
  const float t = 0.5f * length * (extinction0 + extinction1);
  const float left = FallOff(t);
  const float mean = (1.0f - left) / std::max(t, 1e-6f);
  const bool thin = t < 0.06f; // where differences would cancel
  const float weight1 = thin ? t * (0.5f - t * (1.0f / 6.0f - t * (1.0f / 24.0f))) : 1.0f - mean;
  const float weight0 = thin ? t * (0.5f - t * (1.0f / 3.0f - t * 0.125f)) : mean - left;
  const float ratio0 = emission0 / std::max(extinction0, Void);
  const float ratio1 = emission1 / std::max(extinction1, Void);
  return radiance * left + (extinction0 > Void ? ratio0 : ratio1) * weight0 +
    (extinction1 > Void ? ratio1 : ratio0) * weight1;
}
}

void vtkGodRaysOrdinates::GetHarmonics(const Vec3& direction, int degree, float* harmonics)
{
  const double x = direction.x;
  const double y = direction.y;
  const double z = direction.z;
  const double values[MaximumMoments] = { 0.28209479, 0.48860251 * y, 0.48860251 * z,
    0.48860251 * x, 1.09254843 * x * y, 1.09254843 * y * z, 0.31539157 * (3.0 * z * z - 1.0),
    1.09254843 * x * z, 0.54627422 * (x * x - y * y), 0.59004359 * y * (3.0 * x * x - y * y),
    2.89061144 * x * y * z, 0.45704579 * y * (5.0 * z * z - 1.0),
    0.37317633 * z * (5.0 * z * z - 3.0), 0.45704579 * x * (5.0 * z * z - 1.0),
    1.44530572 * z * (x * x - y * y), 0.59004359 * x * (x * x - 3.0 * y * y) };
  std::copy_n(values, (degree + 1) * (degree + 1), harmonics);
}

// Of the weights w = w0 + v that integrate all polynomials x^2a y^2b z^2c of the degree, which on the sphere
// contain those of lower even degrees, takes those with the least sum of v^2/w0.
void vtkGodRaysOrdinates::SetGrid(int directions, const int nodes[3], const Vec3& cell)
{
  std::copy_n(nodes, 3, this->Nodes);
  const Set& set = *std::find_if(std::begin(Sets), std::end(Sets) - 1,
    [&](const Set& each) { return each.Count >= directions; });
  this->Directions.clear();
  for (int code = 0; code < 125; ++code)
  {
    Direction direction = { { code % 5 - 2, code / 5 % 5 - 2, code / 25 - 2 }, Vec3(0.0), 0.0,
      0.0 };
    const int* const move = direction.Move;
    std::array<int, 3> sorted = { std::abs(move[0]), std::abs(move[1]), std::abs(move[2]) };
    std::sort(sorted.rbegin(), sorted.rend());
    const auto kind = std::find(std::begin(Moves), std::end(Moves), sorted) - std::begin(Moves);
    if (kind < 6 && set.Weights[kind] > 0.0)
    {
      direction.Along = Vec3(move[0], move[1], move[2]) * cell;
      direction.Length = vtkGodRays::length(direction.Along);
      direction.Along /= direction.Length;
      direction.Weight = set.Weights[kind];
      this->Directions.push_back(direction);
    }
  }
  std::vector<std::vector<double>> values; // of each polynomial, for each direction
  std::vector<double> lacks;
  for (int a = 0; a <= set.Degree / 2; ++a)
  {
    for (int b = 0; a + b <= set.Degree / 2; ++b)
    {
      const int powers[3] = { a, b, set.Degree / 2 - a - b };
      double mean = 1.0; // (2a - 1)!! (2b - 1)!! (2c - 1)!!/(2a + 2b + 2c + 1)!!
      for (int axis = 0, n = 1; axis < 3; ++axis)
      {
        for (int k = 1; k <= powers[axis]; ++k, ++n)
        {
          mean *= (2.0 * k - 1.0) / (2.0 * n + 1.0);
        }
      }
      values.emplace_back();
      for (const Direction& each : this->Directions)
      {
        const Vec3 squares = each.Along * each.Along;
        values.back().push_back(std::pow(squares.x, powers[0]) * std::pow(squares.y, powers[1]) *
          std::pow(squares.z, powers[2]));
        mean -= each.Weight * values.back().back();
      }
      lacks.push_back(mean);
    }
  }
  std::vector<std::vector<double>> matrix(values.size(), std::vector<double>(values.size(), 0.0));
  std::vector<double*> rows;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    rows.push_back(matrix[i].data());
    for (std::size_t j = 0; j < values.size(); ++j)
    {
      for (std::size_t d = 0; d < this->Directions.size(); ++d)
      {
        matrix[i][j] += this->Directions[d].Weight * values[i][d] * values[j][d];
      }
    }
  }
  vtkMath::SolveLinearSystem(rows.data(), lacks.data(), static_cast<int>(rows.size()));
  for (std::size_t d = 0; d < this->Directions.size(); ++d)
  {
    double factor = 1.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      factor += values[i][d] * lacks[i];
    }
    this->Directions[d].Weight *= 4.0 * vtkMath::Pi() * factor;
  }
  this->Size = static_cast<std::size_t>(nodes[0]) * nodes[1] * nodes[2];
  this->Radiance.assign(this->Directions.size() * this->Size, 0.0f);
  this->SetWalls({});
}

void vtkGodRaysOrdinates::SetWalls(const std::vector<Wall>& walls)
{
  this->Walls = walls;
  this->WallOf.assign(walls.empty() ? 0 : this->Size, -1);
  this->Kept.assign(walls.empty() ? 0 : this->Size, 1.0f);
  for (std::size_t i = 0; i < walls.size(); ++i)
  {
    this->WallOf[walls[i].Node] = static_cast<int>(i);
    this->Kept[walls[i].Node] = walls[i].Kept;
  }
  this->Sent.assign(this->Directions.size() * walls.size(), 0.0f);
  this->Received = this->Sent;
  this->Irradiance.assign(6 * walls.size(), 0.0f);
}

// Finds the radiance that walls send into each direction: the mean of their faces that look there.
void vtkGodRaysOrdinates::SendFromWalls()
{
  for (std::size_t i = 0; i < this->Sent.size(); ++i)
  {
    const std::size_t w = i % this->Walls.size();
    const Vec3& along = this->Directions[i / this->Walls.size()].Along;
    double sum = 0.0;
    double area = 1e-30;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int face = 2 * axis + (along[axis] > 0.0 ? 1 : 0);
      const double seen = this->Walls[w].IsFree[face] ? std::abs(along[axis]) : 0.0;
      sum += seen * (this->Walls[w].Direct[face] + this->Irradiance[6 * w + face]);
      area += seen;
    }
    this->Sent[i] = static_cast<float>(this->Walls[w].Albedo * sum / (vtkMath::Pi() * area));
  }
}

// Finds the irradiance of faces. That of an even radiance is exact with any directions.
void vtkGodRaysOrdinates::GatherAtWalls()
{
  for (int face = 0; face < 6; ++face)
  {
    std::vector<double> sums(this->Walls.size(), 0.0);
    double all = 0.0;
    for (std::size_t d = 0; d < this->Directions.size(); ++d)
    {
      const double cosine = this->Directions[d].Along[face / 2] * (face % 2 ? -1.0 : 1.0);
      const double weight = this->Directions[d].Weight * std::max(cosine, 0.0);
      all += weight;
      for (std::size_t w = 0; w < this->Walls.size(); ++w)
      {
        sums[w] += weight * this->Received[d * this->Walls.size() + w];
      }
    }
    for (std::size_t w = 0; w < this->Walls.size(); ++w)
    {
      this->Irradiance[6 * w + face] = static_cast<float>(vtkMath::Pi() * sums[w] / all);
    }
  }
}

void vtkGodRaysOrdinates::Sweep(
  const float* extinction, const float* emission, int degree, float* result)
{
  this->SendFromWalls();
  const int moments = (degree + 1) * (degree + 1);
  const std::size_t directions = this->Directions.size();
  std::vector<float> harmonics(directions * moments);
  for (std::size_t d = 0; d < directions; ++d)
  {
    GetHarmonics(this->Directions[d].Along, degree, harmonics.data() + d * moments);
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(directions), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> emitted(this->Size);
      for (std::size_t d = begin; d < static_cast<std::size_t>(end); ++d)
      {
        std::fill(emitted.begin(), emitted.end(), 0.0f);
        for (int m = 0; m < moments; ++m)
        {
          const float harmonic = harmonics[d * moments + m];
          for (std::size_t i = 0; i < this->Size; ++i)
          {
            emitted[i] += harmonic * emission[m * this->Size + i];
          }
        }
        this->SweepDirection(d, extinction, emitted.data());
      }
    });
  constexpr std::size_t block = 1024; // nodes
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Size / block + 1), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      const std::size_t first = begin * block;
      const std::size_t last = std::min<std::size_t>(end * block, this->Size);
      for (int m = 0; m < moments; ++m)
      {
        float* const moment = result + m * this->Size;
        std::fill(moment + first, moment + last, 0.0f);
        for (std::size_t d = 0; d < directions; ++d)
        {
          const float weight =
            harmonics[d * moments + m] * static_cast<float>(this->Directions[d].Weight);
          const float* const radiance = this->Radiance.data() + d * this->Size;
          for (std::size_t i = first; i < last; ++i)
          {
            moment[i] += weight * radiance[i];
          }
        }
      }
    });
  this->GatherAtWalls();
}

void vtkGodRaysOrdinates::SweepDirection(
  std::size_t index, const float* extinction, const float* emission)
{
  const Direction& direction = this->Directions[index];
  const int* const move = direction.Move;
  const float length = static_cast<float>(direction.Length);
  const std::ptrdiff_t stride[3] = { 1, this->Nodes[0],
    static_cast<std::ptrdiff_t>(this->Nodes[0]) * this->Nodes[1] };
  float* const radiance = this->Radiance.data() + index * this->Size;
  const float* const sent = this->Sent.data() + index * this->Walls.size();
  float* const received = this->Received.data() + index * this->Walls.size();
  const bool hasWalls = !this->Walls.empty();

  // Planes across one of the move's longest axes are done in the order of the light; the nodes of a row in
  // them do not need each other.
  const int longest = std::max({ std::abs(move[0]), std::abs(move[1]), std::abs(move[2]) });
  const int across = std::abs(move[2]) == longest ? 2 : std::abs(move[1]) == longest ? 1 : 0;
  const int along = across == 0 ? 1 : 0;
  const int rows = across == 2 ? 1 : 2;
  std::ptrdiff_t back = 0;          // from a node to the start of the move that leads to it
  std::ptrdiff_t halves[4] = { 0 }; // and to the nodes about its half-way point
  for (int axis = 0, bit = 0; axis < 3; bit += std::abs(move[axis]) == 1 ? 1 : 0, ++axis)
  {
    back -= move[axis] * stride[axis];
    for (int corner = 0; corner < 4; ++corner)
    {
      const int cells =
        std::abs(move[axis]) == 1 ? (corner >> bit & 1) * move[axis] : move[axis] / 2;
      halves[corner] -= cells * stride[axis];
    }
  }
  const auto mean = [&](const float* values, std::ptrdiff_t node)
  {
    return 0.25f *
      (values[node + halves[0]] + values[node + halves[1]] + values[node + halves[2]] +
        values[node + halves[3]]);
  };
  // Walls send light: in place of the light that they do not let pass, or, on a face of the grid, as light
  // that enters there.
  const auto send = [&](std::ptrdiff_t node, bool enters)
  {
    const int wall = hasWalls ? this->WallOf[node] : -1;
    return wall < 0 ? 0.0f
      : enters      ? (this->Walls[wall].IsFace ? sent[wall] : 0.0f)
                    : (1.0f - this->Walls[wall].Kept) * sent[wall];
  };
  const auto sendHalf = [&](std::ptrdiff_t node, bool enters)
  {
    float sum = 0.0f;
    for (const std::ptrdiff_t half : halves)
    {
      sum += 0.25f * send(node + half, enters);
    }
    return sum;
  };
  const auto carryHalf = [&](std::ptrdiff_t node, float half)
  {
    return Carry(half, mean(extinction, node), mean(emission, node), extinction[node],
      emission[node], 0.5f * length);
  };
  // Nodes of a row whose whole move is inside. A step of 1 is told as a constant, for vector code.
  const auto carryRow = [&](std::ptrdiff_t row, int first, int last, auto step)
  {
    for (int i = first; i < last && longest == 1; ++i)
    {
      const std::ptrdiff_t node = row + i * step;
      radiance[node] = Carry(radiance[node + back], extinction[node + back], emission[node + back],
        extinction[node], emission[node], length);
    }
    for (int i = first; i < last && longest == 2; ++i)
    {
      const std::ptrdiff_t node = row + i * step;
      const std::ptrdiff_t start = node + back;
      const float half = Carry(radiance[start], extinction[start], emission[start],
        mean(extinction, node), mean(emission, node), 0.5f * length);
      radiance[node] = carryHalf(
        node, hasWalls ? mean(this->Kept.data(), node) * half + sendHalf(node, false) : half);
    }
  };
  // How many halves of the move, 2 at most, are inside, for the node of an axis.
  const auto countHalves = [&](int axis, int node)
  {
    const int cells = move[axis] > 0 ? node : this->Nodes[axis] - 1 - node;
    return move[axis] == 0 ? 2 : std::min(2, 2 * cells / std::abs(move[axis]));
  };

  for (int plane = 0; plane < this->Nodes[across]; ++plane)
  {
    const int k = move[across] > 0 ? plane : this->Nodes[across] - 1 - plane;
    for (int j = 0; j < this->Nodes[rows]; ++j)
    {
      const std::ptrdiff_t row = k * stride[across] + j * stride[rows];
      const int count = this->Nodes[along];
      const int inside = std::min(countHalves(across, k), countHalves(rows, j));
      const int first = inside == 2 ? std::min(std::max(move[along], 0), count) : 0;
      const int last = inside == 2 ? std::max(count + std::min(move[along], 0), first) : 0;
      if (along == 0)
      {
        carryRow(row, first, last, std::integral_constant<std::ptrdiff_t, 1>());
      }
      else
      {
        carryRow(row, first, last, stride[along]);
      }
      for (int i = first > 0 ? 0 : last; i < count; i = i + 1 == first ? last : i + 1)
      {
        const std::ptrdiff_t node = row + i * stride[along];
        radiance[node] = std::min(inside, countHalves(along, i)) > 0
          ? carryHalf(node, sendHalf(node, true))
          : send(node, true);
      }
      for (int i = 0; i < count && hasWalls; ++i)
      {
        const std::ptrdiff_t node = row + i * stride[along];
        const int wall = this->WallOf[node];
        if (wall >= 0)
        {
          received[wall] = radiance[node];
          radiance[node] = this->Walls[wall].Kept * radiance[node] + send(node, false);
        }
      }
    }
  }
}
