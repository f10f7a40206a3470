// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysBlockPlan.h
 * @brief   what vtkGodRaysBlockMeans decides without the layer; private to this module
 */

#ifndef vtkGodRaysBlockPlan_h
#define vtkGodRaysBlockPlan_h

#include "vtkGodRaysMarch.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

struct vtkGodRaysBlockPlan
{
  /// What accuracy takes.
  struct Effort
  {
    double Error;         // see ChooseEffort()
    double Spacing;       // of lines where they are farthest apart [pixels]; 0: taps alone
    double TapsPerPixel;  // of blocks' means, half of those near the light [1/pixel]
    double LongestBlock;  // [pixels]
    double Ratio;         // of a block's length to that of the march, times k
    double BumpTapLength; // [pixels]
    double LeastTail; // smaller ends of marches within a block are left out [fraction of the peak]
    bool operator==(const Effort& other) const
    {
      return this->Error == other.Error && this->TapsPerPixel == other.TapsPerPixel;
    }
    bool HasLines() const { return this->Spacing > 0.0; }
  };

  /// Four floats a texel.
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

    /// Put it into the corner of a texture that is at least as large.
    void Upload(vtkOpenGLRenderWindow* window);

    void Release(vtkWindow* window);

    vtkSmartPointer<vtkTextureObject> Texture;
    int TextureWidth = 0;
    int TextureHeight = 0;
  };

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
    int Strip[2] = { 0, 0 };   // even lines between which there are more, see LineOfEven()
    int Lines = 0;             // 0: there is no picture in it
    std::vector<double> Nodes; // from the nearest row [pixels]
    int NodeColumn = 0;
    int BlockColumn = 0;

    int GetBlocks() const { return this->Lines ? static_cast<int>(this->Nodes.size()) - 1 : 0; }
  };

  static constexpr int NumberOfWedges = 4;

  vtkGodRaysMarch March;
  Effort Chosen;
  bool OneChannel;
  double Light[2] = { 0.0, 0.0 }; // as used [pixels of the layer]
  double Density = 0.0;
  std::array<Wedge, NumberOfWedges> Wedges;
  int StripFactor = 1; // how many times as close lines are in strips
  int Lines = 0;       // as textures must hold
  int BlockColumns = 0;
  int NodeColumns = 0;
  double ShortestMarch = 0.0; // shorter ones are summed by taps [pixels]
  int NearBox[4] = {}; // first column and row of those, and of marches whose ends within a block
                       // count, and the first beyond them [pixels of the picture]
  Table Blocks;        // textures of the shaders
  Table Nodes;
  Table Kernel;
  Table Rows;

  vtkGodRaysBlockPlan(const vtkGodRaysMarch& march, const Effort& effort, bool oneChannel)
    : March(march)
    , Chosen(effort)
    , OneChannel(oneChannel)
  {
    this->Fill();
  }
  bool Is(const vtkGodRaysMarch& march, const Effort& effort, bool oneChannel) const
  {
    return this->March == march && this->Chosen == effort && this->OneChannel == oneChannel;
  }

  // To be used for something else: what is on the graphics card is used again.
  void Change(const vtkGodRaysMarch& march, const Effort& effort, bool oneChannel)
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

  /**
   * Returns the least effort that keeps the tolerance: lines, as many as fit into a texture of so many
   * pixels, or taps alone where these are as fast or lines cannot keep it. Where there would be too many
   * taps, returns the most lines instead, which do not keep the tolerance on noise.
   */
  static Effort ChooseEffort(const vtkGodRaysMarch& march, double tolerance, int largest);

  static int RoundUp(int value, int multiple)
  {
    return (value + multiple - 1) / multiple * multiple;
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
  void PlaceStrip(Wedge& wedge, double nearest, double last) const;
  void MakeNodes(Wedge& wedge);
  void MakeBlockTable();
  void MakeNodeTable();
  void MakeWeights(const Wedge& wedge, int node, int row, int& first, int& last);
  double MakeRowTable();
  bool MakeTail(const Wedge& wedge, double r, double march, int row, int index);
  void PlaceNearBox(double reach);
  // A block's place among all means, four of a layer of one channel being one texel.
  int GetMean(const Wedge& wedge, int block) const
  {
    return (this->OneChannel ? 4 : 1) * wedge.BlockColumn + block;
  }
  double GetMarch(const Wedge& wedge, double r) const { return this->Density * (wedge.Near + r); }
};

#endif
