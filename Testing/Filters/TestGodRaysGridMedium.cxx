// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Media of data, exactly: closed forms, a published number, and a march that shares no code.

#include "GodRaysFiltersTesting.h"
#include "GodRaysGridScenes.h"
#include "GodRaysMediumScenes.h"
#include "vtkGodRaysGrid.h"
#include "vtkGodRaysSingleScatteringReference.h"

#include "vtkMatrix3x3.h"

#include <algorithm>
#include <random>

using namespace GodRaysFiltersTesting;
using namespace GodRaysGridScenes;
using GodRaysMediumScenes::Mesh;
using vtkGodRays::Vec3;

namespace
{
using Reference = vtkGodRaysSingleScatteringReference;
const double pi = 3.14159265358979323846;

double GetNumber(Reference* reference, const char* name, int x = 0, int y = 0, int c = 0)
{
  reference->Update();
  vtkImageData* output = reference->GetOutput();
  vtkDataArray* array = output->GetPointData()->GetArray(name);
  return array ? array->GetComponent(y * output->GetDimensions()[0] + x, c) : -1.0;
}

// One pixel that looks along x, without a medium of formulas.
void LookAlongX(Reference* reference, double distance)
{
  reference->SetSize(1, 1);
  reference->SetCameraFocalPoint(1.0, 0.0, 0.0);
  reference->SetCameraViewUp(0.0, 0.0, 1.0);
  reference->SetScatteringCoefficient(0.0, 0.0, 0.0);
  reference->SetFarLimit(distance);
}

// A march of many steps: data are looked up here, between the eight points about each place.
struct March
{
  vtkImageData* Image;
  double Albedo = 1.0;
  int Steps = 400;

  double GetExtinction(const Vec3& p) const
  {
    const double* origin = this->Image->GetOrigin();
    const double* spacing = this->Image->GetSpacing();
    const int* n = this->Image->GetDimensions();
    int cell[3];
    double t[3];
    for (int i = 0; i < 3; ++i)
    {
      const double x = (p[i] - origin[i]) / spacing[i];
      if (!(x >= 0.0 && x <= n[i] - 1))
      {
        return 0.0;
      }
      cell[i] = std::min(static_cast<int>(x), n[i] - 2);
      t[i] = x - cell[i];
    }
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      int at[3];
      for (int i = 0; i < 3; ++i)
      {
        const int up = corner >> i & 1;
        at[i] = cell[i] + up;
        weight *= up ? t[i] : 1.0 - t[i];
      }
      sum += weight * this->Image->GetScalarComponentAsDouble(at[0], at[1], at[2], 0);
    }
    return sum;
  }

  double GetDepth(const Vec3& from, const Vec3& to, int steps) const
  {
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
    {
      sum += this->GetExtinction(from + (i + 0.5) / steps * (to - from));
    }
    return sum * vtkGodRays::length(to - from) / steps;
  }
};
}

//------------------------------------------------------------------------------
// Random lines through random data, against 100 000 steps, and in any number of parts.
TEST(Grid, DepthsOfLinesAreExact)
{
  std::mt19937 generator = MakeGenerator(31);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  const double bounds[6] = { -2.0, 1.0, 0.5, 2.0, -1.0, 3.0 };
  const int points[3] = { 7, 4, 9 };
  auto image = MakeImage(bounds, points, [&](double, double, double) { return uniform(0.0, 2.0); });
  vtkGodRaysGrid grid;
  ASSERT_EQ(grid.Read(image), "");
  const March march = { image };
  double worst = 0.0;
  for (int i = 0; i < 30; ++i)
  {
    Vec3 ends[2];
    for (Vec3& end : ends)
    {
      end = Vec3(uniform(-3.0, 2.0), uniform(0.0, 2.5), uniform(-2.0, 4.0));
    }
    if (i % 3 == 0) // along an axis, in faces of cells
    {
      ends[0] = Vec3(-3.0, 1.0, uniform(-1.0, 3.0));
      ends[1] = Vec3(i % 2 ? 2.0 : -2.5, 1.0, ends[0].z);
    }
    const double length = vtkGodRays::length(ends[1] - ends[0]);
    const Vec3 place = grid.GetPlace(ends[0]);
    const Vec3 steps = grid.GetSteps((ends[1] - ends[0]) / length);
    Vec3 depth(0.0);
    grid.AddDepth(place, steps, 0.0, length, depth);
    worst = std::max(worst, std::abs(depth.x - march.GetDepth(ends[0], ends[1], 100000)));
    Vec3 parts(0.0);
    for (int part = 0; part < 7; ++part)
    {
      grid.AddDepth(place, steps, part * length / 7.0, (part + 1) * length / 7.0, parts);
    }
    EXPECT_NEAR(parts.x, depth.x, 1e-13);
    Vec3 back(0.0);
    grid.AddDepth(grid.GetPlace(ends[1]), -steps, 0.0, length, back);
    EXPECT_NEAR(back.x, depth.x, 1e-13);
    EXPECT_EQ(depth.x, depth.y);
  }
  std::cout << "largest difference from 100 000 steps " << worst << "\n";
  EXPECT_LE(worst, 2e-4); // a step that is half outside: 5 units/100 000, times 2
}

//------------------------------------------------------------------------------
// A ramp along each axis: the optical depth is a square, and no other direction adds to it.
TEST(Grid, RampsAreExact)
{
  const double bounds[6] = { 0.0, 4.0, -1.0, 1.0, -1.0, 1.0 };
  for (const int n : { 2, 3, 17 })
  {
    const int points[3] = { n, 2, 3 };
    auto ramp = MakeImage(bounds, points, [](double x, double, double) { return 0.25 * x; });
    vtkNew<Reference> reference;
    LookAlongX(reference, 10.0);
    reference->SetInputData(2, ramp);
    EXPECT_NEAR(GetNumber(reference, "Transmittance"), std::exp(-0.125 * 16.0), 1e-14);
    reference->SetFarLimit(3.0);
    EXPECT_NEAR(GetNumber(reference, "Transmittance"), std::exp(-0.125 * 9.0), 1e-14);
    // Lit from across: no light is lost on its way but in the unit of data above each place, so
    // L = p integral k s e^-(k s^2/2 + k s) ds, here by Simpson's rule in 20 000 parts.
    reference->SetFarLimit(10.0);
    reference->SetLight(0.0, 0.0, 1.0, 0.0);
    reference->SetDataPhaseFunction(Reference::ISOTROPIC);
    constexpr int parts = 20000;
    double sum = 0.0;
    for (int i = 0; i <= parts; ++i)
    {
      const double s = 4.0 * i / parts;
      const double weight = i == 0 || i == parts ? 1.0 : i % 2 ? 4.0 : 2.0;
      sum += weight * 0.25 * s * std::exp(-0.125 * s * s - 0.25 * s);
    }
    sum *= 4.0 / parts / 3.0 / (4.0 * pi);
    EXPECT_NEAR(GetNumber(reference, "Radiance") / sum, 1.0, 1e-9) << n << " points";
  }
}

//------------------------------------------------------------------------------
// A uniform grid is a homogeneous medium, whatever its resolution: between two walls that are its faces, and
// for a point light in it.
TEST(Grid, UniformDataAreAHomogeneousMedium)
{
  for (const double w : { 0.0, 1.0 })
  {
    vtkNew<Reference> reference;
    reference->SetSize(7, 5);
    reference->SetViewAngle(40.0);
    reference->SetFarLimit(6.0);
    reference->SetParallelProjection(w == 0.0);
    reference->SetParallelScale(2.0);
    reference->SetAsymmetry(0.4);
    reference->SetScatteringCoefficient(0.24, 0.24, 0.24);
    reference->SetAbsorptionCoefficient(0.06, 0.06, 0.06);
    // A directional light is not dimmed by a homogeneous medium: from behind the eye, where the grid ends.
    reference->SetLight(w == 0.0 ? 0.0 : 0.7, w == 0.0 ? 0.0 : 1.1, w == 0.0 ? 1.0 : -3.0, w);
    reference->Update();
    const Picture expected = FromImage(reference->GetOutput());
    const double left = GetNumber(reference, "Transmittance", 2, 3);
    reference->SetScatteringCoefficient(0.0, 0.0, 0.0);
    reference->SetAbsorptionCoefficient(0.0, 0.0, 0.0);
    reference->SetDataAsymmetry(0.4);
    reference->SetDataAlbedo(0.8, 0.8, 0.8);
    reference->SetDataScale(0.3);
    for (const int n : { 2, 5, 16 })
    {
      const double bounds[6] = { -20.0, 20.0, -20.0, 20.0, -6.0, 0.0 };
      const int points[3] = { n, n + 1, 2 * n };
      reference->SetInputData(2,
        MakeImage(
          bounds, points, [](double, double, double) { return 1.0; }, VTK_UNSIGNED_CHAR));
      reference->Update();
      Picture actual = FromImage(reference->GetOutput());
      if (w == 0.0)
      {
        // Light along the rays is dimmed by what it goes through: e^-(2 tau) in place of e^-tau.
        const double part = (1.0 - std::exp(-3.6)) / 2.0 / (1.0 - std::exp(-1.8));
        for (double& value : actual.Values)
        {
          value /= part;
        }
      }
      const double error = GetLargestDifference(actual, expected) / expected.GetMaximum();
      std::cout << "w " << w << ", " << n << " points: " << error << "\n";
      EXPECT_LE(error, 1e-6);
      EXPECT_NEAR(GetNumber(reference, "Transmittance", 2, 3), left, 1e-7);
    }
  }
}

//------------------------------------------------------------------------------
// NIST's smoke_test of the Fire Dynamics Simulator: soot of 8700 m^2/kg times 9.524e-5 kg/m^3, K = 0.8286/m;
// through 1 m of it, a transmittance of 0.43668, white is to be 111 of 255. The last digit given of K is
// worth 2.2e-5 of that. [FDS]
TEST(Grid, SmokeTest)
{
  const double bounds[6] = { 0.0, 1.0, -0.5, 0.5, -0.5, 0.5 };
  const int points[3] = { 11, 11, 11 };
  vtkNew<Reference> reference;
  LookAlongX(reference, 5.0);
  reference->SetInputData(
    2, MakeImage(bounds, points, [](double, double, double) { return 9.524e-5; }));
  reference->SetDataScale(8700.0);
  reference->SetDataAlbedo(0.0, 0.0, 0.0);
  const double left = GetNumber(reference, "Transmittance");
  std::cout << "transmittance " << left << ", grey " << 255.0 * left << "\n";
  EXPECT_NEAR(left, 0.43668, 2.2e-5);
  EXPECT_EQ(std::lround(255.0 * left), 111);
  EXPECT_EQ(GetNumber(reference, "Radiance"), 0.0); // soot of this albedo scatters nothing
  reference->RemoveAllInputConnections(2);          // the control
  EXPECT_EQ(GetNumber(reference, "Transmittance"), 1.0);
}

//------------------------------------------------------------------------------
// Random data in haze, behind and before boxes that throw shadows, for all kinds of light, against a march:
// its points of the view ray, and as many of the light's way to each.
TEST(Grid, AgreesWithAMarch)
{
  std::mt19937 generator = MakeGenerator(32);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * (generator() / 4294967296.0); };
  const double bounds[6] = { -1.5, 1.5, -1.0, 1.2, -6.0, -3.0 };
  const int points[3] = { 5, 6, 7 };
  double worst = 0.0;
  double effect = 0.0;
  for (int round = 0; round < 6; ++round)
  {
    auto image =
      MakeImage(bounds, points, [&](double, double, double) { return uniform(0.0, 1.2); });
    const March march = { image };
    const bool directional = round % 2 == 0;
    Mesh mesh; // between data and light, beyond data, and in them
    mesh.AddBox(-0.6, 0.4, 1.5, 1.6, -5.2, -4.0);
    const double box[6] = { -0.6, 0.4, 1.5, 1.6, -5.2, -4.0 };
    Vec3 light = directional ? Vec3(0.3, 1.0, 0.2) : Vec3(0.4, 2.6, -4.5);
    if (round == 3)
    {
      light = Vec3(0.2, 0.3, -4.2); // in the data
    }
    if (round == 4)
    {
      light = Vec3(0.0, 0.0, -1.0); // behind them: haze before them is in their shadow
    }
    vtkNew<Reference> reference;
    reference->SetInputData(mesh.Get());
    reference->SetInputData(2, image);
    constexpr int size = 3;
    reference->SetSize(size, size);
    reference->SetViewAngle(25.0);
    reference->SetFarLimit(9.0);
    reference->SetScatteringCoefficient(0.05, 0.05, 0.05);
    reference->SetPhaseFunction(Reference::ISOTROPIC);
    reference->SetDataPhaseFunction(Reference::HENYEY_GREENSTEIN);
    reference->SetDataAsymmetry(0.5);
    reference->SetDataAlbedo(0.7, 0.7, 0.7);
    reference->SetLight(light.x, light.y, light.z, directional ? 0.0 : 1.0);
    reference->SetTolerance(1e-6);
    reference->Update();
    const Vec3 to = light / vtkGodRays::length(light);
    for (int pixel = 0; pixel < size * size; ++pixel)
    {
      const double scale = 2.0 / size * std::tan(12.5 * pi / 180.0);
      const Vec3 view(
        (pixel % size - 0.5 * (size - 1)) * scale, (pixel / size - 0.5 * (size - 1)) * scale, -1.0);
      const double length = vtkGodRays::length(view);
      constexpr int steps = 1500;
      double sum = 0.0;
      double plain = 0.0; // without data
      double depth = 0.0;
      for (int i = 0; i < steps; ++i)
      {
        const double z = 9.0 * (i + 0.5) / steps;
        const Vec3 point = z * view;
        const double step = 9.0 / steps * length;
        const double extinction = march.GetExtinction(point);
        depth += 0.5 * step * extinction;
        const Vec3 way = directional ? to : light - point;
        const double r = vtkGodRays::length(way);
        // The box: where the way crosses it.
        double low = 0.0;
        double high = directional ? 1e9 : 1.0;
        for (int axis = 0; axis < 3; ++axis)
        {
          double a = (box[2 * axis] - point[axis]) / way[axis];
          double b = (box[2 * axis + 1] - point[axis]) / way[axis];
          if (way[axis] == 0.0)
          {
            const bool in = point[axis] > box[2 * axis] && point[axis] < box[2 * axis + 1];
            a = in ? -1e9 : 1e9;
            b = 1e9;
          }
          low = std::max(low, std::min(a, b));
          high = std::min(high, std::max(a, b));
        }
        if (low >= high)
        {
          const double cosine = vtkGodRays::dot(way, view) / (r * length);
          const double haze = 0.05 / (4.0 * pi);
          const double g = 0.5;
          const double henyey =
            (1.0 - g * g) / (4.0 * pi * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
          const double hazeDepth = 0.05 * (z * length + (directional ? 0.0 : r));
          const double fall = step / (directional ? 1.0 : r * r) * std::exp(-hazeDepth);
          const double through = march.GetDepth(point, directional ? point + 9.0 * to : light, 150);
          sum += fall * (haze + 0.7 * extinction * henyey) * std::exp(-depth - through);
          plain += fall * haze;
        }
        depth += 0.5 * step * extinction;
      }
      const double actual = GetNumber(reference, "Radiance", pixel % size, pixel / size);
      const double error = std::abs(actual / sum - 1.0);
      worst = std::max(worst, error);
      effect += std::abs(plain / sum - 1.0) / (6 * size * size);
      EXPECT_LE(error, 6e-3) << "round " << round << " pixel " << pixel;
      EXPECT_NEAR(GetNumber(reference, "Transmittance", pixel % size, pixel / size) /
          std::exp(-depth - 0.05 * 9.0 * length),
        1.0, 2e-3);
    }
  }
  std::cout << "largest difference from a march " << worst << ", mean effect of data " << effect
            << "\n";
  EXPECT_GT(effect, 0.1); // the control
}

//------------------------------------------------------------------------------
// Nothing scatters behind data: how far rays go on there changes nothing, by however many times a cell.
TEST(Grid, EmptySpaceBesideDataCountsNothing)
{
  auto plume = MakePlume(48);
  vtkNew<Reference> reference;
  reference->SetInputDataObject(2, plume);
  reference->SetSize(40, 23);
  reference->SetCameraFocalPoint(0.0, 0.0, -1.0);
  reference->SetViewAngle(57.3);
  reference->SetScatteringCoefficient(0.0, 0.0, 0.0);
  reference->SetLight(-0.78, 0.3, -0.55, 0.0);
  reference->SetTolerance(1e-5);
  const auto draw = [&](double farLimit)
  {
    reference->SetFarLimit(farLimit);
    std::vector<double> light;
    for (int y = 0; y < 23; ++y)
    {
      for (int x = 0; x < 40; ++x)
      {
        light.push_back(GetNumber(reference, "Radiance", x, y));
      }
    }
    return light;
  };
  const std::vector<double> shortest = draw(7.6);
  const double peak = *std::max_element(shortest.begin(), shortest.end());
  EXPECT_GT(peak, 0.01);
  for (const double farLimit : { 30.0, 5000.0 })
  {
    const std::vector<double> light = draw(farLimit);
    double worst = 0.0;
    for (std::size_t i = 0; i < light.size(); ++i)
    {
      worst = std::max(worst, std::abs(light[i] - shortest[i]) / peak);
    }
    std::cout << "to " << farLimit << ": largest difference " << worst << " of the peak\n";
    EXPECT_LE(worst, 3e-5);
  }
}

//------------------------------------------------------------------------------
// Two media in the same place are one of their sum; two in a row dim as one through both.
TEST(Grid, SeveralMediaAddUp)
{
  vtkNew<Reference> reference;
  reference->SetSize(6, 6);
  reference->SetViewAngle(40.0);
  reference->SetFarLimit(10.0);
  reference->SetScatteringCoefficient(0.02, 0.02, 0.02);
  reference->SetLight(0.5, 1.0, 0.3, 0.0);
  reference->SetTolerance(1e-7);
  const double bounds[6] = { -1.5, 1.5, -1.5, 1.5, -7.5, -4.5 };
  const int points[3] = { 6, 6, 6 };
  const auto first = [](double x, double y, double) { return 0.5 + 0.2 * x + 0.1 * y; };
  const auto second = [](double x, double, double z) { return 0.3 - 0.1 * x + 0.02 * (z + 6.0); };
  const auto both = [&](double x, double y, double z) { return first(x, y, z) + second(x, y, z); };
  reference->SetInputData(2, MakeImage(bounds, points, both));
  reference->Update();
  const Picture together = FromImage(reference->GetOutput());
  reference->SetInputData(2, MakeImage(bounds, points, first));
  reference->Update();
  const Picture alone = FromImage(reference->GetOutput());
  reference->AddInputData(2, MakeImage(bounds, points, second));
  reference->Update();
  const Picture apart = FromImage(reference->GetOutput());
  EXPECT_LE(GetLargestDifference(together, apart) / together.GetMaximum(), 1e-6);
  EXPECT_GT(GetLargestDifference(together, alone) / together.GetMaximum(), 0.05);
}

//------------------------------------------------------------------------------
// Extents that do not start at 0, an image turned by its direction matrix, and what cannot be used.
TEST(Grid, ReadsImagesOfAllKinds)
{
  const double bounds[6] = { 0.0, 2.0, 0.0, 3.0, 0.0, 1.0 };
  const int points[3] = { 5, 4, 3 };
  const Field field = [](double x, double y, double z) { return 1.0 + x + 2.0 * y + 3.0 * z; };
  auto image = MakeImage(bounds, points, field, VTK_DOUBLE);
  vtkGodRaysGrid plain;
  ASSERT_EQ(plain.Read(image), "");
  EXPECT_LE(vtkGodRays::length(plain.GetPlace(Vec3(1.0, 2.0, 0.5)) - Vec3(2.0, 2.0, 1.0)), 1e-14);
  // An extent that does not start at 0 moves it.
  image->SetExtent(2, 6, 0, 3, -1, 1);
  vtkGodRaysGrid moved;
  ASSERT_EQ(moved.Read(image), "");
  EXPECT_LE(vtkGodRays::length(moved.GetPlace(Vec3(2.0, 2.0, 0.0)) - Vec3(2.0, 2.0, 1.0)), 1e-14);
  // A turn by 90 degrees about z.
  image->SetDimensions(points);
  image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  vtkGodRaysGrid turned;
  ASSERT_EQ(turned.Read(image), "");
  EXPECT_LE(vtkGodRays::length(turned.GetPlace(Vec3(-2.0, 1.0, 0.5)) - Vec3(2.0, 2.0, 1.0)), 1e-14);
  // What cannot be used.
  for (const double wrong : { -1e-3, std::nan(""), HUGE_VAL })
  {
    vtkNew<Reference> reference;
    ErrorListener errors(reference);
    reference->SetSize(2, 2);
    reference->SetInputData(2,
      MakeImage(bounds, points, [&](double x, double, double) { return x > 1.9 ? wrong : 1.0; }));
    reference->Update();
    ASSERT_EQ(errors.Texts.size(), 1u);
    EXPECT_NE(errors.Texts[0].find("negative or not finite"), std::string::npos);
    EXPECT_EQ(reference->GetOutput()->GetNumberOfPoints(), 0);
  }
  const int flat[3] = { 5, 4, 1 };
  EXPECT_NE(plain.Read(MakeImage(bounds, flat, field)).find("no volume"), std::string::npos);
  EXPECT_NE(plain.Read(image, "Soot").find("no array Soot"), std::string::npos);
}
