// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysKronrod.h
 * @brief   Kronrod's rule of 15 points, and Gauss's of 7 within it; private to the implementation files
 *
 * [Piessens1983], there called QK15. Decision 17 tells why it is not Boost's.
 */

#ifndef vtkGodRaysKronrod_h
#define vtkGodRaysKronrod_h

namespace vtkGodRays
{
/// Of Kronrod's points between 1 and 0: those from -1 to 0 mirror them. Odd ones are Gauss's, too.
constexpr double KronrodPlaces[8] = { 0.991455371120812639206854697526329,
  0.949107912342758524526189684047851, 0.864864423359769072789712788640926,
  0.741531185599394439863864773280788, 0.586087235467691130294144691693013,
  0.405845151377397166906606412076961, 0.207784955007898467600689403773245, 0.0 };
/// Of integrals over [-1, 1].
constexpr double KronrodWeights[8] = { 0.022935322010529224963732008058970,
  0.063092092629978553290700663189204, 0.104790010322250183839876322541518,
  0.140653259715525918745189590510238, 0.169004726639267902826583426598550,
  0.190350578064785409913256402421014, 0.204432940075298892414161999234649,
  0.209482141084727828012999174891714 };
constexpr double GaussWeights[4] = { 0.129484966168869693270611432679082,
  0.279705391489276667901467771423780, 0.381830050505118944950369775488975,
  0.417959183673469387755102040816327 };

/// What both rules say of the mean of a function, doubled.
template <typename Value>
struct KronrodSums
{
  Value Kronrod;
  Value Gauss;
};

/**
 * Both rules for middle - reach to middle + reach: times reach, the sums are integrals. Values are
 * numbers or vectors; their difference is the error of Gauss's rule.
 */
template <typename Function>
auto SumByKronrod(const Function& f, double middle, double reach)
{
  const auto center = f(middle);
  using Value = decltype(f(middle));
  KronrodSums<Value> sums{ KronrodWeights[7] * center, GaussWeights[3] * center };
  for (int i = 0; i < 7; ++i)
  {
    const double away = reach * KronrodPlaces[i];
    const Value both = f(middle - away) + f(middle + away);
    sums.Kronrod += KronrodWeights[i] * both;
    if (i % 2 == 1)
    {
      sums.Gauss += GaussWeights[i / 2] * both;
    }
  }
  return sums;
}
}

#endif
