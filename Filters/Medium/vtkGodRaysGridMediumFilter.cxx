// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridMediumFilter.h"

#include "vtkGodRaysGrid.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkGodRaysSetFiniteMacro(vtkGodRaysGridMediumFilter, DataScale, 0.0, 1e9);
vtkGodRaysSetFinite3Macro(vtkGodRaysGridMediumFilter, DataAlbedo, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysGridMediumFilter, DataAsymmetry, -0.99, 0.99);

void vtkGodRaysGridMediumFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "DataScale: " << this->DataScale << "\n";
  os << indent << "DataAlbedo: " << this->DataAlbedo[0] << " " << this->DataAlbedo[1] << " "
     << this->DataAlbedo[2] << "\n";
  os << indent << "DataPhaseFunction: " << this->DataPhaseFunction << "\n";
  os << indent << "DataAsymmetry: " << this->DataAsymmetry << "\n";
}

int vtkGodRaysGridMediumFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  const int extent[6] = { 0, this->Size[0] - 1, 0, this->Size[1] - 1, 0, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(info, this->ScalarType, 3);
  return 1;
}

int vtkGodRaysGridMediumFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < input[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = input[port]->GetInformationObject(i);
      int extent[6];
      if (info->Has(
            vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT())) // of an image; else all is taken
      {
        info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
        info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
      }
    }
  }
  return 1;
}

std::string vtkGodRaysGridMediumFilter::ReadGrids(
  vtkInformationVector* input, std::vector<vtkGodRaysGrid>& grids) const
{
  grids.clear();
  if (this->Size[0] < 1 || this->Size[1] < 1 || this->Size[0] > 32768 || this->Size[1] > 32768)
  {
    return "the picture has no size. Set Size to two numbers in [1, 32768].";
  }
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
