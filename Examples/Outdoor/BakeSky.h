// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a renderer shows in all directions, as a picture to put behind everything.
 */

#ifndef BakeSky_h
#define BakeSky_h

#include "vtkCamera.h"
#include "vtkCullerCollection.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPanoramicProjectionPass.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSkybox.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkWindowToImageFilter.h"

/**
 * The picture about the camera, in all directions: its middle is where the camera looks, its upper edge
 * where ViewUp points. The renderer must be in no window, and has no cullers afterwards.
 */
inline vtkSmartPointer<vtkImageData> TakePanorama(vtkRenderer* renderer)
{
  const int resolution = 512; // of a face of 90 degrees
  const vtkSmartPointer<vtkRenderPass> drawnBy = renderer->GetPass();
  vtkNew<vtkPanoramicProjectionPass> panorama;
  panorama->SetCubeResolution(resolution);
  panorama->SetAngle(360.0);
  panorama->InterpolateOn();
  panorama->SetDelegatePass(drawnBy);
  renderer->SetPass(panorama);
  renderer->GetCullers()->RemoveAllItems(); // they would take away what is behind the camera
  const bool peels = renderer->GetUseDepthPeeling();
  renderer->UseDepthPeelingOn(); // without, a face's depth is copied as OpenGL forbids
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(4 * resolution, 2 * resolution);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  picture->Update();
  window->RemoveRenderer(renderer);
  renderer->SetPass(drawnBy);
  renderer->SetUseDepthPeeling(peels);
  return picture->GetOutput();
}

/**
 * A box of all that a renderer shows, for the camera that it has now. The renderer must be in no window.
 */
inline vtkSmartPointer<vtkSkybox> BakeSky(vtkRenderer* renderer)
{
  vtkNew<vtkTexture> texture;
  texture->SetInputData(TakePanorama(renderer));
  texture->InterpolateOn();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->OrthogonalizeViewUp();
  const double* up = camera->GetViewUp();
  double right[3];
  vtkMath::Cross(camera->GetDirectionOfProjection(), up, right);
  auto box = vtkSmartPointer<vtkSkybox>::New();
  box->SetProjectionToSphere();
  box->SetFloorPlane(up[0], up[1], up[2], 0.0);
  box->SetFloorRight(right[0], right[1], right[2]);
  // VTK 9.6 turns the box by the environment of the renderer instead.
  renderer->SetEnvironmentUp(up[0], up[1], up[2]);
  renderer->SetEnvironmentRight(camera->GetDirectionOfProjection());
  box->SetTexture(texture); // shown as it is: its colours are the window's already
  return box;
}

#endif
