// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysEpipolarIntegrator
 * @brief   the converged radial sum, at a cost that does not depend on the number of samples
 *
 * The default. Evaluates the limit that the sum of a vtkGodRaysRadialModel has for ever more taps,
 * along the lines through the light (epipolar lines), to the pass's ErrorTolerance:
 * root mean square error over the picture, as a fraction of the brightest ray. Derivation and errors:
 * Documentation/Evidence/Accuracy.md. Two back ends give the same numbers within the tolerance:
 *
 * - PROCESSOR: running sums along the lines (vtkGodRaysScatteringFilter), on all threads of
 *   vtkSMPTools. The layer is read back and the result uploaded: for software OpenGL, where both are
 *   copies in memory.
 * - GRAPHICS: means of the layer over blocks of each line times a matrix of the kernel, in three
 *   passes of fragment shaders, OpenGL 3.2.
 *
 * A vtkGodRaysPublishedModel has no limit that its authors meant: it is handed to a
 * vtkGodRaysTapsIntegrator. So an integrator that was set serves all looks.
 *
 * @sa vtkGodRaysPass vtkGodRaysTapsIntegrator vtkGodRaysScatteringFilter
 */

#ifndef vtkGodRaysEpipolarIntegrator_h
#define vtkGodRaysEpipolarIntegrator_h

#include "vtkGodRaysRadialIntegrator.h"
#include "vtkGodRaysRenderingModule.h" // For export macro

#include <memory> // For std::unique_ptr

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysEpipolarIntegrator : public vtkGodRaysRadialIntegrator
{
public:
  static vtkGodRaysEpipolarIntegrator* New();
  vtkTypeMacro(vtkGodRaysEpipolarIntegrator, vtkGodRaysRadialIntegrator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get where light is summed, one of BackendType. Default is AUTOMATIC.
   */
  vtkSetClampMacro(Backend, int, AUTOMATIC, GRAPHICS);
  vtkGetMacro(Backend, int);
  ///@}

  VTK_WRAPEXCLUDE unsigned int GetOneColorFormat(
    vtkGodRaysModel* model, unsigned int precision) override;
  VTK_WRAPEXCLUDE bool Integrate(const Request& request) override;
  std::string Describe(vtkGodRaysModel* model) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGodRaysEpipolarIntegrator();
  ~vtkGodRaysEpipolarIntegrator() override;

private:
  vtkGodRaysEpipolarIntegrator(const vtkGodRaysEpipolarIntegrator&) = delete;
  void operator=(const vtkGodRaysEpipolarIntegrator&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
