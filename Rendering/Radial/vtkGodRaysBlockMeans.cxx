// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysBlockMeans.h"

#include "vtkGodRaysBlockInterpolateFS.h"
#include "vtkGodRaysBlockMeansFS.h"
#include "vtkGodRaysBlockSumFS.h"
#include "vtkGodRaysClippedTaps.h"
#include "vtkGodRaysMarch.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysQuad.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysTarget.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <vector>

namespace
{
// Below these, taps are as fast, and exact.
constexpr double ShortestMarch = 8.0; // [pixels]
constexpr int SmallestLayer = 32;     // [pixels]
constexpr double MostTaps = 2e8;      // of a picture, that are affordable
constexpr double SteepestKernel = 30.0;
constexpr double SteepestGrowth = -5.0;

// Lights farther than this many layers are brought to it: then shafts deviate from where they should
// be by less than 1e-4 pixels in a layer of 1000.
constexpr double FarthestLight = 1e7;

// Of a wedge, beyond 1: a shader's rounding may find a pixel in the wedge next to its own.
constexpr double SlopeMargin = 4e-6;

constexpr double ShortestBlock = 2.0; // [pixels]
constexpr int NumberOfWedges = 4;
constexpr std::size_t LeastPlans = 8; // that are kept, or one for each light of a frame

//------------------------------------------------------------------------------
// What accuracy takes.
struct Effort
{
  double Error;         // see ChooseEffort()
  double Spacing;       // of lines where they are farthest apart [pixels]
  double TapsPerPixel;  // of blocks' means [1/pixel]
  double LongestBlock;  // [pixels]
  double Ratio;         // of a block's length to that of the march, times k
  double BumpTapLength; // [pixels]
  double LeastTail; // smaller ends of marches within a block are left out [fraction of the peak]
  bool operator==(const Effort& other) const { return this->Error == other.Error; }
};

// What each attains on black and white noise from pixel to pixel: root mean square error [fraction
// of the peak] times the root of the number of pixels that are summed, or less; measured.
const Effort Efforts[] = {
  { 0.16, 1.0, 1.0, 16.0, 0.125, 2.0, 2e-3 },
  { 0.077, 1.0, 1.0, 16.0, 0.0625, 1.0, 1e-3 },
  { 0.040, 0.5, 2.0, 16.0, 0.0625, 1.0, 1e-3 },
  { 0.020, 0.5, 2.0, 8.0, 0.0625, 1.0, 5e-4 },
  { 0.014, 1.0 / 3.0, 3.0, 8.0, 0.0625, 1.0, 2e-4 },
  { 0.0085, 1.0 / 6.0, 4.0, 8.0, 0.0625, 0.5, 1e-4 },
};

//------------------------------------------------------------------------------
// No wedge has more lines than this.
double CountLines(const vtkGodRaysMarch& march, const Effort& effort)
{
  const auto sizes = std::minmax(march.LayerSize[0], march.LayerSize[1]);
  return (2.0 * sizes.second + sizes.first) / effort.Spacing + 256.0;
}

//------------------------------------------------------------------------------
// The least effort that keeps the tolerance, or else, kept being false, the greatest whose lines fit
// into a texture.
const Effort* ChooseEffort(
  const vtkGodRaysMarch& march, const vtkGodRaysRadialIntegrator::Request& request, bool& kept)
{
  const int largest = vtkTextureObject::GetMaximumTextureSize(request.Window);
  const Effort* chosen = Efforts;
  // A kernel that grows gives the far end of the march more weight, where errors are as large.
  const double growth = std::exp(0.5 * std::min(std::max(-march.K, 0.0), 5.0));
  const double scale = growth * march.GetParallelism() / std::sqrt(march.GetSummedPixels());
  for (const Effort& effort : Efforts)
  {
    if (CountLines(march, effort) > largest)
    {
      break;
    }
    chosen = &effort;
    kept = effort.Error * scale <= request.ErrorTolerance;
    if (kept)
    {
      break;
    }
  }
  return chosen;
}

//------------------------------------------------------------------------------
int RoundUp(int value, int multiple)
{
  return (value + multiple - 1) / multiple * multiple;
}

//------------------------------------------------------------------------------
// Four floats a texel.
struct Table
{
  std::vector<float> Values;
  int Width = 0;
  int Height = 0;

  void Resize(int width, int height)
  {
    this->Width = width;
    this->Height = height;
    this->Values.assign(std::size_t(4) * width * height, 0.0f);
  }
  void Set(int x, int y, double a, double b, double c, double d)
  {
    float* texel = this->At(x, y);
    texel[0] = static_cast<float>(a);
    texel[1] = static_cast<float>(b);
    texel[2] = static_cast<float>(c);
    texel[3] = static_cast<float>(d);
  }
  float* At(int x, int y)
  {
    return this->Values.data() + 4 * (static_cast<std::size_t>(y) * this->Width + x);
  }

  // A texture that is at least as large, with the table in its corner.
  void Upload(vtkOpenGLRenderWindow* window)
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

  void Release(vtkWindow* window)
  {
    if (this->Texture)
    {
      this->Texture->ReleaseGraphicsResources(window);
      this->Texture = nullptr;
    }
  }

  vtkSmartPointer<vtkTextureObject> Texture;
  int TextureWidth = 0;
  int TextureHeight = 0;
};

//------------------------------------------------------------------------------
struct Wedge
{
  int Axis = 1;      // along which rows follow one another
  int Direction = 1; // of s
  double Near = 0.0; // distance s of the nearest row from the light, and of the last node
  double Far = 0.0;
  double NearRow = 0.0;   // where that is [pixels]
  double FirstLine = 0.0; // column of the first line in the nearest row
  double FirstSlope = 0.0;
  double SlopeStep = 0.0;
  int Lines = 0;             // 0: there is no picture in it
  std::vector<double> Nodes; // from the nearest row [pixels]
  int NodeColumn = 0;
  int BlockColumn = 0;

  int GetBlocks() const { return this->Lines ? static_cast<int>(this->Nodes.size()) - 1 : 0; }
};

//------------------------------------------------------------------------------
// All that can be decided without the layer.
struct Plan
{
  vtkGodRaysMarch March;
  const Effort* Chosen;
  bool OneChannel;
  double Light[2] = { 0.0, 0.0 }; // as used [pixels of the layer]
  double Density = 0.0;
  std::array<Wedge, NumberOfWedges> Wedges;
  int Lines = 0; // as textures must hold
  int BlockColumns = 0;
  int NodeColumns = 0;
  bool HasTail = false;
  double ShortestMarch = 0.0; // shorter ones are summed by taps
  Table Blocks;               // textures of the shaders
  Table Nodes;
  Table Kernel;
  Table Rows;

  Plan(const vtkGodRaysMarch& march, const Effort* effort, bool oneChannel)
    : March(march)
    , Chosen(effort)
    , OneChannel(oneChannel)
  {
    this->Fill();
  }
  bool Is(const vtkGodRaysMarch& march, const Effort* effort, bool oneChannel) const
  {
    return this->March == march && this->Chosen == effort && this->OneChannel == oneChannel;
  }

  // To be used for something else: what is on the graphics card is used again.
  void Change(const vtkGodRaysMarch& march, const Effort* effort, bool oneChannel)
  {
    this->March = march;
    this->Chosen = effort;
    this->OneChannel = oneChannel;
    this->Fill();
  }

  void Upload(vtkOpenGLRenderWindow* window)
  {
    for (Table* table : { &this->Blocks, &this->Nodes, &this->Kernel, &this->Rows })
    {
      table->Upload(window);
    }
  }

  void Release(vtkWindow* window)
  {
    for (Table* table : { &this->Blocks, &this->Nodes, &this->Kernel, &this->Rows })
    {
      table->Release(window);
    }
  }

  int GetNodes() const
  {
    int count = 0;
    for (const Wedge& wedge : this->Wedges)
    {
      count = std::max(count, wedge.GetBlocks() + 1);
    }
    return count;
  }

private:
  void Fill();
  void FindLight();
  void FillWedge(Wedge& wedge);
  void MakeNodes(Wedge& wedge);
  void MakeBlockTable();
  void MakeNodeTable();
  void MakeWeights(const Wedge& wedge, int node, int row, int& first, int& last);
  void MakeRowTable();
  void MakeTail(const Wedge& wedge, double r, double march, int row, int index);
  double GetMarch(const Wedge& wedge, double r) const { return this->Density * (wedge.Near + r); }
};

//------------------------------------------------------------------------------
void Plan::Fill()
{
  this->FindLight();
  // Within few blocks there is nothing to gain.
  this->ShortestMarch = std::max(24.0, 4.0 * std::abs(this->March.K));
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
  this->MakeRowTable();
}

//------------------------------------------------------------------------------
// The light at the end of all marches, if it is not too far away.
void Plan::FindLight()
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

//------------------------------------------------------------------------------
void Plan::FillWedge(Wedge& wedge)
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
  if (last <= 0.0)
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
  const double spacing = this->Chosen->Spacing;
  wedge.SlopeStep = spacing / last;
  // From a pixel's centre on in the last row, to meet others', too, where lines are parallel.
  const double start = std::floor(side + low * last - 0.5 * spacing);
  wedge.FirstSlope = (start - side) / last;
  wedge.FirstLine = side + wedge.FirstSlope * wedge.Near;
  wedge.Lines = static_cast<int>(std::ceil((high - wedge.FirstSlope) / wedge.SlopeStep)) + 2;
  this->MakeNodes(wedge);
}

//------------------------------------------------------------------------------
void Plan::MakeNodes(Wedge& wedge)
{
  const double ratio = this->Chosen->Ratio / std::max(2.0, std::abs(this->March.K));
  const double end = wedge.Far - wedge.Near;
  double r = 0.0;
  wedge.Nodes.push_back(r);
  while (r < end)
  {
    const double wanted = ratio * std::abs(this->GetMarch(wedge, r));
    const double length = std::max(ShortestBlock, std::min(wanted, this->Chosen->LongestBlock));
    r = r + 1.5 * length > end ? end : r + length;
    wedge.Nodes.push_back(r);
  }
}

//------------------------------------------------------------------------------
void Plan::MakeBlockTable()
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

//------------------------------------------------------------------------------
void Plan::MakeNodeTable()
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

//------------------------------------------------------------------------------
// The kernel's integral over each block as seen from a node; first and last are the fours of them.
void Plan::MakeWeights(const Wedge& wedge, int node, int row, int& first, int& last)
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

//------------------------------------------------------------------------------
void Plan::MakeRowTable()
{
  const int* size = this->March.PictureSize;
  this->Rows.Resize(std::max(size[0], size[1]), 3 * NumberOfWedges);
  this->HasTail = false;
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
        1.0 / (wedge.SlopeStep * (wedge.Near + r)), wedge.NodeColumn + block + g, 0.0);
      const double length = f < 0.5 ? r - begin : r - *next;
      this->Rows.Set(i, 3 * w + 1, length, length / (march * phi), block, 0.0);
      this->MakeTail(wedge, r, march, i, 3 * w + 2);
    }
  }
}

//------------------------------------------------------------------------------
// Where the march ends within a block.
void Plan::MakeTail(const Wedge& wedge, double r, double march, int row, int index)
{
  const double tail = r - march;
  if (tail <= 0.0 || tail >= wedge.Nodes.back())
  {
    return;
  }
  const auto next = std::upper_bound(wedge.Nodes.begin() + 1, wedge.Nodes.end() - 1, tail);
  const int block = static_cast<int>(next - wedge.Nodes.begin()) - 1;
  const double begin = wedge.Nodes[block];
  const double length = 2.0 * tail < begin + *next ? tail - begin : tail - *next;
  const double k = this->March.K;
  const double factor = -std::exp(-k) / vtkGodRays::MeanExponential(k) * length / march;
  if (std::abs(factor) > this->Chosen->LeastTail)
  {
    this->Rows.Set(row, index, length, factor, block, -march);
    this->HasTail = true;
  }
}

//------------------------------------------------------------------------------
void SetVector(vtkShaderProgram* program, const char* name, double x, double y)
{
  const float values[2] = { static_cast<float>(x), static_cast<float>(y) };
  program->SetUniform2f(name, values);
}

//------------------------------------------------------------------------------
void SetWedges(vtkShaderProgram* program, const Plan& plan)
{
  float lines[NumberOfWedges][4];
  float rows[NumberOfWedges][4];
  for (int i = 0; i < NumberOfWedges; ++i)
  {
    const Wedge& wedge = plan.Wedges[i];
    lines[i][0] = static_cast<float>(wedge.FirstLine);
    lines[i][1] = static_cast<float>(wedge.SlopeStep * wedge.Near);
    lines[i][2] = static_cast<float>(wedge.FirstSlope);
    lines[i][3] = static_cast<float>(wedge.SlopeStep);
    rows[i][0] = static_cast<float>(wedge.NearRow);
    rows[i][1] = static_cast<float>(wedge.Direction);
    rows[i][2] = wedge.Axis == 0 ? 1.0f : 0.0f;
    rows[i][3] = static_cast<float>(wedge.Lines);
  }
  program->SetUniform4fv("wedgeLines", NumberOfWedges, lines);
  program->SetUniform4fv("wedgeRows", NumberOfWedges, rows);
  SetVector(program, "layerSize", plan.March.LayerSize[0], plan.March.LayerSize[1]);
}

//------------------------------------------------------------------------------
// The first column of each wedge's blocks.
void SetColumns(vtkShaderProgram* program, const Plan& plan)
{
  float columns[4];
  for (int i = 0; i < NumberOfWedges; ++i)
  {
    columns[i] = static_cast<float>(plan.Wedges[i].BlockColumn);
  }
  program->SetUniform4f("wedgeColumns", columns);
}
}

//------------------------------------------------------------------------------
struct vtkGodRaysBlockMeans::Internals
{
  vtkGodRaysQuad MeansQuad{ "vtkGodRaysBlockMeansFS", vtkGodRaysBlockMeansFS };
  vtkGodRaysQuad SumQuad{ "vtkGodRaysBlockSumFS", vtkGodRaysBlockSumFS };
  vtkGodRaysQuad InterpolateQuad{ "vtkGodRaysBlockInterpolateFS", vtkGodRaysBlockInterpolateFS };
  vtkGodRaysTarget Means[2]; // of one channel, of three
  vtkGodRaysTarget Sums[2];
  std::vector<std::unique_ptr<Plan>> Plans; // the one that was used last comes last
  std::size_t Lights = 0;                   // of this frame, up to now
  std::size_t FormerLights = 0;             // of the frame before

  Plan* Prepare(const vtkGodRaysRadialIntegrator::Request& request);
  bool Bind(vtkOpenGLRenderWindow* window, vtkGodRaysTarget& target, int width, int height,
    unsigned int format);
  bool DrawMeans(const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan);
  bool DrawSums(const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan);
  bool DrawPicture(const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan);
};

//------------------------------------------------------------------------------
Plan* vtkGodRaysBlockMeans::Internals::Prepare(const vtkGodRaysRadialIntegrator::Request& request)
{
  if (request.Result->IsEmpty()) // the first light of a frame
  {
    this->FormerLights = this->Lights;
    this->Lights = 0;
  }
  ++this->Lights;
  const vtkGodRaysMarch march(request);
  bool kept = false;
  const Effort* effort = ChooseEffort(march, request, kept);
  const bool oneChannel = request.Layer->HasOneChannel();
  const auto found = std::find_if(this->Plans.begin(), this->Plans.end(),
    [&](const auto& plan) { return plan->Is(march, effort, oneChannel); });
  if (found != this->Plans.end())
  {
    std::rotate(found, found + 1, this->Plans.end());
    return this->Plans.back().get();
  }
  if (this->Plans.size() < std::max({ LeastPlans, this->Lights, this->FormerLights }))
  {
    this->Plans.push_back(std::make_unique<Plan>(march, effort, oneChannel));
  }
  else
  {
    std::rotate(this->Plans.begin(), this->Plans.begin() + 1, this->Plans.end());
    this->Plans.back()->Change(march, effort, oneChannel);
  }
  this->Plans.back()->Upload(request.Window);
  return this->Plans.back().get();
}

//------------------------------------------------------------------------------
// Draw into the lower left part of a target that is at least as large.
bool vtkGodRaysBlockMeans::Internals::Bind(vtkOpenGLRenderWindow* window, vtkGodRaysTarget& target,
  int width, int height, unsigned int format)
{
  const bool same = target.IsReady() && target.GetColorFormat() == format;
  if (!same || target.GetWidth() < width || target.GetHeight() < height)
  {
    target.Prepare(window, std::max(target.GetWidth(), RoundUp(width, 32)),
      std::max(target.GetHeight(), RoundUp(height, 256)), { format, 0 });
  }
  window->GetState()->vtkglDisable(GL_BLEND);
  if (!target.Bind())
  {
    return false;
  }
  window->GetState()->vtkglViewport(0, 0, width, height);
  return true;
}

//------------------------------------------------------------------------------
bool vtkGodRaysBlockMeans::Internals::DrawMeans(
  const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan)
{
  vtkShaderProgram* program = this->Bind(request.Window, this->Means[plan.OneChannel ? 0 : 1],
                                plan.BlockColumns, plan.Lines, GL_RGBA32F)
    ? this->MeansQuad.Begin(request.Window, { { "OneChannel", plan.OneChannel } })
    : nullptr;
  if (!program)
  {
    return false;
  }
  SetWedges(program, plan);
  SetColumns(program, plan);
  SetVector(program, "size", plan.BlockColumns, plan.Lines);
  program->SetUniformf("tapsPerPixel", static_cast<float>(plan.Chosen->TapsPerPixel));
  this->MeansQuad.SetTexture("layer", request.Layer->GetColor());
  this->MeansQuad.SetTexture("blocks", plan.Blocks.Texture);
  this->MeansQuad.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkGodRaysBlockMeans::Internals::DrawSums(
  const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan)
{
  const int index = plan.OneChannel ? 0 : 1;
  const unsigned int format = plan.OneChannel ? GL_R32F : GL_RGBA32F;
  vtkShaderProgram* program =
    this->Bind(request.Window, this->Sums[index], plan.NodeColumns, plan.Lines, format)
    ? this->SumQuad.Begin(request.Window, { { "OneChannel", plan.OneChannel } })
    : nullptr;
  if (!program)
  {
    return false;
  }
  SetWedges(program, plan);
  SetVector(program, "size", plan.NodeColumns, plan.Lines);
  this->SumQuad.SetTexture("means", this->Means[index].GetColor());
  this->SumQuad.SetTexture("nodes", plan.Nodes.Texture);
  this->SumQuad.SetTexture("kernel", plan.Kernel.Texture);
  this->SumQuad.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkGodRaysBlockMeans::Internals::DrawPicture(
  const vtkGodRaysRadialIntegrator::Request& request, const Plan& plan)
{
  const int index = plan.OneChannel ? 0 : 1;
  vtkShaderProgram* program = request.Result->BindToAdd()
    ? this->InterpolateQuad.Begin(request.Window, { { "OneChannel", plan.OneChannel } })
    : nullptr;
  if (!program)
  {
    return false;
  }
  const vtkGodRaysMarch& march = plan.March;
  SetWedges(program, plan);
  SetColumns(program, plan);
  SetVector(program, "size", march.PictureSize[0], march.PictureSize[1]);
  SetVector(program, "origin", march.Origin[0], march.Origin[1]);
  SetVector(program, "pixel", march.Step[0], march.Step[1]);
  SetVector(program, "marchConstant", plan.Density * plan.Light[0], plan.Density * plan.Light[1]);
  const vtkGodRaysTarget& sums = this->Sums[index];
  const vtkGodRaysTarget& means = this->Means[index];
  SetVector(program, "sumsSize", sums.GetWidth(), sums.GetHeight());
  SetVector(program, "meansSize", means.GetWidth(), means.GetHeight());
  const auto set = [program](const char* name, double value)
  { program->SetUniformf(name, static_cast<float>(value)); };
  set("marchSlope", plan.Density);
  set("k", march.K);
  set("shortest", plan.ShortestMarch);
  set("tapsPerPixel", 2.0 * plan.Chosen->TapsPerPixel);
  set("bumpTapLength", plan.Chosen->BumpTapLength);
  program->SetUniformi("hasTail", plan.HasTail);
  float gain[3];
  for (int c = 0; c < 3; ++c)
  {
    gain[c] = static_cast<float>(march.Gain * (plan.OneChannel ? request.Color[c] : 1.0));
  }
  program->SetUniform3f("gain", gain);
  this->InterpolateQuad.SetTexture("layer", request.Layer->GetColor());
  this->InterpolateQuad.SetTexture("means", means.GetColor());
  this->InterpolateQuad.SetTexture("sums", sums.GetColor());
  this->InterpolateQuad.SetTexture("rows", plan.Rows.Texture);
  this->InterpolateQuad.End();
  return true;
}

//------------------------------------------------------------------------------
vtkGodRaysBlockMeans::vtkGodRaysBlockMeans()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkGodRaysBlockMeans::~vtkGodRaysBlockMeans() = default;

//------------------------------------------------------------------------------
bool vtkGodRaysBlockMeans::Keeps(const vtkGodRaysRadialIntegrator::Request& request)
{
  const vtkGodRaysMarch march(request);
  const int size = std::min(march.LayerSize[0], march.LayerSize[1]);
  bool kept = false;
  const Effort* effort = ChooseEffort(march, request, kept);
  if ((!kept && vtkGodRaysClippedTaps::CountTaps(request) <= MostTaps) || size < SmallestLayer ||
    march.GetLongest() < ShortestMarch || march.K > SteepestKernel || march.K < SteepestGrowth)
  {
    return false;
  }
  const double light[2] = { march.Constant[0] / march.Slope, march.Constant[1] / march.Slope };
  const bool inside = light[0] > -1.0 && light[1] > -1.0 && light[0] < march.LayerSize[0] &&
    light[1] < march.LayerSize[1];
  if (march.Slope > 1.0 && inside)
  {
    return false;
  }
  return CountLines(march, *effort) <= vtkTextureObject::GetMaximumTextureSize(request.Window);
}

//------------------------------------------------------------------------------
bool vtkGodRaysBlockMeans::Integrate(const vtkGodRaysRadialIntegrator::Request& request)
{
  Internals& self = *this->Internal;
  vtkTextureObject* layer = request.Layer->GetColor();
  layer->SetWrapS(vtkTextureObject::ClampToBorder);
  layer->SetWrapT(vtkTextureObject::ClampToBorder);
  const Plan* plan = self.Prepare(request);
  return self.DrawMeans(request, *plan) && self.DrawSums(request, *plan) &&
    self.DrawPicture(request, *plan);
}

//------------------------------------------------------------------------------
std::string vtkGodRaysBlockMeans::Describe() const
{
  if (this->Internal->Plans.empty())
  {
    return "block means: nothing has been computed";
  }
  const Plan& plan = *this->Internal->Plans.back();
  int lines = 0;
  for (const Wedge& wedge : plan.Wedges)
  {
    lines += wedge.Lines;
  }
  std::ostringstream text;
  text << "block means: " << lines << " lines " << plan.Chosen->Spacing << " pixels apart, up to "
       << plan.GetNodes() << " nodes, blocks of up to " << plan.Chosen->LongestBlock
       << " pixels, taps for marches below " << plan.ShortestMarch << " pixels";
  return text.str();
}

//------------------------------------------------------------------------------
void vtkGodRaysBlockMeans::Release(vtkWindow* window)
{
  Internals& self = *this->Internal;
  self.MeansQuad.Release();
  self.SumQuad.Release();
  self.InterpolateQuad.Release();
  for (int i = 0; i < 2; ++i)
  {
    self.Means[i].Release(window);
    self.Sums[i].Release(window);
  }
  for (const auto& plan : self.Plans)
  {
    plan->Release(window);
  }
  self.Plans.clear();
}
