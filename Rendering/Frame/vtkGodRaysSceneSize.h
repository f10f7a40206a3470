// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSceneSize
 * @brief   how large a scene is, from which brightness is found; private to this module
 *
 * The density of air of no known unit, the power and the radius of lamps that nobody set, and where air ends
 * depend on the bounds of the visible props. They are found once and held while one of the props is visible
 * of which they were found, so that nothing that flies by changes a picture's brightness.
 */

#ifndef vtkGodRaysSceneSize_h
#define vtkGodRaysSceneSize_h

#include "vtkProp.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkGodRaysCompositor;
class vtkRenderer;

class vtkGodRaysSceneSize
{
public:
  /// Finds the bounds of a frame, on all processes, and holds them if none are held.
  void Find(vtkRenderer* renderer, vtkGodRaysCompositor* compositor);

  /// Has the next Find() hold its bounds.
  void Reset() { this->Props.clear(); }

  /// Why the bounds of the frame cannot be used, with the remedy, or none.
  const std::string& GetFault() const { return this->Fault; }

  /// Returns the bounds of the visible props of the frame; uninitialized if nothing is visible.
  const double* GetBounds() const { return this->Bounds; }

  /// Returns the diagonal of the bounds held; 0 if nothing is visible.
  double GetDiagonal() const;

  /// Returns the depth of the far clipping plane, as VTK sets it for the bounds held, if VTK set it.
  double GetFarDepth(vtkRenderer* renderer) const;

  /// A line of a plan if the bounds held are not those of the frame; else empty.
  std::string Describe() const;

private:
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Held[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  std::vector<vtkWeakPointer<vtkProp>> Props;
  std::string Fault;
};

#endif
