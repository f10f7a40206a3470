// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysGridFilter.h"

#include "vtkFloatArray.h"
#include "vtkGodRaysGridPicture.h"
#include "vtkGodRaysMemory.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkGodRaysGridFilter);

vtkGodRaysSetFiniteMacro(vtkGodRaysGridFilter, ErrorTolerance, 1e-5, 0.1);

class vtkGodRaysGridFilter::vtkInternals
{
public:
  vtkGodRaysGridPicture Drawer;
  std::vector<double> Numbers; // that its depths depend on, of the last time
};

vtkGodRaysGridFilter::vtkGodRaysGridFilter()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(2);
}

vtkGodRaysGridFilter::~vtkGodRaysGridFilter() = default;

void vtkGodRaysGridFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
}

int vtkGodRaysGridFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), port == 0 ? 1 : 0);
  return 1;
}

int vtkGodRaysGridFilter::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* result = vtkImageData::GetData(output);
  std::string fault = this->FindFault();
  std::vector<vtkGodRaysGrid> grids;
  if (fault.empty())
  {
    fault = this->ReadGrids(input[0], grids);
  }
  if (grids.size() > vtkGodRaysGridPicture::MaximumGrids)
  {
    fault = "there are more than 32 media of data. Join some of them.";
  }
  const std::size_t pixels =
    static_cast<std::size_t>(std::max(this->Size[0], 0)) * std::max(this->Size[1], 0);
  constexpr double bytes = 24.0; // of a pixel
  fault = fault.empty() ? vtkGodRays::FindMemoryFault(bytes * pixels, "Size") : fault;
  vtkSmartPointer<vtkFloatArray> depths;
  if (input[1]->GetNumberOfInformationObjects() > 0)
  {
    vtkDataArray* scalars = vtkImageData::GetData(input[1])->GetPointData()->GetScalars();
    if (!scalars || scalars->GetNumberOfComponents() != 1 ||
      static_cast<std::size_t>(scalars->GetNumberOfTuples()) != pixels)
    {
      fault = "the picture of depths does not suit. Give one of Size pixels with one component.";
    }
    else
    {
      depths = vtkSmartPointer<vtkFloatArray>::New();
      depths->DeepCopy(scalars);
      std::replace_if(
        depths->GetPointer(0), depths->GetPointer(0) + pixels,
        [](float depth) { return !(depth > 0.0f); }, 1e30f);
    }
  }
  if (!fault.empty())
  {
    vtkErrorMacro("Cannot compute the light of data: " << fault);
    result->Initialize();
    return 1; // the executive would only add that something failed
  }

  std::vector<double> numbers = { this->DataScale };
  for (std::size_t i = 0; i < grids.size(); ++i)
  {
    numbers.push_back(
      static_cast<double>(vtkImageData::GetData(input[0], static_cast<int>(i))->GetMTime()));
  }
  vtkGodRaysGridPicture& drawer = this->Internals->Drawer;
  drawer.SetGrids(grids, numbers == this->Internals->Numbers);
  this->Internals->Numbers = numbers;

  const View view = this->GetView(this->Size[1]);
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
  parameters.Tolerance = this->ErrorTolerance;
  vtkNew<vtkFloatArray> arrays[2];
  const char* names[2] = { "Radiance", "Transmittance" };
  for (int i = 0; i < 2; ++i)
  {
    arrays[i]->SetName(names[i]);
    arrays[i]->SetNumberOfComponents(3);
    arrays[i]->SetNumberOfTuples(static_cast<vtkIdType>(pixels));
  }
  vtkGodRaysGridPicture::Picture picture;
  std::copy_n(this->Size, 2, picture.Size);
  picture.PixelSize = view.PixelSize;
  picture.Center[0] = 0.5 * this->Size[0];
  picture.Center[1] = 0.5 * this->Size[1];
  picture.Depths = depths ? depths->GetPointer(0) : nullptr;
  picture.Radiance = arrays[0]->GetPointer(0);
  picture.Transmittance = arrays[1]->GetPointer(0);
  drawer.Draw(parameters, picture);
  result->SetDimensions(this->Size[0], this->Size[1], 1);
  result->GetPointData()->SetScalars(arrays[0]);
  result->GetPointData()->AddArray(arrays[1]);
  return 1;
}
