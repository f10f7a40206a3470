// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysPhaseFunction.h
 * @brief   the phase functions: into which directions a medium scatters light
 *
 * The list stands here alone. The constants of classes and of shaders, names in texts, valid ranges and
 * ParaView's lists come of it. The formulas are in vtkGodRaysPhaseMath.glsl.
 */

#ifndef vtkGodRaysPhaseFunction_h
#define vtkGodRaysPhaseFunction_h

/**
 * Each phase function: its constant; its number, counted from 0; its name, of which ParaView shows the
 * first letter as a capital; whether it depends on the asymmetry g, above 0 for light that goes on rather
 * than back. CMake/write_entries.py reads these lines, too.
 */
// clang-format off
#define vtkGodRaysPhaseFunctionsMacro(Each)                                                        \
  Each(ISOTROPIC, 0, "isotropic", false)                                                           \
  Each(RAYLEIGH, 1, "Rayleigh", false)                                                             \
  Each(HENYEY_GREENSTEIN, 2, "Henyey-Greenstein", true)                                            \
  Each(CORNETTE_SHANKS, 3, "Cornette-Shanks", true)                                                \
  Each(SCHLICK, 4, "Schlick", true)
// clang-format on

/**
 * The constants, as the body of an enum. Each class has the enum itself, for which VTK's wrappers expand the
 * macro.
 */
#define vtkGodRaysPhaseFunctionConstantMacro(constant, number, name, hasAsymmetry)                 \
  constant = (number),
#define vtkGodRaysPhaseFunctionConstantsMacro()                                                    \
  vtkGodRaysPhaseFunctionsMacro(vtkGodRaysPhaseFunctionConstantMacro)

/**
 * What is to be known of a phase function besides its formula.
 */
struct vtkGodRaysPhaseFunction
{
  const char* Constant;
  int Number;
  const char* Name;
  bool HasAsymmetry;
};

#define vtkGodRaysPhaseFunctionTraitsMacro(constant, number, name, hasAsymmetry)                   \
  { #constant, number, name, hasAsymmetry },
constexpr vtkGodRaysPhaseFunction vtkGodRaysPhaseFunctions[] = { vtkGodRaysPhaseFunctionsMacro(
  vtkGodRaysPhaseFunctionTraitsMacro) };
#undef vtkGodRaysPhaseFunctionTraitsMacro

/// The number of the last one.
constexpr int vtkGodRaysLastPhaseFunction =
  static_cast<int>(sizeof(vtkGodRaysPhaseFunctions) / sizeof(vtkGodRaysPhaseFunction)) - 1;
static_assert(
  vtkGodRaysPhaseFunctions[vtkGodRaysLastPhaseFunction].Number == vtkGodRaysLastPhaseFunction,
  "phase functions are counted from 0");

#endif
