// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What the rendering tests share: a scene, its pixels, an independent reference, VTK's messages.

#ifndef GodRaysTesting_h
#define GodRaysTesting_h

#include "vtkGodRaysPass.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace GodRaysTesting
{
/// VTK's errors and warnings while it lives; any that a test does not take are failures of it.
class Messages
{
public:
  /// mayDrawNothing: warnings that a frame has no rays are expected.
  explicit Messages(bool mayDrawNothing = false);
  ~Messages();
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  /// The messages so far, which count as expected from then on.
  std::vector<std::string> Take();

  /// Takes the only message so far, which has these words.
  void Expect(const std::string& words);

private:
  bool MayDrawNothing;
};

/// Whether a plan or message has these words.
bool Says(const std::string& text, const std::string& words);

/// A box of this size about a centre.
vtkSmartPointer<vtkActor> MakeBox(std::array<double, 3> center, std::array<double, 3> size,
  std::array<double, 3> color = { 0.5, 0.5, 0.5 });

/// A sphere that shows its colour whatever the lights, for the prop of a light.
vtkSmartPointer<vtkActor> MakeLamp(
  std::array<double, 3> center, double radius, std::array<double, 3> color = { 1.0, 1.0, 1.0 });

/// A directional scene light that comes from this direction.
vtkSmartPointer<vtkLight> MakeSun(
  std::array<double, 3> towards, std::array<double, 3> color = { 1.0, 1.0, 1.0 });

/// A positional scene light.
vtkSmartPointer<vtkLight> MakeLamplight(
  std::array<double, 3> position, std::array<double, 3> color = { 1.0, 1.0, 1.0 });

/// Show sums as they are: no fall with distance, no streaks.
void SetLinear(vtkGodRaysPass* rays);

/// Have the pass add its plain sum, whatever the picture shows; see TestGodRaysExposure for the rest.
void AddPlainly(vtkGodRaysPass* rays);

/// Off screen, one renderer, dark background, camera at (0, 0, 10) that looks at the origin with a
/// view angle of 40 degrees and sees depths of 1 to 100; no multisampling.
struct Stage
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkGodRaysPass> Rays; // not attached yet

  explicit Stage(int width = 128, int height = 96);

  /// Seven pillars before a sun up to the right, the pass attached: rays all over the picture.
  vtkSmartPointer<vtkLight> AddPillarsAndSun();
};

/// 8-bit RGBA of the whole window after a Render, lower left first.
std::vector<unsigned char> GetPixels(vtkRenderWindow* window, bool render = true);

/// Window depths of the whole window after a Render.
std::vector<float> GetDepths(vtkRenderWindow* window, bool render = true);

/// Largest difference of two pictures in the channels RGB or RGBA, in 8-bit levels.
int GetLargestDifference(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int channels = 3);

/// How many pixels differ in the channels RGB by more than so many levels.
int CountDifferentPixels(
  const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int levels = 0);

/// The value of a float RGB image, 0 outside.
double GetValue(vtkImageData* image, int x, int y, int channel = 0);

/// Mean over all pixels and channels.
double GetMean(vtkImageData* image);

/// The clip coordinates X, Y and w of a world position (w = 1) or direction (w = 0), found from the
/// camera's parameters rather than by the pass.
std::array<double, 3> GetClip(vtkRenderer* renderer, std::array<double, 4> world);

/// Sum the taps of the model, as vtkGodRaysRadialSumModel::Evaluate() does, rather than their limit.
void SumTaps(vtkGodRaysPass* rays);

/// Largest difference between the light scattered on the graphics card in the last frame and the
/// model's evaluation in double precision of the occlusion layer read back, as a fraction of the
/// peak; for one light, of which clip is GetClip(). Fails the test when there were no rays.
double GetErrorOfScattering(
  vtkGodRaysPass* rays, vtkRenderer* renderer, std::array<double, 3> clip);

/// The same as root mean square over the picture, and against 1024 taps: against the limit.
double GetErrorOfLimit(vtkGodRaysPass* rays, vtkRenderer* renderer, std::array<double, 3> clip);

/// Visit lights of all kinds in a scene: before and behind the camera, off screen, parallel views,
/// lamps, margins. The function gets a name and the light's world position or direction.
void ForEachLight(
  Stage& scene, const std::function<void(const std::string&, std::array<double, 4>)>& visit);

/// Compare the window with Testing/Baseline/<name>.png: VTK's own regression test, and every pixel
/// within so many levels of 255. Writes what it got when that fails. Returns whether it is alike;
/// with quiet, nothing is written and the comparison may fail as a negative control.
bool IsLikeBaseline(
  vtkRenderWindow* window, const std::string& name, int levels = 2, bool quiet = false);

/// How far a picture is from another one, without rays, with this light added in linear light: the
/// largest difference in red, green or blue, in levels of 255. Both are windows of this width; the
/// light's lower left pixel is at (x, y) in them.
double GetErrorOfSum(const std::vector<unsigned char>& with,
  const std::vector<unsigned char>& without, int width, vtkImageData* light, int x = 0, int y = 0);
}

#endif
