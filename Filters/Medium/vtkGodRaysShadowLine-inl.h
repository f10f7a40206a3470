// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// A line of a picture through the light: its pixels, its plane, and the map's columns in it. Compiled for
// each set of vector instructions: see vtkGodRaysShadowKernels.cxx.
#if defined(vtkGodRaysShadowLine_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef vtkGodRaysShadowLine_inl_h
#undef vtkGodRaysShadowLine_inl_h
#else
#define vtkGodRaysShadowLine_inl_h
#endif

#include "vtkGodRaysCoverageRays-inl.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysShadowKernels.h"
#include "vtkGodRaysShadowLines.h"

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
HWY_INLINE Float SetFloat(double value)
{
  return hn::Set(FloatTag(), static_cast<float>(value));
}

class ShadowLine
{
protected:
  ShadowLine(const CoverageSettings& settings, const CoverageImage& image,
    const CoverageWedge& wedge, const vtkGodRaysShadowGrids& grids, const ShadowTables& tables,
    const ShadowPicture& picture, ShadowLines& memory)
    : Settings(settings)
    , Image(image)
    , Wedge(wedge)
    , Grids(grids)
    , Ladder(tables.Ladder)
    , Fan(tables.Fan)
    , Picture(picture)
    , Memory(memory)
    , Distance(length(Vec3(settings.Light[0], settings.Light[1], settings.Light[2])))
    , Axis(settings.Parallel && settings.Point
          ? Vec3(0.0, 0.0, 1.0)
          : Vec3(settings.Light[0], settings.Light[1], settings.Light[2]) / this->Distance)
  {
    memory.Reserve(
      wedge.Rows, grids.Point ? this->Fan.Columns : this->Ladder.Columns, grids.NumberOfLayers);
    for (int k = 0; k < wedge.Rows; ++k)
    {
      int first;
      int last;
      FindCoveragePixels(wedge, image, wedge.First + k * wedge.Direction, first, last);
      memory.RowFirst[k] = static_cast<float>(first);
      memory.RowEnd[k] = static_cast<float>(std::max(last + 1, first));
    }
  }

  // A line, x = At + Slope n in the n-th row of the wedge.
  struct Straight
  {
    double At;
    double Slope;
  };
  Straight GetLine(double index) const
  {
    const CoverageWedge& wedge = this->Wedge;
    const double x = wedge.FirstLine + index * wedge.Spacing;
    const double slope = (wedge.W * x - wedge.A) / (wedge.W * wedge.Widest - wedge.B);
    return { x + slope * (wedge.First - wedge.Widest), slope * wedge.Direction };
  }

  // The rows in which the line's strip meets the picture, and the pixels in it.
  bool FindPixels(int line)
  {
    const Straight left = this->GetLine(line - 0.5);
    const Straight right = this->GetLine(line + 0.5);
    double low = 0.0;
    double high = this->Wedge.Rows - 1.0;
    const auto clip = [&](double value, double slope) // value + slope n >= 0
    {
      if (slope > 1e-14)
      {
        low = std::max(low, std::ceil(-value / slope));
      }
      else if (slope < -1e-14)
      {
        high = std::min(high, std::floor(-value / slope));
      }
      else if (value < 0.0)
      {
        high = -1.0;
      }
    };
    clip(right.At + 1.0, right.Slope);
    clip(this->Image.Width - left.At, -left.Slope);
    if (!(low <= high))
    {
      return false;
    }
    this->FirstRow = static_cast<int>(low);
    this->Rows = static_cast<int>(high) - this->FirstRow + 1;
    this->FindEdges(left, this->Memory.Begin.data());
    this->FindEdges(right, this->Memory.End.data());
    this->Center = this->GetLine(line);
    const int row = this->Wedge.First + this->FirstRow * this->Wedge.Direction;
    const std::ptrdiff_t step = this->Picture.Along * this->Wedge.Direction;
    std::ptrdiff_t base = row * this->Picture.Along;
    int n = 0;
    for (int k = 0; k < this->Rows; ++k, base += step)
    {
      const int begin = this->Memory.Begin[k];
      const int count = std::min(this->Memory.End[k] - begin, 3);
      for (int i = 0; i < 3; ++i) // without branches; what is too much is written over
      {
        this->Memory.Offset[n + i] = static_cast<int>(base + (begin + i) * this->Picture.Across);
        this->Memory.Row[n + i] = k;
        this->Memory.Column[n + i] = begin + i;
      }
      n += std::max(count, 0);
    }
    this->Pixels = n;
    return n > 0;
  }

  // Neighbours round their common edge alike: rows are counted from the wedge's first.
  void FindEdges(const Straight& edge, int* columns) const
  {
    const FloatTag d;
    const IntTag di;
    for (int k = 0; k < this->Rows; k += GetLanes())
    {
      const int n = this->FirstRow + k;
      const Float x =
        hn::Ceil(SetFloat(edge.At) + SetFloat(edge.Slope) * CountFrom(d, static_cast<float>(n)));
      const Float first = hn::LoadU(d, this->Memory.RowFirst.data() + n);
      const Float end = hn::LoadU(d, this->Memory.RowEnd.data() + n);
      hn::StoreU(hn::ConvertTo(di, hn::Min(hn::Max(x, first), end)), di, columns + k);
    }
  }

  // Where a row's ray goes from the eye, or, if rays are parallel, where it begins.
  Vec3 GetRay(double k) const
  {
    const double n = this->FirstRow + k;
    const double x = this->Center.At + this->Center.Slope * n;
    const double row = this->Wedge.First + n * this->Wedge.Direction;
    return Vec3((x - this->Image.Center[0]) * this->Settings.PixelSize,
      (row - this->Image.Center[1]) * this->Settings.PixelSize,
      this->Settings.Parallel ? 0.0 : 1.0);
  }

  // The line's plane, and the columns of the map in it; false if there are none.
  bool FindColumns()
  {
    const Vec3 ray = this->GetRay(0.0);
    const Vec3 next = this->GetRay(1.0) - ray;
    const Vec3 last = this->GetRay(this->Rows - 1.0);
    this->Square[0] = dot(ray, ray);
    this->Square[1] = 2.0 * dot(ray, next);
    this->Square[2] = dot(next, next);
    const Vec3 origin = this->GetOrigin();
    Vec3 across; // v
    if (this->Settings.Parallel && !this->Grids.Point)
    {
      across = Vec3(0.0, 0.0, 1.0) - this->Axis.z * this->Axis;
    }
    else
    {
      // From the ray that is farther from the axis.
      const Vec3 one = this->GetAcross(ray - origin);
      const Vec3 other = this->GetAcross(last - origin);
      across = dot(one, one) > dot(other, other) ? one : other;
    }
    across = normalize(across);
    this->Along[0] = dot(ray - origin, this->Axis);
    this->Along[1] = dot(next, this->Axis);
    this->Across[0] = dot(ray - origin, across);
    this->Across[1] = dot(next, across);
    this->Meet(across);
    return this->Grids.Point ? this->FindWedges(across)
                             : this->FindStrips(across, ray - this->Across[0] * across);
  }

  // Of (h, t): the eye, or, if rays are parallel, a point light.
  Vec3 GetOrigin() const
  {
    return this->Settings.Parallel && this->Grids.Point
      ? Vec3(this->Settings.Light[0], this->Settings.Light[1], this->Settings.Light[2])
      : Vec3(0.0);
  }

  Vec3 GetAcross(const Vec3& way) const { return way - dot(way, this->Axis) * this->Axis; }

  // See ColumnEdges.
  void Meet(const Vec3& across)
  {
    const bool parallel = this->Settings.Parallel;
    const auto set = [&](int i, double value, double change)
    {
      this->Meeting[i][0] = value;
      this->Meeting[i][1] = change;
    };
    for (int i = 0; i < 4; ++i)
    {
      set(i, 0.0, 0.0);
    }
    if (this->Grids.Point)
    {
      set(0, parallel ? this->Settings.Light[2] : this->Distance, 0.0);
      if (parallel)
      {
        set(1, -this->Across[0], -this->Across[1]);
        set(2, 1.0, 0.0);
        return;
      }
      set(2, this->Along[0], this->Along[1]);
      set(3, this->Across[0], this->Across[1]);
      return;
    }
    set(0, 1.0, 0.0);
    if (parallel)
    {
      set(1, -this->Across[0], -this->Across[1]);
      set(3, across.z, 0.0);
      return;
    }
    set(3, this->Across[0], this->Across[1]);
  }

  // Of a point light: wedges in the map, and not beyond where the first ray goes.
  bool FindWedges(const Vec3& across)
  {
    const double pi = std::acos(-1.0);
    double low =
      this->Settings.Parallel ? 0.0 : std::max(0.0, std::atan2(this->Across[0], this->Along[0]));
    double high = pi;
    for (int face = 0; face < this->Grids.Levels; ++face)
    {
      const vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[face];
      for (int i = 0; i < 3; ++i)
      {
        const Vec3 axis(grid.Axes[i][0], grid.Axes[i][1], grid.Axes[i][2]);
        this->Faces[face][i][0] = dot(axis, this->Axis);
        this->Faces[face][i][1] = dot(axis, across);
      }
    }
    if (this->Grids.Levels == 1) // within a cone about the third axis
    {
      const vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[0];
      double square = 1.0;
      for (int i = 0; i < 2; ++i)
      {
        const double end = grid.Low[i] + grid.Size[i] * grid.Texel[i];
        square += std::pow(std::max(std::abs(grid.Low[i]), std::abs(end)), 2);
      }
      const double* axis = this->Faces[0][2];
      const double cosine =
        1.0 / (std::sqrt(square) * std::max(std::hypot(axis[0], axis[1]), 1e-12));
      if (cosine >= 1.0)
      {
        return false;
      }
      const double half = std::acos(cosine);
      const double middle = std::atan2(axis[1], axis[0]);
      const double turns = middle + half < 0.0 ? 2.0 * pi : 0.0;
      low = std::max(low, middle - half + turns);
      high = std::min(high, middle + half + turns);
    }
    this->FirstColumn = static_cast<int>(std::max((pi - high) / this->Fan.Angle, 0.0));
    this->Columns =
      static_cast<int>(std::min(std::ceil((pi - low) / this->Fan.Angle), this->Fan.Columns + 0.0));
    return this->FirstColumn < this->Columns;
  }

  // Of a directional light: strips across it, from a place where t is 0.
  bool FindStrips(const Vec3& across, const Vec3& start)
  {
    const vtkGodRaysShadowGrids::Grid& grid = this->Grids.Grids[0];
    double begin = 0.0;
    double end = 1e30;
    if (this->Settings.Parallel) // between where rays begin and end
    {
      const double first = this->Across[0];
      const double last = first + this->Across[1] * (this->Rows - 1);
      begin = std::min(first, last);
      end = std::max(first, last) + across.z * this->Settings.FarLimit;
    }
    const double eye = begin;
    double most = 0.0;
    for (int i = 0; i < 2; ++i)
    {
      const Vec3 axis(grid.Axes[i][0], grid.Axes[i][1], grid.Axes[i][2]);
      this->Direction[i] = dot(across, axis);
      this->Offset[i] = this->Settings.Parallel ? dot(start, axis) : 0.0;
      most = std::max(most, std::abs(this->Direction[i]) / grid.Texel[i]);
      const double low = grid.Low[i] - this->Offset[i];
      const double high = low + grid.Size[i] * grid.Texel[i];
      if (std::abs(this->Direction[i]) < 1e-12)
      {
        end = low <= 0.0 && high >= 0.0 ? end : begin - 1.0;
        continue;
      }
      const double one = low / this->Direction[i];
      const double two = high / this->Direction[i];
      begin = std::max(begin, std::min(one, two));
      end = std::min(end, std::max(one, two));
    }
    if (!(begin < end) || !(most > 0.0))
    {
      return false;
    }
    // From the eye on; if the map begins later, from there, as if by Each columns before it.
    const bool isLater = begin > eye || this->Settings.Parallel;
    this->Width = 1.0 / most;
    this->Start = isLater ? begin - ShadowLadder::Each * this->Width : 0.0;
    this->FirstColumn = isLater ? ShadowLadder::FirstWhole : 0;
    const double whole = (end - this->Start) / this->Width - ShadowLadder::Each;
    const double room = this->Ladder.Columns - 64.0;
    this->Columns =
      static_cast<int>(std::min(std::ceil(std::max(whole, 0.0)) + ShadowLadder::FirstWhole, room));
    return true;
  }

  const CoverageSettings& Settings;
  const CoverageImage& Image;
  const CoverageWedge& Wedge;
  const vtkGodRaysShadowGrids& Grids;
  const ShadowLadder& Ladder;
  const ShadowFan& Fan;
  const ShadowPicture& Picture;
  ShadowLines& Memory;
  const double Distance; // of a point light, else 1
  const Vec3 Axis;       // e
  // Of the line:
  Straight Center = {};
  int FirstRow = 0;
  int Rows = 0;
  int Pixels = 0;
  // P of the first row, and its change from row to row; if rays are parallel, h and t of where they begin.
  double Along[2] = {};
  double Across[2] = {};     // Q
  double Meeting[4][2] = {}; // of ColumnEdges, of the first row, and their changes
  double Square[3] = {};     // of D's length, a polynomial of the row
  double Direction[2] = {};  // of t along the map's axes
  double Offset[2] = {};     // where t is 0, along them
  double Faces[vtkGodRaysShadowGrids::MaximumGrids][3]
              [2] = {}; // of e and v along a point light's axes
  double Width = 0.0;   // of a whole column [scene units]
  double Start = 0.0;   // t from which columns are counted
  int FirstColumn = 0;
  int Columns = 0; // one beyond the map's last
};
}
}
HWY_AFTER_NAMESPACE();

#endif
