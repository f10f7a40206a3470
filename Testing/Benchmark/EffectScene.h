// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// A scene of 300,000 triangles before a light, drawn with the pass and without it.

#ifndef EffectScene_h
#define EffectScene_h

#include "Device.h"

#include "vtkActor.h"
#include "vtkGodRaysPass.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <map>
#include <string>
#include <vector>

class EffectScene
{
public:
  EffectScene(Device& device, int width, int height);
  ~EffectScene();

  /// How the frame is drawn.
  struct Variant
  {
    std::string Name;
    bool HasPass;
    bool LampShines; // a sphere in the scene is the light, else a vtkLight
    int Taps;        // 0: the pass's default integrator
  };
  static const std::vector<Variant>& GetVariants();

  /// Draw a frame; the time that it took [s].
  double Draw(const Variant& variant);

  /// The pass of a variant, which has drawn before.
  vtkGodRaysPass* GetPass(const Variant& variant) { return this->Passes[variant.Name]; }

private:
  Device& OpenGL;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Lamp;
  vtkNew<vtkLight> Light;
  std::map<std::string, vtkSmartPointer<vtkGodRaysPass>> Passes;
};

#endif
