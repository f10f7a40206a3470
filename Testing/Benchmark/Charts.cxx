// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Charts.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContext2D.h"
#include "vtkContextItem.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkPen.h"
#include "vtkPlotPoints.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace
{
const int Width = 1280;
const int Height = 800;
const int FontSize = 17;

/// Told apart also by the colour-blind: Okabe and Ito's, but for yellow; three more.
const unsigned char Colors[][3] = { { 0, 114, 178 }, { 86, 180, 233 }, { 204, 121, 167 },
  { 90, 90, 90 }, { 213, 94, 0 }, { 0, 158, 115 }, { 230, 159, 0 }, { 110, 60, 20 }, { 90, 0, 140 },
  { 200, 16, 46 } };
const int NumberOfColors = sizeof(Colors) / sizeof(Colors[0]);

const int Markers[] = { vtkPlotPoints::CIRCLE, vtkPlotPoints::SQUARE, vtkPlotPoints::DIAMOND };
const int NumberOfMarkers = sizeof(Markers) / sizeof(Markers[0]);

struct Box
{
  float Left;
  float Low;
  float Right;
  float High;

  bool Overlaps(const Box& other) const
  {
    return this->Left < other.Right && other.Left < this->Right && this->Low < other.High &&
      other.Low < this->High;
  }
};

/// The names of points, beside them, where there is room; off the lines, if there is room for that, too.
class PointLabels : public vtkContextItem
{
public:
  static PointLabels* New();
  vtkTypeMacro(PointLabels, vtkContextItem);

  struct Label
  {
    double X;
    double Y;
    std::string Text;
    int Color;
  };
  std::vector<Label> Labels;
  vtkChartXY* Chart = nullptr;

  bool Paint(vtkContext2D* painter) override
  {
    const auto place = [this](int axis, double value)
    {
      vtkAxis* a = this->Chart->GetAxis(axis);
      const int i = axis == vtkAxis::BOTTOM ? 0 : 1;
      const double t = (value - a->GetMinimum()) / (a->GetMaximum() - a->GetMinimum());
      return static_cast<float>(a->GetPoint1()[i] + t * (a->GetPoint2()[i] - a->GetPoint1()[i]));
    };
    std::vector<Box> taken; // markers first
    for (const Label& label : this->Labels)
    {
      const float x = place(vtkAxis::BOTTOM, label.X);
      const float y = place(vtkAxis::LEFT, label.Y);
      taken.push_back({ x - 6, y - 6, x + 6, y + 6 });
    }
    std::vector<Box> lines; // between neighbours of a series, in pieces
    for (std::size_t i = 1; i < this->Labels.size(); ++i)
    {
      const int pieces = this->Labels[i].Color == this->Labels[i - 1].Color ? 256 : 0;
      for (int k = 0; k < pieces; ++k)
      {
        const auto mix = [&](float a, float b) { return a + (b - a) * (k + 0.5f) / pieces; };
        const float x = mix(taken[i - 1].Left, taken[i].Left) + 6;
        const float y = mix(taken[i - 1].Low, taken[i].Low) + 6;
        lines.push_back({ x - 2, y - 2, x + 2, y + 2 });
      }
    }
    const float left = this->Chart->GetAxis(vtkAxis::LEFT)->GetPoint1()[0];
    painter->GetTextProp()->SetFontSize(FontSize - 3);
    painter->GetTextProp()->SetJustificationToLeft();
    painter->GetTextProp()->SetVerticalJustificationToBottom();
    for (const Label& label : this->Labels)
    {
      if (label.Text.empty())
      {
        continue;
      }
      const float x = place(vtkAxis::BOTTOM, label.X);
      const float y = place(vtkAxis::LEFT, label.Y);
      float bounds[4];
      painter->ComputeStringBounds(label.Text, bounds);
      const float width = bounds[2];
      const float height = bounds[3];
      const float corners[][2] = { { x + 9, y - height / 2 }, { x - 9 - width, y - height / 2 },
        { x - width / 2, y + 9 }, { x - width / 2, y - 9 - height }, { x + 7, y + 7 },
        { x + 7, y - 7 - height }, { x - 7 - width, y + 7 }, { x - 7 - width, y - 7 - height },
        { x + 7, y + 21 }, { x + 7, y - 21 - height } };
      const auto toBox = [&](const float corner[2]) {
        return Box{ corner[0], corner[1], corner[0] + width, corner[1] + height };
      };
      const auto overlaps = [](const Box& box, const std::vector<Box>& others)
      {
        return std::any_of(
          others.begin(), others.end(), [&](const Box& other) { return box.Overlaps(other); });
      };
      const float(*found)[2] = nullptr;
      for (const bool offLines : { true, false })
      {
        for (const auto& corner : corners)
        {
          const Box box = toBox(corner);
          if (!found && !overlaps(box, taken) &&
            !(offLines && (box.Left < left || overlaps(box, lines))))
          {
            found = &corner;
          }
        }
      }
      if (found)
      {
        taken.push_back(toBox(*found));
        const unsigned char* color = Colors[label.Color % NumberOfColors];
        painter->GetTextProp()->SetColor(
          color[0] / 255.0 * 0.8, color[1] / 255.0 * 0.8, color[2] / 255.0 * 0.8);
        painter->DrawString((*found)[0], (*found)[1], label.Text);
      }
    }
    return true;
  }

protected:
  PointLabels() = default;
  ~PointLabels() override = default;
};
vtkStandardNewMacro(PointLabels);

std::string FormatTick(double value)
{
  char text[32];
  if (value < 0.00999 || value > 99999.0)
  {
    std::snprintf(text, sizeof(text), "%.0e", value);
    std::string shorter = text; // 1e-04 to 1e-4
    for (const char* sign : { "e-0", "e+0" })
    {
      const auto zero = shorter.find(sign);
      if (zero != std::string::npos)
      {
        shorter.erase(zero + 2, 1);
      }
    }
    return shorter;
  }
  std::snprintf(text, sizeof(text), "%g", value);
  return text;
}

/// Axes hold logarithms; ticks are labelled by what they are logarithms of.
void SetAxis(vtkAxis* axis, const std::string& title, double lowest, double highest)
{
  const double margin = 0.06 * std::max(0.5, highest - lowest);
  lowest -= margin;
  highest += margin;
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  const bool fine = highest - lowest < 2.5; // decades
  for (int decade = static_cast<int>(std::floor(lowest)); decade <= highest; ++decade)
  {
    for (double digit : { 1.0, 2.0, 5.0 })
    {
      const double position = decade + std::log10(digit);
      if (position >= lowest && position <= highest && (digit == 1.0 || fine))
      {
        positions->InsertNextValue(position);
        labels->InsertNextValue(FormatTick(digit * std::pow(10.0, decade)));
      }
    }
  }
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(lowest, highest);
  axis->SetCustomTickPositions(positions, labels);
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(FontSize + 1);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(FontSize);
  axis->GetGridPen()->SetColor(225, 225, 225);
  axis->GetPen()->SetColor(90, 90, 90);
}
}

//------------------------------------------------------------------------------
void WriteChart(const Chart& chart, const std::string& file)
{
  vtkNew<vtkContextView> view;
  view->GetRenderWindow()->SetOffScreenRendering(true);
  view->GetRenderWindow()->SetMultiSamples(4);
  view->GetRenderWindow()->SetSize(Width, Height);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);

  vtkNew<vtkChartXY> plots;
  view->GetScene()->AddItem(plots);
  vtkNew<PointLabels> names;
  names->Chart = plots;

  double range[2][2];
  std::fill_n(&range[0][0], 4, std::numeric_limits<double>::quiet_NaN());
  int index = 0;
  for (const ChartSeries& series : chart.Series)
  {
    vtkNew<vtkDoubleArray> x;
    vtkNew<vtkDoubleArray> y;
    x->SetName("x");
    y->SetName(series.Name.c_str());
    for (std::size_t i = 0; i < series.X.size(); ++i)
    {
      if (series.X[i] > 0.0 && series.Y[i] > 0.0)
      {
        const double point[2] = { std::log10(series.X[i]), std::log10(series.Y[i]) };
        x->InsertNextValue(point[0]);
        y->InsertNextValue(point[1]);
        for (int axis = 0; axis < 2; ++axis)
        {
          range[axis][0] = std::fmin(range[axis][0], point[axis]);
          range[axis][1] = std::fmax(range[axis][1], point[axis]);
        }
        names->Labels.push_back(
          { point[0], point[1], i < series.Labels.size() ? series.Labels[i] : "", index });
      }
    }
    if (x->GetNumberOfValues() > 0)
    {
      vtkNew<vtkTable> table;
      table->AddColumn(x);
      table->AddColumn(y);
      auto* plot = vtkPlotPoints::SafeDownCast(
        plots->AddPlot(x->GetNumberOfValues() > 1 ? vtkChart::LINE : vtkChart::POINTS));
      plot->SetInputData(table, 0, 1);
      const unsigned char* color = Colors[index % NumberOfColors];
      plot->SetColor(color[0], color[1], color[2], 255);
      plot->SetWidth(2.0f);
      plot->SetMarkerStyle(Markers[index % NumberOfMarkers]);
      plot->SetMarkerSize(11.0f);
    }
    ++index;
  }
  if (std::isnan(range[0][0]))
  {
    return; // nothing was measured
  }

  plots->SetTitle(chart.Title);
  plots->GetTitleProperties()->SetFontSize(FontSize + 5);
  plots->GetTitleProperties()->BoldOff();
  SetAxis(plots->GetAxis(vtkAxis::BOTTOM), chart.XTitle, range[0][0], range[0][1]);
  SetAxis(plots->GetAxis(vtkAxis::LEFT), chart.YTitle, range[1][0], range[1][1]);
  plots->SetShowLegend(true);
  plots->GetLegend()->SetInline(false);
  plots->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  plots->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  plots->GetLegend()->SetLabelSize(FontSize);
  plots->GetLegend()->GetPen()->SetColor(225, 225, 225);

  view->GetRenderWindow()->Render(); // which lays out the axes
  view->GetScene()->AddItem(names);
  view->GetRenderWindow()->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(view->GetRenderWindow());
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  if (!std::filesystem::exists(file))
  {
    throw std::runtime_error(file + " cannot be written");
  }
}
