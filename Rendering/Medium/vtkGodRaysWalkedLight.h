// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysWalkedLight
 * @brief   a light's rays as vtkGodRaysInScattering computes them, and their way into the sum; private to
 * this module
 */

#ifndef vtkGodRaysWalkedLight_h
#define vtkGodRaysWalkedLight_h

#include "vtkGodRaysInScattering.h"
#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysTarget.h"

#include <string> // For std::string
#include <vector> // For std::vector

class vtkWindow;

class vtkGodRaysWalkedLight
{
public:
  vtkGodRaysInScattering Walk;

  /**
   * Returns the walk's parameters for a layer of this size [pixels] that a pinhole can see; without a shadow
   * map nothing blocks.
   */
  static vtkGodRaysInScattering::Parameters GetParameters(
    const vtkGodRaysMediumIntegrator::Request& request, const int size[2],
    const vtkGodRaysShadowGrids* shadows = nullptr);

  /**
   * Returns whether the last Walk served these parameters and ends of view rays, whose version says whether
   * they are others.
   */
  bool Has(
    const vtkGodRaysInScattering::Parameters& parameters, const int size[2], unsigned int ends);

  /**
   * Computes it, unless it is had already, and adds it to the request's result. Returns false, after an
   * error, if that failed.
   */
  bool Add(const vtkGodRaysMediumIntegrator::Request& request,
    const vtkGodRaysInScattering::Parameters& parameters, const int size[2], unsigned int ends);

  /**
   * Returns what the last Add() did.
   */
  std::string Describe() const { return this->Description + (this->Unchanged ? ", kept" : ""); }

  void Release(vtkWindow* window);

private:
  vtkGodRaysTarget Rays[2];   // of one channel, and of three
  std::vector<double> Walked; // all that the rays depend on
  std::vector<double> Asked;  // here to keep its memory
  std::string Description;
  bool Unchanged = false; // in the last Add()
};

#endif
