// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysSunInformation
 * @brief   where a vtkGodRaysRenderView placed its sun, on the client or on the server that draws
 *
 * @sa vtkSMGodRaysRenderViewProxy
 */

#ifndef vtkGodRaysSunInformation_h
#define vtkGodRaysSunInformation_h

#include "vtkGodRaysViewsModule.h" // For export macro
#include "vtkPVInformation.h"

class VTKGODRAYSVIEWS_EXPORT vtkGodRaysSunInformation : public vtkPVInformation
{
public:
  static vtkGodRaysSunInformation* New();
  vtkTypeMacro(vtkGodRaysSunInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void CopyFromObject(vtkObject* view) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;

  /**
   * Azimuth and elevation [degrees], and 1 if it was placed, else 0, 0, 0; then its colour.
   */
  vtkGetVectorMacro(PlacedSun, double, 6);

protected:
  vtkGodRaysSunInformation();
  ~vtkGodRaysSunInformation() override = default;

private:
  vtkGodRaysSunInformation(const vtkGodRaysSunInformation&) = delete;
  void operator=(const vtkGodRaysSunInformation&) = delete;

  double PlacedSun[6] = { 0.0, 0.0, 0.0, 1.0, 1.0, 1.0 };
};

#endif
