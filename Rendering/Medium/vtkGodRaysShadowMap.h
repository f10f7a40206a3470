// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysShadowMap
 * @brief   depths of the occluders, as a light sees them; private to this module
 *
 * One face, fitted to the occluders, for a light that is infinitely far or sees all of it within 60
 * degrees of one direction; else the six faces of a cube about the light, side by side in one texture. A
 * light that is infinitely far may have up to four nested faces instead, each half as wide as the one
 * before. What was drawn for the last light serves again while light, faces and occluders are the same in
 * the world; one face about all occluders, or about a fixed lamp, so serves while the camera moves. Of
 * plain actors VTK tells that; with any other prop, and on several processes, it is drawn anew. Where only
 * some occluders change, and faces stay as they are, the depths of the others are kept in a map of their own
 * from the first such frame on: it is copied, and what changes is drawn over it.
 *
 * Translucent surfaces and volumes are layers of the grids, if Draw() is asked for them: without such props
 * nothing is drawn or kept for them.
 */

#ifndef vtkGodRaysShadowMap_h
#define vtkGodRaysShadowMap_h

#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysShadowGrids.h"
#include "vtkGodRaysShadowLayers.h"
#include "vtkGodRaysTarget.h"

#include <array>      // For std::array
#include <cstddef>    // For std::size_t
#include <functional> // For std::function
#include <string>     // For std::string
#include <vector>     // For std::vector

class vtkCamera;
class vtkGodRaysLightLayers;
class vtkShaderProgram;

class vtkGodRaysShadowMap
{
public:
  vtkGodRaysShadowMap();
  ~vtkGodRaysShadowMap();

  /**
   * Render the props that block into faces of so many pixels on each side, or as many as the driver
   * takes. For a light that is infinitely far, seen in perspective, there are up to so many levels; more
   * than one are faces of half as many pixels, nested about the axis through the eye. All processes of a
   * compositor call it. What is translucent is drawn if so asked. Returns false when the driver refuses.
   */
  bool Draw(
    const vtkGodRaysMediumIntegrator::Request& request, int size, int levels, bool translucent);

  /**
   * The faces as numbers, read back where they were drawn anew. They are valid until the next Draw().
   */
  const vtkGodRaysShadowGrids& GetGrids();

  /**
   * How many faces there are; 0 if nothing blocks.
   */
  int GetNumberOfFaces() const { return this->NumberOfFaces; }
  int GetSize() const { return this->Size; }

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

  vtkTextureObject* GetDepth() const { return this->Maps[this->NumberOfFaces / 6].GetDepth(); }

  /**
   * Give a shader its numbers.
   */
  void Set(vtkShaderProgram* program) const;

  void Release(vtkWindow* window);

private:
  /// What the picture in the map depends on; empty if that cannot be told.
  struct State
  {
    std::vector<const void*> Objects;
    std::vector<double> Numbers;
    std::vector<double> Places; // of the occluders' bounds in the faces, the same but for rounding
    // Where objects and numbers end: those before the first occluder, and those of each.
    std::vector<std::array<std::size_t, 2>> Ends;

    bool IsSame(const State& other) const;
    bool HasSameFaces(const State& other) const;
    bool HasSameProp(const State& other, std::size_t prop) const;
    void End() { this->Ends.push_back({ this->Objects.size(), this->Numbers.size() }); }
    void Clear();
  };
  void FindState(const vtkGodRaysMediumIntegrator::Request& request, State& state) const;

  bool Render(
    const vtkGodRaysMediumIntegrator::Request& request, vtkGodRaysTarget& map, bool hasRest);
  bool FindRest();
  void RenderProps(const vtkGodRaysMediumIntegrator::Request& request, bool resting, bool changed);
  void ForFaces(
    const vtkGodRaysMediumIntegrator::Request& request, const std::function<void()>& draw);
  bool RenderTranslucent(const vtkGodRaysMediumIntegrator::Request& request, vtkGodRaysTarget& map);
  void Fit(const vtkGodRaysMediumIntegrator::Request& request);
  void FitDirectional(const vtkGodRaysMediumIntegrator::Request& request);
  void FitPoint(const vtkGodRaysMediumIntegrator::Request& request);
  void Nest(const double axes[3][3], const double low[2], const double high[2]);
  void SetFace(int face, const double axes[3][3], const double origin[3], const double low[2],
    const double high[2]);

  int GetColumns() const { return this->NumberOfFaces == 1 ? 1 : this->NumberOfFaces == 6 ? 3 : 2; }
  int GetRows() const { return this->NumberOfFaces == 1 ? 1 : 2; }

  vtkGodRaysTarget Maps[2]; // of one face or nested ones, and of six
  int Levels = 1;           // at most, of a light that is infinitely far
  vtkGodRaysShadowGrids Grids;
  std::vector<float> Depths;  // that the grids have; empty: not read yet
  State Drawn;                // what is in the map
  State Asked;                // what is wanted; here to keep its memory
  State Rest;                 // what is in the map of props that have not changed
  std::vector<bool> IsAtRest; // whether a prop is in it
  vtkGodRaysTarget RestMap;
  bool RestIsDrawn = false;
  int NumberOfChanged = 0;
  bool Kept = false;
  bool Translucent = false; // whether it is asked for
  int LeftOut = 0;          // translucent props, if it is not
  vtkSmartPointer<vtkGodRaysLightLayers> Peeler;
  vtkGodRaysShadowLayers Layers;
  vtkSmartPointer<vtkCamera> Camera;
  int Size = 0; // of a face [pixels]
  int NumberOfFaces = 0;
  double Corners[8][3];    // of the occluders' bounds, in view coordinates
  double ViewToMap[6][16]; // view coordinates to clip coordinates of a face
  double Texel = 0.0;      // width of a pixel, at distance 1 from a point light [scene units]
};

#endif
