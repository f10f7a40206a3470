// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What ModelErrors.h measured, and how it is told: tables, the figures that are asked for, a chart, a page.

#ifndef ModelReport_h
#define ModelReport_h

#include "ModelMethods.h"
#include "Report.h"

#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ModelError
{
const char* const GreyName = ", grey"; // of a time in a medium that dims all colours alike

struct Summary
{
  double Squares = 0.0;
  double Worst = 0.0;
  std::string WorstScene;
  int Count = 0;

  void Add(double error, const std::string& scene)
  {
    this->Squares += error * error;
    if (error > this->Worst)
    {
      this->Worst = error;
      this->WorstScene = scene;
    }
    ++this->Count;
  }
  double GetRms() const { return std::sqrt(this->Squares / std::max(this->Count, 1)); }
};

std::string ToText(double number);

/// As root mean square / worst.
std::string ToText(const Summary& summary);

//------------------------------------------------------------------------------
class ModelReport
{
public:
  std::vector<ModelMethod> Methods;
  std::string Renderer; // what OpenGL calls itself
  std::string Command;  // as the page tells it
  int Width = 0;        // of the pictures
  int Height = 0;
  int PixelsOnEdges = 0;                                              // of the picture with most
  std::ostringstream Cases;                                           // rows of ModelError.csv
  std::map<std::pair<std::string, std::string>, Summary> ByLight;     // method, light; g 0.6
  std::map<std::pair<std::string, std::string>, Summary> ByAsymmetry; // method, g; before the light
  std::map<std::pair<std::string, std::string>, Summary> ByMedium;    // method, scattering; g 0.6
  std::map<std::string, Summary> All;
  std::map<std::string, std::vector<double>> Errors; // of all cases, g 0.6
  std::map<std::string, std::vector<double>> Copies; // of what the rays add to a frame, each round
  std::map<std::string, std::vector<double>> Taps;   // of the same with 100 taps

  /// Tables and figures in Markdown.
  std::string MakeTables() const;

  /// ModelError.md with its chart, in a folder that has the pictures.
  void WritePage(const std::string& folder) const;

private:
  std::string MakeErrorTable() const;
  std::string MakeToleranceTable() const;
  std::string MakeMediumTable() const;
  std::vector<Figure> MakeFigures() const;
  Figure MakeCostFigure(const ModelMethod& choice, const std::string& colors) const;
  double GetShareWithin(const std::string& method, double tolerance) const;
  void WriteErrorChart(const std::string& file) const;
};
}

#endif
