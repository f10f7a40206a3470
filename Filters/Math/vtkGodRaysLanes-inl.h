// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What kernels of all kinds need beside Highway. Compiled for each set of vector instructions: see
// vtkGodRaysVectorSets.h.
#if defined(vtkGodRaysLanes_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef vtkGodRaysLanes_inl_h
#undef vtkGodRaysLanes_inl_h
#else
#define vtkGodRaysLanes_inl_h
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vtkGodRays
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

// first, first + 1 and so on, in at most 16 lanes; exact up to 2^24. Highway's Iota stores lane by lane
// where a register has fewer than 16, and waits until all can be loaded.
template <class Tag>
HWY_INLINE hn::Vec<Tag> CountFrom(Tag d, float first)
{
  alignas(64) static constexpr float numbers[16] = { 0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f,
    8.0f, 9.0f, 10.0f, 11.0f, 12.0f, 13.0f, 14.0f, 15.0f };
  return hn::Load(d, numbers) + hn::Set(d, first);
}
}
}
HWY_AFTER_NAMESPACE();

#endif
