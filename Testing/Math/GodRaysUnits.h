// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The formulas of topics whose quantities have one unit each, compiled with units as types: what compiles has
// the dimensions that it says. C++20: 0 alone compares with quantities of all units, which is known while
// compiling. Vectors count as numbers, as do Vec2 to Vec4 there.

#ifndef GodRaysUnits_h
#define GodRaysUnits_h

#include "vtkGodRaysMath.h"

namespace vtkGodRaysUnits
{
using Real = double;
using Vec2 = vtkGodRays::Vec2;
using Vec3 = vtkGodRays::Vec3;
using Vec4 = vtkGodRays::Vec4;

struct Zero
{
  consteval Zero(double value)
  {
    value == 0.0 ? void() : throw "a number is compared with a quantity";
  }
};

template <int L, int A>
struct Quantity // of the unit length^L angle^A
{
  double Value;
  explicit constexpr Quantity(double value)
    : Value(value)
  {
  }
  Quantity operator-() const { return Quantity(-this->Value); }
  Quantity operator+(Quantity other) const { return Quantity(this->Value + other.Value); }
  Quantity operator-(Quantity other) const { return Quantity(this->Value - other.Value); }
  Quantity& operator+=(Quantity other) { return *this = *this + other; }
  Quantity& operator-=(Quantity other) { return *this = *this - other; }
  bool operator<(Quantity other) const { return this->Value < other.Value; }
  bool operator>(Quantity other) const { return this->Value > other.Value; }
  bool operator<(Zero) const { return this->Value < 0.0; }
  bool operator>(Zero) const { return this->Value > 0.0; }
  bool operator<=(Zero) const { return this->Value <= 0.0; }
  bool operator>=(Zero) const { return this->Value >= 0.0; }
};

template <int L, int A>
auto Make(double value) // a number where the units cancel
{
  if constexpr (L == 0 && A == 0)
  {
    return value;
  }
  else
  {
    return Quantity<L, A>(value);
  }
}
template <int L, int A, int M, int B>
auto operator*(Quantity<L, A> a, Quantity<M, B> b)
{
  return Make<L + M, A + B>(a.Value * b.Value);
}
template <int L, int A, int M, int B>
auto operator/(Quantity<L, A> a, Quantity<M, B> b)
{
  return Make<L - M, A - B>(a.Value / b.Value);
}
template <int L, int A>
auto operator*(double a, Quantity<L, A> b)
{
  return Quantity<L, A>(a * b.Value);
}
template <int L, int A>
auto operator*(Quantity<L, A> a, double b)
{
  return b * a;
}
template <int L, int A>
auto operator/(Quantity<L, A> a, double b)
{
  return Quantity<L, A>(a.Value / b);
}
template <int L, int A>
auto operator/(double a, Quantity<L, A> b)
{
  return Quantity<-L, -A>(a / b.Value);
}
template <int L, int A>
auto sqrt(Quantity<L, A> a)
{
  static_assert(L % 2 == 0 && A % 2 == 0, "the root of this unit is none");
  return Quantity<L / 2, A / 2>(std::sqrt(a.Value));
}
template <int L, int A>
auto abs(Quantity<L, A> a)
{
  return a < 0.0 ? -a : a;
}
template <int L, int A>
auto min(Quantity<L, A> a, Quantity<L, A> b)
{
  return b < a ? b : a;
}
template <int L, int A>
auto max(Quantity<L, A> a, Quantity<L, A> b)
{
  return a < b ? b : a;
}
template <int L, int A>
auto max(Quantity<L, A> a, Zero)
{
  return a < 0.0 ? Quantity<L, A>(0.0) : a;
}
template <int L, int A>
double atan(Quantity<L, A> a, Quantity<L, A> b)
{
  return std::atan2(a.Value, b.Value);
}

using RealLength = Quantity<1, 0>;
using RealArea = Quantity<2, 0>;
using RealPerLength = Quantity<-1, 0>;
using RealAngle = Quantity<0, 1>;
using RealSolidAngle = Quantity<0, 2>;
using RealPerSolidAngle = Quantity<0, -2>;
using RealPerLengthSolidAngle = Quantity<-1, -2>;
using RealPerAreaSolidAngle = Quantity<-2, -2>;
struct Vec2Length
{
  RealLength x, y;
  Vec2Length(double first, double second)
    : x(first)
    , y(second)
  {
  }
  Vec2Length(RealLength first, RealLength second)
    : x(first)
    , y(second)
  {
  }
};

using glm::abs;
using glm::atan;
using glm::clamp;
using glm::cross;
using glm::dot;
using glm::fract;
using glm::length;
using glm::max;
using glm::min;
using std::exp;
using std::log;
using std::sqrt;
using vtkGodRays::PhaseHasAsymmetry;
#define GODRAYS_USE(constant, number, name, hasAsymmetry) using vtkGodRays::PHASE_##constant;
vtkGodRaysPhaseFunctionsMacro(GODRAYS_USE)
#undef GODRAYS_USE

#define FUNCTION inline
#define IN(T) const T&
#define GODRAYS_EXPECT(condition) static_cast<void>(0)
#include "vtkGodRaysCommonMath.glsl"

#include "vtkGodRaysLightMath.glsl"
#include "vtkGodRaysPhaseMath.glsl"
#include "vtkGodRaysPlanetMath.glsl"

#include "vtkGodRaysAirlightMath.glsl"
#undef GODRAYS_EXPECT
#undef IN
#undef FUNCTION
}

#endif
