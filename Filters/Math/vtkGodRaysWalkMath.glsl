// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

//VTK::GodRays::Types

// A straight way through a shadow map. Level 0 are its texels; a cell of level l is 2^l of them wide.

struct MapWalk
{
  Real StartX; // [texels]
  Real StartY;
  Real SlopeX; // of the whole way [texels]
  Real SlopeY;
  Real InverseX; // parts of the way for each texel
  Real InverseY;
  int Rightwards; // 1 or 0
  int Upwards;
  int Width; // of the map [texels]
  int Height;
  int Top;   // level
  int Level; // of the cell where the walk is
  int X;     // a texel of that cell
  int Y;
  Real Begin; // where the way enters the cell [0, 1]
  Real End;   // and where it leaves it, after FindEnd()
  bool ByX;   // through the edge at its side
};

// From one place of a map to another, in texels. From the top level the walk would go down in most places,
// and from texels up: it starts between.
FUNCTION MapWalk BeginWalk(IN(Real) fromX, IN(Real) fromY, IN(Real) toX, IN(Real) toY, IN(int) width,
  IN(int) height, IN(int) top)
{
  MapWalk walk;
  walk.StartX = fromX;
  walk.StartY = fromY;
  walk.SlopeX = toX - fromX;
  walk.SlopeY = toY - fromY;
  walk.InverseX = abs(walk.SlopeX) > Real(1e-12) ? Real(1.0) / walk.SlopeX : Real(1e30);
  walk.InverseY = abs(walk.SlopeY) > Real(1e-12) ? Real(1.0) / walk.SlopeY : Real(1e30);
  walk.Rightwards = walk.SlopeX >= Real(0.0) ? 1 : 0;
  walk.Upwards = walk.SlopeY >= Real(0.0) ? 1 : 0;
  walk.Width = width;
  walk.Height = height;
  walk.Top = top;
  walk.Level = min(top, 3);
  walk.X = clamp(int(fromX), 0, width - 1);
  walk.Y = clamp(int(fromY), 0, height - 1);
  walk.Begin = Real(0.0);
  walk.End = Real(0.0);
  walk.ByX = false;
  return walk;
}

// Where the way leaves the cell.
FUNCTION void FindEnd(INOUT(MapWalk) walk)
{
  int x = ((walk.X >> walk.Level) + walk.Rightwards) << walk.Level;
  int y = ((walk.Y >> walk.Level) + walk.Upwards) << walk.Level;
  Real alongX = (Real(x) - walk.StartX) * walk.InverseX;
  Real alongY = (Real(y) - walk.StartY) * walk.InverseY;
  walk.ByX = alongX < alongY;
  walk.End = min(max(walk.ByX ? alongX : alongY, walk.Begin), Real(1.0));
}

// On to the next cell; false at the end of the way or of the map. By whole numbers: a rounded place alone
// might stay where it is. A level up where the edge is one of the parent, too, as the old parent is known
// to be mixed.
FUNCTION bool GoOn(INOUT(MapWalk) walk)
{
  if (walk.End >= Real(1.0))
  {
    return false;
  }
  walk.Begin = walk.End;
  int last = (1 << walk.Level) - 1;
  int lowX = (walk.X >> walk.Level) << walk.Level;
  int lowY = (walk.Y >> walk.Level) << walk.Level;
  int edge = walk.ByX ? lowX + (walk.Rightwards << walk.Level) : lowY + (walk.Upwards << walk.Level);
  if (walk.ByX)
  {
    walk.X = edge - 1 + walk.Rightwards;
    walk.Y = clamp(
      int(walk.StartY + walk.End * walk.SlopeY), lowY, min(lowY + last, walk.Height - 1));
  }
  else
  {
    walk.X =
      clamp(int(walk.StartX + walk.End * walk.SlopeX), lowX, min(lowX + last, walk.Width - 1));
    walk.Y = edge - 1 + walk.Upwards;
  }
  if (walk.Level < walk.Top && ((edge >> (walk.Level + 1)) << (walk.Level + 1)) == edge)
  {
    ++walk.Level;
  }
  return walk.X >= 0 && walk.Y >= 0 && walk.X < walk.Width && walk.Y < walk.Height;
}

// The slope of a texel's plane, for each texel: planes of the scene are planes in a map. The lesser one to
// both sides, if they agree: none at an occluder's edge.
FUNCTION Real TexelSlope(IN(Real) before, IN(Real) here, IN(Real) after)
{
  Real down = here - before;
  Real up = after - here;
  return down * up > Real(0.0) ? (abs(down) < abs(up) ? down : up) : Real(0.0);
}
