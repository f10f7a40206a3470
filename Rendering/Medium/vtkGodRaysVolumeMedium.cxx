// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysVolumeMedium.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkGodRaysCompositor.h"
#include "vtkGodRaysDiffuseLight.h"
#include "vtkGodRaysLight.h"
#include "vtkGodRaysMediumRays.h"
#include "vtkGodRaysOpenGL.h"
#include "vtkGodRaysRole.h"
#include "vtkGodRaysScene.h"
#include "vtkGodRaysSum.h"
#include "vtkGodRaysView.h"
#include "vtkGodRaysViewDepths.h"
#include "vtkGodRaysVolumeHaze.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <new>
#include <sstream>

namespace
{
constexpr double PartOfTolerance =
  0.7; // what is left is for the medium's own light and the shadow map

std::vector<vtkProp*> FindProps(vtkRenderer* renderer)
{
  std::vector<vtkProp*> found;
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (prop->GetVisibility() && vtkGodRaysGetRole(prop) == vtkGodRaysRole::MEDIUM &&
      !vtkGodRaysHiddenProps::IsHidden(prop))
    {
      found.push_back(prop);
    }
  }
  return found;
}
}

bool vtkGodRaysVolumeMedium::HasVolumes(vtkRenderer* renderer)
{
  return !FindProps(renderer).empty();
}

std::string vtkGodRaysVolumeMedium::Take(vtkRenderer* renderer, vtkGodRaysCompositor* compositor,
  const vtkGodRaysVolumeGrid::Numbers& numbers)
{
  this->Props = FindProps(renderer);
  std::string fault;
  this->Split = compositor && compositor->IsDistributed() &&
    vtkGodRaysCompositor::Any(compositor, !this->Props.empty());
  if (this->Split)
  {
    this->Props.clear();
  }
  else if (this->Props.size() > vtkGodRaysGridPicture::MaximumGrids)
  {
    fault = "there are more than " + std::to_string(vtkGodRaysGridPicture::MaximumGrids) +
      " volumes tagged MEDIUM. Join some of them, or give them another role";
  }
  else if (!this->Props.empty())
  {
    fault = this->Read(numbers);
  }
  // images of props with a fault are kept: they would be resampled in each frame
  if (this->Props.empty())
  {
    this->Images.clear();
  }
  if (!fault.empty())
  {
    this->Props.clear();
  }
  if (this->Props.empty() && !this->Grids.empty())
  {
    this->Grids.clear();
    this->Objects.clear();
    ++this->Version;
    ++this->ExtinctionVersion;
    this->Drawers.clear();
    this->Light = 0;
  }
  return fault;
}

std::string vtkGodRaysVolumeMedium::Read(const vtkGodRaysVolumeGrid::Numbers& numbers)
{
  std::vector<const void*> objects;
  std::vector<double> times = { numbers.Scale, static_cast<double>(numbers.Resolution) };
  for (vtkProp* prop : this->Props)
  {
    auto volume = vtkVolume::SafeDownCast(prop);
    vtkAbstractVolumeMapper* mapper = volume ? volume->GetMapper() : nullptr;
    const bool hasInput = mapper && mapper->GetNumberOfInputConnections(0) > 0;
    if (hasInput)
    {
      volume->Update();
    }
    if (hasInput && mapper->GetInputDataObject(0, 0))
    {
      vtkGodRaysVolumeHaze::AddState(volume, objects, times);
      continue;
    }
    objects.insert(objects.end(), { prop, mapper }); // a fault that may be mended
    times.push_back(mapper ? static_cast<double>(mapper->GetMTime()) : 0.0);
  }
  if (!this->Fault.empty() && objects == this->FaultObjects && times == this->FaultNumbers)
  {
    return this->Fault; // of what has not changed since
  }
  this->Fault.clear();
  std::vector<double> others = { numbers.Albedo[0], numbers.Albedo[1], numbers.Albedo[2],
    static_cast<double>(numbers.PhaseFunction), numbers.Asymmetry };
  const bool same = objects == this->Objects && times == this->Numbers &&
    std::all_of(this->Grids.begin(), this->Grids.end(),
      [](const vtkGodRaysGrid& grid) { return grid.Table->IsInPlace(); });
  if (same && others == this->Others && this->Grids.size() == this->Props.size())
  {
    return "";
  }
  std::vector<vtkGodRaysGrid> grids(this->Props.size());
  std::vector<vtkGodRaysVolumeGrid::Error> errors(grids.size());
  this->Images.resize(grids.size()); // a prop that has another place in the list is resampled again
  for (std::size_t i = 0; i < grids.size(); ++i)
  {
    std::string fault;
    try
    {
      fault =
        vtkGodRaysVolumeGrid::Read(this->Props[i], numbers, this->Images[i], grids[i], errors[i]);
    }
    catch (const std::bad_alloc&)
    {
      fault = "needs more memory than there is. Take fewer points, as by vtkImageResample";
    }
    this->Images[i].Forget();
    if (!fault.empty())
    {
      this->Fault = "a prop tagged MEDIUM " + fault;
      this->FaultObjects = std::move(objects);
      this->FaultNumbers = std::move(times);
      return this->Fault;
    }
  }
  this->Grids = std::move(grids);
  this->Errors = std::move(errors);
  this->Objects = std::move(objects);
  this->Numbers = std::move(times);
  this->Others = std::move(others);
  ++this->Version;
  this->ExtinctionVersion += same ? 0 : 1;
  return "";
}

// Of the picture, from those of the layer, which may have a margin; once a frame.
bool vtkGodRaysVolumeMedium::ReadDepths(const vtkGodRaysMediumIntegrator::Request& request)
{
  vtkGodRaysTarget* const ends = request.Depths->GetEnds();
  if (!ends || this->DepthsFrame == request.Depths->GetFrame())
  {
    return ends != nullptr;
  }
  const int layer[2] = { ends->GetWidth(), ends->GetHeight() };
  const int size[2] = { request.Result->GetWidth(), request.Result->GetHeight() };
  std::vector<float> depths(static_cast<std::size_t>(layer[0]) * layer[1]);
  ends->Read(GL_RED, GL_FLOAT, depths.data(), layer[0]);
  if (layer[0] == size[0] && layer[1] == size[1])
  {
    this->Depths.swap(depths);
  }
  else
  {
    const auto find = [&](int pixel, int i) // in the layer
    {
      const double place = (pixel + 0.5) / size[i] - 0.5;
      return std::clamp(
        static_cast<int>((0.5 + request.View->ViewScale * place) * layer[i]), 0, layer[i] - 1);
    };
    this->Depths.resize(static_cast<std::size_t>(size[0]) * size[1]);
    for (int y = 0; y < size[1]; ++y)
    {
      const std::size_t row = static_cast<std::size_t>(find(y, 1)) * layer[0];
      for (int x = 0; x < size[0]; ++x)
      {
        this->Depths[static_cast<std::size_t>(y) * size[0] + x] = depths[row + find(x, 0)];
      }
    }
  }
  this->DepthsFrame = request.Depths->GetFrame();
  return true;
}

// The one of the next light, with the grids as they are.
vtkGodRaysVolumeMedium::Drawer& vtkGodRaysVolumeMedium::GetDrawer()
{
  if (this->Light == this->Drawers.size())
  {
    this->Drawers.emplace_back();
  }
  Drawer& drawer = this->Drawers[this->Light];
  if (drawer.Version != this->Version)
  {
    drawer.Picture.SetGrids(this->Grids, drawer.ExtinctionVersion == this->ExtinctionVersion);
    drawer.Version = this->Version;
    drawer.ExtinctionVersion = this->ExtinctionVersion;
  }
  return drawer;
}

/// Does what takes memory. Returns false, after a warning, if there is not enough.
template <typename Work>
bool vtkGodRaysVolumeMedium::Try(const Work& work)
{
  try
  {
    work();
    return true;
  }
  catch (const std::bad_alloc&)
  {
    this->Drawers.clear();
    this->Light = 0;
    vtkGenericWarningMacro(
      "vtkGodRaysPass: the light's way through the volumes tagged MEDIUM needs more "
      "memory than there is, a sixteenth of that of their points for each light. Take "
      "fewer points, as by vtkImageResample.");
    return false;
  }
}

const vtkGodRaysGridPicture* vtkGodRaysVolumeMedium::Prepare(
  const vtkGodRaysMediumIntegrator::Request& request)
{
  vtkGodRaysGridPicture& picture = this->GetDrawer().Picture;
  return this->Try([&]() { picture.Prepare(vtkGodRaysMediumRays::GetWorldParameters(request)); })
    ? &picture
    : nullptr;
}

bool vtkGodRaysVolumeMedium::Draw(const vtkGodRaysMediumIntegrator::Request& request,
  const vtkGodRaysShadowGrids* shadows, const vtkGodRaysDiffuseLight* diffuse)
{
  if (!this->ReadDepths(request))
  {
    return false;
  }
  vtkGodRaysGridPicture& drawer = this->GetDrawer().Picture;
  ++this->Light;
  drawer.SetShadows(shadows);
  drawer.SetDiffuse(diffuse ? diffuse->GetAir() : nullptr, diffuse ? diffuse->GetData() : nullptr);
  auto parameters = vtkGodRaysMediumRays::GetWorldParameters(request);
  parameters.Tolerance = PartOfTolerance * request.ErrorTolerance;

  const vtkGodRaysTarget& ends = *request.Depths->GetEnds();
  const int layer[2] = { ends.GetWidth(), ends.GetHeight() };
  const vtkGodRaysFroxels::Picture seen = vtkGodRaysMediumRays(request, layer).GetPicture();
  vtkGodRaysGridPicture::Picture picture;
  std::copy_n(seen.Size, 2, picture.Size);
  std::copy_n(seen.Center, 2, picture.Center);
  picture.PixelSize = seen.PixelSize;
  const std::size_t values = 3 * static_cast<std::size_t>(picture.Size[0]) * picture.Size[1];
  this->Radiance.resize(values);
  this->Transmittance.resize(values);
  picture.Depths = this->Depths.data();
  picture.Radiance = this->Radiance.data();
  picture.Transmittance = this->Transmittance.data();
  if (!this->Try([&]() { drawer.Draw(parameters, picture); }))
  {
    return false;
  }
  drawer.SetShadows(nullptr);
  drawer.SetDiffuse(nullptr, nullptr);

  if (!request.Result->Settle()) // what is lent may be these rays, of another light
  {
    return false;
  }
  const double white[3] = { 1.0, 1.0, 1.0 };
  this->Rays.Prepare(request.Window, picture.Size[0], picture.Size[1], { GL_RGBA32F, 0 });
  this->Rays.Write(GL_RGB, GL_FLOAT, this->Radiance.data());
  this->Veil.Prepare(request.Window, picture.Size[0], picture.Size[1], { GL_RGBA32F, 0 });
  this->Veil.Write(GL_RGB, GL_FLOAT, this->Transmittance.data());
  return request.Result->Lend(this->Rays, white, 1.0);
}

void vtkGodRaysVolumeMedium::End()
{
  while (this->Drawers.size() > this->Light) // of lights that are gone
  {
    this->Drawers.pop_back();
  }
  this->Props.clear();
}

void vtkGodRaysVolumeMedium::GetResamplingErrors(double& mean, double& largest) const
{
  mean = 0.0;
  largest = 0.0;
  for (const vtkGodRaysVolumeGrid::Error& error : this->Errors)
  {
    mean = std::max(mean, error.Mean * error.Whole);
    largest = std::max(largest, error.Largest * error.Whole);
  }
}

std::string vtkGodRaysVolumeMedium::Describe() const
{
  if (this->Light == 0)
  {
    return "";
  }
  const vtkGodRaysGridPicture& last = this->Drawers[this->Light - 1].Picture;
  const double pixels = std::max(static_cast<double>(this->Transmittance.size()) / 3.0, 1.0);
  const double rays = static_cast<double>(last.GetNumberOfRays());
  std::ostringstream text;
  text << ", data of " << this->Grids.size() << " volumes: " << rays / pixels << " rays a pixel of "
       << static_cast<double>(last.GetNumberOfSteps()) / std::max(rays, 1.0)
       << " steps for the last light, whose way through them is "
       << (last.KeptLight() ? "kept" : "summed anew");
  for (std::size_t i = 0; i < this->Grids.size(); ++i)
  {
    if (!this->Images[i].GetSamples().empty())
    {
      const int* points = this->Grids[i].Points;
      text << ", a grid resampled to " << points[0] << " x " << points[1] << " x " << points[2]
           << " points, off by " << this->Errors[i].Mean << " of the largest extinction (at most "
           << this->Errors[i].Largest << ") at the centres of its cells";
    }
  }
  return text.str();
}

void vtkGodRaysVolumeMedium::Release(vtkWindow* window)
{
  this->Rays.Release(window);
  this->Veil.Release(window);
}
