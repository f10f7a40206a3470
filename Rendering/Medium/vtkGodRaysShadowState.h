// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysShadowState.h
 * @brief   what the depths in a shadow map depend on; private to this module
 */

#ifndef vtkGodRaysShadowState_h
#define vtkGodRaysShadowState_h

#include "vtkGodRaysMediumIntegrator.h" // For Request

#include <array>   // For std::array
#include <cstddef> // For std::size_t
#include <vector>  // For std::vector

class vtkGodRaysShadowFaces;
class vtkGodRaysTarget;

/// Empty if it cannot be told. A prop of which VTK cannot report all changes differs from itself.
struct vtkGodRaysShadowState
{
  std::vector<const void*> Objects;
  std::vector<double> Numbers;
  std::vector<double> Places; // of the occluders' bounds in the faces, the same but for rounding
  // Where objects and numbers end: those before the first occluder, and those of each.
  std::vector<std::array<std::size_t, 2>> Ends;

  /// Finds it from modification times of actors, of all that they draw, of assemblies' parts and of volumes.
  void Find(const vtkGodRaysMediumIntegrator::Request& request, const vtkGodRaysShadowFaces& faces,
    const vtkGodRaysTarget& map);

  std::size_t GetNumberOfProps() const { return this->Ends.empty() ? 0 : this->Ends.size() - 1; }
  bool IsSame(const vtkGodRaysShadowState& other) const;
  bool HasSameFaces(const vtkGodRaysShadowState& other) const;
  bool HasSameProp(const vtkGodRaysShadowState& other, std::size_t prop) const;
  void Clear();

private:
  void End() { this->Ends.push_back({ this->Objects.size(), this->Numbers.size() }); }
};

#endif
