# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a renderer shows in all directions, as a picture to put behind everything."""

import vtkmodules.all as vtk


def take_panorama(renderer):
    """The picture about the camera, in all directions: its middle is where the camera looks, its
    upper edge where ViewUp points. The renderer must be in no window, and has no cullers afterwards."""
    resolution = 512  # of a face of 90 degrees
    drawn_by = renderer.GetPass()
    panorama = vtk.vtkPanoramicProjectionPass()
    panorama.SetCubeResolution(resolution)
    panorama.SetAngle(360)
    panorama.InterpolateOn()
    panorama.SetDelegatePass(drawn_by)
    renderer.SetPass(panorama)
    renderer.GetCullers().RemoveAllItems()  # they would take away what is behind the camera
    peels = renderer.GetUseDepthPeeling()
    renderer.UseDepthPeelingOn()  # without, a face's depth is copied as OpenGL forbids
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(4 * resolution, 2 * resolution)
    window.AddRenderer(renderer)
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    picture.ShouldRerenderOff()
    picture.Update()
    window.RemoveRenderer(renderer)
    renderer.SetPass(drawn_by)
    renderer.SetUseDepthPeeling(peels)
    return picture.GetOutput()


def bake_sky(renderer):
    """A box of all that a renderer shows, for the camera that it has now. The renderer must be in no
    window."""
    texture = vtk.vtkTexture()
    texture.SetInputData(take_panorama(renderer))
    texture.InterpolateOn()
    camera = renderer.GetActiveCamera()
    camera.OrthogonalizeViewUp()
    right = [0, 0, 0]
    vtk.vtkMath.Cross(camera.GetDirectionOfProjection(), camera.GetViewUp(), right)
    box = vtk.vtkSkybox()
    box.SetProjectionToSphere()
    box.SetFloorPlane(*camera.GetViewUp(), 0)
    box.SetFloorRight(right)
    # VTK 9.6 turns the box by the environment of the renderer instead.
    renderer.SetEnvironmentUp(*camera.GetViewUp())
    renderer.SetEnvironmentRight(*camera.GetDirectionOfProjection())
    box.SetTexture(texture)  # shown as it is: its colours are the window's already
    return box
