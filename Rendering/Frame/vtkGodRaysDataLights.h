// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysDataLights
 * @brief   lights that let the sun of the rays touch the data; private to this module
 *
 * Adds two lights to a renderer: a rim light that grazes the data from the sun's side of the picture, and a
 * soft key light from there. If a visible prop is coloured by data or by a texture, there is only a weak rim
 * light, which keeps the mean CIELAB difference from the picture without it below 4. If one is a volume,
 * both are off. The renderer's other lights are left alone. And it adds copies of lights that are to shine on
 * surfaces.
 */

#ifndef vtkGodRaysDataLights_h
#define vtkGodRaysDataLights_h

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h" // For vtkWeakPointer
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkGodRaysDataLights
{
public:
  ~vtkGodRaysDataLights()
  {
    this->Remove();
    this->Shine(nullptr, {});
  }

  /**
   * Adds the lights to a renderer, and places them for its camera. The direction is in world coordinates,
   * towards the sun. To be called in each frame before the scene is drawn; it modifies nothing if the
   * camera, the sun and the kind of the props are those of the last call.
   */
  void Update(vtkRenderer* renderer, const double sunDirection[3]);

  /**
   * Adds copies of the lights that a renderer lacks, so that they shine on its surfaces; with the others
   * goes what was added for them. A sun that was placed in the picture shines from 25 degrees above the
   * horizon at least: a camera that looks down has it under the ground.
   */
  void Shine(vtkRenderer* renderer, const std::vector<vtkSmartPointer<vtkLight>>& lights,
    vtkLight* placed = nullptr);

  /**
   * Returns rim and key light, which are no light of the scene.
   */
  std::vector<vtkLight*> GetLights() const { return { this->Key, this->Rim }; }

  /**
   * Takes rim and key light off their renderer.
   */
  void Remove();

private:
  vtkNew<vtkLight> Key;
  vtkNew<vtkLight> Rim;
  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<vtkSmartPointer<vtkLight>> Suns; // copies
  vtkWeakPointer<vtkRenderer> SunsRenderer;
};

#endif
