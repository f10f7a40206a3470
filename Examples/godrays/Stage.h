// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene as it is drawn: with its camera, light, background and rays.
 */

#ifndef Stage_h
#define Stage_h

#include "Options.h"
#include "Presets.h"
#include "Scene.h"
#include "Viewpoint.h"

#include "vtkGodRaysPass.h" // For vtkGodRaysPass
#include "vtkLight.h"       // For vtkLight
#include "vtkNew.h"         // For vtkNew
#include "vtkRenderer.h"    // For vtkRenderer

#include <string> // For std::string
#include <vector> // For std::vector

class Stage
{
public:
  Stage(Scene scene, const Viewpoint& view, const Options& options);
  ~Stage();

  Stage(const Stage&) = delete;
  void operator=(const Stage&) = delete;

  vtkRenderer* GetRenderer() const { return this->Renderer; }
  vtkGodRaysPass* GetRays() const { return this->Rays; }
  const Scene& GetScene() const { return this->Data; }
  const Viewpoint& GetView() const { return this->View; }
  const Viewpoint& GetOriginalView() const { return this->Original; } ///< light for any preset
  const Preset& GetLook() const { return this->Look; }
  const std::string& GetBackground() const { return this->Settings.Background; }
  bool AreRaysOn() const { return this->HasRays; }

  void SetRays(bool on);
  void SetPreset(const Preset& preset);

  /**
   * As --background has it. With a physical sky, which is drawn over it, nothing changes.
   */
  void SetBackground(const std::string& background);

  /**
   * Have the lamp at another point, or the sun in another direction, a unit vector.
   */
  void MoveLight(const Vector3& place);

  /**
   * Have the light of another view.
   */
  void TakeLight(const Viewpoint& view);

  /**
   * Factor on the physical sky's usual exposure. Without such a sky nothing changes.
   */
  void SetExposure(double factor);

  /// A number of the rays, named as its option.
  struct Parameter
  {
    std::string Name;
    double Low, High;
    double Value;
  };

  /**
   * Those that the look or medium has, and a useful range of them.
   */
  std::vector<Parameter> GetParameters() const;

  /**
   * Set one of them. Those that were set, as by an option, stay when the look or medium changes.
   */
  void SetParameter(const std::string& name, double value);

  /**
   * Set all that were set of another one.
   */
  void SetParameters(const Stage& other);

  /**
   * The camera, the light and the look, as options for the command line.
   */
  std::string GetOptions() const;

private:
  void PlaceLight();
  void MoveSkySun();

  Scene Data;
  Viewpoint Original;
  Viewpoint View; ///< with the light that suits the preset
  Options Settings;
  Preset Look;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLight> Light;
  vtkNew<vtkGodRaysPass> Rays;
  double ExposureFactor = 1.0; ///< on that of the physical one
  bool HasRays = false;
};

/**
 * The preset of the options; the usual one if they name none.
 */
const Preset& GetPreset(const Options& options);

#endif
