// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which array of a data set gives the colours, and which colours.
 */

#ifndef Coloring_h
#define Coloring_h

#include "Options.h"

#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <map>    // For std::map
#include <set>    // For std::set
#include <string> // For std::string

class vtkActor;
class vtkColorTransferFunction;
class vtkDataArray;
class vtkDataSet;

/// The array chosen for a data set; Array is null when there is none.
struct ColorArray
{
  vtkDataArray* Array = nullptr;
  bool OfCells = false;

  std::string GetName() const;

  /// Whether the values are colours: red, green, blue and perhaps opacity in bytes.
  bool IsColor() const;
};

/**
 * Chooses arrays, and gives the same colours to the same values in all data sets of the scene.
 */
class Coloring
{
public:
  explicit Coloring(const Options& options);

  /**
   * The array asked for; else the active one, that of points before that of cells; else the first
   * that looks like one to colour by.
   */
  ColorArray Choose(vtkDataSet* data);

  /**
   * Let the values of an array count for the range of the colours. Returns whether some are outliers, which
   * do not.
   */
  bool AddToRange(const ColorArray& choice);

  /**
   * Returns true if all values of an array are one, such as those of an isosurface, and no option asks for
   * their colours: such data are drawn plain. All parts have to be in the range by then.
   */
  bool TellsNothing(const ColorArray& choice) const;

  /**
   * Let an array have the colours of terrain, if the user chose none; with onlyIfNamed, if its name
   * says that it holds elevations.
   */
  void SetTerrain(const std::string& name, bool onlyIfNamed);

  /**
   * The colours of an array, over the range of all chosen arrays of its name.
   */
  vtkSmartPointer<vtkColorTransferFunction> MakeColors(const std::string& name) const;
  void GetRange(const std::string& name, double range[2]) const;

  /**
   * Give an actor the colours of the array chosen for its data.
   */
  void Apply(const ColorArray& choice, vtkActor* actor) const;

  /**
   * Throws Failure, which lists the arrays there are, when no data set had the array asked for.
   */
  void CheckFound() const;

private:
  const Options& Settings;
  std::map<std::string, std::array<double, 2>> Ranges;
  std::set<std::string> Terrain;
  std::set<std::string> Seen;
  bool Found = false;
};

#endif
