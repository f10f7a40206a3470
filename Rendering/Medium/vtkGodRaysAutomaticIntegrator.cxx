// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysAutomaticIntegrator.h"

#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysEpipolarCoverageIntegrator.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysShadowMapIntegrator.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkGodRaysAutomaticIntegrator);

namespace
{
// Measured: on the twelve scenes of Documentation/ModelError.md, 95 of 100 cases are within 0.0093 with one
// map of 1024 pixels, and within 0.0055, 0.0051, 0.0031 and 0.0029 with four nested ones of half of 768,
// 1024, 1536 and 3072.
constexpr double OneMapTolerance = 0.008;
constexpr int OneMapSize = 1024;
constexpr int NumberOfNestedMaps = 4;

int GetNestedMapSize(double tolerance)
{
  const double steps = std::round(6.0 / 256.0 / tolerance);
  return 256 * static_cast<int>(std::min(std::max(steps, 3.0), 16.0));
}
}

//------------------------------------------------------------------------------
vtkGodRaysAutomaticIntegrator::vtkGodRaysAutomaticIntegrator()
{
  this->Shadows->SweepMapOn();
  this->Shadows->SetNumberOfSteps(32);
}

//------------------------------------------------------------------------------
vtkGodRaysAutomaticIntegrator::~vtkGodRaysAutomaticIntegrator() = default;

//------------------------------------------------------------------------------
void vtkGodRaysAutomaticIntegrator::Choose(const Request& request)
{
  const bool sweeps = vtkGodRaysShadowMapIntegrator::CanSweep(request);
  if (!sweeps && vtkGodRaysEpipolarCoverageIntegrator::Evaluates(request))
  {
    this->Chosen = this->Coverage;
    return;
  }
  double tolerance = request.ErrorTolerance;
  if (request.Compositor &&
    request.Compositor->IsDistributed()) // whose maps are joined: of one size
  {
    request.Compositor->Reduce(&tolerance, 1, vtkGodRaysCompositor::GREATEST);
  }
  const bool nested = sweeps && request.Light->IsInfinite() && tolerance < OneMapTolerance;
  this->Shadows->SetMapSize(nested ? GetNestedMapSize(tolerance) : OneMapSize);
  this->Shadows->SetNumberOfNestedMaps(nested ? NumberOfNestedMaps : 1);
  this->Chosen = this->Shadows;
}

//------------------------------------------------------------------------------
bool vtkGodRaysAutomaticIntegrator::Integrate(const Request& request)
{
  this->Choose(request);
  return this->Chosen->Integrate(request);
}

//------------------------------------------------------------------------------
bool vtkGodRaysAutomaticIntegrator::Contribute(const Request& request)
{
  this->Choose(request);
  return this->Chosen->Contribute(request);
}

//------------------------------------------------------------------------------
std::string vtkGodRaysAutomaticIntegrator::Describe(vtkGodRaysModel* model)
{
  return this->Chosen ? "automatic: " + this->Chosen->Describe(model) : "automatic: nothing yet";
}

//------------------------------------------------------------------------------
void vtkGodRaysAutomaticIntegrator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Shadows->ReleaseGraphicsResources(window);
  this->Coverage->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkGodRaysAutomaticIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shadows:\n";
  this->Shadows->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Coverage:\n";
  this->Coverage->PrintSelf(os, indent.GetNextIndent());
}
