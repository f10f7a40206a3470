// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysIntegrator.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkGodRaysIntegrator::ForgetErrors()
{
  this->ErrorEstimate = -1.0;
  this->LargestVerifiedError = -1.0;
}

//------------------------------------------------------------------------------
void vtkGodRaysIntegrator::TakeErrors(double rootMeanSquare, double largest)
{
  this->ErrorEstimate = std::max(this->ErrorEstimate, rootMeanSquare);
  this->LargestVerifiedError = std::max(this->LargestVerifiedError, largest);
}

//------------------------------------------------------------------------------
void vtkGodRaysIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VerifyPixels: " << this->VerifyPixels << "\n";
  os << indent << "ErrorEstimate: " << this->ErrorEstimate << "\n";
  os << indent << "LargestVerifiedError: " << this->LargestVerifiedError << "\n";
}
