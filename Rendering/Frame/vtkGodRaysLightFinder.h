// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysLightFinder
 * @brief   find the lights of a frame; private to this module
 */

#ifndef vtkGodRaysLightFinder_h
#define vtkGodRaysLightFinder_h

#include "vtkGodRaysLight.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysTransfer.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkGodRaysCompositor;
class vtkGodRaysSceneSize;
class vtkLight;
class vtkRenderer;
struct vtkGodRaysView;

///@{
/// Note on a light what it is above the air: its colour times its intensity, in linear light, where the
/// light itself has what the air leaves of that; and the mean radiance of its sky, where that lights the
/// scene. The note holds while its colour stays; a change of the intensity is a factor. Returns false if
/// there is none.
void vtkGodRaysSetLightAboveAir(vtkLight* light, const double above[3], const double sky[3]);
bool vtkGodRaysGetLightAboveAir(vtkLight* light, double above[3], double sky[3] = nullptr);
///@}

class vtkGodRaysLightFinder
{
public:
  vtkRenderer* Renderer = nullptr;
  double SourceRadius = 0.0;          ///< of positional lights [world units]; 0: automatic
  double SunAngularRadius = 0.0;      ///< of directional lights [degrees]
  double BackgroundGlow = 0.0;        ///< fraction of the light's radiance
  double BackgroundGlowRadius = 0.0;  ///< [degrees]
  double BackgroundGlowFalloff = 0.0; ///< [degrees]
  vtkGodRaysTransfer Transfer = vtkGodRaysTransfer::SRGB; ///< of the colours of lights
  bool CapsMarch = true;                                  ///< see vtkGodRaysRadialSumModel
  double Tiles = 1.0;        ///< of which the view is one, across or up the whole picture
  bool LightsMedium = false; ///< all emitters count, wherever it is
  bool AboveAir = false;     ///< suns are as they are above the air, which dims them itself
  vtkGodRaysCompositor* Compositor = nullptr; ///< of a scene on several processes
  const vtkGodRaysSceneSize* Scene = nullptr;

  /**
   * The lights, and the props tagged LIGHT, of which any light may fall into the layer.
   */
  void Find(const vtkGodRaysView& view, const std::vector<vtkSmartPointer<vtkLight>>& lights,
    std::vector<vtkGodRaysLight>& found);

  /**
   * Forget the last Find(), but not the memory that it took.
   */
  void Clear();

  /**
   * A line for each light of the last Find(), with the reason if it was left out.
   */
  const std::string& GetPlan() const { return this->Plan; }

  ///@{
  /**
   * What the last Find() could not compute with, see vtkGodRaysGate: lights that it left out, and the scene
   * as a whole, without which there are no rays.
   */
  const std::vector<std::string>& GetFaults() const { return this->Faults; }
  const std::string& GetFaultOfScene() const { return this->FaultOfScene; }
  ///@}

private:
  vtkGodRays::Vec3 Decode(const double color[3]) const;
  void Add(vtkGodRaysLight& seen, const vtkGodRaysView& view, const vtkGodRays::Vec3& light,
    std::vector<vtkGodRaysLight>& found);
  void SetMarch(vtkGodRaysLight& seen, const vtkGodRaysView& view) const;
  void LeaveOut(const vtkGodRaysLight& seen, const std::string& fault);
  void Tell(const vtkGodRaysLight& seen, const char* what);
  double FindDiagonal();
  double FindPower(vtkLight* light);
  void SetSpot(vtkGodRaysLight& seen, const vtkGodRaysView& view, vtkLight* light) const;

  std::string Plan;
  std::vector<std::string> Faults;
  std::string FaultOfScene;
};

#endif
