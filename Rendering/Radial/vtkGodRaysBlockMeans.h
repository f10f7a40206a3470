// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGodRaysBlockMeans
 * @brief   the converged radial sum in three passes of fragment shaders; private to this module
 *
 * The plane about the light falls into four wedges, |dx| <= |dy| and the rest, each up and down. A
 * wedge has lines through the light, a spacing apart where they are farthest apart, and nodes at the
 * same distances s from the light along them, in rows or columns of the layer ("rows" from here on).
 * Between two nodes is a block.
 *
 * 1. vtkGodRaysBlockMeansFS: the mean of the layer over each block of each line.
 * 2. vtkGodRaysBlockSumFS: the integral at each node, the means times a matrix with the kernel's
 *    integral over each block as seen from each node, in double precision.
 * 3. vtkGodRaysBlockInterpolateFS: the integral at each pixel. Between nodes, and lines, the product
 *    of integral and length of the march is interpolated; from the nearer node to the pixel, and
 *    where the march ends within a block, a few taps say how the layer differs from the mean of the
 *    block, unless it is even there. Near the light, and where marches are short, taps are summed.
 *    That and the ends of marches within a block are drawn in a box about the light alone: some
 *    drivers run through a branch that no pixel takes.
 *
 * The box is the whole picture, and there are no lines, where these cannot keep the tolerance, or are not
 * faster: for marches below 8 pixels, layers where vtkGodRaysMarch::IsSmall(), kernels that end within few
 * pixels (k > 30) or grow steeply (k < -5), marches past a light in the layer, and where lines would have
 * to be closer together than textures are large.
 *
 * Shaders see no large numbers: lines are known by where they cross the nearest and the farthest
 * row of the picture, pixels by their row. So a light at infinity, or behind the camera, is like any
 * other. Everything that depends on lights and camera is computed in double precision when it
 * changes, and kept in small textures; textures grow as need be and never shrink.
 *
 * Means, nodes and tables are 32-bit floats: there are fewer of them than pixels, and some drivers cut
 * off the digits that 16-bit ones lack, which adds up. The gain is applied last: nothing stored exceeds
 * the layer.
 */

#ifndef vtkGodRaysBlockMeans_h
#define vtkGodRaysBlockMeans_h

#include "vtkGodRaysRadialIntegrator.h" // For Request

#include <memory>
#include <string>

class vtkWindow;

class vtkGodRaysBlockMeans
{
public:
  vtkGodRaysBlockMeans();
  ~vtkGodRaysBlockMeans();
  vtkGodRaysBlockMeans(const vtkGodRaysBlockMeans&) = delete;
  void operator=(const vtkGodRaysBlockMeans&) = delete;

  /**
   * Add the light of one layer to the result, to request.ErrorTolerance, root mean square over the picture
   * as a fraction of the largest possible result. Of very small tolerances of large pictures, for which taps
   * would be too many, it keeps what it can, and not on noise. The march is the request's, of a
   * vtkGodRaysRadialModel; the context is current. Returns false, after an error, if that failed.
   */
  bool Integrate(const vtkGodRaysRadialIntegrator::Request& request, const vtkGodRaysMarch& march);

  /// What the last Integrate() did, in one line.
  std::string Describe() const;

  void Release(vtkWindow* window);

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
