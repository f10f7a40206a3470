// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file   vtkGodRaysVectorSets.h
 * @brief  The sets of vector instructions that a file of kernels is compiled for.
 *
 * To be included before Highway's foreach_target.h, in place of its HWY_DISABLED_TARGETS. Left out:
 *
 * - SSSE3, which differs too little from SSE4 to be worth its code;
 * - of x86 all that is newer than AVX3 (AVX-512): these have lower bits in Highway, and more of them with
 *   each version of it; their registers are as wide;
 * - those whose registers have no size when the program is compiled (arm64 has NEON as well).
 */
#ifndef vtkGodRaysVectorSets_h
#define vtkGodRaysVectorSets_h

#define HWY_DISABLED_TARGETS                                                                       \
  (HWY_SSSE3 | (HWY_AVX3 - 1) | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

#endif
