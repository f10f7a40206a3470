// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridTable.h"

#include "vtkDataArray.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

template <typename T, bool IsMasked>
struct vtkGodRaysGridTable::Reader
{
  static constexpr bool HasEntries = std::is_integral_v<T> && sizeof(T) <= 2;
  using Real = std::conditional_t<std::is_same_v<T, float>, float, double>;

  const vtkGodRaysGridTable& Table;
  const T* const Values;
  const Real First;
  const Real PerUnit;
  const Real Last; // entry

  explicit Reader(const vtkGodRaysGridTable& table)
    : Table(table)
    , Values(static_cast<const T*>(table.Values))
    , First(static_cast<Real>(table.First))
    , PerUnit(static_cast<Real>(table.PerUnit))
    , Last(static_cast<Real>(table.Entries - 1))
  {
  }

  struct Entry
  {
    int Low;
    float Part; // of the way to the next one
    bool IsShown;
  };

  Entry Find(std::ptrdiff_t point) const
  {
    Entry entry = { 0, 0.0f, !IsMasked || this->Table.Shown.Get(point) };
    if constexpr (HasEntries)
    {
      const int at = static_cast<int>(this->Values[point]) - static_cast<int>(this->First);
      entry.Low = std::clamp(at, 0, static_cast<int>(this->Last));
    }
    else
    {
      const Real at = (static_cast<Real>(this->Values[point]) - this->First) * this->PerUnit;
      const Real inside = at > Real(0) ? std::min(at, this->Last) : Real(0); // also of NaN
      entry.Low = static_cast<int>(inside);
      entry.Part = static_cast<float>(inside - static_cast<Real>(entry.Low));
    }
    return entry;
  }

  float Get(const Entry& entry, const float* values, int stride) const
  {
    const float* v = values + static_cast<std::ptrdiff_t>(entry.Low) * stride;
    float value = v[0];
    if constexpr (!HasEntries)
    {
      value += entry.Part * (v[stride] - v[0]);
    }
    return !IsMasked || entry.IsShown ? value : 0.0f;
  }

  void Find(std::ptrdiff_t first, std::ptrdiff_t row, std::ptrdiff_t slice, Entry entries[8]) const
  {
    const std::ptrdiff_t rows[4] = { first, first + row, first + slice, first + slice + row };
    for (int i = 0; i < 8; ++i)
    {
      entries[i] = this->Find(rows[i / 2] + i % 2);
    }
  }

  static void GetCorners(const vtkGodRaysGridTable& table, std::ptrdiff_t first, std::ptrdiff_t row,
    std::ptrdiff_t slice, int component, float* corners)
  {
    const Reader reader(table);
    Entry entries[8];
    reader.Find(first, row, slice, entries);
    const int stride = component == 0 ? 1 : table.Bands;
    const float* values =
      component == 0 ? table.Extinctions.data() : table.Scatterings.data() + component - 1;
    for (int i = 0; i < 8; ++i)
    {
      corners[i] = reader.Get(entries[i], values, stride);
    }
  }

  static void Look(const vtkGodRaysGridTable& table, std::ptrdiff_t first, std::ptrdiff_t row,
    std::ptrdiff_t slice, const float* t, float* coefficients)
  {
    const Reader reader(table);
    Entry entries[8];
    reader.Find(first, row, slice, entries);
    const auto mean = [&](const float* values, int stride)
    {
      float v[8];
      for (int i = 0; i < 8; ++i)
      {
        v[i] = reader.Get(entries[i], values, stride);
      }
      const float a = v[0] + t[0] * (v[1] - v[0]);
      const float b = v[2] + t[0] * (v[3] - v[2]);
      const float c = v[4] + t[0] * (v[5] - v[4]);
      const float d = v[6] + t[0] * (v[7] - v[6]);
      const float front = a + t[1] * (b - a);
      const float back = c + t[1] * (d - c);
      return front + t[2] * (back - front);
    };
    coefficients[0] = mean(table.Extinctions.data(), 1);
    for (int band = 0; band < table.Bands; ++band)
    {
      coefficients[1 + band] = mean(table.Scatterings.data() + band, table.Bands);
    }
  }

  static float Integrate(const vtkGodRaysGridTable& table, const vtkGodRaysGridPlanes& planes)
  {
    const Reader reader(table);
    const float* values = table.Extinctions.data();
    return planes.Integrate(
      [&](std::ptrdiff_t point) { return reader.Get(reader.Find(point), values, 1); });
  }

  static void AddRange(
    const vtkGodRaysGridTable& table, std::ptrdiff_t first, int count, float& low, float& high)
  {
    const Reader reader(table);
    for (int i = 0; i < count; ++i)
    {
      const float value = reader.Get(reader.Find(first + i), table.Extinctions.data(), 1);
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
};

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
  this->Owner = std::make_shared<vtkSmartPointer<vtkDataArray>>(own);
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

template <typename T>
void vtkGodRaysGridTable::SetFunctions()
{
  const auto set = [this](auto reader)
  {
    using Chosen = decltype(reader);
    this->Functions.GetCorners = Chosen::GetCorners;
    this->Functions.Look = Chosen::Look;
    this->Functions.Integrate = Chosen::Integrate;
    this->Functions.AddRange = Chosen::AddRange;
  };
  if (this->Shown.IsEmpty())
  {
    set(Reader<T, false>(*this));
  }
  else
  {
    set(Reader<T, true>(*this));
  }
}

void vtkGodRaysGridTable::Finish()
{
  // One more of each, so that what is between the last entry and the next one can be looked up.
  this->Extinctions.push_back(this->Extinctions.back());
  this->Scatterings.insert(
    this->Scatterings.end(), this->Scatterings.end() - this->Bands, this->Scatterings.end());
  switch (this->Array->GetDataType())
  {
    vtkTemplateMacro(this->SetFunctions<VTK_TT>());
  }
}
