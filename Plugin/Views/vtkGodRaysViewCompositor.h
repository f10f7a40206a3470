// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysViewCompositor
 * @brief   joins the layers of a scene that ParaView renders on several processes; private
 *
 * Layers are reduced over the processes of the global controller, as floats. A background that
 * ParaView puts under the picture later is drawn for the rays, too.
 */

#ifndef vtkGodRaysViewCompositor_h
#define vtkGodRaysViewCompositor_h

#include "vtkGodRaysCompositor.h"

class vtkGodRaysViewCompositor : public vtkGodRaysCompositor
{
public:
  static vtkGodRaysViewCompositor* New();
  vtkTypeMacro(vtkGodRaysViewCompositor, vtkGodRaysCompositor);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Before a frame: its background as it should be, whether it is drawn by several processes, and
   * whether ParaView joins its depth.
   */
  void Update(vtkRenderer* renderer, bool distributed, bool hasDepth);

  bool IsDistributed() override { return this->Distributed; }
  bool IsRoot() override;
  bool HasDepth() override { return this->Depth; }
  void Reduce(float* values, std::size_t count, Operation operation) override;
  void Reduce(double* values, std::size_t count, Operation operation) override;
  bool DrawBackground(vtkRenderer* renderer) override;

protected:
  vtkGodRaysViewCompositor() = default;
  ~vtkGodRaysViewCompositor() override = default;

private:
  vtkGodRaysViewCompositor(const vtkGodRaysViewCompositor&) = delete;
  void operator=(const vtkGodRaysViewCompositor&) = delete;

  /// What ParaView changes in a renderer to draw over black.
  struct Background
  {
    double Color[3] = { 0.0, 0.0, 0.0 };
    bool Gradient = false;
    bool Textured = false;

    void Get(vtkRenderer* renderer);
    void Set(vtkRenderer* renderer) const;
    bool operator==(const Background& other) const;
  };

  bool Distributed = false;
  bool Depth = true;
  Background Wanted;
};

#endif
