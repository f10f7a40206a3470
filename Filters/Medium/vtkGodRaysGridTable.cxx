// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridTable.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <type_traits>

namespace
{
// Returns the array as floats, which owner keeps.
const float* GetFloats(vtkDataArray* array, std::shared_ptr<const void>& owner)
{
  vtkSmartPointer<vtkFloatArray> floats = vtkFloatArray::FastDownCast(array);
  if (!floats)
  {
    floats = vtkSmartPointer<vtkFloatArray>::New();
    floats->DeepCopy(array);
  }
  owner = std::make_shared<vtkSmartPointer<vtkFloatArray>>(floats);
  return floats->GetPointer(0);
}

bool IsWithin(const float* values, vtkIdType count, float high)
{
  std::atomic<bool> good(true);
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      bool fine = true;
      for (vtkIdType i = begin; i < end; ++i)
      {
        fine = fine && values[i] >= 0.0f && values[i] <= high; // false for NaN
      }
      if (!fine)
      {
        good = false;
      }
    });
  return good;
}
}

bool vtkGodRaysGridTable::SetCoefficients(vtkDataArray* extinction, vtkDataArray* scattering)
{
  vtkDataArray* const arrays[2] = { extinction, scattering };
  for (int i = 0; i < 2 && arrays[i]; ++i)
  {
    this->Arrays[i] = GetFloats(arrays[i], this->Owners[i]);
    this->Bands[i] = arrays[i]->GetNumberOfComponents();
    if (!IsWithin(this->Arrays[i], arrays[i]->GetNumberOfValues(), 1e30f))
    {
      return false;
    }
  }
  this->Components = this->Bands[0] + this->Bands[1];
  this->Function = [](const vtkGodRaysGridTable& self, const std::ptrdiff_t* points, int count,
                     int first, int last, float* coefficients)
  {
    for (int component = first; component < last; ++component)
    {
      const int i = component < self.Bands[0] ? 0 : 1;
      const int bands = self.Bands[i];
      const float* const values = self.Arrays[i] + component - i * self.Bands[0];
      for (int k = 0; k < count; ++k)
      {
        *coefficients++ = values[points[k] * bands];
      }
    }
  };
  return true;
}

template <typename T>
void vtkGodRaysGridTable::Look(
  const std::ptrdiff_t* points, int count, int first, int last, float* coefficients) const
{
  constexpr bool hasEntries = std::is_integral_v<T> && sizeof(T) <= 2;
  using Real = std::conditional_t<std::is_same_v<T, float>, float, double>;
  const T* const values = static_cast<const T*>(this->Values);
  const Real begin = static_cast<Real>(this->First);
  const Real perUnit = static_cast<Real>(this->PerUnit);
  const Real end = static_cast<Real>(this->Entries - 1);
  const bool isMasked = !this->Shown.IsEmpty();
  for (int k = 0; k < count; ++k)
  {
    int entry = 0;
    float part = 0.0f; // of the way to the next one
    if constexpr (hasEntries)
    {
      const int at = static_cast<int>(values[points[k]]) - static_cast<int>(this->First);
      entry = std::clamp(at, 0, this->Entries - 1);
    }
    else
    {
      const Real at = (static_cast<Real>(values[points[k]]) - begin) * perUnit;
      const Real inside = at > Real(0) ? std::min(at, end) : Real(0); // also of NaN
      entry = static_cast<int>(inside);
      part = static_cast<float>(inside - static_cast<Real>(entry));
    }
    const float* v = this->Coefficients.data() + entry * this->Components + first;
    const bool isShown = !isMasked || this->Shown.Get(points[k]);
    for (int i = 0; i < last - first; ++i, ++v)
    {
      float value = v[0];
      if constexpr (!hasEntries)
      {
        value += part * (v[this->Components] - v[0]);
      }
      coefficients[i * count + k] = isShown ? value : 0.0f;
    }
  }
}

template <typename T>
bool vtkGodRaysGridTable::FindRange(const T* values)
{
  struct Range
  {
    T Low = std::numeric_limits<T>::max();
    T High = std::numeric_limits<T>::lowest();
    bool IsFinite = true;
  };
  vtkSMPThreadLocal<Range> ranges;
  vtkSMPTools::For(0, this->Count,
    [&](vtkIdType begin, vtkIdType end)
    {
      Range range = ranges.Local();
      for (vtkIdType i = begin; i < end; ++i)
      {
        if (this->Shown.IsEmpty() || this->Shown.Get(i))
        {
          range.IsFinite = range.IsFinite && std::isfinite(static_cast<double>(values[i]));
          range.Low = std::min(range.Low, values[i]);
          range.High = std::max(range.High, values[i]);
        }
      }
      ranges.Local() = range;
    });
  Range whole;
  for (const Range& range : ranges)
  {
    whole.Low = std::min(whole.Low, range.Low);
    whole.High = std::max(whole.High, range.High);
    whole.IsFinite = whole.IsFinite && range.IsFinite;
  }
  const bool isAny = whole.Low <= whole.High; // point is shown
  this->First = isAny ? static_cast<double>(whole.Low) : 0.0;
  this->Last = isAny ? static_cast<double>(whole.High) : 0.0;
  return whole.IsFinite;
}

bool vtkGodRaysGridTable::SetValues(vtkDataArray* values)
{
  vtkSmartPointer<vtkDataArray> own = values;
  if (!values->HasStandardMemoryLayout())
  {
    own.TakeReference(vtkDataArray::CreateDataArray(values->GetDataType()));
    own->DeepCopy(values);
  }
  this->Owners[0] = std::make_shared<vtkSmartPointer<vtkDataArray>>(own);
  this->Array = own;
  this->Values = own->GetVoidPointer(0);
  this->Count = own->GetNumberOfTuples();
  bool isFinite = true;
  switch (own->GetDataType())
  {
    vtkTemplateMacro(isFinite = this->FindRange(static_cast<const VTK_TT*>(this->Values)));
  }
  if (!isFinite)
  {
    return false;
  }
  if (!(this->Last > this->First))
  {
    this->Last = this->First + 1.0;
  }
  const bool hasEntries = own->GetDataTypeSize() <= 2;
  this->Entries = hasEntries ? static_cast<int>(this->Last - this->First) + 1 : MostEntries;
  this->PerUnit = (this->Entries - 1) / (this->Last - this->First);
  return true;
}

bool vtkGodRaysGridTable::IsInPlace() const
{
  return this->Array->GetNumberOfTuples() == this->Count &&
    this->Array->GetVoidPointer(0) == this->Values;
}

void vtkGodRaysGridTable::Finish()
{
  // One more, so that what is between the last entry and the next one can be looked up.
  const std::vector<float> last(
    this->Coefficients.end() - this->Components, this->Coefficients.end());
  this->Coefficients.insert(this->Coefficients.end(), last.begin(), last.end());
  switch (this->Array->GetDataType())
  {
    vtkTemplateMacro(
      this->Function = [](const vtkGodRaysGridTable& self, const std::ptrdiff_t* points, int count,
                         int first, int last, float* coefficients)
      { self.Look<VTK_TT>(points, count, first, last, coefficients); });
  }
}
