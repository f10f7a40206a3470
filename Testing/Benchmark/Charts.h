// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Charts with two logarithmic axes, drawn by VTK.

#ifndef Charts_h
#define Charts_h

#include <string>
#include <vector>

struct ChartSeries
{
  std::string Name;
  std::vector<double> X;
  std::vector<double> Y;
  std::vector<std::string> Labels; // one for each point, or none
};

struct Chart
{
  std::string Title;
  std::string XTitle;
  std::string YTitle;
  std::vector<ChartSeries> Series;
};

/**
 * Draw a chart into a PNG file. Points that are not above 0 are left out.
 */
void WriteChart(const Chart& chart, const std::string& file);

#endif
