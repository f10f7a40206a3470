// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// What a medium leaves of the sight of points: closed forms, quadratures that share no code, published
// numbers.

#include "GodRaysFiltersTesting.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysVisibilityFilter.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <limits>

using namespace GodRaysFiltersTesting;
using vtkGodRays::Vec3;

namespace
{
using Filter = vtkGodRaysVisibilityFilter;

template <typename Set = vtkPolyData>
vtkSmartPointer<Set> MakePoints(const std::vector<Vec3>& places)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& place : places)
  {
    points->InsertNextPoint(place.x, place.y, place.z);
  }
  auto set = vtkSmartPointer<Set>::New();
  set->SetPoints(points);
  return set;
}

// A homogeneous medium, grey.
void SetMedium(Filter* filter, double scattering, double absorption)
{
  filter->SetScatteringCoefficient(scattering, scattering, scattering);
  filter->SetAbsorptionCoefficient(absorption, absorption, absorption);
}

double Get(Filter* filter, const char* name, vtkIdType point = 0, int component = 0)
{
  filter->Update();
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
  EXPECT_TRUE(array) << name;
  return array ? array->GetComponent(point, component) : std::nan("");
}

double GetErrorBound(Filter* filter, const std::string& name)
{
  vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray((name + "_Error").c_str());
  EXPECT_TRUE(array && array->GetNumberOfTuples() == 1) << name;
  return array ? array->GetComponent(0, 0) : 0.0;
}

vtkSmartPointer<vtkPolyData> MakeSquare(const std::array<Vec3, 4>& corners)
{
  GodRaysMediumScenes::Mesh mesh;
  for (const Vec3& corner : corners)
  {
    mesh.AddPoint(corner.x, corner.y, corner.z);
  }
  mesh.AddPolygon({ 0, 1, 2, 3 });
  return mesh.Get();
}

vtkSmartPointer<vtkPolyData> MakeWall(double x, double size)
{
  return MakeSquare(
    { Vec3(x, -size, -size), Vec3(x, size, -size), Vec3(x, size, size), Vec3(x, -size, size) });
}

// Integral of a function over a way, by Simpson's rule in long double.
long double Integrate(
  long double length, int steps, const std::function<long double(long double)>& function)
{
  long double sum = function(0.0L) + function(length);
  for (int i = 1; i < steps; ++i)
  {
    sum += (i % 2 == 1 ? 4.0L : 2.0L) * function(length * i / steps);
  }
  return sum * length / (3.0L * steps);
}
}

//------------------------------------------------------------------------------
// NIST's verification case smoke_test: K = 0.8286/m over 1 m leaves 43.668 %, a grey of 111. K is published
// to four figures: that is 2.2e-5 of the light.
TEST(VisibilityFilter, SmokeTest)
{
  vtkNew<Filter> filter;
  filter->SetInputData(MakePoints({ { 0.0, 0.0, -1.0 }, { 100.0, 0.0, 0.0 } }));
  SetMedium(filter, 0.5, 0.3286);
  EXPECT_NEAR(Get(filter, "OpticalDepth", 0, 2), 0.8286, 1e-15);
  EXPECT_NEAR(Get(filter, "Transmittance", 0, 0), std::exp(-0.8286), 1e-15);
  EXPECT_NEAR(Get(filter, "Transmittance", 0, 0), 0.43668, 2.2e-5);
  EXPECT_EQ(std::lround(255.0 * Get(filter, "Transmittance", 0, 1)), 111);
  filter->SetWorldUnitInMeters(0.01); // the same medium, in centimetres
  SetMedium(filter, 0.005, 0.003286);
  EXPECT_NEAR(Get(filter, "Transmittance", 1, 0), 0.43668, 2.2e-5);
  EXPECT_NEAR(Get(filter, "Distance_m", 1), 1.0, 1e-15);
  EXPECT_NEAR(Get(filter, "MeteorologicalRange_m", 1), 3.912023 / 0.8286, 1e-6);
}

//------------------------------------------------------------------------------
// 3.912/sigma and 2.996/sigma, with targets just before and just beyond.
TEST(VisibilityFilter, KoschmiedersLaw)
{
  const double extinction = 1.5e-3;
  for (const auto& [threshold, depth] : { std::pair(0.02, 3.912), std::pair(0.05, 2.996) })
  {
    const double range = depth / extinction;
    vtkNew<Filter> filter;
    filter->SetCameraPosition(7.0, 8.0, 9.0);
    filter->SetInputData(MakePoints(
      { { 7.0 + 0.999 * range, 8.0, 9.0 }, { 7.0, 8.0 - 1.001 * range, 9.0 }, { 7.0, 8.0, 9.0 } }));
    SetMedium(filter, extinction, 0.0);
    filter->SetContrastThreshold(threshold);
    EXPECT_NEAR(Get(filter, "MeteorologicalRange_m", 0) / range, 1.0, 2e-4);
    EXPECT_EQ(Get(filter, "Visible", 0), 1.0);
    EXPECT_EQ(Get(filter, "Visible", 1), 0.0);
    EXPECT_NEAR(Get(filter, "Contrast", 1), std::exp(-1.001 * depth), 1e-12);
    EXPECT_EQ(Get(filter, "Visible", 2), 1.0); // the observer itself
    EXPECT_TRUE(std::isinf(Get(filter, "MeteorologicalRange_m", 2)));
    filter->SetInherentContrast(0.5);
    EXPECT_EQ(Get(filter, "Visible", 0), 0.0);
  }
}

//------------------------------------------------------------------------------
TEST(VisibilityFilter, ExponentialDensity)
{
  const double scaleHeight = 1200.0;
  const double ground = 300.0;
  const double observer = 500.0;
  const auto density = [&](double z) { return std::exp(-(z - ground) / scaleHeight); };
  vtkNew<Filter> filter;
  filter->SetCameraPosition(0.0, 0.0, observer);
  filter->SetMediumUp(0.0, 0.0, 3.0);
  filter->SetGroundLevel(ground);
  filter->SetScaleHeight(scaleHeight);
  filter->SetScatteringCoefficient(1e-4, 2e-4, 3e-4);
  std::mt19937 generator = MakeGenerator(5);
  std::vector<Vec3> places = { { 0.0, 0.0, 2500.0 }, { 0.0, 0.0, 310.0 },
    { 6000.0, -8000.0, observer } };
  for (int i = 0; i < 500; ++i)
  {
    const auto random = [&] { return generator() / 4294967296.0; };
    places.emplace_back(2e4 * random(), -2e4 * random(), 300.0 + 5000.0 * random());
  }
  filter->SetInputData(MakePoints(places));
  // vertical and horizontal
  EXPECT_NEAR(Get(filter, "OpticalDepth", 0, 1),
    2e-4 * scaleHeight * (density(observer) - density(2500.0)), 1e-14);
  EXPECT_NEAR(Get(filter, "OpticalDepth", 1, 1),
    2e-4 * scaleHeight * (density(310.0) - density(observer)), 1e-14);
  EXPECT_NEAR(Get(filter, "OpticalDepth", 2, 1), 2e-4 * density(observer) * 1e4, 1e-14);
  // slanted: the same as vertically, over the sine
  double worst = 0.0;
  for (vtkIdType i = 3; i < static_cast<vtkIdType>(places.size()); ++i)
  {
    const Vec3& place = places[i];
    const double distance = std::hypot(place.x, place.y, place.z - observer);
    for (int c = 0; c < 3; ++c)
    {
      const double sine = (place.z - observer) / distance;
      const double expected =
        1e-4 * (c + 1) * scaleHeight * (density(observer) - density(place.z)) / sine;
      worst = std::max(worst, std::abs(Get(filter, "OpticalDepth", i, c) / expected - 1.0));
      EXPECT_NEAR(Get(filter, "Transmittance", i, c), std::exp(-expected), 1e-10);
    }
  }
  std::cout << "largest relative error over a plane " << worst << "\n";
  EXPECT_LT(worst, GetErrorBound(filter, "OpticalDepth"));
}

//------------------------------------------------------------------------------
// Two components over the Earth, against a quadrature of the density along the way.
TEST(VisibilityFilter, Planet)
{
  const double radius = 6.36e6;
  vtkNew<Filter> filter;
  filter->SetMediumUp(0.0, 0.0, 1.0);
  filter->SetPlanetRadius(radius);
  filter->SetScatteringCoefficient(2e-5, 2e-5, 2e-5);
  filter->SetScaleHeight(1200.0);
  filter->SetGasScatteringCoefficient(1.2e-5, 1.2e-5, 1.2e-5);
  filter->SetGasScaleHeight(8000.0);
  std::mt19937 generator = MakeGenerator(6);
  const auto random = [&] { return generator() / 4294967296.0; };
  double worst = 0.0;
  int hidden = 0;
  for (int round = 0; round < 12; ++round)
  {
    const Vec3 eye(3e5 * (random() - 0.5), 3e5 * (random() - 0.5), 20.0 + 9e3 * random());
    filter->SetCameraPosition(eye.x, eye.y, eye.z);
    std::vector<Vec3> places;
    for (int i = 0; i < 25; ++i)
    {
      const double far = std::pow(10.0, 2.0 + 3.5 * random());
      places.push_back(eye + far * Vec3(random() - 0.5, random() - 0.5, 0.2 * (random() - 0.5)));
    }
    filter->SetInputData(MakePoints(places));
    for (vtkIdType i = 0; i < 25; ++i)
    {
      const Vec3 way = places[i] - eye;
      const long double length = vtkGodRays::length(way);
      long double lowest = 1e30L;
      const auto density = [&](long double s)
      {
        const long double part = s / length;
        const long double x = eye.x + part * way.x;
        const long double y = eye.y + part * way.y;
        const long double z = radius + eye.z + part * way.z;
        const long double height = std::sqrt(x * x + y * y + z * z) - radius;
        lowest = std::min(lowest, height);
        return 2e-5L * std::exp(-height / 1200.0L) + 1.2e-5L * std::exp(-height / 8000.0L);
      };
      const double expected = static_cast<double>(Integrate(length, 4000, density));
      if (Get(filter, "Hidden", i) == 1.0)
      {
        EXPECT_LT(lowest, 1.0L);
        ++hidden;
        continue;
      }
      EXPECT_GT(lowest, -1.0L);
      worst = std::max(worst, std::abs(Get(filter, "OpticalDepth", i) / expected - 1.0));
    }
  }
  std::cout << "largest relative error over a planet " << worst << ", hidden " << hidden << "\n";
  EXPECT_LT(worst, GetErrorBound(filter, "OpticalDepth"));
  EXPECT_GT(hidden, 5);
  EXPECT_LT(hidden, 200);
}

//------------------------------------------------------------------------------
TEST(VisibilityFilter, OccludersHideAndThoseOnThemAreSeen)
{
  vtkNew<Filter> filter;
  SetMedium(filter, 1e-3, 0.0);
  filter->SetInputData(
    MakePoints({ { 10.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 5.0, 1.0, 1.0 }, { 10.0, 9.0, 0.0 } }));
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(Get(filter, "Visible", i), 1.0);
  }
  filter->SetOccludersData(MakeWall(5.0, 3.0));
  const double expected[4] = { 1.0, 0.0, 0.0, 0.0 };
  for (vtkIdType i = 0; i < 4; ++i) // behind, before, on it, beside
  {
    EXPECT_EQ(Get(filter, "Hidden", i), expected[i]) << i;
    EXPECT_EQ(Get(filter, "Visible", i), 1.0 - expected[i]) << i;
  }

  // a ball's points from outside: those that face the eye, but for its rim
  GodRaysMediumScenes::Mesh mesh;
  mesh.AddSphere(0.0, 0.0, 0.0, 2.0, 30);
  const auto ball = mesh.Get();
  filter->SetCameraPosition(9.0, 1.0, 2.0);
  filter->SetInputData(ball);
  filter->SetOccludersData(ball);
  const Vec3 eye(9.0, 1.0, 2.0);
  int counts[2] = { 0, 0 };
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    double p[3];
    ball->GetPoint(i, p);
    const double facing = vtkGodRays::dot(Vec3(p[0], p[1], p[2]), eye - Vec3(p[0], p[1], p[2]));
    if (std::abs(facing) > 1.5)
    {
      EXPECT_EQ(Get(filter, "Hidden", i), facing > 0.0 ? 0.0 : 1.0) << facing;
      ++counts[facing > 0.0 ? 1 : 0];
    }
  }
  EXPECT_GT(counts[0], 500);
  EXPECT_GT(counts[1], 500);
}

//------------------------------------------------------------------------------
// Random triangles, against the intersection of Moeller and Trumbore.
TEST(VisibilityFilter, HidesWhatTrianglesHide)
{
  std::mt19937 generator = MakeGenerator(7);
  const auto random = [&](double size)
  {
    Vec3 v;
    for (int i = 0; i < 3; ++i)
    {
      v[i] = size * (generator() / 4294967296.0 - 0.5);
    }
    return v;
  };
  std::vector<Vec3> corners;
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 middle = random(10.0);
    for (int k = 0; k < 3; ++k)
    {
      corners.push_back(middle + random(1.0));
    }
  }
  auto mesh = MakePoints(corners);
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < 900; i += 3)
  {
    cells->InsertNextCell({ i, i + 1, i + 2 });
  }
  mesh->SetPolys(cells);
  std::vector<Vec3> places;
  for (int i = 0; i < 2000; ++i)
  {
    places.push_back(random(12.0));
  }
  vtkNew<Filter> filter;
  filter->SetCameraPosition(0.3, -0.2, 0.1);
  filter->SetInputData(MakePoints(places));
  filter->SetOccludersData(mesh);
  const Vec3 eye(0.3, -0.2, 0.1);
  int hidden = 0;
  int wrong = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const Vec3 way = places[i] - eye;
    bool expected = false;
    for (std::size_t k = 0; k < corners.size(); k += 3)
    {
      const Vec3 a = corners[k + 1] - corners[k];
      const Vec3 b = corners[k + 2] - corners[k];
      const Vec3 p = vtkGodRays::cross(way, b);
      const double determinant = vtkGodRays::dot(a, p);
      const Vec3 from = eye - corners[k];
      const Vec3 q = vtkGodRays::cross(from, a);
      const double u = vtkGodRays::dot(from, p) / determinant;
      const double v = vtkGodRays::dot(way, q) / determinant;
      const double t = vtkGodRays::dot(b, q) / determinant;
      expected = expected || (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < 1.0);
    }
    hidden += expected ? 1 : 0;
    wrong += (Get(filter, "Hidden", static_cast<vtkIdType>(i)) == 1.0) != expected ? 1 : 0;
  }
  std::cout << hidden << " of 2000 hidden, " << wrong << " wrong\n";
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(hidden, 100);
}

//------------------------------------------------------------------------------
TEST(VisibilityFilter, IrradianceOfASun)
{
  vtkNew<Filter> filter;
  filter->SetInputData(MakePoints({ { 0.0, 0.0, 100.0 }, { 50.0, 0.0, 2000.0 } }));
  SetMedium(filter, 2e-4, 1e-4);
  filter->SetMediumUp(0.0, 0.0, 1.0);
  filter->SetLight(0.8, 0.0, 0.6, 0.0);
  filter->SetLightColor(1361.0, 900.0, 0.0);
  EXPECT_EQ(Get(filter, "Irradiance", 0, 0), 1361.0); // homogeneous: as it arrives
  filter->SetScaleHeight(1000.0);
  const auto expected = [](double height)
  { return std::exp(-3e-4 * 1000.0 * std::exp(-height / 1000.0) / 0.6); };
  EXPECT_NEAR(Get(filter, "Irradiance", 0, 0), 1361.0 * expected(100.0), 1e-9);
  EXPECT_NEAR(Get(filter, "Irradiance", 1, 1), 900.0 * expected(2000.0), 1e-9);
  EXPECT_EQ(Get(filter, "Irradiance", 1, 2), 0.0);
  filter->SetLight(0.8, 0.0, -0.1, 0.0); // below the horizon
  EXPECT_EQ(Get(filter, "Irradiance", 0, 0), 0.0);

  // a wall's shadow: the ray to the sun meets it at a height of 103 m, or passes over it
  filter->SetLight(0.8, 0.0, 0.6, 0.0);
  filter->SetOccludersData(MakeWall(4.0, 200.0));
  EXPECT_EQ(Get(filter, "Irradiance", 0, 0), 0.0);
  EXPECT_NEAR(Get(filter, "Irradiance", 1, 0), 1361.0 * expected(2000.0), 1e-9);

  // a planet: night on the other side, and the sun at its zenith as over a plane
  filter->SetOccludersData(nullptr);
  filter->SetPlanetRadius(6.36e6);
  filter->SetInputData(MakePoints({ { 0.0, 0.0, 100.0 }, { 0.0, 0.0, -2.0 * 6.36e6 - 100.0 } }));
  filter->SetLight(0.0, 0.0, 1.0, 0.0);
  EXPECT_NEAR(
    Get(filter, "Irradiance", 0, 0), 1361.0 * std::exp(-0.3 * std::exp(-0.1)), 1361.0 * 1e-4);
  EXPECT_EQ(Get(filter, "Irradiance", 1, 0), 0.0);
}

//------------------------------------------------------------------------------
TEST(VisibilityFilter, IrradianceOfALamp)
{
  vtkNew<Filter> filter;
  filter->SetInputData(MakePoints({ { 3.0, 4.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 0.0, -2.0, 0.0 } }));
  SetMedium(filter, 0.05, 0.02);
  filter->SetLight(0.0, 0.0, 0.0, 2.0);
  filter->SetLightColor(100.0, 10.0, 1.0);
  EXPECT_NEAR(Get(filter, "Irradiance", 0, 0), 100.0 / 25.0 * std::exp(-0.35), 1e-12);
  EXPECT_NEAR(Get(filter, "Irradiance", 0, 1), 10.0 / 25.0 * std::exp(-0.35), 1e-13);
  EXPECT_EQ(Get(filter, "Irradiance", 1, 0), 0.0); // in the lamp itself
  filter->SetWorldUnitInMeters(10.0);              // 50 m; coefficients stay in 1/unit
  EXPECT_NEAR(Get(filter, "Irradiance", 0, 0), 100.0 / 2500.0 * std::exp(-0.35), 1e-14);
  filter->SetWorldUnitInMeters(1.0);
  filter->SetSpotDirection(0.0, -1.0, 0.0);
  filter->SetConeAngle(30.0);
  filter->SetSpotExponent(4.0);
  EXPECT_EQ(Get(filter, "Irradiance", 0, 0), 0.0);
  EXPECT_NEAR(Get(filter, "Irradiance", 2, 0), 100.0 / 4.0 * std::exp(-0.14), 1e-12);
  filter->SetSpotDirection(3.0, 4.0, 3.0);
  filter->SetConeAngle(60.0);
  const double cosine = 25.0 / (5.0 * std::sqrt(34.0));
  EXPECT_NEAR(
    Get(filter, "Irradiance", 0, 0), 100.0 / 25.0 * std::pow(cosine, 4.0) * std::exp(-0.35), 1e-12);
  filter->SetOccludersData(MakeWall(1.0, 3.0));
  EXPECT_EQ(Get(filter, "Irradiance", 0, 0), 0.0);
}

//------------------------------------------------------------------------------
TEST(VisibilityFilter, ArraysHaveUnitsAndErrors)
{
  vtkNew<Filter> filter;
  auto grid = MakePoints<vtkUnstructuredGrid>({ { 1.0, 0.0, 0.0 } });
  vtkNew<vtkDoubleArray> own;
  own->SetName("Own");
  own->InsertNextValue(3.0);
  grid->GetPointData()->AddArray(own);
  filter->SetInputData(grid);
  filter->Update();
  vtkPointSet* output = filter->GetOutput();
  ASSERT_TRUE(output && output->IsA("vtkUnstructuredGrid"));
  EXPECT_EQ(grid->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(grid->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_TRUE(output->GetPointData()->GetArray("Own"));
  const std::pair<const char*, const char*> units[] = { { "Distance_m", "m" },
    { "OpticalDepth", "1" }, { "Transmittance", "1" }, { "Contrast", "1" },
    { "MeteorologicalRange_m", "m" }, { "Irradiance", "W m-2" } };
  for (const auto& [name, unit] : units)
  {
    vtkDataArray* array = output->GetPointData()->GetArray(name);
    ASSERT_TRUE(array) << name;
    EXPECT_STREQ(array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()), unit);
    EXPECT_GT(GetErrorBound(filter, name), 0.0);
    EXPECT_LT(GetErrorBound(filter, name), 1e-4);
  }
  filter->ComputeIrradianceOff();
  filter->SetInputData(MakePoints({ { 1.0, 0.0, 0.0 } }));
  filter->Update();
  output = filter->GetOutput();
  EXPECT_TRUE(output->IsA("vtkPolyData"));
  EXPECT_FALSE(output->GetPointData()->GetArray("Irradiance"));
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
TEST(VisibilityFilter, SaysWhatCannotBeUsed)
{
  const double nan = std::nan("");
  const auto check = [](const std::function<void(Filter*)>& spoil, const char* word)
  {
    vtkNew<Filter> filter;
    filter->SetInputData(MakePoints({ { 1.0, 0.0, 0.0 } }));
    spoil(filter);
    const ErrorListener errors(filter);
    filter->Update();
    ASSERT_EQ(errors.Texts.size(), 1u) << word;
    EXPECT_NE(errors.Texts[0].find("Cannot compute what is seen"), std::string::npos);
    EXPECT_NE(errors.Texts[0].find(word), std::string::npos) << errors.Texts[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  check([&](Filter* f) { f->SetCameraPosition(nan, 0.0, 0.0); }, "CameraPosition");
  check([&](Filter* f) { f->SetInputData(MakePoints({ { nan, 0.0, 0.0 } })); }, "point 0");
  check([&](Filter* f) { f->SetOccludersData(MakeWall(nan, 1.0)); }, "point of the occluders 0");
  check([](Filter* f) { f->SetLight(0.0, 0.0, 0.0, 0.0); }, "Light");
  check([](Filter* f) { f->SetScatteringCoefficient(-1.0, 0.0, 0.0); }, "ScatteringCoefficient");
  // what is no error here: a camera that looks nowhere
  vtkNew<Filter> filter;
  filter->SetInputData(MakePoints({ { 1.0, 0.0, 0.0 } }));
  filter->SetCameraFocalPoint(filter->GetCameraPosition());
  const ErrorListener errors(filter);
  filter->Update();
  EXPECT_TRUE(errors.Texts.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 1);
}
