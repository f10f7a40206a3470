// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysBlockPlan.h"

#include "vtkGodRaysMath.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
// Lights farther than this many layers are brought to it: then shafts deviate from where they should
// be by less than 1e-4 pixels in a layer of 1000.
constexpr double FarthestLight = 1e7;

// Of a wedge, beyond 1: a shader's rounding may find a pixel in the wedge next to its own.
constexpr double SlopeMargin = 1e-5;

constexpr double ShortestBlock = 2.0; // [pixels]

constexpr double LongestMarch = 1e30; // [pixels] no march is longer

// About the row or column of pixels that the light is in, pictures may change from one to the next and
// stay so along all of a line. So lines are closer there: within as many pixels as a line needs to
// move to the side by so many of them, but not more than the largest.
constexpr double StripSpacing = 0.125; // [pixels]
constexpr double StripReach = 8.0;     // [pixels]
constexpr double LargestStrip = 128.0; // [pixels]

// Beyond these kernels, taps are as fast, and exact.
constexpr double SteepestKernel = 30.0;
constexpr double SteepestGrowth = -5.0;

constexpr double MostTaps = 2e8; // of a picture are affordable: 100 a pixel of 1920 x 1080

// On black and white noise from pixel to pixel, with taps h <= 1 pixels apart, the error is at most
// NoiseError h^2/sqrt(pixels that are summed) [of the peak]; measured.
constexpr double NoiseError = 0.1;

// How many times as close its lines are.
int FindStripFactor(double spacing)
{
  return std::max(1, static_cast<int>(std::ceil(spacing / StripSpacing - 1e-6)));
}

// What each attains on black and white noise from pixel to pixel: root mean square error [fraction
// of the peak] times the root of the number of pixels that are summed, or less; measured.
const vtkGodRaysBlockPlan::Effort Efforts[] = {
  { 0.16, 1.0, 1.0, 16.0, 0.125, 2.0, 3e-3 },
  { 0.077, 1.0, 1.0, 16.0, 0.125, 1.0, 3e-3 },
  { 0.050, 0.5, 1.0, 16.0, 0.125, 1.0, 2e-3 },
  { 0.025, 0.5, 2.0, 16.0, 0.125, 1.0, 1e-3 },
  { 0.014, 1.0 / 3.0, 3.0, 8.0, 0.0625, 1.0, 2e-4 },
  { 0.0085, 1.0 / 6.0, 4.0, 8.0, 0.0625, 0.5, 1e-4 },
};

// No wedge has more lines than this.
double CountLines(const vtkGodRaysMarch& march, const vtkGodRaysBlockPlan::Effort& effort)
{
  const auto sizes = std::minmax(march.LayerSize[0], march.LayerSize[1]);
  const double ofStrip = 2.0 * LargestStrip * (FindStripFactor(effort.Spacing) - 1);
  return (2.0 * sizes.second + sizes.first + ofStrip) / effort.Spacing + 256.0;
}

// How many taps for each pixel of a march within the layer keep a tolerance.
double CountTapsPerPixel(const vtkGodRaysMarch& march, double tolerance)
{
  const double size = std::min(march.LayerSize[0], march.LayerSize[1]);
  const double length = 0.5 * std::min(march.GetLongest(), size); // within the layer, about
  const double summed = std::max(1.0, length / std::max(1.0, std::abs(march.K)));
  const double taps = march.GetGrowth() * NoiseError / (tolerance * std::sqrt(summed));
  return std::min(std::max(1.0, std::sqrt(taps)), 16.0);
}

// Returns whether lines through the light keep any tolerance, faster than taps.
bool CanHaveLines(const vtkGodRaysMarch& march)
{
  if (march.IsSmall() || march.GetLongest() < vtkGodRaysMarch::ShortestSweep ||
    march.K > SteepestKernel || march.K < SteepestGrowth)
  {
    return false;
  }
  const double light[2] = { march.Constant[0] / march.Slope, march.Constant[1] / march.Slope };
  const bool inside = light[0] > -1.0 && light[1] > -1.0 && light[0] < march.LayerSize[0] &&
    light[1] < march.LayerSize[1];
  return march.Slope <= 1.0 || !inside; // past a light in the layer there are none
}
}

vtkGodRaysBlockPlan::Effort vtkGodRaysBlockPlan::ChooseEffort(
  const vtkGodRaysMarch& march, double tolerance, int largest)
{
  const double taps = CountTapsPerPixel(march, tolerance);
  const Effort tapsAlone = { 0.0, 0.0, 0.5 * taps, 0.0, 0.0, 1.0, 0.0 };
  if (!CanHaveLines(march))
  {
    return tapsAlone;
  }
  const bool affordable =
    taps * march.GetLengthWithin() * march.PictureSize[0] * march.PictureSize[1] <= MostTaps;
  const double scale = march.GetErrorScale();
  const Effort* most = &tapsAlone;
  for (const Effort& effort : Efforts)
  {
    if (CountLines(march, effort) > largest)
    {
      break;
    }
    if (effort.Error * scale <= tolerance)
    {
      return effort;
    }
    most = &effort;
  }
  return affordable ? tapsAlone : *most;
}

void vtkGodRaysBlockPlan::Table::Upload(vtkOpenGLRenderWindow* window)
{
  if (!this->Texture || this->TextureWidth < this->Width || this->TextureHeight < this->Height)
  {
    this->Release(window);
    this->TextureWidth = std::max(this->TextureWidth, RoundUp(this->Width, 64));
    this->TextureHeight = std::max(this->TextureHeight, RoundUp(this->Height, 64));
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
    this->Texture->SetInternalFormat(GL_RGBA32F);
    this->Texture->SetFormat(GL_RGBA);
    this->Texture->SetDataType(GL_FLOAT);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Texture->Allocate2D(this->TextureWidth, this->TextureHeight, 4, VTK_FLOAT);
  }
  this->Texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(
    GL_TEXTURE_2D, 0, 0, 0, this->Width, this->Height, GL_RGBA, GL_FLOAT, this->Values.data());
  this->Texture->Deactivate();
}

void vtkGodRaysBlockPlan::Table::Release(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}

void vtkGodRaysBlockPlan::Fill()
{
  this->FindLight();
  // Within few blocks there is nothing to gain.
  this->ShortestMarch =
    this->Chosen.HasLines() ? std::max(24.0, 4.0 * std::abs(this->March.K)) : LongestMarch;
  this->StripFactor = FindStripFactor(this->Chosen.Spacing);
  this->Lines = 1;
  this->BlockColumns = 0;
  this->NodeColumns = 0;
  for (int i = 0; i < NumberOfWedges; ++i)
  {
    Wedge& wedge = this->Wedges[i];
    wedge.Axis = i >= 2 ? 0 : 1;
    wedge.Direction = i % 2 ? -1 : 1;
    this->FillWedge(wedge);
    wedge.BlockColumn = this->BlockColumns;
    wedge.NodeColumn = this->NodeColumns;
    if (wedge.Lines > 0)
    {
      // One more of each is 0, should rounding make a filter read it; weights go by fours.
      this->Lines = std::max(this->Lines, wedge.Lines + 1);
      const int fours = RoundUp(wedge.GetBlocks(), 4);
      this->BlockColumns += this->OneChannel ? fours / 4 : fours;
      this->NodeColumns += wedge.GetBlocks() + 2;
    }
  }
  ++this->BlockColumns;
  ++this->NodeColumns;
  this->MakeBlockTable();
  this->MakeNodeTable();
  this->PlaceNearBox(this->MakeRowTable());
}

// The light at the end of all marches, if it is not too far away.
void vtkGodRaysBlockPlan::FindLight()
{
  const int* layer = this->March.LayerSize;
  const double size = std::max(layer[0], layer[1]);
  double center[2];
  double way[2];
  for (int i = 0; i < 2; ++i)
  {
    center[i] = 0.5 * (layer[i] - 1);
    way[i] = this->March.Constant[i] - this->March.Slope * center[i];
  }
  const double length = std::hypot(way[0], way[1]);
  this->Density = this->March.Slope;
  if (std::abs(this->Density) * FarthestLight * size < length)
  {
    this->Density = length / (FarthestLight * size);
  }
  for (int i = 0; i < 2; ++i)
  {
    this->Light[i] = this->Density != 0.0 ? center[i] + way[i] / this->Density : center[i];
  }
}

void vtkGodRaysBlockPlan::FillWedge(Wedge& wedge)
{
  const int axis = wedge.Axis;
  const double light = this->Light[axis];
  const double side = this->Light[1 - axis];
  const bool up = wedge.Direction > 0;
  const double size = this->March.LayerSize[axis];
  const double ends[2] = { this->March.GetPoint(axis, 0),
    this->March.GetPoint(axis, this->March.PictureSize[axis] - 1) };
  wedge.Lines = 0;
  wedge.Nodes.clear();

  // Rows of the picture, and of the layer, which is 0 in rows -1 and size.
  const double first = std::max(0.0, up ? ends[0] - light : light - ends[1]);
  const double last = up ? ends[1] - light : light - ends[0];
  const double entry = up ? -1.0 - light : light - size;
  const double exit = up ? size - light : light + 1.0;
  if (last <= 0.0 || !this->Chosen.HasLines())
  {
    return;
  }
  wedge.Near = std::max(0.0, entry);
  wedge.NearRow = entry > 0.0 ? (up ? -1.0 : size) : light;
  wedge.Far = this->Density > 0.0 ? last : exit;

  // Lines that pass the picture's points.
  const double limit = 1.0 + SlopeMargin;
  const double left = this->March.GetPoint(1 - axis, 0) - side;
  const double right = this->March.GetPoint(1 - axis, this->March.PictureSize[1 - axis] - 1) - side;
  const double nearest = std::max(first, 1e-9);
  const double low = std::max(-limit, std::min(left / nearest, left / last));
  const double high = std::min(limit, std::max(right / nearest, right / last));
  if (low > high)
  {
    return;
  }
  const double spacing = this->Chosen.Spacing;
  wedge.SlopeStep = spacing / last;
  // From a pixel's centre on in the last row, to meet others', too, where lines are parallel.
  const double start = std::floor(side + low * last - 0.5 * spacing);
  wedge.FirstSlope = (start - side) / last;
  wedge.FirstLine = side + wedge.FirstSlope * wedge.Near;
  wedge.Lines = static_cast<int>(std::ceil((high - wedge.FirstSlope) / wedge.SlopeStep)) + 2;
  this->PlaceStrip(wedge, std::max(first, wedge.Near), last);
  wedge.Lines += (this->StripFactor - 1) * (wedge.Strip[1] - wedge.Strip[0]);
  this->MakeNodes(wedge);
}

// About slope 0; nearest and last are the distances of the first and last rows from the light.
void vtkGodRaysBlockPlan::PlaceStrip(Wedge& wedge, double nearest, double last) const
{
  const double spacing = this->Chosen.Spacing;
  const double change = std::max(1.0 - nearest / last, 1e-9);
  const double reach = std::min(StripReach / change, LargestStrip) / spacing;
  const double axis = -wedge.FirstSlope / wedge.SlopeStep;
  const double end = wedge.Lines - 1.0;
  wedge.Strip[0] = static_cast<int>(std::min(std::max(std::floor(axis - reach), 0.0), end));
  wedge.Strip[1] = static_cast<int>(std::min(std::max(std::ceil(axis + reach), 0.0), end));
}

void vtkGodRaysBlockPlan::MakeNodes(Wedge& wedge)
{
  const double ratio = this->Chosen.Ratio / std::max(2.0, std::abs(this->March.K));
  const double end = wedge.Far - wedge.Near;
  double r = 0.0;
  wedge.Nodes.push_back(r);
  while (r < end)
  {
    const double wanted = ratio * std::abs(this->GetMarch(wedge, r));
    const double length = std::max(ShortestBlock, std::min(wanted, this->Chosen.LongestBlock));
    r = r + 1.5 * length > end ? end : r + length;
    wedge.Nodes.push_back(r);
  }
}

void vtkGodRaysBlockPlan::MakeBlockTable()
{
  this->Blocks.Resize(this->BlockColumns, 2);
  for (const Wedge& wedge : this->Wedges)
  {
    for (int b = 0; b < wedge.GetBlocks(); ++b)
    {
      const int column = wedge.BlockColumn + (this->OneChannel ? b / 4 : b);
      const int channel = this->OneChannel ? b % 4 : 0;
      this->Blocks.At(column, 0)[channel] = static_cast<float>(wedge.Nodes[b]);
      this->Blocks.At(column, 1)[channel] = static_cast<float>(wedge.Nodes[b + 1]);
    }
  }
}

void vtkGodRaysBlockPlan::MakeNodeTable()
{
  const int fours = RoundUp(this->GetNodes(), 4) / 4;
  this->Nodes.Resize(this->NodeColumns, 2);
  this->Kernel.Resize(std::max(1, fours), this->NodeColumns);
  for (int column = 0; column < this->NodeColumns; ++column)
  {
    this->Nodes.Set(column, 0, 0.0, -1.0, 0.0, 0.0);
  }
  for (int w = 0; w < NumberOfWedges; ++w)
  {
    const Wedge& wedge = this->Wedges[w];
    const int blocks = wedge.GetBlocks();
    for (int n = 0; wedge.Lines > 0 && n <= blocks; ++n)
    {
      const int column = wedge.NodeColumn + n;
      int first = 0;
      int last = -1;
      this->MakeWeights(wedge, n, column, first, last);
      this->Nodes.Set(column, 0, first, last, column, wedge.BlockColumn);
      this->Nodes.Set(
        column, 1, wedge.Nodes[std::max(0, n - 1)], wedge.Nodes[std::min(blocks, n + 1)], w, 0.0);
    }
  }
}

// The kernel's integral over each block as seen from a node; first and last are the fours of them.
void vtkGodRaysBlockPlan::MakeWeights(const Wedge& wedge, int node, int row, int& first, int& last)
{
  const double r = wedge.Nodes[node];
  const double march = this->GetMarch(wedge, r);
  if (std::abs(march) < 0.5)
  {
    return; // only pixels that are summed by taps are as near
  }
  const double k = this->March.K;
  const double scale = 1.0 / vtkGodRays::MeanExponential(k);
  const int step = this->Density > 0.0 ? -1 : 1;
  int lowest = wedge.GetBlocks();
  int highest = -1;
  double t = 0.0;
  double kernel = 1.0;
  for (int b = step < 0 ? node - 1 : node; b >= 0 && b < wedge.GetBlocks() && t < 1.0; b += step)
  {
    const double end = std::min(1.0, (r - wedge.Nodes[step < 0 ? b : b + 1]) / march);
    const double kernelAtEnd = std::exp(-k * end);
    const double weight = std::abs(k) > 1e-6 ? (kernel - kernelAtEnd) / k : end - t;
    this->Kernel.At(b / 4, row)[b % 4] = static_cast<float>(scale * weight);
    lowest = std::min(lowest, b);
    highest = std::max(highest, b);
    t = end;
    kernel = kernelAtEnd;
  }
  if (highest >= 0)
  {
    first = lowest / 4;
    last = highest / 4;
  }
}

// Returns how far from the light the ends of marches within a block count, along either axis [pixels].
double vtkGodRaysBlockPlan::MakeRowTable()
{
  const int* size = this->March.PictureSize;
  this->Rows.Resize(std::max(size[0], size[1]), 3 * NumberOfWedges);
  double reach = 0.0;
  const double phi = vtkGodRays::MeanExponential(this->March.K);
  for (int w = 0; w < NumberOfWedges; ++w)
  {
    const Wedge& wedge = this->Wedges[w];
    for (int i = 0; wedge.Lines > 0 && i < size[wedge.Axis]; ++i)
    {
      double r = wedge.Direction * (this->March.GetPoint(wedge.Axis, i) - wedge.NearRow);
      const double march = this->GetMarch(wedge, r);
      if (r < 0.0 || r > wedge.Nodes.back() + 1e-3 || std::abs(march) < 0.5)
      {
        continue; // not in the wedge, or summed by taps
      }
      r = std::min(r, wedge.Nodes.back());
      const auto next = std::upper_bound(wedge.Nodes.begin() + 1, wedge.Nodes.end() - 1, r);
      const int block = static_cast<int>(next - wedge.Nodes.begin()) - 1;
      const double begin = wedge.Nodes[block];
      const double f = (r - begin) / (*next - begin);
      const double g = f * this->GetMarch(wedge, *next) / march;
      this->Rows.Set(i, 3 * w, wedge.FirstLine + r * wedge.FirstSlope,
        1.0 / (wedge.SlopeStep * (wedge.Near + r)), wedge.NodeColumn + block + g,
        wedge.Strip[1] - wedge.Strip[0]);
      const double length = f < 0.5 ? r - begin : r - *next;
      this->Rows.Set(
        i, 3 * w + 1, length, length / (march * phi), this->GetMean(wedge, block), 0.0);
      if (this->MakeTail(wedge, r, march, i, 3 * w + 2))
      {
        reach = std::max(reach, wedge.Near + r);
      }
    }
  }
  return reach;
}

// Where the march ends within a block; false if that does not count.
bool vtkGodRaysBlockPlan::MakeTail(const Wedge& wedge, double r, double march, int row, int index)
{
  const double tail = r - march;
  if (tail <= 0.0 || tail >= wedge.Nodes.back())
  {
    return false;
  }
  const auto next = std::upper_bound(wedge.Nodes.begin() + 1, wedge.Nodes.end() - 1, tail);
  const int block = static_cast<int>(next - wedge.Nodes.begin()) - 1;
  const double begin = wedge.Nodes[block];
  const double length = 2.0 * tail < begin + *next ? tail - begin : tail - *next;
  const double k = this->March.K;
  const double factor = -std::exp(-k) / vtkGodRays::MeanExponential(k) * length / march;
  if (std::abs(factor) <= this->Chosen.LeastTail)
  {
    return false;
  }
  this->Rows.Set(row, index, length, factor, this->GetMean(wedge, block), -march);
  return true;
}

// What is drawn by taps, or has ends of marches that count, as far from the light.
void vtkGodRaysBlockPlan::PlaceNearBox(double reach)
{
  // without a density marches are 0, and taps everywhere
  reach = std::max(reach, this->ShortestMarch / std::max(std::abs(this->Density), 1e-30)) + 1.0;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double size = this->March.PictureSize[axis];
    const auto place = [&](double point)
    {
      return std::min(
        std::max((point - this->March.GetPoint(axis, 0)) / this->March.Step[axis], 0.0), size);
    };
    this->NearBox[axis] = static_cast<int>(std::floor(place(this->Light[axis] - reach)));
    this->NearBox[axis + 2] = static_cast<int>(std::ceil(place(this->Light[axis] + reach)));
  }
}
