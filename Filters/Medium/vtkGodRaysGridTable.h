// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysGridTable
 * @brief   coefficients at the points of a grid, looked up from numbers of any type; private
 *
 * What a transfer function makes of numbers is in a table. The numbers are read where they are, so that
 * nothing is kept for a point but, where some points have no medium, a bit. Numbers of 8 and 16 bits have an
 * entry each; between the entries of others coefficients are linear.
 */

#ifndef vtkGodRaysGridTable_h
#define vtkGodRaysGridTable_h

#include "vtkGodRaysFiltersModule.h" // For export macro

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class vtkDataArray;

/// A bit for each point.
class vtkGodRaysGridBits
{
public:
  void Resize(std::size_t points, bool value)
  {
    this->Words.assign((points + 63) / 64, value ? ~std::uint64_t(0) : 0);
  }
  bool IsEmpty() const { return this->Words.empty(); }
  bool Get(std::size_t point) const { return (this->Words[point / 64] >> point % 64 & 1) != 0; }
  void Set(std::size_t point, bool value)
  {
    const std::uint64_t bit = std::uint64_t(1) << point % 64;
    std::uint64_t& word = this->Words[point / 64];
    word = value ? word | bit : word & ~bit;
  }
  /// Of 64 points each, which are in one word: threads may set those of several.
  std::size_t GetNumberOfWords() const { return this->Words.size(); }

private:
  std::vector<std::uint64_t> Words;
};

/// A line's ways through planes of points that lie side by side, across the axis that it goes along most.
struct vtkGodRaysGridPlanes
{
  int Count;                 // of planes
  std::ptrdiff_t First;      // the first point of the first one
  std::ptrdiff_t Next;       // from there to that of the next
  std::ptrdiff_t Strides[2]; // of points in a plane
  int Last[2];               // cell there
  double Begin[2];           // the place in the first plane [points]
  double Step[2];            // from plane to plane

  /// The integral, from the first plane to the last, of get(point), which counts as linear from plane to
  /// plane. [points]
  template <typename Get>
  float Integrate(const Get& get) const
  {
    float sum = 0.0f;
    float value = 0.0f;
    for (int i = 0; i < this->Count; ++i)
    {
      std::ptrdiff_t point = this->First + i * this->Next;
      float t[2];
      for (int k = 0; k < 2; ++k)
      {
        const double at = std::max(this->Begin[k] + i * this->Step[k], 0.0);
        const int cell = std::min(static_cast<int>(at), this->Last[k]);
        t[k] = static_cast<float>(at - cell);
        point += cell * this->Strides[k];
      }
      const float a = get(point);
      const float b = get(point + this->Strides[1]);
      const float front = a + t[0] * (get(point + this->Strides[0]) - a);
      const float back = b + t[0] * (get(point + this->Strides[0] + this->Strides[1]) - b);
      value = front + t[1] * (back - front);
      sum += i == 0 ? 0.5f * value : value;
    }
    return this->Count > 1 ? sum - 0.5f * value : 0.0f;
  }
};

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysGridTable
{
public:
  static constexpr int MostEntries = 4096; // of numbers of more than 16 bits

  vtkGodRaysGridBits Shown; // which points have anything; empty: all have

  /**
   * Take numbers of one component, which must stay as they are, and find their range at points that are
   * shown and how many entries that has. An array whose numbers do not stand side by side is copied. False
   * if a number is not finite.
   */
  bool SetValues(vtkDataArray* values);

  ///@{
  /// What is made of numbers from First to Last, evenly: extinction and, of 0, 1 or 3 bands, scattering.
  /// [1/scene unit]
  double First = 0.0;
  double Last = 1.0;
  int Bands = 0;
  int Entries = 0;
  std::vector<float> Extinctions; // as many
  std::vector<float> Scatterings; // the bands side by side
  ///@}

  /**
   * Choose how numbers are read, once table and points are known; do so once.
   */
  void Finish();

  /// Whether the numbers are still where they were.
  bool IsInPlace() const;

  ///@{
  /// At the corners of a cell, x fastest, from its first point, and those of its neighbours in x at a
  /// distance of 1: component 0 is extinction, those behind are scattering.
  void GetCorners(std::ptrdiff_t first, std::ptrdiff_t row, std::ptrdiff_t slice, int component,
    float corners[8]) const
  {
    this->Functions.GetCorners(*this, first, row, slice, component, corners);
  }
  /// Extinction, and scattering of each band, at a place of the cell.
  void Look(std::ptrdiff_t first, std::ptrdiff_t row, std::ptrdiff_t slice, const float place[3],
    float* coefficients) const
  {
    this->Functions.Look(*this, first, row, slice, place, coefficients);
  }
  /// The integral of extinction from plane to plane.
  float Integrate(const vtkGodRaysGridPlanes& planes) const
  {
    return this->Functions.Integrate(*this, planes);
  }
  /// Extend the range of extinction to that of a few points side by side.
  void AddRange(std::ptrdiff_t first, int count, float& low, float& high) const
  {
    this->Functions.AddRange(*this, first, count, low, high);
  }
  ///@}

private:
  template <typename T, bool IsMasked>
  struct Reader;

  struct
  {
    void (*GetCorners)(const vtkGodRaysGridTable&, std::ptrdiff_t, std::ptrdiff_t, std::ptrdiff_t,
      int, float*) = nullptr;
    void (*Look)(const vtkGodRaysGridTable&, std::ptrdiff_t, std::ptrdiff_t, std::ptrdiff_t,
      const float*, float*) = nullptr;
    float (*Integrate)(const vtkGodRaysGridTable&, const vtkGodRaysGridPlanes&) = nullptr;
    void (*AddRange)(const vtkGodRaysGridTable&, std::ptrdiff_t, int, float&, float&) = nullptr;
  } Functions;

  template <typename T>
  bool FindRange(const T* values);
  template <typename T>
  void SetFunctions();

  double PerUnit = 1.0; // entries
  std::shared_ptr<const void> Owner;
  vtkDataArray* Array = nullptr;
  const void* Values = nullptr;
  std::ptrdiff_t Count = 0;
};

#endif
