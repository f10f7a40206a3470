// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysRadialIntegrator.h"

#include "vtkGodRaysLight.h"
#include "vtkGodRaysMarch.h"
#include "vtkGodRaysRadialSumModel.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"

#include <algorithm>

vtkGodRaysMarchParameters vtkGodRaysRadialIntegrator::Request::GetMarchParameters() const
{
  vtkGodRaysMarchParameters march;
  march.Density = this->Model->GetDensity();
  march.Decay = this->Model->GetDecay();
  march.Weight = this->Model->GetWeight();
  march.Exposure = this->Model->GetExposure();
  march.NumberOfSamples = this->Model->GetNumberOfSamples();
  std::copy_n(this->Light->Clip, 3, march.LightClip);
  march.MarchScale = this->Light->MarchScale;
  return march;
}

vtkGodRaysMarch vtkGodRaysRadialIntegrator::Request::GetMarch() const
{
  const int layer[2] = { this->Layer->GetWidth(), this->Layer->GetHeight() };
  const int picture[2] = { this->Result->GetWidth(), this->Result->GetHeight() };
  return vtkGodRaysMarch(this->GetMarchParameters(), layer, picture, this->ViewScale);
}

void vtkGodRaysRadialIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

unsigned int vtkGodRaysRadialIntegrator::GetOneColorFormat(vtkGodRaysModel*, unsigned int)
{
  return 0;
}

bool vtkGodRaysRadialIntegrator::Supports(vtkGodRaysModel* model)
{
  return vtkGodRaysRadialSumModel::SafeDownCast(model) != nullptr;
}
