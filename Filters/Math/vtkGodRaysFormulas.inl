// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// All formulas, for C++: included within a namespace in which Real, Vec2, Vec3 and Vec4 are types of GLM,
// after vtkGodRaysPhaseFunction.h.
//
// Each formula is written once, in vtkGodRays<Topic>Math.glsl, and compiled by GLSL 1.50 after
// vtkGodRaysTypes.glsl and by C++17 here. So: no suffixes on numbers, no swizzles beyond .x .y .z, no
// gl_*, no uniforms; a texture is a Layer and is read by SampleLayer. A line //VTK::GodRays::<Topic> names
// what a topic needs: for C++ a comment, for shaders where that text goes, see vtkGodRaysQuad.
// Source keys are those of Documentation/References.md.

using glm::abs;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::floor;
using glm::fract;
using glm::length;
using glm::log;
using glm::max;
using glm::min;
using glm::pow;
using glm::sin;
using glm::smoothstep;
using glm::sqrt;
using std::exp2; // GLM has them through e, inexactly
using std::log2;

// Numbers with a unit.
using RealLength = Real;
using RealArea = Real;
using RealPerLength = Real;
using RealAngle = Real;
using RealSolidAngle = Real;
using RealPerSolidAngle = Real;
using RealPerLengthSolidAngle = Real;
using RealPerAreaSolidAngle = Real;
using Vec2Length = Vec2;

// GODRAYS_EXPECT(condition) states the domain of a formula. A build with GODRAYS_CHECK_DOMAINS, such as
// that of the tests of the formulas, stops where a condition does not hold; NaN is in no domain. It is
// nothing otherwise, and shaders are without these lines, each of which holds the whole statement.
#ifdef GODRAYS_CHECK_DOMAINS
#define GODRAYS_EXPECT(condition)                                                                  \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::fprintf(stderr, "%s() is for %s\n", __func__, #condition);                              \
      std::abort();                                                                                \
    }                                                                                              \
  } while (false)
#else
#define GODRAYS_EXPECT(condition) static_cast<void>(0)
#endif

#define vtkGodRaysPhaseKindMacro(constant, number, name, hasAsymmetry)                             \
  constexpr int PHASE_##constant = (number);
vtkGodRaysPhaseFunctionsMacro(vtkGodRaysPhaseKindMacro)
#undef vtkGodRaysPhaseKindMacro

inline bool PhaseHasAsymmetry(int kind)
{
  GODRAYS_EXPECT(kind >= 0 && kind <= vtkGodRaysLastPhaseFunction);
  return vtkGodRaysPhaseFunctions[kind].HasAsymmetry;
}

// The cosine of an angle, apart from rounding in single precision.
inline bool IsCosine(Real value)
{
  return value >= -1.00001 && value <= 1.00001;
}

#define LAYER_TEMPLATE template <typename Layer>
#define FUNCTION inline
#define IN(T) const T&
#define INOUT(T) T&
#include "vtkGodRaysCommonMath.glsl"

#include "vtkGodRaysColourMath.glsl"
#include "vtkGodRaysGridMath.glsl"
#include "vtkGodRaysLightMath.glsl"
#include "vtkGodRaysOrdersMath.glsl"
#include "vtkGodRaysPhaseMath.glsl"
#include "vtkGodRaysPlanetMath.glsl"
#include "vtkGodRaysRadialMath.glsl"
#include "vtkGodRaysSkyMapMath.glsl"
#include "vtkGodRaysWalkMath.glsl"

#include "vtkGodRaysAirlightMath.glsl"
#include "vtkGodRaysMediumMath.glsl"
#include "vtkGodRaysSkyMath.glsl"
#include "vtkGodRaysVisibilityMath.glsl"
#undef GODRAYS_EXPECT
#undef INOUT
#undef IN
#undef FUNCTION
#undef LAYER_TEMPLATE
