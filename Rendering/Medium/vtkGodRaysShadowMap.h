// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysShadowMap
 * @brief   depths of the occluders, as a light sees them; private to this module
 *
 * A map serves again while light, faces and occluders are the same in the world; one
 * face about all occluders, or about a fixed lamp, so serves while the camera moves. Modification times tell
 * that of actors, assemblies and volumes; other props are drawn anew, and on several processes all are. Where
 * only some occluders change, and faces stay as they are, the depths of the others are kept in a map of their
 * own from the first such frame on: it is copied, and what changes is drawn over it.
 *
 * Translucent surfaces and volumes are layers of the grids: without such props nothing is drawn or kept for
 * them.
 */

#ifndef vtkGodRaysShadowMap_h
#define vtkGodRaysShadowMap_h

#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysShadowFaces.h"
#include "vtkGodRaysShadowLayers.h"
#include "vtkGodRaysShadowState.h"
#include "vtkGodRaysTarget.h"

#include <functional> // For std::function
#include <string>     // For std::string
#include <vector>     // For std::vector

class vtkCamera;
class vtkGodRaysLightLayers;

class vtkGodRaysShadowMap
{
public:
  vtkGodRaysShadowMap();
  ~vtkGodRaysShadowMap();

  /**
   * Render the props that block into the faces that vtkGodRaysShadowFaces::Fit() places: into a texture of
   * its own, or, opaque ones alone, into an atlas, from a corner on. All processes of a compositor call it.
   * Returns false when the driver refuses. Fit() only finds the faces, and whether Draw() has to Redraw(),
   * unless it says WasKept().
   */
  bool Redraw(
    const vtkGodRaysMediumIntegrator::Request& request, vtkTextureObject* atlas = nullptr);
  void Fit(const vtkGodRaysMediumIntegrator::Request& request, int size, int levels,
    vtkTextureObject* atlas = nullptr, const int corner[2] = nullptr);
  bool Draw(const vtkGodRaysMediumIntegrator::Request& request, int size, int levels,
    vtkTextureObject* atlas = nullptr, const int corner[2] = nullptr);

  /**
   * The faces as numbers, read back where they were drawn anew. They are valid until the next Draw().
   */
  const vtkGodRaysShadowGrids& GetGrids();

  /**
   * How many faces there are; 0 if nothing blocks.
   */
  int GetNumberOfFaces() const { return this->Faces.Count; }
  const vtkGodRaysShadowFaces& GetFaces() const { return this->Faces; }

  /**
   * Returns whether something lets a part of the light through. Only the grids have how much.
   */
  bool HasLayers() const { return this->NumberOfLayers > 0; }

  ///@{
  /**
   * Layers take gigabytes: take them and their memory from another map, for the next Redraw(). From then on
   * the other's grids lack their numbers, until it is redrawn.
   */
  void TakeMemory(vtkGodRaysShadowMap& other);
  bool HasNumbers() const { return this->NumberOfLayers == this->Layers.GetNumberOfLayers(); }
  double GetMemory() const; // estimate [bytes], with what a walk makes of them
  ///@}

  /**
   * Whether the last Draw() took what was there.
   */
  bool WasKept() const { return this->Kept; }

  /**
   * How many props the last Draw() drew over those that had not changed, and how many props there are; the
   * first is 0 where all were drawn, or none.
   */
  int GetNumberOfChanged() const { return this->NumberOfChanged; }
  int GetNumberOfProps() const { return static_cast<int>(this->IsAtRest.size()); }

  /**
   * What was drawn of translucent things, for the plan; empty if there are none.
   */
  std::string DescribeLayers() const;

  vtkTextureObject* GetDepth() const { return this->Maps[this->Faces.Count / 6].GetDepth(); }

  void Release(vtkWindow* window);

private:
  bool Render(
    const vtkGodRaysMediumIntegrator::Request& request, vtkGodRaysTarget& map, bool hasRest);
  bool FindRest();
  bool RenderProps(const vtkGodRaysMediumIntegrator::Request& request, const int origin[2],
    bool resting, bool changed);
  bool ForFaces(const vtkGodRaysMediumIntegrator::Request& request, const int origin[2],
    const std::vector<vtkProp*>& props, const std::function<void(std::vector<vtkProp*>&)>& draw);
  bool RenderTranslucent(const vtkGodRaysMediumIntegrator::Request& request, vtkGodRaysTarget& map);

  vtkGodRaysTarget Maps[2]; // of one face or nested ones, and of six
  vtkGodRaysShadowFaces Faces;
  std::vector<float> Depths;   // that the grids have; empty: not read yet
  vtkGodRaysShadowState Drawn; // what is in the map
  vtkGodRaysShadowState Asked; // what is wanted; here to keep its memory
  vtkGodRaysShadowState Rest;  // what is in the map of props that have not changed
  std::vector<bool> IsAtRest;  // whether a prop is in it
  vtkGodRaysTarget RestMap;
  bool RestIsDrawn = false;
  int NumberOfChanged = 0;
  bool Kept = false;
  int LeftOut = 0; // volumes that cast no shadow
  vtkSmartPointer<vtkGodRaysLightLayers> Peeler;
  vtkGodRaysShadowLayers Layers;
  int NumberOfLayers = 0; // that were drawn, also if another map took them
  bool HasColoredLayers = false;
  vtkSmartPointer<vtkCamera> Camera;
};

#endif
