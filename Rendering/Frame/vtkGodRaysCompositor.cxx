// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysCompositor.h"

#include "vtkMath.h"

bool vtkGodRaysCompositor::Any(vtkGodRaysCompositor* compositor, bool here)
{
  if (!compositor || !compositor->IsDistributed())
  {
    return here;
  }
  double value = here ? 1.0 : 0.0;
  compositor->Reduce(&value, 1, GREATEST);
  return value > 0.0;
}

void vtkGodRaysCompositor::JoinBounds(vtkGodRaysCompositor* compositor, double bounds[6])
{
  if (!compositor || !compositor->IsDistributed())
  {
    return;
  }
  if (!vtkMath::AreBoundsInitialized(bounds))
  {
    for (int i = 0; i < 6; ++i)
    {
      bounds[i] = i % 2 ? -VTK_DOUBLE_MAX : VTK_DOUBLE_MAX;
    }
  }
  // the least of the lower ends, and of the upper ends with their signs changed
  for (int i = 1; i < 6; i += 2)
  {
    bounds[i] = -bounds[i];
  }
  compositor->Reduce(bounds, 6, LEAST);
  for (int i = 1; i < 6; i += 2)
  {
    bounds[i] = -bounds[i];
  }
  if (bounds[0] > bounds[1])
  {
    vtkMath::UninitializeBounds(bounds);
  }
}

void vtkGodRaysCompositor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
