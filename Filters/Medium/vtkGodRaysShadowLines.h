// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysShadowLines.h
 * @brief   what a band of lines needs while it is swept over a shadow map
 *
 * Private; see vtkGodRaysShadowKernels.h.
 */

#ifndef vtkGodRaysShadowLines_h
#define vtkGodRaysShadowLines_h

#include "vtkGodRaysCoverageKernels.h" // For CoverageMaximumPlanes

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkGodRays
{
constexpr int ShadowBlock = 32;     // columns whose sums are one
constexpr int ShadowBlockRoom = 72; // for two sums before each and after the last, whole vectors

class ShadowLines
{
public:
  // Of a line's rows.
  std::vector<float> RowFirst, RowEnd; // pixels of the wedge
  std::vector<int> Begin, End;         // pixels of the line
  std::vector<float> Perpendicular;    // distance from the axis at depth 1 [columns]
  std::vector<float> Length;           // of view rays in a column [scene units]
  std::vector<float> LogLength;        // its natural logarithm
  std::vector<float> Extinction;       // for each column's width
  std::vector<float> Step;             // place on the ladder
  std::vector<float> Before;           // transmittance of what is before the first column
  std::vector<int> Head;               // the first column that turns dark there, or -1
  // Of its pixels.
  std::vector<int> Offset, Row, Column;
  std::vector<float> Depth;     // of where rays end
  std::vector<float> At;        // the same [whole columns]
  std::vector<float> Whole;     // columns before it
  std::vector<float> Rest;      // and a part of the next one
  std::vector<float> LastWidth; // of that one [whole columns]
  std::vector<float> Longer;    // the pixel's ray than the line's [fraction]
  std::vector<float> Last;      // where rays end [columns, and part of the light of one]
  std::vector<int> LastColumn;  // the whole ones of it
  std::vector<float> Within;    // the rest of it
  std::vector<float> Excess;    // of sums between the ladder's steps [fraction]
  std::vector<float> Stretch;   // what sums are times, as the pixel's ray is not the line's
  std::vector<float> Sums;      // of what is dark before their ends, at two steps
  // Of columns.
  std::vector<int> Flip, Next;
  std::vector<float> Dark;       // 1 or 0
  std::vector<int> DarkBlocks;   // how many columns of each block are
  std::vector<float> Inner;      // sums of what is dark before a column, in its block, at two steps
  std::vector<float> Outer;      // and in the blocks before
  std::vector<float> IsAfter;    // 0 in its first half, then 1
  std::vector<float> EdgePlaces; // where columns begin
  std::vector<float> Ones;
  // Of runs of dark columns, in any order: the first, and the one after the last.
  std::vector<int> RunBegin, RunEnd;
  std::vector<int> OtherEnd; // of the run that a column ends, its other end
  std::vector<int> RunAt;    // of the run that a column begins, its place
  // Of what some pixels see of them.
  std::vector<int> SeenBegin, SeenEnd, Seer;
  std::vector<float> SeenDark[3]; // parts of the light, of each colour
  // Of layers that let light through: a column's place in the k-th is k Room more.
  int Room = 0;
  std::vector<float> Part[3];            // that turns dark, of each colour
  std::vector<float> Sum[3];             // of what is dark
  std::vector<int> Shade[3];             // the same in whole steps, one column later
  std::vector<std::uint64_t> ShadeEdges; // bits of columns whose shade is not that before
  std::vector<float> Hidden[CoverageMaximumPlanes];

  void Reserve(int rows, int columns, int layers)
  {
    const std::size_t paddedRows = rows + 16;
    for (std::vector<float>* values : { &this->RowFirst, &this->RowEnd, &this->Perpendicular,
           &this->Length, &this->LogLength, &this->Extinction, &this->Step, &this->Before })
    {
      values->resize(paddedRows);
    }
    for (std::vector<int>* values : { &this->Begin, &this->End, &this->Head })
    {
      values->resize(paddedRows);
    }
    this->Offset.resize(4 * paddedRows);
    this->Row.resize(4 * paddedRows);
    this->Column.resize(4 * paddedRows);
    this->LastColumn.resize(4 * paddedRows);
    for (std::vector<float>* values :
      { &this->Depth, &this->At, &this->Whole, &this->Rest, &this->LastWidth, &this->Longer,
        &this->Last, &this->Within, &this->Excess, &this->Stretch })
    {
      values->resize(4 * paddedRows);
    }
    this->Sums.resize(8 * paddedRows);
    this->Room = columns + 64;
    this->Flip.resize(static_cast<std::size_t>(this->Room) * std::max(layers, 1));
    this->Next.resize(this->Flip.size());
    for (int c = 0; c < 3 && layers > 0; ++c)
    {
      this->Part[c].resize(this->Flip.size());
      this->Sum[c].resize(this->Room);
      this->Shade[c].resize(this->Room + 1);
    }
    this->ShadeEdges.resize(layers > 0 ? this->Room / 64 + 2 : 0);
    this->EdgePlaces.resize(columns + 64);
    this->Ones.resize(columns + 64, 1.0f);
    this->OtherEnd.resize(columns + 64);
    this->RunAt.resize(columns + 64);
    this->Dark.resize(columns + 64);
    const std::size_t blocks = columns / ShadowBlock + 64;
    this->DarkBlocks.resize(blocks);
    if (this->IsAfter.size() != 2 * blocks)
    {
      this->IsAfter.assign(2 * blocks, 1.0f);
      std::fill_n(this->IsAfter.begin(), blocks, 0.0f);
    }
    this->Inner.resize(blocks * ShadowBlockRoom);
    this->Outer.resize(2 * blocks);
  }
};
}

#endif
