// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef GodRaysLonelyCompositor_h
#define GodRaysLonelyCompositor_h

#include "vtkGodRaysCompositor.h"

namespace GodRaysTesting
{
/// One process of several, of which the others have nothing of the scene, and wait for nothing.
class LonelyCompositor : public vtkGodRaysCompositor
{
public:
  static LonelyCompositor* New()
  {
    auto compositor = new LonelyCompositor;
    compositor->InitializeObjectBase();
    return compositor;
  }
  bool IsDistributed() override { return this->Distributed; }
  bool IsRoot() override { return true; }
  bool HasDepth() override { return true; }
  void Reduce(float*, std::size_t, Operation) override { ++this->Calls; }
  void Reduce(double*, std::size_t, Operation) override { ++this->Calls; }
  bool DrawBackground(vtkRenderer*) override { return false; }

  bool Distributed = true; // false: this process has all data
  int Calls = 0;
};
}

#endif
