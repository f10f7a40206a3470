// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysPresets
 * @brief   all looks and media by name, and the models that have them
 *
 * First the looks of vtkGodRaysRadialModel, of which the first is that of a new vtkGodRaysPass; then the
 * media of vtkGodRaysHomogeneousModel; then the formulations of vtkGodRaysPublishedModel, whose names have
 * "published:" before them here.
 *
 * @sa vtkGodRaysPass
 */

#ifndef vtkGodRaysPresets_h
#define vtkGodRaysPresets_h

#include "vtkGodRaysRenderingModule.h" // For export macro
#include "vtkObject.h"
#include "vtkWrappingHints.h" // For VTK_NEWINSTANCE

#include <string> // For std::string

class vtkGodRaysModel;

class VTKGODRAYSRENDERING_EXPORT vtkGodRaysPresets : public vtkObject
{
public:
  static vtkGodRaysPresets* New();
  vtkTypeMacro(vtkGodRaysPresets, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The number of presets; the name of one, and what it is in a few words, null for an index that is out
   * of range.
   */
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index);
  static const char* GetPresetDescription(int index);
  ///@}

  /**
   * All names, with commas between.
   */
  static std::string ListNames();

  /**
   * A new model with the parameters of this name; null, without an error, if there is no such name.
   */
  VTK_NEWINSTANCE static vtkGodRaysModel* NewModel(const char* name);

  /**
   * Set the parameters of this name, and no others, of a model of the class that has it. Returns false,
   * without an error, and changes nothing if the model is of another class, or null, or if there is no such
   * name.
   */
  static bool ApplyTo(vtkGodRaysModel* model, const char* name);

protected:
  vtkGodRaysPresets() = default;
  ~vtkGodRaysPresets() override = default;

private:
  vtkGodRaysPresets(const vtkGodRaysPresets&) = delete;
  void operator=(const vtkGodRaysPresets&) = delete;
};

#endif
