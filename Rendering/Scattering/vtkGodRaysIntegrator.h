// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysIntegrator
 * @brief   how the light scattered towards the eye is summed: the base of all integrators
 *
 * A model says what is summed, an integrator evaluates it. What it is given to do so depends on the
 * effect: see vtkGodRaysRadialIntegrator and vtkGodRaysMediumIntegrator.
 *
 * @sa vtkGodRaysModel vtkGodRaysPass
 */

#ifndef vtkGodRaysIntegrator_h
#define vtkGodRaysIntegrator_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"
#include "vtkWrappingHints.h" // For VTK_WRAPEXCLUDE

#include <string> // For std::string

class vtkGodRaysModel;
class vtkWindow;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysIntegrator : public vtkObject
{
public:
  vtkTypeMacro(vtkGodRaysIntegrator, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where light is summed, by integrators that have a Backend.
  enum BackendType
  {
    AUTOMATIC = 0, ///< PROCESSOR where OpenGL is software, GRAPHICS elsewhere
    PROCESSOR = 1, ///< on the processor
    GRAPHICS =
      2, ///< in shaders: where there is a choice, in compute shaders if OpenGL has them (4.3)
    FRAGMENTS = 3 ///< in fragment shaders
  };

  ///@{
  /**
   * Set/Get at how many pixels of a frame, at most all, chosen at random but the same every time, one in
   * each of as many equal parts of the picture, the result is compared with the exact one [no unit]; 0 does
   * not. See GetErrorEstimate(). It costs some 0.1 ms a pixel, and reading the result. Of a
   * vtkGodRaysRadialModel the exact sum is that of 2048 taps in double precision. Of a medium it is single
   * scattering among the opaque polygons of the scene, to 1e-6, which needs the scene on one process.
   * Published sums are not compared. Valid range: [0, 1000000]. Default is 0.
   */
  vtkSetClampMacro(VerifyPixels, int, 0, 1000000);
  vtkGetMacro(VerifyPixels, int);
  ///@}

  ///@{
  /**
   * Set/Get in every how many still frames VerifyPixels are compared [frames], beginning with the first. A
   * frame is still unless the user drags, which the window's DesiredUpdateRate of at least 1 tells; others
   * are never compared. Valid range: [1, 1000000]. Default is 1.
   */
  vtkSetClampMacro(VerifyInterval, int, 1, 1000000);
  vtkGetMacro(VerifyInterval, int);
  ///@}

  ///@{
  /**
   * The root mean square, and the largest, error at the VerifyPixels pixels of the last frame, of
   * its worst light [fraction of that light's brightest exact ray, of those pixels and of the one that
   * came out brightest]; -1 when none were compared. With n pixels, at most a fraction ln(1/p)/n of the
   * picture exceeds the largest one, with probability 1 - p.
   */
  vtkGetMacro(ErrorEstimate, double);
  vtkGetMacro(LargestVerifiedError, double);
  ///@}

  ///@{
  /**
   * For effects: begin a frame, whose errors are unknown, and decide whether pixels of it are compared;
   * whether they are; take the errors of a light.
   */
  VTK_WRAPEXCLUDE void BeginVerification(bool isStill);
  VTK_WRAPEXCLUDE bool IsVerified() const { return this->VerifiesFrame; }
  VTK_WRAPEXCLUDE void TakeErrors(double rootMeanSquare, double largest);
  ///@}

  /**
   * Whether this integrator can evaluate the model.
   */
  virtual bool Supports(vtkGodRaysModel* model) = 0;

  /**
   * What this integrator does for a model, in one line, for vtkGodRaysPass::GetPlan().
   */
  virtual std::string Describe(vtkGodRaysModel* model) = 0;

  /**
   * Free what is on the graphics card.
   */
  virtual void ReleaseGraphicsResources(vtkWindow* window) = 0;

protected:
  vtkGodRaysIntegrator() = default;
  ~vtkGodRaysIntegrator() override = default;

  /// Returns whether light is summed on the processor, in the context that is current.
  bool UsesProcessor() const;

  int Backend = AUTOMATIC;
  int VerifyPixels = 0;
  int VerifyInterval = 1;
  double ErrorEstimate = -1.0;
  double LargestVerifiedError = -1.0;

private:
  bool VerifiesFrame = false;
  int StillFrames = 0; // since pixels were compared

  vtkGodRaysIntegrator(const vtkGodRaysIntegrator&) = delete;
  void operator=(const vtkGodRaysIntegrator&) = delete;
};

#endif
