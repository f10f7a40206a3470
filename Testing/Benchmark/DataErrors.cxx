// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DataErrors.h"

#include "Charts.h"
#include "GodRaysGridScenes.h"
#include "Report.h"
#include "Rounds.h"
#include "Statistics.h"

#include "vtkGodRaysCoverageSweep.h"
#include "vtkGodRaysGridPicture.h"
#include "vtkGodRaysMath.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNGWriter.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>

// The mapper scatters from VTK 9.2 on.
#define HAS_SCATTERING_MAPPER (VTK_MAJOR_VERSION * 100 + VTK_MINOR_VERSION >= 902)

using vtkGodRays::Vec3;
using Parameters = vtkGodRaysSingleScattering::Parameters;

namespace
{
const double ViewAngle = 57.3;
const double FarLimit = 30.0;
const double Asymmetry = 0.5;
const double Albedo = 0.9;
const Vec3 Sun(-0.78, 0.3, -0.55); // towards it
const double HazeScattering = 0.03;

/// One value a pixel.
using Picture = std::vector<float>;

double Seconds(const std::function<void()>& run)
{
  const auto begin = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

//------------------------------------------------------------------------------
/// Hills below the smoke, and a ridge that shadows part of it.
vtkSmartPointer<vtkPolyData> MakeTerrain(int parts)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j <= parts; ++j)
  {
    for (int i = 0; i <= parts; ++i)
    {
      const double x = -9.0 + 18.0 * i / parts;
      const double z = -1.0 - 18.0 * j / parts;
      const double hills =
        0.25 * std::sin(1.9 * x + 0.6) * std::cos(1.4 * z) + 0.1 * std::sin(4.1 * x - 3.3 * z);
      const double aside = x + 3.4 + 0.35 * std::sin(0.9 * z);
      const double ridge = 2.1 * std::exp(-aside * aside / 0.5) * (1.0 + 0.35 * std::sin(2.3 * z));
      points->InsertNextPoint(x, -2.0 + hills + ridge, z);
    }
  }
  const int row = parts + 1;
  for (int j = 0; j < parts; ++j)
  {
    for (int i = 0; i < parts; ++i)
    {
      const vtkIdType a = static_cast<vtkIdType>(j) * row + i;
      triangles->InsertNextCell({ a, a + 1, a + row + 1 });
      triangles->InsertNextCell({ a, a + row + 1, a + row });
    }
  }
  auto terrain = vtkSmartPointer<vtkPolyData>::New();
  terrain->SetPoints(points);
  terrain->SetPolys(triangles);
  return terrain;
}

//------------------------------------------------------------------------------
/// Smoke, terrain, sun and a camera in the origin that looks along -z.
class Scene
{
public:
  Scene(int points, int width, int height, int mapSize)
    : Width(width)
    , Height(height)
    , Smoke(GodRaysGridScenes::MakePlume(points))
    , Terrain(MakeTerrain(96))
  {
    this->Grid.Read(this->Smoke);
    std::fill_n(this->Grid.Albedo, 3, Albedo);
    this->Grid.PhaseFunction = 2; // Henyey and Greenstein's
    this->Grid.Asymmetry = Asymmetry;
    const double length = vtkGodRays::length(Sun);
    this->ToSun = Sun / length;
    this->Clear.Forward[2] = -1.0;
    this->Clear.Light[0] = this->ToSun.x;
    this->Clear.Light[1] = this->ToSun.y;
    this->Clear.Light[2] = this->ToSun.z;
    this->Clear.Light[3] = 0.0;
    this->Clear.Medium.FarLimit = FarLimit;
    this->Clear.Tolerance = 1.0 / 255.0;
    this->Hazy = this->Clear;
    vtkGodRaysMedium::Component& haze = this->Hazy.Medium.Components[0];
    std::fill_n(haze.Scattering, 3, HazeScattering);
    haze.PhaseFunction = 2;
    haze.Asymmetry = Asymmetry;
    this->FindDepths();
    this->DrawMap(mapSize);
  }

  double GetPixelSize() const
  {
    return 2.0 * std::tan(vtkMath::RadiansFromDegrees(0.5 * ViewAngle)) / this->Height;
  }
  double GetX(int column) const
  {
    return (column + 0.5 - 0.5 * this->Width) * this->GetPixelSize();
  }
  double GetY(int row) const { return (row + 0.5 - 0.5 * this->Height) * this->GetPixelSize(); }
  std::size_t GetPixel(int column, int row) const
  {
    return static_cast<std::size_t>(row) * this->Width + column;
  }

  /// Whether the terrain leaves a place to the sun, as the shadow map has it.
  bool IsLit(const Vec3& place) const
  {
    const double view[3] = { place.x, place.y, -place.z };
    return this->Shadows.GetHeight(view) <= vtkGodRays::dot(place, this->ToSun);
  }

  /// Extinction at a place of the grid [1/scene unit].
  float GetExtinction(const Vec3& place) const
  {
    int first[3];
    Vec3 offset(0.0);
    for (int i = 0; i < 3; ++i)
    {
      if (!(place[i] >= 0.0 && place[i] <= this->Grid.Points[i] - 1))
      {
        return 0.0f;
      }
      first[i] = std::min(static_cast<int>(place[i]), this->Grid.Points[i] - 2);
      offset[i] = place[i] - first[i];
    }
    const float* v = this->Grid.Extinction + this->Grid.GetPoint(first[0], first[1], first[2]);
    const std::ptrdiff_t row = this->Grid.Points[0];
    const std::ptrdiff_t slice = row * this->Grid.Points[1];
    const auto mix = [](float a, float b, double t) { return a + static_cast<float>(t) * (b - a); };
    const auto plane = [&](const float* p)
    { return mix(mix(p[0], p[1], offset.x), mix(p[row], p[row + 1], offset.x), offset.y); };
    return mix(plane(v), plane(v + slice), offset.z);
  }

  int Width;
  int Height;
  vtkSmartPointer<vtkImageData> Smoke;
  vtkSmartPointer<vtkPolyData> Terrain;
  vtkGodRaysGrid Grid;
  Vec3 ToSun;
  Parameters Clear; // smoke alone
  Parameters Hazy;
  Picture Depths; // view depths of the terrain, at most FarLimit
  vtkGodRaysShadowGrids Shadows;

private:
  void FindDepths()
  {
    vtkGodRaysSingleScattering exact;
    exact.SetParameters(this->Clear);
    exact.SetOccluders(this->Terrain);
    this->Depths.resize(static_cast<std::size_t>(this->Width) * this->Height);
    vtkSMPTools::For(0, this->Height,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (int row = static_cast<int>(begin); row < end; ++row)
        {
          for (int column = 0; column < this->Width; ++column)
          {
            const double sight = exact.FindSight(this->GetX(column), this->GetY(row));
            this->Depths[this->GetPixel(column, row)] =
              static_cast<float>(std::min(sight, FarLimit));
          }
        }
      });
  }

  // As a parallel camera at the sun sees the terrain.
  void DrawMap(int size)
  {
    const Vec3 right = glm::normalize(vtkGodRays::cross(Vec3(0.0, 1.0, 0.0), this->ToSun));
    const Vec3 up = vtkGodRays::cross(this->ToSun, right);
    const Vec3 middle = Vec3(0.0, 0.0, -6.0) + 20.0 * this->ToSun;
    const double extent = 5.4; // all of the smoke
    const double length = 40.0;
    Parameters camera;
    for (int i = 0; i < 3; ++i)
    {
      camera.Position[i] = middle[i];
      camera.Right[i] = right[i];
      camera.Up[i] = up[i];
      camera.Forward[i] = -this->ToSun[i];
      this->Shadows.Grids[0].Axes[0][i] = i == 2 ? -right[i] : right[i];
      this->Shadows.Grids[0].Axes[1][i] = i == 2 ? -up[i] : up[i];
    }
    camera.Parallel = true;
    camera.Medium.FarLimit = length;
    vtkGodRaysSingleScattering exact;
    exact.SetParameters(camera);
    exact.SetOccluders(this->Terrain);
    this->Map.resize(static_cast<std::size_t>(size) * size);
    const double texel = extent / size;
    vtkSMPTools::For(0, size,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType j = begin; j < end; ++j)
        {
          for (int i = 0; i < size; ++i)
          {
            const double sight =
              exact.FindSight((i + 0.5) * texel - 0.5 * extent, (j + 0.5) * texel - 0.5 * extent);
            this->Map[j * size + i] = static_cast<float>(std::min(sight / length, 1.0));
          }
        }
      });
    vtkGodRaysShadowGrids::Grid& grid = this->Shadows.Grids[0];
    grid.Depths = this->Map.data();
    grid.Stride = size;
    grid.Size[0] = grid.Size[1] = size;
    grid.Low[0] = vtkGodRays::dot(middle, right) - 0.5 * extent;
    grid.Low[1] = vtkGodRays::dot(middle, up) - 0.5 * extent;
    grid.Texel[0] = grid.Texel[1] = texel;
    this->Shadows.Levels = 1;
    this->Shadows.Range[0] = -vtkGodRays::dot(middle, this->ToSun);
    this->Shadows.Range[1] = this->Shadows.Range[0] + length;
  }

  Picture Map;
};

//------------------------------------------------------------------------------
/// What a method draws: the light of smoke alone, before the terrain. Pixels that are not drawn hold NaN.
class Method
{
public:
  std::string Name;
  std::string Series;                    // of the chart
  std::function<void(Picture&)> Prepare; // what the first picture does besides; may be empty
  std::function<void(Picture&)> Draw;
  double Share = 1.0; // of the pixels that are drawn; the time is that of all
  bool IsFitted = false;
  bool IsHazy = false; // beside haze, and held to what smoke changes
};

//------------------------------------------------------------------------------
// Radiance towards the eye of a place for each unit of length, before extinction on the way to the eye.
float GetSource(double phase, float extinction, double sunDepth)
{
  return static_cast<float>(Albedo * extinction * phase * std::exp(-sunDepth));
}

//------------------------------------------------------------------------------
// The optical depth of the sun's way to a place of the grid, by equal steps to the grid's border.
double MarchToSun(const Scene& scene, const Vec3& place, int steps)
{
  const Vec3 change = scene.Grid.GetSteps(scene.ToSun);
  double begin = 0.0;
  double end = 1e30;
  if (!scene.Grid.Clip(place, change, begin, end))
  {
    return 0.0;
  }
  const double length = (end - begin) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    sum += scene.GetExtinction(place + (begin + (i + 0.5) * length) * change);
  }
  return sum * length;
}

//------------------------------------------------------------------------------
// Equal steps through the grid's box, each with a ray of an eighth as many steps to the sun.
void March(const Scene& scene, int steps, int rowStride, Picture& picture)
{
  picture.assign(scene.Depths.size(), std::numeric_limits<float>::quiet_NaN());
  const int sunSteps = std::max(steps / 8, 8);
  const int rows = (scene.Height + rowStride - 1) / rowStride;
  vtkSMPTools::For(0, rows, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType k = first; k < last; ++k)
      {
        const int row = static_cast<int>(k) * rowStride;
        for (int column = 0; column < scene.Width; ++column)
        {
          const std::size_t pixel = scene.GetPixel(column, row);
          const Vec3 way(scene.GetX(column), scene.GetY(row), -1.0);
          const double perDepth = vtkGodRays::length(way);
          const Vec3 along = way / perDepth;
          const Vec3 place = scene.Grid.GetPlace(Vec3(0.0));
          const Vec3 change = scene.Grid.GetSteps(along);
          double begin = 0.0;
          double end = perDepth * scene.Depths[pixel];
          float light = 0.0f;
          if (scene.Grid.Clip(place, change, begin, end))
          {
            const double phase =
              vtkGodRays::Phase({ 2, Asymmetry }, vtkGodRays::dot(along, scene.ToSun));
            const double length = (end - begin) / steps;
            double through = 1.0;
            for (int i = 0; i < steps; ++i)
            {
              const double s = begin + (i + 0.5) * length;
              const Vec3 here = place + s * change;
              const float extinction = scene.GetExtinction(here);
              if (extinction > 0.0f)
              {
                const double left = std::exp(-extinction * length);
                if (scene.IsLit(s * along))
                {
                  light += static_cast<float>(through * (1.0 - left) / extinction *
                    GetSource(phase, extinction, MarchToSun(scene, here, sunSteps)));
                }
                through *= left;
              }
            }
          }
          picture[pixel] = light;
        }
      }
    });
}

//------------------------------------------------------------------------------
// What engines do: a grid of the view's cells, slices at depths that grow exponentially; each cell has one
// sample and one ray of 32 steps to the sun; slices are summed with the light that each scatters integrated
// over it (Hillaire, Physically Based and Unified Volumetric Rendering in Frostbite, 2015); pixels are
// interpolated.
void DrawFroxels(const Scene& scene, int slices, Picture& picture)
{
  const int columns = 160;
  const int rows = 90;
  const double nearest = 2.0;
  const double farthest = 12.0;
  const auto getDepth = [&](double slice)
  { return nearest * std::pow(farthest / nearest, slice / slices); };
  // light that reaches the eye from before each slice's end
  std::vector<float> sums(static_cast<std::size_t>(columns) * rows * (slices + 1), 0.0f);
  vtkSMPTools::For(0, rows, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType j = first; j < last; ++j)
      {
        for (int i = 0; i < columns; ++i)
        {
          const double x =
            ((i + 0.5) * scene.Width / columns - 0.5 * scene.Width) * scene.GetPixelSize();
          const double y =
            ((j + 0.5) * scene.Height / rows - 0.5 * scene.Height) * scene.GetPixelSize();
          const Vec3 way(x, y, -1.0);
          const double perDepth = vtkGodRays::length(way);
          const double phase =
            vtkGodRays::Phase({ 2, Asymmetry }, vtkGodRays::dot(way, scene.ToSun) / perDepth);
          double through = 1.0;
          float* sum = sums.data() + (j * columns + i) * (slices + 1);
          for (int k = 0; k < slices; ++k)
          {
            const Vec3 world = getDepth(k + 0.5) * way;
            const Vec3 here = scene.Grid.GetPlace(world);
            const float extinction = scene.GetExtinction(here);
            sum[k + 1] = sum[k];
            if (extinction > 0.0f)
            {
              const double left =
                std::exp(-extinction * perDepth * (getDepth(k + 1.0) - getDepth(k)));
              if (scene.IsLit(world))
              {
                sum[k + 1] += static_cast<float>(through * (1.0 - left) / extinction *
                  GetSource(phase, extinction, MarchToSun(scene, here, 32)));
              }
              through *= left;
            }
          }
        }
      }
    });
  picture.resize(scene.Depths.size());
  vtkSMPTools::For(0, scene.Height, 16,
    [&](vtkIdType first, vtkIdType last)
    {
      const auto split = [](double at, int count, int& low, double& share)
      {
        at = std::min(std::max(at, 0.0), count - 1.0);
        low = std::min(static_cast<int>(at), count - 2);
        share = at - low;
      };
      for (vtkIdType row = first; row < last; ++row)
      {
        for (int column = 0; column < scene.Width; ++column)
        {
          const std::size_t pixel = scene.GetPixel(column, static_cast<int>(row));
          int low[3];
          double share[3];
          split((column + 0.5) * columns / scene.Width - 0.5, columns, low[0], share[0]);
          split((row + 0.5) * rows / scene.Height - 0.5, rows, low[1], share[1]);
          split(std::log(std::max<double>(scene.Depths[pixel] / nearest, 1.0)) * slices /
              std::log(farthest / nearest),
            slices + 1, low[2], share[2]);
          double value = 0.0;
          for (int corner = 0; corner < 8; ++corner)
          {
            double weight = 1.0;
            int at[3];
            for (int a = 0; a < 3; ++a)
            {
              at[a] = low[a] + (corner >> a & 1);
              weight *= corner >> a & 1 ? share[a] : 1.0 - share[a];
            }
            value += weight *
              sums[(static_cast<std::size_t>(at[1]) * columns + at[0]) * (slices + 1) + at[2]];
          }
          picture[pixel] = static_cast<float>(value);
        }
      }
    });
}

//------------------------------------------------------------------------------
/// Ours.
class Ours
{
public:
  Ours(const Scene& scene, bool hazy)
    : From(scene)
    , IsHazy(hazy)
    , Radiance(3 * scene.Depths.size())
    , Transmittance(3 * scene.Depths.size())
  {
    this->Forget();
  }

  /// As if nothing had been drawn yet.
  void Forget()
  {
    this->Drawer = std::make_unique<vtkGodRaysGridPicture>();
    this->Drawer->SetGrids({ this->From.Grid });
    this->Drawer->SetShadows(&this->From.Shadows);
  }

  void Draw(double tolerance)
  {
    Parameters parameters = this->IsHazy ? this->From.Hazy : this->From.Clear;
    parameters.Tolerance = tolerance;
    vtkGodRaysGridPicture::Picture picture;
    picture.Size[0] = this->From.Width;
    picture.Size[1] = this->From.Height;
    picture.PixelSize = this->From.GetPixelSize();
    picture.Center[0] = 0.5 * this->From.Width;
    picture.Center[1] = 0.5 * this->From.Height;
    picture.Depths = this->From.Depths.data();
    picture.Radiance = this->Radiance.data();
    picture.Transmittance = this->Transmittance.data();
    this->Drawer->Draw(parameters, picture);
  }

  void Get(Picture& picture) const
  {
    picture.resize(this->From.Depths.size());
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      picture[i] = this->Radiance[3 * i];
    }
  }

private:
  const Scene& From;
  bool IsHazy;
  std::unique_ptr<vtkGodRaysGridPicture> Drawer;
  Picture Radiance;
  Picture Transmittance;
};

#if HAS_SCATTERING_MAPPER
//------------------------------------------------------------------------------
/// VTK's volume mapper with all of its scattering in a volume, before a black terrain.
class Mapper
{
public:
  Mapper(Device& device, const Scene& scene)
    : OpenGL(device)
  {
    const double highest = scene.Smoke->GetScalarRange()[1];
    vtkNew<vtkPiecewiseFunction> opacity;
    for (int i = 0; i <= 256; ++i)
    {
      const double extinction = highest * i / 256.0;
      opacity->AddPoint(extinction, 1.0 - std::exp(-extinction));
    }
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
    white->AddRGBPoint(highest, 1.0, 1.0, 1.0);
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(scene.Smoke);
    mapper->SetVolumetricScatteringBlending(2.0f); // its own word for all of it
    mapper->SetGlobalIlluminationReach(1.0f);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->GetProperty()->SetScalarOpacity(opacity);
    volume->GetProperty()->SetScalarOpacityUnitDistance(1.0);
    volume->GetProperty()->SetColor(white);
    volume->GetProperty()->SetInterpolationTypeToLinear();
    volume->GetProperty()->ShadeOn();
    volume->GetProperty()->SetAmbient(0.0);
    volume->GetProperty()->SetDiffuse(1.0);
    volume->GetProperty()->SetSpecular(0.0);
    volume->GetProperty()->SetScatteringAnisotropy(static_cast<float>(Asymmetry));
    vtkNew<vtkPolyDataMapper> surface;
    surface->SetInputData(scene.Terrain);
    vtkNew<vtkActor> terrain;
    terrain->SetMapper(surface);
    terrain->GetProperty()->LightingOff();
    terrain->GetProperty()->SetColor(0.0, 0.0, 0.0);
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetPosition(scene.ToSun.x, scene.ToSun.y, scene.ToSun.z);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 0.0);
    camera->SetFocalPoint(0.0, 0.0, -1.0);
    camera->SetViewAngle(ViewAngle);
    camera->SetClippingRange(0.1, 100.0);
    this->Renderer->AddLight(light);
    this->Renderer->AddVolume(volume);
    this->Renderer->AddActor(terrain);
    device.GetWindow()->SetSize(scene.Width, scene.Height);
    device.GetWindow()->AddRenderer(this->Renderer);
  }
  ~Mapper() { this->OpenGL.GetWindow()->RemoveRenderer(this->Renderer); }
  Mapper(const Mapper&) = delete;
  void operator=(const Mapper&) = delete;

  void Draw(Picture& picture)
  {
    vtkRenderWindow* window = this->OpenGL.GetWindow();
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    const int* size = window->GetSize();
    window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    picture.resize(pixels->GetNumberOfTuples());
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      picture[i] = pixels->GetValue(3 * static_cast<vtkIdType>(i)) / 255.0f;
    }
  }

private:
  Device& OpenGL;
  vtkNew<vtkRenderer> Renderer;
};
#endif

//------------------------------------------------------------------------------
class DataErrors
{
public:
  DataErrors(Device& device, const DataErrorSettings& settings)
    : OpenGL(device)
    , Settings(settings)
    , Stage(settings.Quick ? 48 : 256, settings.Quick ? 160 : 1920, settings.Quick ? 90 : 1080,
        settings.Quick ? 512 : 1024)
    , Alone(Stage, false)
    , InHaze(Stage, true)
  {
#if HAS_SCATTERING_MAPPER
    this->Volume = std::make_unique<Mapper>(device, this->Stage);
#endif
    this->AddMethods();
  }

  void Measure();
  bool Check() const;
  std::string MakeTable() const;
  void WritePage() const;

private:
  void AddMethods();
  void FindTruth();
  double Compare(const Method& method, Picture picture) const;
  void WritePicture() const;

  Device& OpenGL;
  const DataErrorSettings& Settings;
  Scene Stage;
  Ours Alone;
  Ours InHaze;
#if HAS_SCATTERING_MAPPER
  std::unique_ptr<Mapper> Volume;
#endif
  std::vector<Method> Methods;
  struct Sample
  {
    std::size_t Pixel;
    double Alone;  // light of smoke
    double Change; // what smoke changes in haze
    double Hazy;   // light of both
  };
  std::vector<Sample> Truth;
  std::vector<Picture> Pictures; // of each method
  std::vector<double> Errors;
  std::vector<std::vector<double>> Marches; // of each method, in each round
};

//------------------------------------------------------------------------------
void DataErrors::AddMethods()
{
  const auto add = [this](const std::string& name, const std::string& series,
                     std::function<void(Picture&)> draw) -> Method&
  {
    this->Methods.emplace_back();
    this->Methods.back().Name = name;
    this->Methods.back().Series = series;
    this->Methods.back().Draw = std::move(draw);
    return this->Methods.back();
  };
  for (const int share : { 16, 64, 255, 1024 })
  {
    add("vtkGodRays, 1/" + std::to_string(share), "vtkGodRays",
      [this, share](Picture& picture)
      {
        this->Alone.Draw(1.0 / share);
        this->Alone.Get(picture);
      });
  }
  add("vtkGodRays, 1/255, first picture", "vtkGodRays, first",
    [this](Picture& picture)
    {
      this->Alone.Forget();
      this->Alone.Draw(1.0 / 255.0);
      this->Alone.Get(picture);
    });
  add("vtkGodRays, 1/255, in haze", "vtkGodRays, in haze",
    [this](Picture& picture)
    {
      this->InHaze.Draw(1.0 / 255.0);
      this->InHaze.Get(picture);
    })
    .IsHazy = true;
  for (const int slices : { 64, 128 })
  {
    add("froxels, 160 x 90 x " + std::to_string(slices), "froxels",
      [this, slices](Picture& picture) { DrawFroxels(this->Stage, slices, picture); });
  }
  for (const int steps : { 64, 256, 1024 })
  {
    const int stride = this->Settings.Quick ? 1 : steps / 16;
    Method& march = add("march, " + std::to_string(steps) + " steps", "march with shadow rays",
      [this, steps, stride](Picture& picture) { March(this->Stage, steps, stride, picture); });
    const int rows = (this->Stage.Height + stride - 1) / stride;
    march.Share = static_cast<double>(rows) / this->Stage.Height;
  }
#if HAS_SCATTERING_MAPPER
  add("VTK's volume mapper, scattering", "VTK's volume mapper",
    [this](Picture& picture) { this->Volume->Draw(picture); })
    .IsFitted = true;
#endif
}

//------------------------------------------------------------------------------
void DataErrors::FindTruth()
{
  vtkGodRaysSingleScattering exact[3]; // smoke, haze, both
  for (int i = 0; i < 3; ++i)
  {
    Parameters parameters = i == 0 ? this->Stage.Clear : this->Stage.Hazy;
    parameters.Tolerance = 1e-5;
    exact[i].SetParameters(parameters);
    exact[i].SetOccluders(this->Stage.Terrain);
    if (i != 1)
    {
      exact[i].SetGrids({ this->Stage.Grid });
    }
  }
  // Rows that are multiples of 64, which all methods draw.
  const int rows = this->Settings.Quick ? 4 : 64;
  const int columns = this->Settings.Quick ? 5 : 13;
  for (int row = 0; row < this->Stage.Height; row += rows)
  {
    for (int column = row / rows % columns; column < this->Stage.Width; column += columns)
    {
      this->Truth.push_back({ this->Stage.GetPixel(column, row), 0.0, 0.0, 0.0 });
    }
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Truth.size()), 8,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Sample& sample = this->Truth[i];
        const int column = static_cast<int>(sample.Pixel % this->Stage.Width);
        const int row = static_cast<int>(sample.Pixel / this->Stage.Width);
        vtkGodRaysSingleScattering::Result ray[3];
        for (int k = 0; k < 3; ++k)
        {
          exact[k].Evaluate(this->Stage.GetX(column), this->Stage.GetY(row), ray[k],
            this->Stage.Depths[sample.Pixel]);
        }
        sample.Alone = ray[0].Radiance[0];
        sample.Change = ray[2].Radiance[0] - ray[1].Radiance[0];
        sample.Hazy = ray[2].Radiance[0];
      }
    });
}

//------------------------------------------------------------------------------
// Root mean square, as a fraction of the peak of the light.
double DataErrors::Compare(const Method& method, Picture picture) const
{
  const auto get = [&](const Sample& sample)
  { return method.IsHazy ? sample.Change : sample.Alone; };
  double factor = 1.0;
  if (method.IsFitted)
  {
    double product = 0.0;
    double square = 0.0;
    for (const Sample& sample : this->Truth)
    {
      product += picture[sample.Pixel] * get(sample);
      square += static_cast<double>(picture[sample.Pixel]) * picture[sample.Pixel];
    }
    factor = product / square;
  }
  double squares = 0.0;
  double peak = 0.0;
  for (const Sample& sample : this->Truth)
  {
    squares += std::pow(factor * picture[sample.Pixel] - get(sample), 2);
    peak = std::max(peak, method.IsHazy ? sample.Hazy : sample.Alone);
  }
  return std::sqrt(squares / this->Truth.size()) / peak;
}

//------------------------------------------------------------------------------
void DataErrors::Measure()
{
  this->FindTruth();
  this->OpenGL.PrepareUnits(this->Stage.Width, this->Stage.Height);
  this->Pictures.resize(this->Methods.size());
  std::vector<RoundsItem> items;
  items.push_back({ "march", [&] { return this->OpenGL.MeasureMarch(); }, {} });
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    items.push_back({ this->Methods[i].Name,
      [this, i]
      {
        const Method& method = this->Methods[i];
        const auto draw = [&] { method.Draw(this->Pictures[i]); };
        return (method.IsFitted ? this->OpenGL.Measure(draw) : Seconds(draw)) / method.Share;
      },
      {} });
  }
  MeasureRounds("data error", items, this->Settings.Quick ? 1 : 5);
  const auto unit = GetSeconds(items, "march");
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    this->Marches.push_back(Statistics::Divide(GetSeconds(items, this->Methods[i].Name), unit));
    this->Errors.push_back(this->Compare(this->Methods[i], this->Pictures[i]));
  }
}

//------------------------------------------------------------------------------
std::string DataErrors::MakeTable() const
{
  std::ostringstream text;
  text << "| method | RMSE | marches |\n|---|---|---|\n";
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    char row[160];
    std::snprintf(row, sizeof(row), "| %s | %.4f | %.3g |\n", this->Methods[i].Name.c_str(),
      this->Errors[i], Statistics::GetMedian(this->Marches[i]));
    text << row;
  }
  return text.str();
}

//------------------------------------------------------------------------------
bool DataErrors::Check() const
{
  std::printf("\n%s\n", this->MakeTable().c_str());
  double ours = 0.0;
  double coarse = 0.0;
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    if (this->Methods[i].Name == "vtkGodRays, 1/255" || this->Methods[i].IsHazy)
    {
      ours = std::max(ours, this->Errors[i]);
    }
    if (this->Methods[i].Name == "froxels, 160 x 90 x 64")
    {
      coarse = this->Errors[i]; // the control
    }
  }
  const bool kept = ours < 1.0 / 255.0 && coarse > 1.0 / 255.0;
  if (!kept)
  {
    std::printf(
      "our error, %g, should be below 1/255, and that of froxels, %g, above\n", ours, coarse);
  }
  return kept;
}

//------------------------------------------------------------------------------
// Ours, froxels and, where there is one, VTK's mapper, each as bright as its largest value makes it.
void DataErrors::WritePicture() const
{
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    const std::string& name = this->Methods[i].Name;
    if (name == "vtkGodRays, 1/255" || name == "froxels, 160 x 90 x 64" ||
      this->Methods[i].IsFitted)
    {
      shown.push_back(i);
    }
  }
  const int scale = this->Settings.Quick ? 1 : 3;
  const int width = this->Stage.Width / scale;
  const int height = this->Stage.Height / scale;
  const int gap = 4;
  const int all = static_cast<int>(shown.size()) * (width + gap) - gap;
  vtkNew<vtkImageData> image;
  image->SetDimensions(all, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill_n(pixels, image->GetNumberOfPoints(), static_cast<unsigned char>(255));
  for (std::size_t p = 0; p < shown.size(); ++p)
  {
    const Picture& picture = this->Pictures[shown[p]];
    const float white = *std::max_element(picture.begin(), picture.end());
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        const float value = picture[this->Stage.GetPixel(x * scale, y * scale)];
        pixels[static_cast<std::size_t>(y) * all + p * (width + gap) + x] =
          static_cast<unsigned char>(
            std::lround(255.0 * vtkGodRays::EncodeDisplay(std::max(0.0f, value / white))));
      }
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName((this->Settings.Folder + "/Gallery/data-error.png").c_str());
  writer->Write();
}

//------------------------------------------------------------------------------
void DataErrors::WritePage() const
{
  const std::string& folder = this->Settings.Folder;
  Chart chart;
  chart.Title = "Smoke of 256 x 256 x 256 points, 1920 x 1080";
  chart.XTitle = "time of a picture (marches of 60 taps)";
  chart.YTitle = "RMSE against single scattering (fraction of the peak)";
  for (std::size_t i = 0; i < this->Methods.size(); ++i)
  {
    const Method& method = this->Methods[i];
    if (chart.Series.empty() || chart.Series.back().Name != method.Series)
    {
      chart.Series.push_back({ method.Series, {}, {}, {} });
    }
    chart.Series.back().X.push_back(Statistics::GetMedian(this->Marches[i]));
    chart.Series.back().Y.push_back(this->Errors[i]);
    chart.Series.back().Labels.push_back(method.Name);
  }
  WriteChart(chart, folder + "/Charts/data-error.png");
  this->WritePicture();
  std::ofstream page(folder + "/DataError.md");
  page
    << "# Data error\n\nWritten by `" << this->Settings.Command
    << "`.\n\n"
       "How far pictures of a medium of data are from single scattering, and what they cost. The "
       "scene is smoke of\n256 x 256 x 256 points over hills, half in the shadow of a ridge, lit "
       "by "
       "a sun. The truth is\n`vtkGodRaysSingleScatteringReference`, to 1e-5; errors are root mean "
       "squares over "
    << this->Truth.size() << " pixels of 1920 x 1080,\nas fractions of the peak. The unit of time "
    << "is the bare march of 60 bilinear taps of a picture of that size, measured\nin the same "
       "rounds; medians of five. Two threads; OpenGL: "
    << this->OpenGL.GetRendererName() << "; VTK " << VTK_MAJOR_VERSION << "." << VTK_MINOR_VERSION
    << ".\n\n"
       "- *vtkGodRays*: `vtkGodRaysGridPicture` by its tolerance; the first picture includes the "
       "light's depths through\n  the data, which are kept. *In haze*: beside a homogeneous "
       "medium, "
       "whose own light is not counted.\n"
       "- *froxels*: one sample and one ray of 32 steps to the sun in each cell of the view.\n"
       "- *march*: equal steps through the data's box, each with a ray of an eighth as many to the "
       "sun, at least 8. Every\n  4th to 64th row is drawn, and the time is that of all.\n"
       "- *VTK's volume mapper*: all of its scattering, reach 1. It has no unit, so its picture is "
       "times what makes its\n  error least; it sees no shadow of the hills. Ours and the other "
       "two "
       "run on the processor, it on OpenGL.\n\n"
       "All are given the depths of the hills and their shadow map, whose making is not "
       "counted.\n\n![Data error against cost](Charts/data-error.png)\n\n"
    << this->MakeTable()
    << "\nOurs, froxels of 64 slices, and VTK's mapper where this VTK scatters:\n\n"
       "![Smoke](Gallery/data-error.png)\n";
  page.close();
  SealPage(folder + "/DataError.md");
}
}

//------------------------------------------------------------------------------
bool MeasureDataErrors(Device& device, const DataErrorSettings& settings)
{
  DataErrors errors(device, settings);
  errors.Measure();
  const bool kept = errors.Check();
  if (!settings.Folder.empty())
  {
    errors.WritePage();
  }
  return kept;
}
