// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysGridTable
 * @brief   extinction and scattering at the points of a grid; private
 *
 * They are read from arrays of coefficients, or looked up from numbers of any type: then a table holds the
 * transfer function. The numbers are read where they are, so that nothing is kept for a point but, where some
 * points have no medium, a bit. Numbers of 8 and 16 bits have an entry each; between the entries of others
 * coefficients are linear.
 */

#ifndef vtkGodRaysGridTable_h
#define vtkGodRaysGridTable_h

#include "vtkGodRaysFiltersModule.h" // For export macro

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

class VTKGODRAYSFILTERS_EXPORT vtkGodRaysGridTable
{
public:
  static constexpr int MostEntries = 4096; // of numbers of more than 16 bits
  static constexpr int MostComponents = 6; // extinction and scattering of 3 bands each

  vtkGodRaysGridBits Shown; // which points have anything; empty: all have

  /**
   * Take coefficients at each point, of 1 or 3 bands, which are copied unless they are floats; scattering may
   * be null. False if one is negative, above 1e30 or not finite.
   */
  bool SetCoefficients(vtkDataArray* extinction, vtkDataArray* scattering);

  /**
   * Take numbers of one component, which must stay as they are, and find their range at points that are
   * shown and how many entries that has. An array whose numbers do not stand side by side is copied. False
   * if a number is not finite. Then fill in Coefficients, and call Finish().
   */
  bool SetValues(vtkDataArray* values);

  ///@{
  /// Holds what numbers from First to Last, evenly, stand for: extinction and, of 0, 1 or 3 bands,
  /// scattering, side by side. [1/scene unit]
  double First = 0.0;
  double Last = 1.0;
  int Entries = 0;
  int Components = 1;
  std::vector<float> Coefficients;
  ///@}

  /**
   * Choose how numbers are read, once table and points are known; do so once.
   */
  void Finish();

  /// Whether the numbers are still where they were.
  bool IsInPlace() const;

  /// Read the components from first to before last at so many points: all of the first one, then the next.
  void Gather(
    const std::ptrdiff_t* points, int count, int first, int last, float* coefficients) const
  {
    this->Function(*this, points, count, first, last, coefficients);
  }

private:
  void (*Function)(
    const vtkGodRaysGridTable&, const std::ptrdiff_t*, int, int, int, float*) = nullptr;

  template <typename T>
  bool FindRange(const T* values);
  template <typename T>
  void Look(
    const std::ptrdiff_t* points, int count, int first, int last, float* coefficients) const;

  double PerUnit = 1.0; // entries
  std::shared_ptr<const void> Owners[2];
  vtkDataArray* Array = nullptr;
  const void* Values = nullptr;
  std::ptrdiff_t Count = 0;
  const float* Arrays[2] = { nullptr, nullptr }; // extinction and scattering at each point
  int Bands[2] = { 0, 0 };                       // of these
};

#endif
