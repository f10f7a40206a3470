// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkGodRaysPresetTable.h
 * @brief   how models find a name in their tables of presets; private to this module
 */

#ifndef vtkGodRaysPresetTable_h
#define vtkGodRaysPresetTable_h

#include "vtkGodRaysModel.h"

#include <string>

/**
 * The row with this Name, or null, after an error of the model that lists the names.
 */
template <typename Row, std::size_t size>
const Row* vtkGodRaysFindPreset(vtkGodRaysModel* model, const Row (&table)[size], const char* name)
{
  const std::string wanted = name ? name : "";
  std::string names;
  for (const Row& row : table)
  {
    if (wanted == row.Name)
    {
      return &row;
    }
    names += std::string(names.empty() ? "" : ", ") + row.Name;
  }
  vtkErrorWithObjectMacro(
    model, "There is no preset \"" << wanted << "\". The presets are: " << names << ".");
  return nullptr;
}

#endif
