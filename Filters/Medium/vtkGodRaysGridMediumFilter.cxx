// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridMediumFilter.h"

#include "vtkGodRaysGrid.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"

#include <algorithm>

vtkGodRaysSetFiniteMacro(vtkGodRaysGridMediumFilter, DataScale, 0.0, 1e9);
vtkGodRaysSetFinite3Macro(vtkGodRaysGridMediumFilter, DataAlbedo, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysGridMediumFilter, DataAsymmetry, -0.99, 0.99);

void vtkGodRaysGridMediumFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DataScale: " << this->DataScale << "\n";
  os << indent << "DataAlbedo: " << this->DataAlbedo[0] << " " << this->DataAlbedo[1] << " "
     << this->DataAlbedo[2] << "\n";
  os << indent << "DataPhaseFunction: " << this->DataPhaseFunction << "\n";
  os << indent << "DataAsymmetry: " << this->DataAsymmetry << "\n";
}

std::string vtkGodRaysGridMediumFilter::ReadGrids(
  vtkInformationVector* input, std::vector<vtkGodRaysGrid>& grids) const
{
  grids.clear();
  for (int i = 0; i < input->GetNumberOfInformationObjects(); ++i)
  {
    vtkGodRaysGrid grid;
    grid.Scale = this->DataScale;
    std::copy_n(this->DataAlbedo, 3, grid.Albedo);
    grid.PhaseFunction = this->DataPhaseFunction;
    grid.Asymmetry = this->DataAsymmetry;
    vtkImageData* image = vtkImageData::GetData(input, i);
    const std::string fault = image ? grid.Read(image) : "data of a medium are no image.";
    if (!fault.empty())
    {
      return fault;
    }
    grids.push_back(grid);
  }
  return {};
}
