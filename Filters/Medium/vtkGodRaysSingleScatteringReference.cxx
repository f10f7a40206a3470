// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkDoubleArray.h"
#include "vtkGodRaysGrid.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSingleScattering.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkGodRaysSingleScatteringReference);

vtkGodRaysSetFiniteMacro(vtkGodRaysSingleScatteringReference, Tolerance, 1e-12, 1e-2);

namespace
{
const double Infinity = std::numeric_limits<double>::infinity();
}

vtkGodRaysSingleScatteringReference::vtkGodRaysSingleScatteringReference()
{
  this->SetNumberOfInputPorts(3);
  this->ScalarType = VTK_DOUBLE;
}

void vtkGodRaysSingleScatteringReference::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}

int vtkGodRaysSingleScatteringReference::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 2 ? "vtkImageData" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), port == 2 ? 1 : 0);
  return 1;
}

int vtkGodRaysSingleScatteringReference::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* result = vtkImageData::GetData(output);
  std::string fault = this->FindFault();
  std::vector<vtkGodRaysGrid> grids;
  if (fault.empty())
  {
    fault = this->ReadGrids(input[2], grids);
  }
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute scattered light: " << fault);
    result->Initialize();
    return 1; // the executive would only add that something failed
  }

  const int width = this->Size[0];
  const int height = this->Size[1];
  const vtkIdType pixels = static_cast<vtkIdType>(width) * height;
  vtkNew<vtkDoubleArray> radiances;
  radiances->SetName("Radiance");
  radiances->SetNumberOfComponents(3);
  radiances->SetNumberOfTuples(pixels);
  vtkNew<vtkDoubleArray> transmittances;
  transmittances->SetName("Transmittance");
  transmittances->SetNumberOfComponents(3);
  transmittances->SetNumberOfTuples(pixels);
  vtkNew<vtkDoubleArray> depths;
  depths->SetName("Depth");
  depths->SetNumberOfTuples(pixels);
  vtkNew<vtkDoubleArray> ends;
  ends->SetName("End");
  ends->SetNumberOfTuples(pixels);

  const View view = this->GetView(height);
  vtkGodRaysSingleScattering::Parameters parameters;
  std::copy_n(view.Position, 3, parameters.Position);
  std::copy_n(view.Right, 3, parameters.Right);
  std::copy_n(view.Up, 3, parameters.Up);
  std::copy_n(view.Forward, 3, parameters.Forward);
  parameters.Parallel = view.Parallel;
  std::copy_n(this->Light, 4, parameters.Light);
  std::copy_n(this->LightColor, 3, parameters.LightColor);
  parameters.Spot = this->GetSpot(view);
  parameters.Medium = this->GetMedium(view);
  parameters.Tolerance = this->Tolerance;
  vtkGodRaysSingleScattering scattering;
  scattering.SetParameters(parameters);
  scattering.SetGrids(grids);
  scattering.SetOccluders(vtkPolyData::GetData(input[0]));
  if (input[1]->GetNumberOfInformationObjects() > 0)
  {
    scattering.SetSeen(vtkPolyData::GetData(input[1]));
  }

  const auto evaluateRow = [&](int y)
  {
    vtkGodRaysSingleScattering::Result ray;
    for (int x = 0; x < width; ++x)
    {
      scattering.Evaluate(
        (x + 0.5 - 0.5 * width) * view.PixelSize, (y + 0.5 - 0.5 * height) * view.PixelSize, ray);
      const vtkIdType pixel = static_cast<vtkIdType>(y) * width + x;
      std::copy_n(ray.Radiance, 3, radiances->GetPointer(3 * pixel));
      std::copy_n(ray.Transmittance, 3, transmittances->GetPointer(3 * pixel));
      ends->SetValue(pixel, ray.Sight);
      depths->SetValue(
        pixel, ray.Crossings.empty() ? Infinity : ray.Crossings.front() / ray.LengthPerDepth);
    }
  };

  constexpr int steps = 20;
  for (int step = 0; step < steps; ++step)
  {
    vtkSMPTools::For(static_cast<vtkIdType>(height) * step / steps,
      static_cast<vtkIdType>(height) * (step + 1) / steps, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType y = begin; y < end; ++y)
        {
          evaluateRow(static_cast<int>(y));
        }
      });
    if (!this->TellProgress((step + 1.0) / steps))
    {
      result->Initialize();
      return 1;
    }
  }
  result->SetDimensions(width, height, 1);
  result->GetPointData()->SetScalars(radiances);
  result->GetPointData()->AddArray(transmittances);
  result->GetPointData()->AddArray(depths);
  result->GetPointData()->AddArray(ends);
  return 1;
}
