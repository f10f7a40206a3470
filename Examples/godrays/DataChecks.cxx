// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataChecks.h"

#include "Failure.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <utility>
#include <vector>

//------------------------------------------------------------------------------
void CheckCells(const std::string& path, vtkDataObject* data)
{
  std::vector<vtkCellArray*> all;
  vtkIdType numberOfPoints = 0;
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    all = { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() };
    numberOfPoints = surface->GetNumberOfPoints();
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    all = { grid->GetCells() };
    numberOfPoints = grid->GetNumberOfPoints();
  }
  for (vtkCellArray* cells : all)
  {
    double range[2] = { 0.0, -1.0 };
    if (cells && cells->GetNumberOfConnectivityIds() > 0)
    {
      cells->GetConnectivityArray()->GetRange(range);
    }
    if (range[0] < 0.0 || range[1] >= numberOfPoints || (cells && !cells->IsValid()))
    {
      throw Failure(path + ": has a cell with a point that is not there; write it again");
    }
  }
}

//------------------------------------------------------------------------------
void CheckSizes(const std::string& path, vtkDataSet* data)
{
  if (data->GetNumberOfPoints() < 0 || data->GetNumberOfCells() < 0)
  {
    throw Failure(path + ": says a size that cannot be; write it again");
  }
  const std::pair<vtkFieldData*, vtkIdType> all[] = {
    { data->GetPointData(), data->GetNumberOfPoints() },
    { data->GetCellData(), data->GetNumberOfCells() },
  };
  for (const auto& [arrays, number] : all)
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      if (arrays->GetAbstractArray(i)->GetNumberOfTuples() < number)
      {
        throw Failure(path + ": has too few values in an array; write it again");
      }
    }
  }
}
