// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysSunInformation.h"

#include "vtkClientServerStream.h"
#include "vtkGodRaysRenderView.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkGodRaysSunInformation);

vtkGodRaysSunInformation::vtkGodRaysSunInformation()
{
  this->SetRootOnly(1);
}

void vtkGodRaysSunInformation::CopyFromObject(vtkObject* view)
{
  auto own = vtkGodRaysRenderView::SafeDownCast(view);
  if (own)
  {
    own->GetPlacedSun(this->PlacedSun);
  }
}

void vtkGodRaysSunInformation::AddInformation(vtkPVInformation* other)
{
  auto sun = vtkGodRaysSunInformation::SafeDownCast(other);
  if (sun && sun->PlacedSun[2] != 0.0)
  {
    std::copy_n(sun->PlacedSun, 6, this->PlacedSun);
  }
}

void vtkGodRaysSunInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << vtkClientServerStream::InsertArray(this->PlacedSun, 6)
          << vtkClientServerStream::End;
}

void vtkGodRaysSunInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  if (!stream->GetArgument(0, 0, this->PlacedSun, 6))
  {
    vtkErrorMacro("The server did not say where it placed the sun; Place Sun stays on.");
  }
}

void vtkGodRaysSunInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PlacedSun: " << this->PlacedSun[0] << " " << this->PlacedSun[1] << " "
     << this->PlacedSun[2] << "\n";
}
