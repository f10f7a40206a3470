// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysIntegrator.h"

#include "vtkGodRaysOpenGL.h"

#include <algorithm>
#include <cstring>

bool vtkGodRaysIntegrator::UsesProcessor() const
{
  const auto name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const auto names = { "llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SWR",
    "SwiftShader", "GDI Generic" };
  const bool isSoftware = name &&
    std::any_of(names.begin(), names.end(),
      [&](const char* software) { return std::strstr(name, software) != nullptr; });
  return this->Backend == PROCESSOR || (this->Backend == AUTOMATIC && isSoftware);
}

void vtkGodRaysIntegrator::BeginVerification(bool isStill)
{
  this->ErrorEstimate = -1.0;
  this->LargestVerifiedError = -1.0;
  this->VerifiesFrame = false;
  if (this->VerifyPixels <= 0)
  {
    this->StillFrames = 0;
  }
  else if (isStill)
  {
    this->VerifiesFrame = this->StillFrames % this->VerifyInterval == 0;
    this->StillFrames = (this->StillFrames + 1) % this->VerifyInterval;
  }
}

void vtkGodRaysIntegrator::TakeErrors(double rootMeanSquare, double largest)
{
  this->ErrorEstimate = std::max(this->ErrorEstimate, rootMeanSquare);
  this->LargestVerifiedError = std::max(this->LargestVerifiedError, largest);
}

void vtkGodRaysIntegrator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VerifyPixels: " << this->VerifyPixels << "\n";
  os << indent << "VerifyInterval: " << this->VerifyInterval << "\n";
  os << indent << "ErrorEstimate: " << this->ErrorEstimate << "\n";
  os << indent << "LargestVerifiedError: " << this->LargestVerifiedError << "\n";
}
