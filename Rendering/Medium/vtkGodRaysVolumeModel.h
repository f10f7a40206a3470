// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysVolumeModel
 * @brief   no medium but the data of volumes: smoke, clouds or plumes in clear air
 *
 * What scatters is the data of each vtkVolume tagged MEDIUM, see vtkGodRaysPass::SetRole(), with the Data
 * numbers of vtkGodRaysMediumModel; the air between them does nothing. For smoke in haze, take
 * vtkGodRaysHomogeneousModel or vtkGodRaysAtmosphereModel: they have the same numbers. Without such a volume
 * there are no rays.
 *
 * @sa vtkGodRaysMediumModel vtkGodRaysGridFilter
 */

#ifndef vtkGodRaysVolumeModel_h
#define vtkGodRaysVolumeModel_h

#include "vtkGodRaysMediumModel.h"
#include "vtkGodRaysRenderingModule.h" // For export macro

#include <string> // For std::string

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysVolumeModel : public vtkGodRaysMediumModel
{
public:
  static vtkGodRaysVolumeModel* New();
  vtkTypeMacro(vtkGodRaysVolumeModel, vtkGodRaysMediumModel);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  std::string Describe() const override;

protected:
  vtkGodRaysVolumeModel() = default;
  ~vtkGodRaysVolumeModel() override = default;

  void FillMedium(vtkGodRaysMedium& medium, const double worldToView[16]) const override;

private:
  vtkGodRaysVolumeModel(const vtkGodRaysVolumeModel&) = delete;
  void operator=(const vtkGodRaysVolumeModel&) = delete;
};

#endif
