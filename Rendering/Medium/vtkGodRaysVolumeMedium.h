// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysVolumeMedium
 * @brief   the volumes of a scene that are media: their light and what they dim; private to this module
 *
 * vtkGodRaysGridPicture on the processor, for each light. Data are read, and the light's depths through them
 * summed, when they change; else both are kept, for each light of the frame before.
 */

#ifndef vtkGodRaysVolumeMedium_h
#define vtkGodRaysVolumeMedium_h

#include "vtkGodRaysGridPicture.h"
#include "vtkGodRaysMediumIntegrator.h" // For Request
#include "vtkGodRaysTarget.h"
#include "vtkGodRaysVolumeGrid.h"
#include "vtkGodRaysVolumeImage.h"

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

class vtkGodRaysCompositor;
class vtkGodRaysDiffuseLight;
class vtkProp;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

class vtkGodRaysVolumeMedium
{
public:
  /**
   * Whether a renderer shows props tagged MEDIUM that no pass around this one has taken.
   */
  static bool HasVolumes(vtkRenderer* renderer);

  /**
   * Take them for a frame. Returns what is wrong, and what to do; then, and if there are none, it has none.
   */
  std::string Take(vtkRenderer* renderer, vtkGodRaysCompositor* compositor,
    const vtkGodRaysVolumeGrid::Numbers& numbers);

  const std::vector<vtkProp*>& GetProps() const { return this->Props; }
  bool IsEmpty() const { return this->Props.empty(); }

  /**
   * Returns whether processes share their data: then mappers draw them.
   */
  bool IsSplit() const { return this->Split; }

  ///@{
  /// Media of the props, and a number that changes whenever they do.
  const std::vector<vtkGodRaysGrid>& GetGrids() const { return this->Grids; }
  unsigned int GetVersion() const { return this->Version; }
  ///@}

  void Begin() { this->Light = 0; }

  /**
   * Find what they leave of the light that Draw() is to draw next, which is valid until then. Returns null,
   * after an error, if that failed.
   */
  const vtkGodRaysGridPicture* Prepare(const vtkGodRaysMediumIntegrator::Request& request);

  /**
   * Add what they change of a light to the request's result, where shadows are as told, null for none, and
   * light that was scattered before, null for none. Returns false, after an error, if that failed.
   */
  bool Draw(const vtkGodRaysMediumIntegrator::Request& request,
    const vtkGodRaysShadowGrids* shadows, const vtkGodRaysDiffuseLight* diffuse = nullptr);

  /**
   * What they leave of what is behind them, of the picture's size, after Draw().
   */
  ///@{
  vtkTextureObject* GetVeil() const { return this->Veil.GetColor(); }
  const std::vector<float>& GetTransmittance() const { return this->Transmittance; }
  ///@}

  /**
   * How far extinction is from that of grids that were resampled, in the worst of them [1/scene unit]: root
   * mean square, and at most.
   */
  void GetResamplingErrors(double& mean, double& largest) const;

  /**
   * What was drawn, for the plan.
   */
  std::string Describe() const;

  /**
   * Forget the props of the frame.
   */
  void End();

  void Release(vtkWindow* window);

private:
  std::string Read(const vtkGodRaysVolumeGrid::Numbers& numbers);
  bool ReadDepths(const vtkGodRaysMediumIntegrator::Request& request);

  template <typename Work>
  bool Try(const Work& work);

  struct Drawer
  {
    vtkGodRaysGridPicture Picture;
    unsigned int Version = 0;
    unsigned int ExtinctionVersion = 0;
  };

  Drawer& GetDrawer();

  bool Split = false;
  std::vector<vtkProp*> Props;
  std::vector<vtkGodRaysGrid> Grids;
  std::vector<vtkGodRaysVolumeImage> Images;
  std::vector<vtkGodRaysVolumeGrid::Error> Errors;
  std::vector<const void*> Objects; // that they are of
  std::vector<double> Numbers;      // that extinction depends on
  std::vector<double> Others;       // that the rest does
  std::string Fault;                // of the volumes that were read last; empty if they had none
  std::vector<const void*> FaultObjects; // as Objects and Numbers
  std::vector<double> FaultNumbers;
  unsigned int Version = 0;
  unsigned int ExtinctionVersion = 0;
  std::deque<Drawer> Drawers; // of the lights, in the frame's order
  std::size_t Light = 0;      // how many the frame has had
  std::vector<float> Depths;
  unsigned int DepthsFrame = 0;
  std::vector<float> Radiance;
  std::vector<float> Transmittance;
  vtkGodRaysTarget Rays;
  vtkGodRaysTarget Veil;
};

#endif
