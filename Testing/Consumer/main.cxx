// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// consumer <file.png>: draws a cone before the sun, without rays and with them, checks that the
// rays change the picture, and writes it.

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkGodRaysPass.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>

namespace
{
/// Draw the window and count the bytes in which it differs from the picture before.
int RenderAndCompare(vtkRenderWindow* window, vtkUnsignedCharArray* before)
{
  window->Render();
  vtkNew<vtkUnsignedCharArray> now;
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, now);
  int changed = 0;
  for (vtkIdType i = 0; i < before->GetNumberOfValues(); ++i)
  {
    changed += before->GetValue(i) != now->GetValue(i);
  }
  before->DeepCopy(now);
  return changed;
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: consumer <file.png>\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkConeSource> cone;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GetActiveCamera()->SetPosition(0, 0, 5);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(200, 150);
  window->AddRenderer(renderer);

  vtkNew<vtkLight> sun;
  sun->SetPosition(0.1, 0.15, -1); // behind the cone, seen from the camera
  vtkNew<vtkGodRaysPass> rays;
  rays->AddLight(sun);
  rays->Attach(renderer);

  vtkNew<vtkUnsignedCharArray> picture;
  rays->SetIntensity(0);
  RenderAndCompare(window, picture);
  rays->SetIntensity(1);
  const int changed = RenderAndCompare(window, picture);

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  rays->Detach(renderer);

  std::cout << changed << " bytes of " << picture->GetNumberOfValues() << " show rays.\n"
            << "The picture with rays: " << argv[1] << '\n';
  if (changed < 1000)
  {
    std::cerr << "The rays do not reach the picture; what the pass did:\n" << rays->GetPlan();
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
