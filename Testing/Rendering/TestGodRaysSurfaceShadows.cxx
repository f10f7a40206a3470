// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Shadows on surfaces against rays that are cast at the triangles. What a picture should show is what it
// shows with the light off, and the more that the light adds times how much of it rays see: whatever VTK's
// shading does drops out.

#include "GodRaysTesting.h"

#include "vtkGodRaysHomogeneousModel.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysTriangleTree.h"

#include "vtkAppendPolyData.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkEDLShading.h"
#include "vtkElevationFilter.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPointSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#if __has_include("vtkCompositePolyDataMapper2.h")
#include "vtkCompositePolyDataMapper2.h"
using BlockMapper = vtkCompositePolyDataMapper2;
#else
#include "vtkCompositePolyDataMapper.h"
using BlockMapper = vtkCompositePolyDataMapper;
#endif

#if __has_include("vtkLODActor.h")
#include "vtkLODActor.h"
#else // ParaView's VTK has none
using vtkLODActor = vtkActor;
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace GodRaysTesting;

namespace
{
using vtkGodRays::Vec3;
using Pixels = std::vector<unsigned char>;

Vec3 GetVector(const double* values)
{
  return { values[0], values[1], values[2] };
}

/// Casts rays at what actors show.
class RayCaster
{
public:
  explicit RayCaster(const std::vector<vtkActor*>& actors)
    : Tree(Join(actors))
  {
  }

  /// Returns whether a ray hits before from + reach * along; sets reach to the nearest hit, and the normal.
  bool Hit(const Vec3& from, const Vec3& along, double& reach, Vec3* facet = nullptr) const
  {
    const Vec3 inverse = 1.0 / along;
    const Vec3 aside = cross(
      along, std::abs(along.x) < std::abs(along.y) ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0));
    const Vec3 normal = normalize(aside);
    bool found = false;
    const auto misses = [&](const Vec3& centre, const Vec3& half)
    {
      const Vec3 middle = (centre - from) * inverse;
      const Vec3 reaches = (1.0 + 1e-12) * half * abs(inverse);
      const Vec3 first = middle - reaches;
      const Vec3 last = middle + reaches;
      return std::max({ first.x, first.y, first.z, 0.0 }) >
        std::min({ last.x, last.y, last.z, reach }) * (1.0 + 1e-9);
    };
    const auto visit = [&](const vtkGodRays::Triangle& triangle)
    {
      const Vec3 one = triangle[1] - triangle[0];
      const Vec3 other = triangle[2] - triangle[0];
      const Vec3 p = cross(along, other);
      const Vec3 s = from - triangle[0];
      const Vec3 q = cross(s, one);
      const double determinant = dot(one, p);
      const double u = dot(s, p) / determinant;
      const double v = dot(along, q) / determinant;
      const double t = dot(other, q) / determinant;
      if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < reach)
      {
        found = true;
        reach = t;
        if (facet)
        {
          *facet = normalize(cross(one, other));
        }
      }
    };
    this->Tree.Find(normal, dot(normal, from), misses, visit);
    return found;
  }

private:
  static vtkSmartPointer<vtkPolyData> Join(const std::vector<vtkActor*>& actors)
  {
    vtkNew<vtkAppendPolyData> all;
    for (vtkActor* actor : actors)
    {
      actor->GetMapper()->Update();
      vtkNew<vtkTransform> toWorld;
      toWorld->SetMatrix(actor->GetMatrix());
      vtkNew<vtkTransformFilter> placed;
      placed->SetInputData(actor->GetMapper()->GetInput());
      placed->SetTransform(toWorld);
      all->AddInputConnection(placed->GetOutputPort());
    }
    all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    all->Update();
    return all->GetOutput();
  }

  vtkGodRays::TriangleTree Tree;
};

/// Holds what a pixel shows, and how much of a light reaches it there; Facet points towards the eye.
struct Seen
{
  Vec3 Place;
  Vec3 Facet;
  double Visibility = -1.0; // nothing is seen
  bool IsData = false;      // shadows take only a part of the light
};

/// Casts a ray through each pixel of a renderer's part of its window.
std::vector<Seen> Look(vtkRenderer* renderer, const RayCaster& rays)
{
  const int* size = renderer->GetRenderWindow()->GetSize();
  const int* origin = renderer->GetOrigin();
  const int* part = renderer->GetSize();
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vec3 eye = GetVector(camera->GetPosition());
  const double distance = camera->GetDistance();
  const Vec3 ahead = distance * GetVector(camera->GetDirectionOfProjection());
  const Vec3 right = normalize(cross(ahead, GetVector(camera->GetViewUp())));
  const Vec3 up = normalize(cross(right, ahead));
  const bool isParallel = camera->GetParallelProjection() != 0;
  double wide = 1.0;
  if (auto* transform = camera->GetUserViewTransform())
  {
    wide = transform->GetMatrix()->GetElement(0, 0);
  }
  const double half = isParallel
    ? camera->GetParallelScale()
    : distance * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  std::vector<Seen> seen(static_cast<std::size_t>(size[0]) * size[1]);
  for (int y = 0; y < part[1]; ++y)
  {
    for (int x = 0; x < part[0]; ++x)
    {
      const Vec3 across = half / part[1] *
        ((2.0 * x + 1.0 - part[0]) / wide * right + (2.0 * y + 1.0 - part[1]) * up);
      const Vec3 from = isParallel ? eye + across : eye;
      const Vec3 along = isParallel ? ahead : ahead + across;
      Seen& pixel = seen[static_cast<std::size_t>(origin[1] + y) * size[0] + origin[0] + x];
      double reach = 100.0;
      if (rays.Hit(from, along, reach, &pixel.Facet))
      {
        pixel.Place = from + reach * along;
        pixel.Facet *= dot(pixel.Facet, along) > 0.0 ? -1.0 : 1.0;
        pixel.Visibility = 1.0;
      }
    }
  }
  return seen;
}

/// Casts a ray from each pixel's place to a light, or to places of its disc: of a radius, or, for a sun, of
/// its tangent.
void LookAtLight(std::vector<Seen>& seen, const RayCaster& rays, vtkLight* light, double size,
  double most = 1.0, double radius = 0.0)
{
  double values[3];
  light->GetTransformedPosition(values);
  const Vec3 position = GetVector(values);
  light->GetTransformedFocalPoint(values);
  const Vec3 sun = 100.0 * size * normalize(position - GetVector(values));
  const int samples = radius > 0.0 ? 64 : 1;
  for (Seen& pixel : seen)
  {
    if (pixel.Visibility >= 0.0)
    {
      const Vec3 middle = light->GetPositional() ? position - pixel.Place : sun;
      const Vec3 right = normalize(
        cross(middle, std::abs(middle.x) < std::abs(middle.y) ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
      const Vec3 up = normalize(cross(right, middle));
      const double rim = radius * (light->GetPositional() ? 1.0 : length(middle));
      double dark = 0.0;
      for (int i = 0; i < samples; ++i)
      {
        const double part = rim * std::sqrt((i + 0.5) / samples);
        const Vec3 along = middle + part * (std::cos(2.4 * i) * right + std::sin(2.4 * i) * up);
        double reach = 1.0;
        dark += dot(pixel.Facet, along) <= 0.0 ||
            rays.Hit(pixel.Place + 1e-6 * size * pixel.Facet, along, reach)
          ? 1.0 / samples
          : 0.0;
      }
      pixel.Visibility = 1.0 - dark * (pixel.IsData ? most : 1.0);
    }
  }
}

/// Pixels that are off by more than 2 levels [%]: all, darker or brighter beyond 2 pixels from the edges of
/// the true shadow. With things, edges of those count, too.
struct Errors
{
  double Off = 0.0, Acne = 0.0, Leak = 0.0;
};

Errors Compare(const std::vector<Seen>& seen, int width, const Pixels& on, const Pixels& off,
  const Pixels& got, bool hasThings = false)
{
  const int height = static_cast<int>(seen.size()) / width;
  const auto isNearEdge = [&](int x, int y)
  {
    const Seen& here = seen[static_cast<std::size_t>(y) * width + x];
    for (int j = std::max(y - 2, 0); j <= std::min(y + 2, height - 1); ++j)
    {
      for (int i = std::max(x - 2, 0); i <= std::min(x + 2, width - 1); ++i)
      {
        const Seen& there = seen[static_cast<std::size_t>(j) * width + i];
        const bool isOther = (there.Visibility >= 0.0 && there.Visibility != here.Visibility) ||
          (hasThings && (there.Visibility < 0.0 || there.IsData != here.IsData));
        if (isOther)
        {
          return true;
        }
      }
    }
    return false;
  };
  Errors errors;
  int pixels = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const double part = seen[i].Visibility;
    if (part < 0.0)
    {
      continue;
    }
    ++pixels;
    double worst = 0.0;
    for (std::size_t k = 4 * i; k < 4 * i + 3; ++k)
    {
      const double error = got[k] - (off[k] + part * (on[k] - off[k]));
      worst = std::abs(error) > std::abs(worst) ? error : worst;
    }
    if (std::abs(worst) > 2.0)
    {
      errors.Off += 1.0;
      if (!isNearEdge(static_cast<int>(i) % width, static_cast<int>(i) / width))
      {
        (worst < 0.0 ? errors.Acne : errors.Leak) += 1.0;
      }
    }
  }
  for (double* count : { &errors.Off, &errors.Acne, &errors.Leak })
  {
    *count *= 100.0 / std::max(pixels, 1);
  }
  return errors;
}

vtkSmartPointer<vtkActor> MakeActor(vtkAlgorithm* source, bool smooth)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  smooth ? property->SetInterpolationToGouraud() : property->SetInterpolationToFlat();
  property->SetAmbient(0.15);
  property->SetDiffuse(0.8);
  return actor;
}

vtkSmartPointer<vtkPlaneSource> MakeGround(double half, int resolution = 1)
{
  auto ground = vtkSmartPointer<vtkPlaneSource>::New();
  ground->SetOrigin(-half, -half, 0.0);
  ground->SetPoint1(half, -half, 0.0);
  ground->SetPoint2(-half, half, 0.0);
  ground->SetResolution(resolution, resolution);
  return ground;
}

/// A scene with shadows, without rays. Its light is the renderer's only one.
struct Shadows : Stage
{
  vtkSmartPointer<vtkLight> Light = MakeSun({ -3.0, -2.0, 6.0 });

  Shadows(int width, int height)
    : Stage(width, height)
  {
    this->Renderer->AddLight(this->Light);
    this->Rays->SetIntensity(0.0);
    this->Rays->SurfaceShadowsOn();
    this->Rays->SoftShadowsOff();
    this->Rays->SetMostDataShadow(1.0);
    this->Rays->Attach(this->Renderer);
  }

  Pixels Draw(bool shadows = true, double intensity = 1.0)
  {
    this->Rays->SetSurfaceShadows(shadows);
    this->Light->SetIntensity(intensity);
    auto pixels = GetPixels(this->Window);
    this->Light->SetIntensity(1.0);
    return pixels;
  }
};

// ---------------------------------------------------------------------------------------------
// Against rays

enum SceneKind
{
  PILLARS,
  HILLS,
  PLATES
};

struct Landscape : Shadows
{
  std::vector<vtkActor*> Actors;

  vtkActor* Add(vtkSmartPointer<vtkActor> actor)
  {
    this->Renderer->AddActor(actor);
    this->Actors.push_back(actor);
    return actor;
  }

  void AddBox(std::array<double, 3> low, std::array<double, 3> high)
  {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(low[0], high[0], low[1], high[1], low[2], high[2]);
    this->Add(MakeActor(box, false));
  }

  /// Adds a smooth sheet of so many quadrilaterals.
  vtkActor* AddSheet(int across, int along, const std::function<Vec3(double, double)>& bend)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetResolution(across, along);
    plane->SetOrigin(0.0, 0.0, 0.0);
    plane->SetPoint1(1.0, 0.0, 0.0);
    plane->SetPoint2(0.0, 1.0, 0.0);
    plane->Update();
    vtkNew<vtkPolyData> sheet;
    sheet->DeepCopy(plane->GetOutput());
    sheet->GetPointData()->SetNormals(nullptr);
    for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i)
    {
      const double* p = sheet->GetPoint(i);
      const Vec3 place = bend(p[0], p[1]);
      sheet->GetPoints()->SetPoint(i, place.x, place.y, place.z);
    }
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(sheet);
    normals->SplittingOff();
    return this->Add(MakeActor(normals, true));
  }

  explicit Landscape(SceneKind kind)
    : Shadows(320, 240)
  {
    if (kind == HILLS)
    {
      this->AddSheet(120, 120,
        [](double u, double v)
        {
          const Vec3 p(20.0 * u - 10.0, 20.0 * v - 10.0, 0.0);
          const double hill = 1.6 * std::exp(-0.4 * (std::pow(p.x - 2.0, 2.0) + p.y * p.y));
          return Vec3(p.x, p.y,
            1.2 * std::sin(0.9 * p.x) * std::cos(0.7 * p.y) +
              0.35 * std::sin(2.3 * p.x + 1.7 * p.y) + hill);
        });
    }
    else
    {
      this->Add(MakeActor(MakeGround(10.0), false));
    }
    if (kind == PILLARS)
    {
      for (double x = -6.0; x < 6.5; x += 2.4)
      {
        this->AddBox({ x, -0.3, 0.0 }, { x + 0.6, 0.3, 5.0 });
      }
      this->AddBox({ -7.0, -0.5, 5.0 }, { 7.0, 0.5, 5.5 });
      vtkNew<vtkSphereSource> sphere;
      sphere->SetRadius(1.5);
      sphere->SetCenter(3.0, -4.0, 1.5);
      sphere->SetThetaResolution(64);
      sphere->SetPhiResolution(64);
      this->Add(MakeActor(sphere, true));
    }
    if (kind == PLATES)
    {
      vtkActor* torus = this->AddSheet(96, 48,
        [](double u, double v)
        {
          const double turn = 2.0 * vtkMath::Pi() * u;
          const double tube = 2.0 * vtkMath::Pi() * v;
          const double radius = 2.5 + 0.5 * std::cos(tube);
          return Vec3(radius * std::cos(turn), radius * std::sin(turn), 0.5 * std::sin(tube));
        });
      torus->SetPosition(0.0, -1.0, 3.0);
      torus->RotateX(40.0);
      for (double i = 0.0; i < 4.5; i += 1.0)
      {
        this->AddBox({ -8.0 + 0.1 * i, -3.0 + 1.2 * i, 0.4 * (i + 1.0) },
          { -4.0 + 0.1 * i, -2.0 + 1.2 * i, 0.4 * (i + 1.0) + 0.03 });
      }
      for (double y = -4.0; y < 4.5; y += 1.0)
      {
        this->AddBox({ 4.0, y, 0.0 }, { 8.0, y + 0.04, 2.0 });
      }
    }
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(9.0, -16.0, 9.0);
    camera->SetFocalPoint(0.0, 0.0, 1.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(45.0);
    this->Renderer->ResetCameraClippingRange();
  }
};

/// Bounds of errors: of 12 suns the mean and the worst; of two lamps and a spotlight, the worst.
struct Case
{
  const char* Name;
  SceneKind Kind;
  Errors Mean, Worst, Lamps;
  double Soft; // root mean square of soft shadows [levels]
};

const Case Cases[] = {
  { "pillars", PILLARS, { 0.3, 0.01, 0.01 }, { 0.7, 0.02, 0.01 }, { 0.6, 0.01, 0.01 }, 3.5 },
  { "hills", HILLS, { 0.5, 0.02, 0.03 }, { 1.0, 0.05, 0.15 }, { 1.0, 0.05, 0.02 }, 3.5 },
  { "plates", PLATES, { 0.25, 0.01, 0.01 }, { 0.5, 0.03, 0.03 }, { 0.7, 0.01, 0.04 }, 5.5 },
};

void ExpectBelow(const char* what, const Errors& errors, const Errors& bounds)
{
  std::printf(
    "%s: off %.3f %%, acne %.4f %%, leaks %.4f %%\n", what, errors.Off, errors.Acne, errors.Leak);
  EXPECT_LT(errors.Off, bounds.Off) << what;
  EXPECT_LT(errors.Acne, bounds.Acne) << what;
  EXPECT_LT(errors.Leak, bounds.Leak) << what;
}

void PrintTo(const Case& scene, std::ostream* os)
{
  *os << scene.Name;
}

class GodRaysSurfaceShadowsTruth : public ::testing::TestWithParam<Case>
{
};
}

TEST_P(GodRaysSurfaceShadowsTruth, IsNear)
{
  constexpr int suns = 12;
  Messages messages;
  Landscape scene(GetParam().Kind);
  const RayCaster rays(scene.Actors);
  std::vector<Seen> seen = Look(scene.Renderer, rays);
  Errors mean;
  Errors worst;
  double without = 0.0;
  const auto measure = [&]
  {
    const Pixels on = scene.Draw(false);
    const Pixels off = scene.Draw(false, 0.0);
    LookAtLight(seen, rays, scene.Light, 20.0);
    const Errors errors = Compare(seen, 320, on, off, scene.Draw());
    without += Compare(seen, 320, on, off, on).Off / suns;
    for (double Errors::*part : { &Errors::Off, &Errors::Acne, &Errors::Leak })
    {
      mean.*part += errors.*part / suns;
      worst.*part = std::max(worst.*part, errors.*part);
    }
  };
  std::mt19937 random(20260101);
  const auto draw = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int i = 0; i < suns; ++i)
  {
    const double azimuth = 2.0 * vtkMath::Pi() * draw();
    const double elevation = vtkMath::RadiansFromDegrees(3.0 + 84.0 * draw());
    scene.Light->SetPosition(std::cos(azimuth) * std::cos(elevation),
      std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
    measure();
  }
  EXPECT_GT(without, 5.0) << "no shadow would pass, too";
  ExpectBelow("12 suns, mean", mean, GetParam().Mean);
  ExpectBelow("12 suns, worst", worst, GetParam().Worst);
  worst = {};
  scene.Light->PositionalOn();
  scene.Light->SetFocalPoint(0.0, 0.0, 1.0);
  for (const Vec3& place : { Vec3(0.9, -2.5, 3.4), Vec3(-3.0, 2.5, 4.2), Vec3(-6.0, -8.0, 9.0) })
  {
    scene.Light->SetPosition(place.x, place.y, place.z);
    scene.Light->SetConeAngle(place.z > 5.0 ? 30.0 : 180.0);
    measure();
  }
  ExpectBelow("two lamps and a spotlight, worst", worst, GetParam().Lamps);
}

TEST_P(GodRaysSurfaceShadowsTruth, IsNearOfADisc)
{
  Messages messages;
  Landscape scene(GetParam().Kind);
  const RayCaster rays(scene.Actors);
  const std::vector<Seen> seen = Look(scene.Renderer, rays);
  const auto measure = [&](double radius, const char* what)
  {
    std::vector<Seen> lit = seen;
    scene.Rays->SetSoftShadows(true);
    const Pixels on = scene.Draw(false);
    const Pixels off = scene.Draw(false, 0.0);
    const Pixels soft = scene.Draw();
    scene.Rays->SetSoftShadows(false);
    const Pixels hard = scene.Draw();
    LookAtLight(lit, rays, scene.Light, 20.0, 1.0, radius);
    double squares[2] = {};
    int count = 0;
    for (std::size_t i = 0; i < lit.size(); ++i)
    {
      for (std::size_t k = 4 * i; lit[i].Visibility >= 0.0 && k < 4 * i + 3; ++k, ++count)
      {
        const double truth = off[k] + lit[i].Visibility * (on[k] - off[k]);
        squares[0] += (soft[k] - truth) * (soft[k] - truth);
        squares[1] += (hard[k] - truth) * (hard[k] - truth);
      }
    }
    const double error = std::sqrt(squares[0] / count);
    std::printf("%s: %.2f levels, hard %.2f\n", what, error, std::sqrt(squares[1] / count));
    EXPECT_LT(error, GetParam().Soft) << what;
  };
  scene.Light->SetPosition(-0.63, -0.44, 0.64);
  for (const double degrees : { 0.2678, 1.0, 3.0 })
  {
    scene.Rays->SetSunAngularRadius(degrees);
    measure(std::tan(vtkMath::RadiansFromDegrees(degrees)),
      ("a sun of " + std::to_string(degrees) + " degrees").c_str());
  }
  scene.Light->PositionalOn();
  scene.Light->SetConeAngle(180.0);
  scene.Light->SetPosition(-3.0, 2.5, 4.2);
  scene.Rays->SetSourceRadius(0.3);
  measure(0.3, "a lamp of 0.3");
}

INSTANTIATE_TEST_SUITE_P(Scenes, GodRaysSurfaceShadowsTruth, ::testing::ValuesIn(Cases),
  [](const auto& info) { return std::string(info.param.Name); });

// ---------------------------------------------------------------------------------------------
// Mappers, props, passes and windows

namespace
{
/// A plate over a floor. Rays are cast at the two as they are here, whatever shows them.
struct Zoo : Shadows
{
  vtkNew<vtkCubeSource> PlateSource;
  vtkSmartPointer<vtkPlaneSource> Ground = MakeGround(5.0, 12);
  vtkSmartPointer<vtkActor> Plate = MakeActor(PlateSource, false);
  vtkSmartPointer<vtkActor> Floor = MakeActor(Ground, true);
  vtkPolyDataMapper* Mapper = vtkPolyDataMapper::SafeDownCast(Floor->GetMapper());
  vtkProperty* Property = Floor->GetProperty();
  vtkCamera* Camera = this->Renderer->GetActiveCamera();
  double Size = 1.0;
  double Most = 1.0; // of a light, that shadows take of the floor
  vtkSmartPointer<vtkRenderPass> Others;

  Zoo()
    : Shadows(200, 150)
  {
    this->Place(1.0);
    this->Camera->SetParallelScale(4.0);
    this->Property->SetColor(0.9, 0.8, 0.6);
    this->Renderer->AddActor(this->Plate);
    this->Renderer->AddActor(this->Floor);
    this->Renderer->ResetCameraClippingRange();
  }

  void Spread(double half)
  {
    this->Ground->SetOrigin(-half, -half, 0.0);
    this->Ground->SetPoint1(half, -half, 0.0);
    this->Ground->SetPoint2(-half, half, 0.0);
  }

  void Place(double size, double east = 0.0)
  {
    this->Size = size;
    const auto at = [&](double x, double y, double z) {
      return std::array<double, 3>{ east + size * x, size * y, size * z };
    };
    this->PlateSource->SetCenter(at(0.0, 0.0, 2.05).data());
    this->PlateSource->SetXLength(3.0 * size);
    this->PlateSource->SetYLength(2.0 * size);
    this->PlateSource->SetZLength(0.1 * size);
    this->Ground->SetOrigin(at(-5.0, -5.0, 0.0).data());
    this->Ground->SetPoint1(at(5.0, -5.0, 0.0).data());
    this->Ground->SetPoint2(at(-5.0, 5.0, 0.0).data());
    this->Light->SetPosition(at(-3.0, -2.0, 6.0).data());
    this->Light->SetFocalPoint(at(0.0, 0.0, 0.0).data());
    this->Camera->SetPosition(at(3.0, -9.0, 7.0).data());
    this->Camera->SetFocalPoint(at(0.0, 0.0, 0.0).data());
    this->Camera->SetViewUp(0.0, 0.0, 1.0);
  }

  /// Makes the light positional: from 90 degrees on it has no cone.
  void SetLamp(double angle, double x = -3.0, double y = -2.0, double z = 6.0)
  {
    this->Light->PositionalOn();
    this->Light->SetConeAngle(angle);
    this->Light->SetPosition(x, y, z);
  }

  /// Takes another actor for the floor, with the mapper and properties of the one before.
  void SetFloor(vtkSmartPointer<vtkActor> actor)
  {
    this->Renderer->RemoveActor(this->Floor);
    actor->SetMapper(this->Mapper);
    actor->SetProperty(this->Property);
    this->Floor = actor;
    this->Renderer->AddActor(actor);
  }

  /// Replaces an actor by an assembly of it.
  void Assemble(vtkActor* actor)
  {
    vtkNew<vtkAssembly> assembly;
    assembly->AddPart(actor);
    this->Renderer->RemoveActor(actor);
    this->Renderer->AddActor(assembly);
  }

  static vtkSmartPointer<vtkTexture> MakeTexture(bool isSRGB)
  {
    vtkNew<vtkImageData> checks;
    checks->SetDimensions(16, 16, 1);
    checks->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* first = static_cast<unsigned char*>(checks->GetScalarPointer());
    for (int i = 0; i < 768; ++i)
    {
      first[i] = (i / 3 % 16 / 2 + i / 96) % 2 == 0 ? 120 : 250;
    }
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(checks);
    texture->SetUseSRGBColorSpace(isSRGB);
    return texture;
  }

  vtkPolyData* ColorByScalars(double most)
  {
    vtkNew<vtkElevationFilter> heights;
    heights->SetInputConnection(this->Ground->GetOutputPort());
    heights->SetLowPoint(-5.0, 0.0, 0.0);
    heights->SetHighPoint(5.0, 0.0, 0.0);
    this->Mapper->SetInputConnection(heights->GetOutputPort());
    this->Mapper->Update();
    this->Rays->SetMostDataShadow(most);
    this->Most = most;
    return this->Mapper->GetInput();
  }

  /// Shows a source at points by glyphs.
  static void SetGlyphs(vtkActor* actor, vtkPolyData* points, vtkAlgorithm* source)
  {
    vtkNew<vtkGlyph3DMapper> glyphs;
    glyphs->SetInputData(points);
    glyphs->SetSourceConnection(source->GetOutputPort());
    glyphs->ScalingOff();
    glyphs->OrientOff();
    actor->SetMapper(glyphs);
  }

  static vtkSmartPointer<vtkPolyData> MakePoint()
  {
    vtkNew<vtkPointSource> point; // in (0, 0, 0)
    point->SetNumberOfPoints(1);
    point->SetRadius(0.0);
    point->Update();
    return point->GetOutput();
  }

  static void SetBlock(vtkActor* actor, vtkPolyData* data)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(1, data);
    vtkNew<BlockMapper> mapper;
    mapper->SetInputDataObject(blocks);
    actor->SetMapper(mapper);
  }

  /// Has a pass on the renderer before the rays.
  void SetPass(vtkRenderPass* pass)
  {
    this->Others = pass;
    this->Rays->Detach(this->Renderer);
    this->Renderer->SetPass(pass);
    this->Rays->Attach(this->Renderer);
  }

  /// Casts rays at the plate, and at the ground where the floor stands.
  RayCaster MakeRays()
  {
    auto plate = MakeActor(this->PlateSource, false);
    auto floor = MakeActor(this->Ground, false);
    plate->SetUserMatrix(this->Plate->GetMatrix());
    floor->SetUserMatrix(this->Floor->GetMatrix());
    return RayCaster({ plate, floor });
  }
};

using Step = void (*)(Zoo&);

void UsePBR(Zoo& zoo)
{
  zoo.Property->SetInterpolationToPBR();
  zoo.Property->SetRoughness(0.5);
}

void UseSSAO(Zoo& zoo)
{
  zoo.Renderer->UseSSAOOn();
  zoo.Renderer->SetSSAORadius(1.0);
  zoo.Renderer->SetSSAOBias(0.01);
}

void PassSSAO(Zoo& zoo)
{
  vtkNew<vtkSSAOPass> pass;
  pass->SetDelegatePass(vtkSmartPointer<vtkRenderStepsPass>::New());
  pass->SetRadius(1.0);
  pass->SetBias(0.01);
  zoo.SetPass(pass);
}

void PassEDL(Zoo& zoo)
{
  vtkNew<vtkEDLShading> pass;
  pass->SetDelegatePass(vtkSmartPointer<vtkRenderStepsPass>::New());
  zoo.SetPass(pass);
}

void PeelDepths(Zoo& zoo)
{
  zoo.Renderer->UseDepthPeelingOn();
  zoo.Renderer->SetMaximumNumberOfPeels(8);
  zoo.Renderer->SetOcclusionRatio(0.0);
}

void UseHalfAWindow(Zoo& zoo)
{
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  zoo.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  zoo.Window->AddRenderer(other);
}

void TurnOver(Zoo& zoo)
{
  vtkNew<vtkProperty> back;
  back->SetColor(0.4, 0.9, 0.5);
  back->SetAmbient(0.15);
  zoo.Floor->SetBackfaceProperty(back);
  zoo.Ground->SetPoint1(-5.0, 5.0, 0.0);
  zoo.Ground->SetPoint2(5.0, -5.0, 0.0);
}

void ShowEdges(Zoo& zoo)
{
  zoo.Property->EdgeVisibilityOn();
  zoo.Property->SetEdgeColor(0.1, 0.1, 0.5);
  zoo.Property->SetLineWidth(2.0);
}

void Clip(Zoo& zoo)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.3, 0.0);
  plane->SetOrigin(-1.2, 0.0, 0.0);
  zoo.Mapper->AddClippingPlane(plane);
}

void ReplaceShader(Zoo& zoo)
{
  zoo.Floor->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Light::Impl", true, "//VTK::Light::Impl\n  gl_FragData[0].b *= 0.3;\n", false);
}

void Follow(Zoo& zoo)
{
  auto follower = vtkSmartPointer<vtkFollower>::New();
  follower->SetCamera(zoo.Camera);
  zoo.SetFloor(follower);
}

void AddOtherLights(Zoo& zoo) // before the one that casts shadows
{
  zoo.Renderer->RemoveAllLights();
  vtkNew<vtkLight> off;
  off->SwitchOff();
  zoo.Renderer->AddLight(off);
  vtkNew<vtkLight> fill;
  fill->SetLightTypeToHeadlight();
  fill->SetIntensity(0.3);
  zoo.Renderer->AddLight(fill);
  zoo.Renderer->AddLight(zoo.Light);
}

void UseCameraLight(Zoo& zoo)
{
  zoo.Light->SetLightTypeToCameraLight();
  zoo.Light->SetPosition(-0.7, 0.6, 0.8);
}

/// Has the camera's user view transform scale the scene.
void ScaleView(Zoo& zoo, double x, double y, double z)
{
  vtkNew<vtkTransform> scaling;
  scaling->Scale(x, y, z);
  zoo.Camera->SetUserViewTransform(scaling);
}

void MirrorView(Zoo& zoo)
{
  ScaleView(zoo, -1.0, 1.0, 1.0);
  zoo.Property->SetInterpolationToFlat(); // VTK turns normals of others away from the eye
}

void TurnLight(Zoo& zoo)
{
  vtkNew<vtkTransform> turn;
  turn->RotateZ(50.0);
  zoo.Light->SetTransformMatrix(turn->GetMatrix());
}

const struct Row
{
  const char* Name;
  std::vector<Step> Steps;
} Rows[] = {
  { "flat", { [](Zoo& zoo) { zoo.Property->SetInterpolationToFlat(); } } },
  { "Gouraud", { [](Zoo& zoo) { zoo.Property->SetInterpolationToGouraud(); } } },
  { "PBR", { UsePBR } },
  { "PBR with texture",
    { UsePBR, [](Zoo& zoo) { zoo.Property->SetBaseColorTexture(zoo.MakeTexture(true)); } } },
  { "texture", { [](Zoo& zoo) { zoo.Floor->SetTexture(zoo.MakeTexture(false)); } } },
  { "scalars", { [](Zoo& zoo) { zoo.ColorByScalars(1.0); } } },
  { "scalars by half", { [](Zoo& zoo) { zoo.ColorByScalars(0.5); } } },
  { "scalars by texture",
    { [](Zoo& zoo) { zoo.ColorByScalars(1.0); },
      [](Zoo& zoo) { zoo.Mapper->InterpolateScalarsBeforeMappingOn(); } } },
  { "scalars by texture by half",
    { [](Zoo& zoo) { zoo.ColorByScalars(0.5); },
      [](Zoo& zoo) { zoo.Mapper->InterpolateScalarsBeforeMappingOn(); } } },
  { "two sides", { TurnOver } },
  { "edges", { ShowEdges } },
  { "clipping plane", { Clip } },
  { "shader of the user", { ReplaceShader } },
  { "glyphs",
    { [](Zoo& zoo) { zoo.Ground->Update(); },
      [](Zoo& zoo) { zoo.SetGlyphs(zoo.Floor, zoo.Ground->GetOutput(), MakeGround(0.28)); } } },
  { "glyphs with scalars by half",
    { [](Zoo& zoo) { zoo.SetGlyphs(zoo.Floor, zoo.ColorByScalars(0.5), MakeGround(0.28)); } } },
  { "glyphs that cast",
    { [](Zoo& zoo) { zoo.SetGlyphs(zoo.Plate, zoo.MakePoint(), zoo.PlateSource); } } },
  { "composite with scalars by half",
    { [](Zoo& zoo) { zoo.SetBlock(zoo.Floor, zoo.ColorByScalars(0.5)); } } },
  { "composites",
    { [](Zoo& zoo) { zoo.PlateSource->Update(); }, [](Zoo& zoo) { zoo.Ground->Update(); },
      [](Zoo& zoo) { zoo.SetBlock(zoo.Plate, zoo.PlateSource->GetOutput()); },
      [](Zoo& zoo) { zoo.SetBlock(zoo.Floor, zoo.Ground->GetOutput()); } } },
  { "translucent", { [](Zoo& zoo) { zoo.Property->SetOpacity(0.5); } } },
  { "depth peeling", { PeelDepths, [](Zoo& zoo) { zoo.Property->SetOpacity(0.5); } } },
  { "SSAO of the renderer", { UseSSAO } },
  { "SSAO pass", { PassSSAO } },
  { "EDL", { PassEDL } },
  { "half a window", { UseHalfAWindow } },
  { "wide window", { [](Zoo& zoo) { zoo.Window->SetSize(450, 150); } } },
  { "multisampling", { [](Zoo& zoo) { zoo.Window->SetMultiSamples(8); } } },
  { "parallel projection", { [](Zoo& zoo) { zoo.Camera->ParallelProjectionOn(); } } },
  { "LOD actor", { [](Zoo& zoo) { zoo.SetFloor(vtkSmartPointer<vtkLODActor>::New()); } } },
  { "follower", { Follow } },
  { "assemblies",
    { [](Zoo& zoo) { zoo.Assemble(zoo.Floor); }, [](Zoo& zoo) { zoo.Assemble(zoo.Plate); } } },
  { "lamp", { [](Zoo& zoo) { zoo.SetLamp(180.0, -1.0, -0.5, 3.5); } } },
  { "lamp away from the origin",
    { [](Zoo& zoo) { zoo.Place(1.0, 1e3); },
      [](Zoo& zoo) { zoo.SetLamp(180.0, 1e3 - 1.0, -0.5, 3.5); } } },
  { "lamp far from the origin",
    { [](Zoo& zoo) { zoo.Place(1.0, 1e4); },
      [](Zoo& zoo) { zoo.SetLamp(180.0, 1e4 - 1.0, -0.5, 3.5); } } },
  { "lamp in parallel projection",
    { [](Zoo& zoo) { zoo.SetLamp(180.0, -1.0, -0.5, 3.5); },
      [](Zoo& zoo) { zoo.Camera->ParallelProjectionOn(); } } },
  { "spotlight", { [](Zoo& zoo) { zoo.SetLamp(35.0); } } },
  { "spotlight with PBR", { UsePBR, [](Zoo& zoo) { zoo.SetLamp(35.0); } } },
  { "three lights of which one is off", { AddOtherLights } },
  { "camera light", { UseCameraLight } },
  { "light with a matrix", { TurnLight } },
  { "mirrored view", { MirrorView } },
  { "mirrored view of a lamp",
    { MirrorView, [](Zoo& zoo) { zoo.SetLamp(180.0, -1.0, -0.5, 3.5); } } },
  { "wide view", { [](Zoo& zoo) { ScaleView(zoo, 1.5, 1.0, 1.0); } } },
  { "wide view of a lamp",
    { [](Zoo& zoo) { ScaleView(zoo, 1.5, 1.0, 1.0); },
      [](Zoo& zoo) { zoo.SetLamp(180.0, -1.0, -0.5, 3.5); } } },
  { "far from the origin", { [](Zoo& zoo) { zoo.Place(1.0, 1e6); } } },
  { "tiny", { [](Zoo& zoo) { zoo.Place(1e-4); } } },
  { "huge", { [](Zoo& zoo) { zoo.Place(1e5); } } },
  { "wide ground", { [](Zoo& zoo) { zoo.Spread(200.0); } } },
  { "very wide ground", { [](Zoo& zoo) { zoo.Spread(2000.0); } } },
};

void PrintTo(const Row& row, std::ostream* os)
{
  *os << row.Name;
}

std::string NameOf(const ::testing::TestParamInfo<Row>& info)
{
  std::string name = info.param.Name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

class GodRaysSurfaceShadowsOn : public ::testing::TestWithParam<Row>
{
};
}

TEST_P(GodRaysSurfaceShadowsOn, IsThatOfThePlate)
{
  Messages messages;
  Zoo zoo;
  for (Step step : GetParam().Steps)
  {
    step(zoo);
  }
  zoo.Renderer->ResetCameraClippingRange();
  zoo.Draw(); // some passes of VTK's show the scene from their second frame on
  const Pixels on = zoo.Draw(false);
  const Pixels off = zoo.Draw(false, 0.0);
  const Pixels got = zoo.Draw();
  const RayCaster rays = zoo.MakeRays();
  auto seen = Look(zoo.Renderer, rays);
  for (Seen& pixel : seen)
  {
    pixel.IsData = pixel.Place.z < 1.9 * zoo.Size;
  }
  LookAtLight(seen, rays, zoo.Light, zoo.Size * 10.0, zoo.Most);
  const int width = zoo.Window->GetSize()[0];
  const Errors none = Compare(seen, width, on, off, on, true);
  const Errors errors = Compare(seen, width, on, off, got, true);
  EXPECT_GT(none.Leak, 1.5) << "no shadow would pass, too";
  EXPECT_LT(errors.Off, 1.0);
  EXPECT_EQ(errors.Acne, 0.0);
  EXPECT_EQ(errors.Leak, 0.0);
  EXPECT_EQ(GetLargestDifference(zoo.Draw(false), on), 0);
  for (const std::string& text : messages.Take())
  {
    EXPECT_TRUE(Says(text, "was deprecated")) << text; // vtkLODActor of VTK 9.1 says that of itself
  }
  if (zoo.Others)
  {
    zoo.Rays->Detach(zoo.Renderer);
    zoo.Others->ReleaseGraphicsResources(zoo.Window);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, GodRaysSurfaceShadowsOn, ::testing::ValuesIn(Rows), NameOf);

// ---------------------------------------------------------------------------------------------
// Other properties

TEST(GodRaysSurfaceShadows, OfAFloorAloneAreNone)
{
  Messages messages;
  Zoo zoo;
  zoo.Renderer->RemoveActor(zoo.Plate);
  for (bool isLamp : { false, true })
  {
    zoo.Light->SetPositional(isLamp);
    zoo.Light->SetConeAngle(180.0);
    for (double height : { 0.1, 0.4, 1.0, 3.0, 9.0 })
    {
      zoo.Light->SetPosition(-3.0, -2.0, height);
      const Pixels without = zoo.Draw(false);
      EXPECT_EQ(CountDifferentPixels(zoo.Draw(), without), 0) << isLamp << ", height " << height;
      EXPECT_TRUE(Says(zoo.Rays->GetPlan(), "shadows of 1 of 1 lights")) << zoo.Rays->GetPlan();
    }
  }
  const Pixels with = zoo.Draw();
  zoo.Rays->Detach(zoo.Renderer);
  EXPECT_EQ(GetPixels(zoo.Window), with);
}

TEST(GodRaysSurfaceShadows, OfAHeadlightAreNone)
{
  Messages messages;
  Zoo zoo;
  zoo.Light->SetLightTypeToHeadlight();
  zoo.Draw();
  EXPECT_TRUE(Says(zoo.Rays->GetAdvice(), "no light casts shadows on surfaces"));
  EXPECT_EQ(zoo.Draw(), zoo.Draw(false));
  zoo.Draw();
  EXPECT_TRUE(Says(zoo.Rays->GetPlan(), "shadows of 0 of 1 lights")) << zoo.Rays->GetPlan();
}

TEST(GodRaysSurfaceShadows, OfLightsThatAreNotFiniteAreToldOf)
{
  Messages messages;
  Zoo zoo;
  const Pixels with = zoo.Draw();
  auto lost = MakeSun({ std::nan(""), 0.0, 1.0 });
  lost->SetIntensity(0.0);
  zoo.Renderer->AddLight(lost);
  zoo.Draw();
  EXPECT_EQ(zoo.Draw(), with);
  const auto told = messages.Take();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_TRUE(Says(told[0], "no shadows on surfaces of a light, directional")) << told[0];
}

TEST(GodRaysSurfaceShadows, LeaveSelectionsAlone)
{
  Messages messages;
  Zoo zoo;
  const Pixels with = zoo.Draw();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(zoo.Renderer);
  selector->SetArea(0, 0, 199, 149);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  ASSERT_EQ(selection->GetNumberOfNodes(), 2u);
  std::set<vtkObjectBase*> found;
  for (unsigned int i = 0; i < 2; ++i)
  {
    found.insert(selection->GetNode(i)->GetProperties()->Get(vtkSelectionNode::PROP()));
  }
  EXPECT_EQ(found, (std::set<vtkObjectBase*>{ zoo.Plate, zoo.Floor }));
  EXPECT_EQ(zoo.Draw(), with);
}

TEST(GodRaysSurfaceShadows, HaveLightsOfTheRaysThatTheRendererLacks)
{
  Messages messages;
  Zoo zoo;
  zoo.Renderer->GetLights()->RemoveAllItems();
  const auto count = [&] { return zoo.Renderer->GetLights()->GetNumberOfItems(); };
  zoo.Draw(false);
  EXPECT_EQ(count(), 1) << "VTK's headlight";
  zoo.Rays->AddLight(zoo.Light);
  zoo.Draw(false);
  EXPECT_EQ(count(), 1);
  for (bool detaches : { false, true })
  {
    const Pixels with = zoo.Draw();
    EXPECT_EQ(count(), 2);
    EXPECT_EQ(zoo.Renderer->GetLights()->IsItemPresent(zoo.Light), 0) << "a copy";
    EXPECT_TRUE(Says(zoo.Rays->GetPlan(), "shadows of 1 of 2 lights")) << zoo.Rays->GetPlan();
    EXPECT_EQ(zoo.Draw(), with);
    if (detaches)
    {
      zoo.Rays->Detach(zoo.Renderer);
    }
    else
    {
      zoo.Draw(false);
    }
    EXPECT_EQ(count(), 1) << detaches;
  }
}

// The camera looks down by 38 degrees, so that a sun behind the picture's middle is below the ground.
TEST(GodRaysSurfaceShadows, OfAPlacedSunFallOnTheGround)
{
  Messages messages;
  Zoo zoo;
  zoo.Renderer->GetLights()->RemoveAllItems();
  vtkLight* sun = zoo.Rays->PlaceSun(zoo.Renderer, 0.5, 0.6);
  ASSERT_NE(sun, nullptr);
  EXPECT_LT(sun->GetPosition()[2], 0.0);
  EXPECT_GT(CountDifferentPixels(zoo.Draw(), zoo.Draw(false), 20), 500);
  zoo.Draw();
  EXPECT_EQ(zoo.Rays->GetAdvice(), "");
  auto copy = vtkLight::SafeDownCast(zoo.Renderer->GetLights()->GetItemAsObject(1));
  ASSERT_NE(copy, nullptr);
  EXPECT_NEAR(GetVector(copy->GetPosition()).z - GetVector(copy->GetFocalPoint()).z, 0.4226, 1e-3);
}

// Eight lights, suns and lamps, of an opaque plate and of a pane. A ninth, the weakest, casts none, which is
// told once.
TEST(GodRaysSurfaceShadows, OfLightsAdd)
{
  for (const double opacity : { 1.0, 0.5 })
  {
    Messages messages;
    Zoo zoo;
    zoo.Plate->GetProperty()->SetOpacity(opacity);
    std::vector<vtkSmartPointer<vtkLight>> lights = { zoo.Light };
    for (const double i : { 0.0, 1.0, 2.0 })
    {
      lights.push_back(MakeLamplight({ -1.0 + i, -0.5 - i, 3.5 }));
      lights.push_back(MakeSun({ 3.0 - 2.0 * i, -1.0 + i, 5.0 }));
    }
    lights.push_back(MakeLamplight({ 2.0, 3.0, 6.0 }));
    zoo.Renderer->RemoveAllLights();
    for (vtkLight* light : lights)
    {
      light->SetIntensity(0.1);
      zoo.Renderer->AddLight(light);
    }
    zoo.Window->Render();
    const Pixels all = GetPixels(zoo.Window);
    EXPECT_TRUE(Says(zoo.Rays->GetPlan(), "shadows of 8 of 8 lights, 0 maps drawn, 0 shaders"))
      << zoo.Rays->GetPlan();
    lights[1]->SetPosition(-1.1, -0.5, 3.5);
    GetPixels(zoo.Window);
    EXPECT_TRUE(
      Says(zoo.Rays->GetPlan(), opacity < 1.0 ? " 2 maps drawn" : " 1 maps drawn, 0 shaders"))
      << "of what is opaque, and of panes " << zoo.Rays->GetPlan();
    lights[1]->SetPosition(-1.0, -0.5, 3.5);
    EXPECT_EQ(GetPixels(zoo.Window), all);
    std::vector<Pixels> each;
    for (vtkLight* light : lights)
    {
      for (vtkLight* other : lights)
      {
        other->SetSwitch(other == light);
      }
      each.push_back(GetPixels(zoo.Window));
      EXPECT_TRUE(Says(zoo.Rays->GetPlan(), "shadows of 1 of 1 lights")) << zoo.Rays->GetPlan();
    }
    for (vtkLight* light : lights)
    {
      light->SetIntensity(0.0);
    }
    const Pixels none = GetPixels(zoo.Window);
    int largest = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      int sum = -7 * none[i];
      for (const Pixels& one : each)
      {
        sum += one[i];
      }
      largest = i % 4 == 3 ? largest : std::max(largest, std::abs(all[i] - sum));
    }
    EXPECT_LE(largest, 8) << "levels of rounding, half of one a picture";

    auto ninth = MakeSun({ 0.0, 1.0, 5.0 });
    ninth->SetIntensity(0.05);
    zoo.Renderer->AddLight(ninth);
    for (vtkLight* light : lights)
    {
      light->SetIntensity(0.1);
      light->SwitchOn();
    }
    EXPECT_TRUE(messages.Take().empty());
    zoo.Draw(true, 0.1);
    zoo.Draw(true, 0.1);
    EXPECT_TRUE(Says(zoo.Rays->GetPlan(), "shadows of 8 of 9 lights")) << zoo.Rays->GetPlan();
    const auto told = messages.Take();
    ASSERT_EQ(told.size(), 1u);
    EXPECT_TRUE(Says(told[0], "no shadows on surfaces of all but the 8 strongest of 9 lights"))
      << told[0];
  }
}

TEST(GodRaysSurfaceShadows, BuildNothingWithoutCause)
{
  const std::string unchanged = " 0 maps drawn, 0 shaders built";
  Messages messages;
  for (bool hasMedium : { false, true })
  {
    Zoo zoo;
    if (hasMedium)
    {
      zoo.Rays->SetIntensity(1.0);
      ASSERT_TRUE(zoo.Rays->ApplyPreset("haze"));
      zoo.Rays->AddLight(zoo.Light);
    }
    for (int frame = 0; frame < 3; ++frame)
    {
      GetPixels(zoo.Window);
    }
    EXPECT_EQ(Says(zoo.Rays->GetPlan(), "rays: none"), !hasMedium) << zoo.Rays->GetPlan();
    EXPECT_TRUE(Says(zoo.Rays->GetPlan(), unchanged)) << zoo.Rays->GetPlan();
    for (int frame = 0; frame < 20; ++frame)
    {
      zoo.Renderer->GetActiveCamera()->Azimuth(1.0);
      zoo.Renderer->GetActiveCamera()->Elevation(0.3);
      GetPixels(zoo.Window);
      EXPECT_TRUE(Says(zoo.Rays->GetPlan(), unchanged)) << frame << zoo.Rays->GetPlan();
    }
    zoo.Light->SetPosition(-3.0, 1.0, 6.0);
    GetPixels(zoo.Window);
    EXPECT_TRUE(Says(zoo.Rays->GetPlan(), " 1 maps drawn")) << zoo.Rays->GetPlan();
  }
}

/// The red, green and blue of the floor's middle.
std::array<double, 3> GetMiddle(Zoo& zoo)
{
  const Pixels pixels = GetPixels(zoo.Window);
  const int* size = zoo.Window->GetSize();
  const std::size_t middle = static_cast<std::size_t>(size[1]) / 2 * size[0] + size[0] / 2;
  return { pixels[4 * middle] + 0.0, pixels[4 * middle + 1] + 0.0, pixels[4 * middle + 2] + 0.0 };
}

/// Expects the floor's middle to have a part of the light, in linear light.
void ExpectPart(Zoo& zoo, const std::array<double, 3>& part, const char* what)
{
  zoo.Rays->SetSurfaceShadows(false);
  const auto on = GetMiddle(zoo);
  const double intensity = zoo.Light->GetIntensity();
  zoo.Light->SetIntensity(0.0);
  const auto off = GetMiddle(zoo);
  zoo.Light->SetIntensity(intensity);
  zoo.Rays->SetSurfaceShadows(true);
  const auto got = GetMiddle(zoo);
  for (int c = 0; c < 3; ++c)
  {
    const double shown = vtkGodRays::EncodeDisplay(part[c]);
    EXPECT_NEAR(got[c], off[c] + shown * (on[c] - off[c]), 2.0)
      << what << " " << c << ", lit " << on[c] << ", dark " << off[c];
  }
}

/// A floor that is seen from above, whose middle is below the plate.
void LookDown(Zoo& zoo)
{
  zoo.Light->SetPosition(0.0, 3.0, 6.0);
  zoo.Light->SetFocalPoint(0.0, 0.0, 0.0);
  zoo.PlateSource->SetCenter(0.0, 1.0, 2.0); // on the light's way, not on the eye's
  zoo.PlateSource->SetYLength(0.6);
  zoo.Camera->SetPosition(0.0, -6.0, 6.0);
  zoo.Camera->SetFocalPoint(0.0, 0.0, 0.0);
  zoo.Renderer->ResetCameraClippingRange();
}

TEST(GodRaysSurfaceShadows, OfPanesAreTheirColour)
{
  Messages messages;
  Zoo zoo;
  LookDown(zoo);
  zoo.PlateSource->SetZLength(0.0); // two faces, one on the other, would count twice
  zoo.Plate->GetProperty()->BackfaceCullingOn();
  for (const double opacity : { 0.3, 0.6, 0.9 })
  {
    double color[3] = { 1.0, 0.6, 0.2 };
    zoo.Plate->GetProperty()->SetColor(color);
    zoo.Plate->GetProperty()->SetOpacity(opacity);
    std::array<double, 3> part;
    for (int c = 0; c < 3; ++c)
    {
      part[c] = std::pow(1.0 - opacity, 3.0 - 2.0 * color[c]); // see vtkGodRaysLightLayers
    }
    ExpectPart(zoo, part, "pane");
  }
}

// A box of smoke, twice as deep as the light's way down through it, 45 degrees aside, is.
TEST(GodRaysSurfaceShadows, OfVolumesAreWhatTheyLeave)
{
  Messages messages;
  Zoo zoo;
  LookDown(zoo);
  zoo.Renderer->RemoveActor(zoo.Plate);
  vtkNew<vtkImageData> image;
  image->SetDimensions(17, 17, 17);
  image->SetSpacing(1.0 / 8.0, 1.0 / 8.0, 1.0 / 16.0);
  image->SetOrigin(-1.0, 0.25, 1.5); // 1 high
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 17 * 17 * 17, 255);
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  zoo.Renderer->AddVolume(volume);
  for (const double depth : { 0.1, 1.0, 3.0 })
  {
    const double length = std::sqrt(1.0 + 0.25); // through 1 of height
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 1.0 - std::exp(-depth / length));
    opacity->AddPoint(255.0, 1.0 - std::exp(-depth / length));
    volume->GetProperty()->SetScalarOpacity(opacity);
    const double left = std::exp(-depth);
    ExpectPart(zoo, { left, left, left }, "smoke");
  }
}

TEST(GodRaysSurfaceShadows, AreDimmedByTheMedium)
{
  Messages messages;
  Zoo zoo;
  LookDown(zoo);
  zoo.Renderer->RemoveActor(zoo.Plate);
  zoo.Light->SetPosition(0.0, 0.0, 5.0);
  zoo.Light->PositionalOn();
  zoo.Light->SetConeAngle(180.0);
  vtkNew<vtkGodRaysHomogeneousModel> fog;
  fog->SetAttenuateScene(true);
  zoo.Rays->SetModel(fog);
  zoo.Rays->SetIntensity(
    1e-4); // a picture of surfaces alone, but for what is between them and the eye
  zoo.Rays->SetAutomaticExposure(false);
  zoo.Rays->AddLight(zoo.Light);
  fog->SetScatteringCoefficient(0.0, 0.0, 0.0);
  const auto measure = [&](double r, double g, double b)
  {
    fog->SetAbsorptionCoefficient(r, g, b);
    const auto plain = GetMiddle(zoo);
    return plain;
  };
  // The way from the floor to the eye dims both pictures alike: their ratio is that of the light's way.
  zoo.Floor->GetProperty()->SetAmbient(0.0);
  for (const double sigma : { 0.02, 0.1, 0.2 })
  {
    zoo.Rays->SurfaceShadowsOff();
    const auto without = measure(sigma, 0.5 * sigma, 0.0);
    zoo.Rays->SurfaceShadowsOn();
    const auto with = measure(sigma, 0.5 * sigma, 0.0);
    for (int c = 0; c < 3; ++c)
    {
      const double left = std::exp(-5.0 * sigma * (1.0 - 0.5 * c));
      const double ratio =
        vtkGodRays::DecodeDisplay(with[c] / 255.0) / vtkGodRays::DecodeDisplay(without[c] / 255.0);
      EXPECT_NEAR(ratio, left, 0.03) << sigma << " " << c;
    }
  }
}

// A camera's model transform scales view coordinates, and directions in them.
TEST(GodRaysSurfaceShadows, AreThoseOfACameraThatScales)
{
  Messages messages;
  Zoo zoo;
  const Pixels with = zoo.Draw();
  const Pixels without = zoo.Draw(false);
  zoo.Place(0.5);
  zoo.Camera->SetPosition(3.0, -9.0, 7.0); // where it was
  vtkNew<vtkMatrix4x4> twice;
  for (int i = 0; i < 3; ++i)
  {
    twice->SetElement(i, i, 2.0);
  }
  zoo.Camera->SetModelTransformMatrix(twice);
  zoo.Renderer->ResetCameraClippingRange();
  EXPECT_LT(CountDifferentPixels(zoo.Draw(false), without, 2), 50);
  EXPECT_LT(CountDifferentPixels(zoo.Draw(), with, 2), 100);
  EXPECT_GT(CountDifferentPixels(with, without, 2), 1000);
}

TEST(GodRaysSurfaceShadows, FollowWhatCasts)
{
  Messages messages;
  Zoo zoo;
  const Pixels without = zoo.Draw(false);
  const Pixels first = zoo.Draw();
  vtkGodRaysPass::SetRole(zoo.Plate, vtkGodRaysPass::IGNORED);
  EXPECT_EQ(zoo.Draw(), without);
  vtkGodRaysPass::SetRole(zoo.Plate, vtkGodRaysPass::AUTOMATIC);
  EXPECT_EQ(zoo.Draw(), first);
  zoo.Plate->GetProperty()->SetOpacity(0.5);
  const Pixels translucent = zoo.Draw();
  const int paler = CountDifferentPixels(translucent, zoo.Draw(false), 20);
  zoo.Plate->GetProperty()->SetOpacity(0.05);
  EXPECT_EQ(CountDifferentPixels(zoo.Draw(), zoo.Draw(false), 20), 0) << "it lets light through";
  EXPECT_GT(paler, 500) << "and casts its shadow";
  zoo.Plate->GetProperty()->SetOpacity(1.0);
  zoo.Plate->VisibilityOff();
  EXPECT_EQ(zoo.Draw(), zoo.Draw(false));
  zoo.Plate->VisibilityOn();
  EXPECT_EQ(zoo.Draw(), first);
  zoo.Plate->SetPosition(0.5, 0.2, 0.0);
  const Pixels moved = zoo.Draw();
  EXPECT_GT(CountDifferentPixels(moved, first, 2), 100);
  Zoo other;
  other.PlateSource->SetCenter(0.5, 0.2, 2.05);
  EXPECT_EQ(moved, other.Draw());
  zoo.Rays->Detach(zoo.Renderer);
  EXPECT_EQ(GetPixels(zoo.Window), other.Draw(false));
}

TEST(GodRaysSurfaceShadows, OfThinThingsAreNone)
{
  enum
  {
    POINTS,
    SPHERES,
    LINES,
    WIREFRAME,
    TUBES,
    PARTS // a wireframe in an assembly
  };
  Messages messages;
  for (int kind = POINTS; kind <= PARTS; ++kind)
  {
    Zoo zoo;
    vtkProperty* property = zoo.Plate->GetProperty();
    const bool isPoints = kind == POINTS || kind == SPHERES;
    property->SetRepresentation(isPoints ? VTK_POINTS : VTK_WIREFRAME);
    property->SetPointSize(9.0);
    property->SetLineWidth(kind == TUBES ? 9.0 : 2.0);
    property->SetRenderPointsAsSpheres(kind == SPHERES);
    property->SetRenderLinesAsTubes(kind == TUBES);
    if (kind == LINES)
    {
      vtkNew<vtkPolyData> lines;
      zoo.PlateSource->Update();
      lines->SetPoints(zoo.PlateSource->GetOutput()->GetPoints());
      lines->SetLines(zoo.PlateSource->GetOutput()->GetPolys());
      vtkPolyDataMapper::SafeDownCast(zoo.Plate->GetMapper())->SetInputData(lines);
      property->SetRepresentationToSurface();
    }
    if (kind == PARTS)
    {
      zoo.Assemble(zoo.Plate);
    }
    EXPECT_EQ(CountDifferentPixels(zoo.Draw(), zoo.Draw(false)), 0) << "kind " << kind;
  }
}

TEST(GodRaysSurfaceShadows, AreOfEachRendererOfAWindow)
{
  Messages messages;
  Zoo zoo;
  zoo.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  other->SetActiveCamera(zoo.Renderer->GetActiveCamera());
  other->SetBackground(zoo.Renderer->GetBackground());
  auto plate = MakeActor(zoo.PlateSource, false);
  plate->SetPosition(0.5, 1.0, -0.5);
  other->AddActor(plate);
  other->AddActor(MakeActor(zoo.Ground, true));
  other->AddLight(zoo.Light); // VTK 9.1 confuses lights of two renderers whose shaders are the same
  zoo.Window->AddRenderer(other);
  vtkNew<vtkGodRaysPass> rays;
  rays->SetIntensity(0.0);
  rays->SurfaceShadowsOn();
  rays->Attach(other);
  const Pixels both = zoo.Draw();
  EXPECT_EQ(CountDifferentPixels(zoo.Draw(), both), 0);
  EXPECT_TRUE(Says(rays->GetPlan(), " 0 maps drawn, 0 shaders built")) << rays->GetPlan();
  EXPECT_TRUE(Says(zoo.Rays->GetPlan(), " 0 maps drawn, 0 shaders built")) << zoo.Rays->GetPlan();
  // the halves are those of windows with one of the two passes
  const auto countChanged = [&](const Pixels& picture, int half)
  {
    int different = 0;
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      different += static_cast<int>(i / 4 % 200 / 100) == half && picture[i] != both[i];
    }
    return different;
  };
  rays->Detach(other);
  const Pixels right = zoo.Draw();
  EXPECT_EQ(countChanged(right, 1), 0);
  EXPECT_GT(countChanged(right, 0), 500);
  rays->Attach(other);
  const Pixels left = zoo.Draw(false);
  EXPECT_EQ(countChanged(left, 0), 0);
  EXPECT_GT(countChanged(left, 1), 500);
  rays->Detach(other);
}

// Actors that two renderers share: each half of the window is as if it were the renderer's own, whether the
// other has no shadows, or softer ones, and no shader is built in a steady frame.
TEST(GodRaysSurfaceShadows, OfSharedActorsAreThoseOfTheirRenderer)
{
  Messages messages;
  Zoo zoo;
  zoo.Rays->SetSunAngularRadius(3.0);
  zoo.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
  vtkNew<vtkRenderer> other;
  other->SetViewport(0.0, 0.0, 0.5, 1.0);
  other->SetActiveCamera(zoo.Camera);
  other->SetBackground(zoo.Renderer->GetBackground());
  other->AddLight(zoo.Light);
  zoo.Window->AddRenderer(other);
  vtkNew<vtkGodRaysPass> rays;
  rays->SetIntensity(0.0);
  rays->SurfaceShadowsOn();
  rays->SetSunAngularRadius(3.0);
  rays->SetMostDataShadow(1.0);
  enum
  {
    LIT,
    HARD,
    SOFT,
    EMPTY
  };
  const auto draw = [&](int left, int right)
  {
    zoo.Renderer->RemoveAllViewProps();
    other->RemoveAllViewProps();
    for (vtkActor* actor : { zoo.Plate.Get(), zoo.Floor.Get() })
    {
      left == EMPTY ? void() : other->AddActor(actor);
      right == EMPTY ? void() : zoo.Renderer->AddActor(actor);
    }
    rays->SetSurfaceShadows(left == HARD || left == SOFT);
    rays->SetSoftShadows(left == SOFT);
    zoo.Rays->SetSoftShadows(right == SOFT);
    for (int frame = 0; frame < 3; ++frame)
    {
      zoo.Draw(right == HARD || right == SOFT);
    }
    const Pixels pixels = zoo.Draw(right == HARD || right == SOFT);
    for (vtkGodRaysPass* each : { rays.Get(), zoo.Rays.Get() })
    {
      EXPECT_TRUE(!each->GetSurfaceShadows() || Says(each->GetPlan(), " 0 maps drawn, 0 shaders"))
        << left << right << each->GetPlan();
    }
    return pixels;
  };
  const auto countDifferent = [](const Pixels& one, const Pixels& two, std::size_t half)
  {
    int different = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
    {
      different += i / 4 % 200 / 100 == half && one[i] != two[i];
    }
    return different;
  };
  rays->Attach(other);
  for (int left : { LIT, HARD, SOFT })
  {
    for (int right : { LIT, HARD, SOFT })
    {
      const Pixels both = draw(left, right);
      EXPECT_EQ(countDifferent(both, draw(left, EMPTY), 0), 0) << left << right;
      EXPECT_EQ(countDifferent(both, draw(EMPTY, right), 1), 0) << left << right;
    }
  }
  EXPECT_GT(countDifferent(draw(LIT, SOFT), draw(HARD, LIT), 0), 500);
  EXPECT_GT(countDifferent(draw(HARD, SOFT), draw(SOFT, HARD), 1), 100);
  rays->Detach(other);
  zoo.Rays->Detach(zoo.Renderer);
  EXPECT_FALSE(zoo.Floor->GetPropertyKeys() &&
    zoo.Floor->GetPropertyKeys()->Has(vtkOpenGLRenderPass::RenderPasses()));
}

// From inside a closed room no wall should be lit, also where light from outside grazes walls, along their
// edges. Thin lines are.
TEST(GodRaysSurfaceShadows, LeaveThinLinesInClosedRooms)
{
  Messages messages;
  Zoo zoo;
  zoo.Renderer->RemoveActor(zoo.Floor);
  zoo.PlateSource->SetBounds(-4.0, 4.0, -3.0, 3.0, 0.0, 2.5);
  zoo.Camera->SetViewAngle(80.0);
  std::mt19937 random(20260102);
  const auto draw = [&] { return 2.0 * static_cast<double>(random()) / 4294967296.0 - 1.0; };
  double shares[2] = {};
  const int pixels = 200 * 150;
  for (int i = 0; i < 40; ++i)
  {
    const bool isLamp = i % 2 == 1;
    const Vec3 towards = normalize(Vec3(draw(), draw(), 1.05 * std::abs(draw()) + 0.02));
    const Vec3 from = 7.0 * towards;
    zoo.Light->SetPositional(isLamp);
    zoo.Light->SetConeAngle(180.0);
    zoo.Light->SetPosition(from.x, from.y, from.z);
    zoo.Camera->SetPosition(2.0 * draw(), 1.5 * draw(), 1.25);
    const double turn = 3.1 * draw();
    const double* eye = zoo.Camera->GetPosition();
    zoo.Camera->SetFocalPoint(eye[0] + std::cos(turn), eye[1] + std::sin(turn), 1.2 + 0.3 * draw());
    zoo.Renderer->ResetCameraClippingRange();
    const Pixels dark = zoo.Draw(true, 0.0);
    shares[isLamp] += CountDifferentPixels(zoo.Draw(), dark, 2) / (20.0 * pixels);
  }
  std::printf(
    "lit from outside: by suns %.4f %%, by lamps %.4f %%\n", 100.0 * shares[0], 100.0 * shares[1]);
  EXPECT_LT(shares[0], 0.004);
  EXPECT_LT(shares[1], 0.009);
}

// Over wide ground, too, edges of shadows stay where they are in the world: most frames of a camera that
// moves draw no map.
TEST(GodRaysSurfaceShadows, StayOverWideGroundWhileTheCameraMoves)
{
  Messages messages;
  Zoo zoo;
  zoo.Spread(300.0);
  zoo.Rays->SetSoftShadows(false);
  zoo.Renderer->ResetCameraClippingRange();
  zoo.Draw();
  int drawn = 0;
  for (int frame = 0; frame < 60; ++frame)
  {
    // 0.05 is two pixels where it looks
    zoo.Camera->SetPosition(3.0 + 0.05 * frame, -9.0, 7.0 - 0.02 * frame);
    zoo.Camera->SetFocalPoint(0.03 * frame, 0.0, 0.0);
    zoo.Draw();
    drawn += Says(zoo.Rays->GetPlan(), " 0 maps drawn, 0 shaders built") ? 0 : 1;
  }
  EXPECT_LE(drawn, 6);
}

// Also far from what casts them, over ground 500 times as wide: the middle of a ball's shadow, seen from
// along the light, across it and from above, and through a long lens.
TEST(GodRaysSurfaceShadows, OfALowSunReachFarOverWideGround)
{
  Messages messages;
  struct View
  {
    double Elevation, Angle, Distance;
    Vec3 From;
  };
  std::vector<View> views = { { 0.21, 5.0, 300.0, { 0.8, -0.8, 0.6 } },
    { 0.21, 2.0, 500.0, { 0.8, -0.8, 0.6 } } };
  for (double elevation : { 0.05, 0.1, 0.2, 0.4 })
  {
    for (const Vec3& from :
      { Vec3(0.8, -0.8, 0.6), Vec3(-0.7, -0.7, 0.6), Vec3(0.1, 0.0, 1.0), Vec3(0.5, 1.0, 0.3) })
    {
      views.push_back({ elevation, 30.0, 40.0, from });
    }
  }
  for (const View& view : views)
  {
    Zoo zoo;
    zoo.Spread(500.0);
    zoo.Renderer->RemoveActor(zoo.Plate);
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(1.0);
    ball->SetCenter(0.0, 0.0, 2.0);
    ball->SetThetaResolution(40);
    ball->SetPhiResolution(40);
    zoo.Renderer->AddActor(MakeActor(ball, true));
    zoo.Rays->SetSoftShadows(false);
    zoo.Light->SetFocalPoint(0.0, 0.0, 0.0);
    zoo.Light->SetPosition(0.7071, 0.7071, std::tan(view.Elevation));
    const double away = -0.7071 * 2.0 / std::tan(view.Elevation);
    const Vec3 eye = Vec3(away, away, 0.0) + view.Distance * normalize(view.From);
    zoo.Camera->SetFocalPoint(away, away, 0.0);
    zoo.Camera->SetPosition(eye.x, eye.y, eye.z);
    zoo.Camera->SetViewUp(0.0, 0.0, 1.0);
    zoo.Camera->SetViewAngle(view.Angle);
    zoo.Renderer->ResetCameraClippingRange();
    const int* size = zoo.Window->GetSize();
    const std::size_t middle = 4 * (static_cast<std::size_t>(size[1] / 2) * size[0] + size[0] / 2);
    const int lit = zoo.Draw(false)[middle];
    EXPECT_LT(zoo.Draw()[middle], lit - 5)
      << view.Elevation << " " << view.Angle << " " << view.From.x << " " << view.From.y;
  }
}
