// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysTimers
 * @brief   times of a frame's stages on the graphics card; private to this module
 */

#ifndef vtkGodRaysTimers_h
#define vtkGodRaysTimers_h

#include <memory>
#include <utility>
#include <vector>

class vtkOpenGLRenderTimer;
class vtkRenderWindow;

class vtkGodRaysTimers
{
public:
  /// In the order of vtkGodRaysPass::GetStageTimes().
  enum Stage
  {
    SCENE,
    OCCLUSION,
    SCATTERING,
    BLEND,
    NUMBER_OF_STAGES
  };

  vtkGodRaysTimers();
  ~vtkGodRaysTimers();
  vtkGodRaysTimers(const vtkGodRaysTimers&) = delete;
  void operator=(const vtkGodRaysTimers&) = delete;

  /**
   * Forget the times of the last frame; measure those of the next, or not.
   */
  void BeginFrame(bool measure);

  ///@{
  /**
   * Begin and end a stretch of a stage; a stage may have several in a frame, but not nested.
   */
  void Start(Stage stage);
  void Stop();
  ///@}

  /**
   * The times of the frame [seconds], 0 where not measured. Its context must be current; waits.
   */
  void GetTimes(double seconds[NUMBER_OF_STAGES]);

  /**
   * Free what is on the graphics card of a window; null if that is gone.
   */
  void Release(vtkRenderWindow* window);

private:
  std::vector<std::pair<Stage, std::unique_ptr<vtkOpenGLRenderTimer>>> Timers;
  std::size_t Used = 0;
  bool Measure = false;
  bool Running = false; ///< whether the timer Used does
};

#endif
