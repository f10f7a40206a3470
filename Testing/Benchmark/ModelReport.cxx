// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelReport.h"

#include "Charts.h"
#include "ModelScene.h"
#include "Statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace ModelError
{
namespace
{
const double LeastShare = 0.95; // of the cases that a tolerance must hold for

template <typename Map>
Summary Find(const Map& map, const std::string& a, const std::string& b)
{
  const auto found = map.find({ a, b });
  return found == map.end() ? Summary() : found->second;
}
}

//------------------------------------------------------------------------------
std::string ToText(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), number < 0.1 ? "%.4f" : "%.3f", number);
  return text;
}

//------------------------------------------------------------------------------
std::string ToText(const Summary& summary)
{
  return summary.Count ? ToText(summary.GetRms()) + " / " + ToText(summary.Worst) : "-";
}

//------------------------------------------------------------------------------
std::string ModelReport::MakeErrorTable() const
{
  std::ostringstream text;
  text << "| method | all lights | worst scene";
  for (const NamedLight& light : Lights)
  {
    text << " | " << light.Name;
  }
  text << " | copies, grey | of 100 taps | copies, three colours |\n"
          "|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const ModelMethod& method : this->Methods)
  {
    const Summary& all = this->All.at(method.Name);
    text << "| " << method.Name << " | " << ToText(all) << " | " << all.WorstScene;
    for (const NamedLight& light : Lights)
    {
      text << " | " << ToText(Find(this->ByLight, method.Name, light.Name));
    }
    char times[64];
    std::snprintf(times, sizeof(times), " | %.3g | %.3g | %.3g |\n",
      Statistics::GetMedian(this->Copies.at(method.Name + GreyName)),
      Statistics::GetMedian(this->Taps.at(method.Name + GreyName)),
      Statistics::GetMedian(this->Copies.at(method.Name)));
    text << times;
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::string ModelReport::MakeToleranceTable() const
{
  std::ostringstream text;
  text << "\nThe automatic choice, by tolerance: cases within it, and the error that 95 of 100 "
          "cases keep.\n\n"
          "| tolerance | within | 95 of 100 | all lights | copies, grey | three colours |\n"
          "|---|---|---|---|---|---|\n";
  for (const ModelMethod& method : this->Methods)
  {
    if (!method.IsAutomatic())
    {
      continue;
    }
    std::vector<double> errors = this->Errors.at(method.Name);
    std::sort(errors.begin(), errors.end());
    const double within = this->GetShareWithin(method.Name, method.Tolerance);
    char row[160];
    std::snprintf(row, sizeof(row), "| 1/%.0f | %d of %d | %.4f | %s | %.3g | %.3g |\n",
      1.0 / method.Tolerance, static_cast<int>(std::lround(within * errors.size())),
      static_cast<int>(errors.size()), errors[(errors.size() - 1) * 95 / 100],
      ToText(this->All.at(method.Name)).c_str(),
      Statistics::GetMedian(this->Copies.at(method.Name + GreyName)),
      Statistics::GetMedian(this->Copies.at(method.Name)));
    text << row;
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::string ModelReport::MakeMediumTable() const
{
  std::ostringstream text;
  text << "\n| method | scattering 0.02 | 0.1 | 0.3 | g 0, front | g 0.6, front | g 0.85, front |\n"
          "|---|---|---|---|---|---|---|\n";
  for (const ModelMethod& method : this->Methods)
  {
    text << "| " << method.Name;
    for (const char* medium : { "0", "1", "2" })
    {
      text << " | " << ToText(Find(this->ByMedium, method.Name, medium));
    }
    for (const double asymmetry : { 0.0, 0.6, 0.85 })
    {
      text << " | " << ToText(Find(this->ByAsymmetry, method.Name, std::to_string(asymmetry)));
    }
    text << " |\n";
  }
  return text.str();
}

//------------------------------------------------------------------------------
// Of the cases, those whose error a tolerance allows.
double ModelReport::GetShareWithin(const std::string& method, double tolerance) const
{
  const std::vector<double>& errors = this->Errors.at(method);
  const auto within =
    std::count_if(errors.begin(), errors.end(), [&](double error) { return error <= tolerance; });
  return static_cast<double>(within) / errors.size();
}

//------------------------------------------------------------------------------
// What the choice costs against the cheapest other method that keeps its tolerance; the ratio is taken in
// each round. The choice at another tolerance is no other method. One that drew fewer cases does not count.
Figure ModelReport::MakeCostFigure(const ModelMethod& choice, const std::string& colors) const
{
  const auto getCost = [&](const ModelMethod& method)
  { return Statistics::GetMedian(this->Copies.at(method.Name + colors)); };
  const std::size_t cases = this->Errors.at(choice.Name).size();
  bool hasOthers = false;
  const ModelMethod* cheapest = nullptr;
  for (const ModelMethod& method : this->Methods)
  {
    if (!method.IsAutomatic() && this->Errors.at(method.Name).size() == cases)
    {
      hasOthers = true;
      if (this->GetShareWithin(method.Name, choice.Tolerance) >= LeastShare &&
        (!cheapest || getCost(method) < getCost(*cheapest)))
      {
        cheapest = &method;
      }
    }
  }
  Figure figure;
  figure.Text = choice.Name + (colors.empty() ? ", three colours" : colors) +
    ": its cost over that of the cheapest method that keeps the tolerance";
  figure.Bound = 1.3;
  if (cheapest)
  {
    figure.Note = cheapest->Name;
    figure.Measured = Statistics::GetMedian(Statistics::Divide(
      this->Copies.at(choice.Name + colors), this->Copies.at(cheapest->Name + colors)));
  }
  else if (hasOthers)
  {
    figure.Note = "no other one does";
  }
  return figure;
}

//------------------------------------------------------------------------------
std::vector<Figure> ModelReport::MakeFigures() const
{
  std::vector<Figure> figures;
  const auto addBest = [&](const std::string& text, double bound, double measured)
  {
    Figure figure;
    figure.Text = BestModel + text;
    figure.Bound = bound;
    figure.Measured = measured;
    figures.push_back(figure);
  };
  addBest(": RMSE of all cases", 0.0015, this->All.at(BestModel).GetRms());
  addBest(": RMSE of the worst case", 0.007, this->All.at(BestModel).Worst);
  const auto front = this->ByLight.find({ BestModel, GodRaysMediumScenes::Lights[0].Name });
  addBest(": RMSE of all cases before the light", 0.003,
    front == this->ByLight.end() ? Statistics::None : front->second.GetRms());
  addBest(", grey: what the rays add to a frame [copies]", 9.0,
    Statistics::GetMedian(this->Copies.at(BestModel + std::string(GreyName))));
  addBest(", three colours: what the rays add to a frame [copies]", 14.0,
    Statistics::GetMedian(this->Copies.at(BestModel)));
  for (const ModelMethod& method : this->Methods)
  {
    // from 1/32 to 1/512
    if (method.IsAutomatic() && method.Tolerance < 0.04 && method.Tolerance > 0.0015)
    {
      Figure within;
      within.Text = method.Name + ": cases within the tolerance [%]";
      within.Relates = Figure::AT_LEAST;
      within.Bound = 100.0 * LeastShare;
      within.Measured = 100.0 * this->GetShareWithin(method.Name, method.Tolerance);
      figures.push_back(within);
      figures.push_back(this->MakeCostFigure(method, GreyName));
      figures.push_back(this->MakeCostFigure(method, ""));
    }
  }
  return figures;
}

//------------------------------------------------------------------------------
std::string ModelReport::MakeTables() const
{
  return this->MakeErrorTable() + this->MakeToleranceTable() +
    "\nThe defaults are asked to keep their tolerance in 95 of 100 cases, and to cost at most 1.3 "
    "times the cheapest\nother method of the table that keeps it, which is named. Ratios are taken "
    "in each round; the table has medians.\n\n" +
    MakeFigureTable(this->MakeFigures()) + this->MakeMediumTable();
}

//------------------------------------------------------------------------------
void ModelReport::WriteErrorChart(const std::string& file) const
{
  Chart chart;
  chart.Title = "Model error against cost, 1920 x 1080";
  chart.XTitle = "what the rays add to a frame (full-screen copies)";
  chart.YTitle = "RMSE against single scattering (fraction of the peak)";
  for (const ModelMethod& method : this->Methods)
  {
    if (chart.Series.empty() || chart.Series.back().Name != method.Series)
    {
      chart.Series.push_back({ method.Series, {}, {}, {} });
    }
    chart.Series.back().X.push_back(Statistics::GetMedian(this->Copies.at(method.Name + GreyName)));
    chart.Series.back().Y.push_back(this->All.at(method.Name).GetRms());
    chart.Series.back().Labels.push_back(method.Name);
  }
  WriteChart(chart, file);
}

//------------------------------------------------------------------------------
void ModelReport::WritePage(const std::string& folder) const
{
  std::filesystem::create_directories(folder + "/Charts");
  this->WriteErrorChart(folder + "/Charts/model-error.png");
  std::ofstream page(folder + "/ModelError.md");
  page << "# Model error\n\nWritten by `" << this->Command
       << "`.\n\n"
          "How far pictures are from single scattering, and what they cost. The truth is "
          "`vtkGodRaysSingleScatteringReference`.\n"
          "\n"
          "Errors are root mean squares over a picture of "
       << this->Width << " x " << this->Height
       << " pixels, as fractions of its peak. Tables show *root mean\n"
          "square / worst* of the cases. The cases are twelve scenes with three media: scattering "
          "coefficients of 0.02, 0.1 and 0.3\n"
          "to a far limit of 20 (optical depths 0.4, 2 and 6), no absorption, Henyey-Greenstein "
          "with g 0.6 unless another is named.\n"
          "The radial sum has no scale of its own, so it is multiplied by the factor that makes "
          "its error least.\n"
          "\n"
          "The cost is the time that rays add to a frame of the scene *city* at 1920 x 1080, in "
          "full-screen copies: in a grey medium,\n"
          "the same as a fraction of the radial sum with 100 taps, and in a medium of three "
          "colours; medians of five rounds. OpenGL:\n"
       << this->Renderer
       << ".\n"
          "\n"
          "Where an edge is within 1/256 of a pixel from its centre, in up to "
       << this->PixelsOnEdges
       << " pixels of a picture, the nearer truth counts.\n"
          "The remaining errors of shadow maps are at edges narrower than a pixel or a texel of "
          "the map.\n"
          "\n"
          "- *shadow map, walked*: the number and size of nested maps; *in shaders* walks every "
          "pixel's ray, at any tolerance.\n"
          "- *automatic*: the default of the library, by tolerance.\n"
          "- *closed form*: light without any shadow.\n"
          "- *froxels*: a grid of view cells as in games, written for this comparison in plain "
          "double precision, on the processor.\n"
          "  Each cell has one look-up in the library's shadow map of 1024 x 1024, which is kept. "
          "Pixels are interpolated.\n"
          "- *epipolar lines, min/max trees*: 1-D min/max mipmaps [Chen2011], written for this "
          "comparison: lines that meet the\n"
          "  picture's border two pixels apart, each with a tree of the same map's least and "
          "greatest heights.\n"
          "\n"
          "![Model error against cost](Charts/model-error.png)\n"
          "\n"
       << this->MakeTables() << "\n## Pictures\n\n"
       << "The truth, the radial sum, " << BestModel
       << ", and four times the differences of both from the truth; the light is in front, the "
          "coefficient 0.1.\n\n";
  for (const Scene& scene : MakeMediumScenes(4))
  {
    std::string name = scene.Name;
    std::replace(name.begin(), name.end(), ' ', '-');
    if (std::filesystem::exists(folder + "/Pictures/model-error-" + name + ".png"))
    {
      page << "**" << scene.Name << "**\n\n![" << scene.Name << "](Pictures/model-error-" << name
           << ".png)\n\n";
    }
  }
  page << "## Every case\n\n[ModelError.csv](ModelError.csv) has the errors of each case.\n";
  std::ofstream cases(folder + "/ModelError.csv");
  cases << "scene,light,g,method,root mean square,worst\n" << this->Cases.str();
  cases.close();
  page.close();
  SealPage(folder + "/ModelError.md");
}
}
