// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What godrays_benchmark measures of looks: speed and error of the integrators, and the figures that are
// asked for.

#ifndef Benchmark_h
#define Benchmark_h

#include "Device.h"
#include "GodRaysPictures.h"
#include "Methods.h"
#include "Report.h"
#include "Scattering.h"

#include "vtkGodRaysSweepKernels.h"

#include <regex>
#include <string>
#include <vector>

struct BenchmarkOptions
{
  bool Quick = false;
  bool List = false;
  bool ModelError = false;
  bool DataError = false;
  std::string Filter = ".";
  std::string Methods = ".";
  std::string Instructions = vtkGodRays::GetInstructionSets().front();
  std::string CSV;
  std::string Documentation;
  std::string Command = "build/bin/godrays_benchmark"; // as the page tells it
};

//------------------------------------------------------------------------------
class Benchmark
{
public:
  struct Size
  {
    int Width;
    int Height;
  };

  explicit Benchmark(const BenchmarkOptions& options);

  void MeasureScattering();
  void MeasureEffect();
  void MeasureSamples();
  void MeasurePixels();
  void MeasureThreads();
  void MeasureSteadyFrame();

  /// Whether errors keep their bounds; says where not.
  bool Check() const;

  void Print();

private:
  bool IsWanted(const std::string& name) const
  {
    return std::regex_search(name, std::regex(this->Settings.Filter));
  }
  void JudgeErrorAndCost();
  void WriteFiles();
  void MeasureCase(const GodRaysPictures::Picture& picture, const GodRaysPictures::Mask& mask,
    const GodRaysPictures::Light& light);
  const Method* FindMethod(const std::string& name) const;
  std::vector<const Method*> GetConverged() const;
  Size GetSize() const { return this->Settings.Quick ? Size{ 320, 180 } : Size{ 1920, 1080 }; }
  void AddFigure(const std::string& text, Figure::Relation relation, double bound, double measured,
    const std::string& note = "");

  const BenchmarkOptions& Settings;
  Device OpenGL;
  Scattering Stage;
  std::vector<Method> Methods;
  Report Results;
};

#endif
