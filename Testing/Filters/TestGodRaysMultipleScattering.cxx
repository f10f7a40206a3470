// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Light of all orders of scattering: the Monte Carlo reference against published numbers, the solver against
// the reference.

#include "GodRaysFiltersTesting.h"
#include "GodRaysMultipleScatteringReference.h"
#include "GodRaysTransportScenes.h"

#include "vtkSMPTools.h"

#include <chrono>
#include <fstream>
#include <sstream>

using namespace GodRaysTransportScenes;

namespace
{
using Solver = vtkGodRaysMultipleScattering;
using Reference = GodRaysMultipleScatteringReference;
constexpr double Pi = 3.14159265358979323846;

// What the reference made of a case, in some 20 s: see MultipleScattering.WriteTruths.
struct Truth
{
  const char* Name;
  double Peak;                // of all light [radiance]
  double Mean;                // of all light [Peak]
  double Noise;               // of a ray's light of two and more scatterings, RMS [Peak]
  int Orders[Width * Height]; // that light [1e-5 Peak]
};
const Truth Truths[] = {
#include "GodRaysTransportTruths.inc"
};

struct Traced // rays of a case
{
  std::vector<double> Single;
  std::vector<double> Orders;
  std::vector<double> Variance;
};

Traced Trace(const Case& each, int paths, int color = 0)
{
  Reference reference;
  reference.SetScene(
    each.Media, MakeMesh(each), each.Boxes.empty() ? 0.0 : each.Boxes.front().Albedo);
  const std::vector<Ray> rays = MakeRays(each);
  Traced traced;
  traced.Single.resize(rays.size());
  traced.Orders.resize(rays.size());
  traced.Variance.resize(rays.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(rays.size()), 4,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Reference::Result result = reference.Evaluate(
          rays[i].Origin, rays[i].Direction, color, paths, static_cast<unsigned int>(i + 1));
        traced.Single[i] = result.Single;
        traced.Orders[i] = result.Orders;
        traced.Variance[i] = result.Variance;
      }
    });
  return traced;
}

Solver::Parameters MakeParameters(int cells, int directions, int degree)
{
  Solver::Parameters parameters;
  parameters.Cells = cells;
  parameters.Directions = directions;
  parameters.Degree = degree;
  return parameters;
}

Vec3 GetForward(const Case& each)
{
  return (each.Focus - each.Eye) / vtkGodRays::length(each.Focus - each.Eye);
}

// The solver's light of two and more scatterings, of a case's rays.
std::vector<double> Evaluate(Solver& solver, const Case& each, const Solver::Parameters& parameters,
  int steps = 128, int color = 0)
{
  solver.Update(each.Media, parameters);
  Solver::Texture texture;
  solver.Contract(each.Eye, GetForward(each), each.Angle <= 0.0, texture);
  std::vector<double> values;
  for (const Ray& ray : MakeRays(each))
  {
    values.push_back(solver.Evaluate(texture, ray, steps).Orders[color]);
  }
  return values;
}

struct Comparison
{
  double Mean; // the error of the mean of all light [of that]
  double Rms;  // of the error, without the truth's noise [peak]
};

Comparison Compare(const std::vector<double>& values, const Truth& truth)
{
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double error = values[i] / truth.Peak - 1e-5 * truth.Orders[i];
    count += truth.Orders[i] > 0 ? 1 : 0;
    sum += error;
    squares += error * error - truth.Noise * truth.Noise;
  }
  return { sum / (truth.Mean * static_cast<double>(values.size())),
    std::sqrt(std::max(squares, 0.0) / std::max(count, 1)) };
}
}

//------------------------------------------------------------------------------
// A half space that scatters evenly: Chandrasekhar's H functions, radiance = w/(4 pi) mu0/(mu + mu0) H H0.
TEST(MultipleScatteringReference, HalfSpace_Isotropic_MatchesHFunctions)
{
  constexpr int count = 64; // midpoints
  for (const double albedo : { 0.9, 0.99 })
  {
    std::vector<double> h(count, 1.0);
    const auto getH = [&](double mu)
    {
      double sum = 0.0;
      for (int i = 0; i < count; ++i)
      {
        const double other = (i + 0.5) / count;
        sum += other * h[i] / (mu + other) / count;
      }
      return 1.0 / (std::sqrt(1.0 - albedo) + 0.5 * albedo * sum);
    };
    for (int pass = 0; pass < 200; ++pass)
    {
      std::vector<double> next(count);
      for (int i = 0; i < count; ++i)
      {
        next[i] = getH((i + 0.5) / count);
      }
      h = next;
    }
    Case each = MakeCase("half space", Kind::OPEN, 1.0, 0.0, albedo);
    each.Media.Low = Vec3(-2e4, -2e4, -40.0);
    each.Media.High = Vec3(2e4, 2e4, 0.0);
    each.Media.Lights[0].Position = Vec3(-0.6, 0.0, 0.8);
    Reference reference;
    reference.SetScene(each.Media, nullptr, 0.0);
    for (const double mu : { 0.2, 0.6, 1.0 })
    {
      const Reference::Result result =
        reference.Evaluate(Vec3(0.0), Vec3(0.0, -std::sqrt(1.0 - mu * mu), -mu), 0, 20000, 7);
      const double expected =
        albedo / (4.0 * 3.14159265358979) * 0.8 / (mu + 0.8) * getH(mu) * getH(0.8);
      const double sigma = std::sqrt(result.Variance);
      std::cout << "albedo " << albedo << ", mu " << mu << ": "
                << (result.Single + result.Orders) / expected - 1.0 << ", sigma "
                << sigma / expected << "\n";
      EXPECT_NEAR(result.Single + result.Orders, expected, 4.0 * sigma);
      EXPECT_LT(sigma, 0.01 * expected);
    }
  }
}

//------------------------------------------------------------------------------
// A slab of albedo 0.9, asymmetry 0.75 and depth 2, lit across: van de Hulst's reflection and transmission.
TEST(MultipleScatteringReference, Slab_HenyeyGreenstein_MatchesVanDeHulst)
{
  Case each = MakeCase("slab", Kind::OPEN, 1.0, 0.75, 0.9);
  each.Media.Low = Vec3(-2e4, -2e4, -2.0);
  each.Media.High = Vec3(2e4, 2e4, 0.0);
  each.Media.Lights[0].Position = Vec3(0.0, 0.0, 1.0);
  Reference reference;
  reference.SetScene(each.Media, nullptr, 0.0);
  double flux[2] = { 0.0, std::exp(-2.0) };
  double variance[2] = { 0.0, 0.0 };
  constexpr int count = 200;
  for (int i = 0; i < 2 * count; ++i)
  {
    const int pair = i / 2;
    const double mu = (pair + 0.5) / count;
    const double side = i % 2 ? -1.0 : 1.0; // of the slab, from which it is seen
    const Reference::Result result = reference.Evaluate(Vec3(0.0, 0.0, side < 0.0 ? -2.0 : 0.0),
      Vec3(std::sqrt(1.0 - mu * mu), 0.0, -side * mu), 0, 1000, i);
    const double weight = 2.0 * 3.14159265358979 * mu / count;
    flux[i % 2] += weight * (result.Single + result.Orders);
    variance[i % 2] += weight * weight * result.Variance;
  }
  std::cout << "reflected " << flux[0] << ", passed " << flux[1] << ", sigma "
            << std::sqrt(variance[0]) << " and " << std::sqrt(variance[1]) << "\n";
  EXPECT_NEAR(flux[0], 0.09739, 0.0015);
  EXPECT_NEAR(flux[1], 0.66096, 0.003);
}

//------------------------------------------------------------------------------
// In light that comes evenly from everywhere, what absorbs nothing looks as bright as that everywhere.
TEST(MultipleScatteringReference, Furnace_AlbedoOne_IsEven)
{
  for (const bool smoke : { true, false })
  {
    Case each = smoke ? MakeCase("smoke", Kind::SMOKE, 5.0, 0.5)
                      : MakeCase("columns", Kind::COLUMNS, 2.0, 0.5, 1.0, View::SIDE, 1.0);
    each.Media.Lights.clear();
    constexpr int suns = 400;
    for (int i = 0; i < suns; ++i)
    {
      const double z = (2.0 * i + 1.0) / suns - 1.0;
      const double aside = std::sqrt(1.0 - z * z);
      AddSun(each, Vec3(aside * std::cos(2.39996 * i), aside * std::sin(2.39996 * i), z),
        4.0 * 3.14159265358979 / suns);
    }
    Reference reference;
    reference.SetScene(each.Media, MakeMesh(each), 1.0);
    double sum = 0.0;
    double variance = 0.0;
    double directly = 0.0; // seen through the medium
    constexpr int rays = 200;
    for (int i = 0; i < rays; ++i)
    {
      const double z = (2.0 * i + 1.0) / rays - 1.0;
      const double aside = std::sqrt(1.0 - z * z);
      const Vec3 along(aside * std::cos(2.39996 * i), aside * std::sin(2.39996 * i), z);
      const Vec3 eye = smoke ? Vec3(0.5) : Vec3(0.5, 0.15, 0.3);
      const Reference::Result result = reference.Evaluate(eye, along, 0, 1000, i);
      sum += result.Single + result.Orders;
      variance += result.Variance;
      double begin = 0.0;
      double end = 1e9;
      each.Media.Clip(eye, along, begin, end);
      for (const Box& box : each.Boxes)
      {
        end = std::min(end, box.Meet(eye, along)); // surfaces count as bright
      }
      double depth = 0.0;
      for (int k = 0; k < 256; ++k)
      {
        const Vec3 place = eye + (k + 0.5) / 256 * end * along;
        depth += each.Media.Sample(0, place).Extinction.x * end / 256;
      }
      directly += std::exp(-depth);
    }
    std::cout << (sum + directly) / rays << ", sigma " << std::sqrt(variance) / rays << "\n";
    EXPECT_NEAR((sum + directly) / rays, 1.0, 0.01);
    EXPECT_LT(directly, 0.7 * rays);
  }
}

//------------------------------------------------------------------------------
// Writes GodRaysTransportTruths.inc anew, to the file and in the seconds for each case that the environment
// tells. Numbers differ from run to run by their noise.
TEST(MultipleScattering, WriteTruths)
{
  const char* const file = std::getenv("GODRAYS_TRUTHS");
  const char* const seconds = std::getenv("GODRAYS_SECONDS");
  if (!file || !seconds)
  {
    GTEST_SKIP() << "GODRAYS_TRUTHS and GODRAYS_SECONDS are not set";
  }
  std::ofstream out(file);
  out << "// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors\n"
         "// SPDX-License-Identifier: BSD-3-Clause\n";
  for (const Case& each : MakeCases())
  {
    const auto getSeconds = []
    {
      const auto now = std::chrono::steady_clock::now().time_since_epoch();
      return std::chrono::duration<double>(now).count();
    };
    const double start = getSeconds();
    Trace(each, 16);
    const double taken = std::max(getSeconds() - start, 1e-3);
    const Traced traced =
      Trace(each, static_cast<int>(glm::clamp(16.0 * std::atof(seconds) / taken, 16.0, 1e6)));
    double peak = 0.0;
    double mean = 0.0;
    double variance = 0.0;
    for (std::size_t i = 0; i < traced.Orders.size(); ++i)
    {
      peak = std::max(peak, traced.Single[i] + traced.Orders[i]);
      mean += (traced.Single[i] + traced.Orders[i]) / static_cast<double>(traced.Orders.size());
      variance += traced.Variance[i] / static_cast<double>(traced.Orders.size());
    }
    out << "{ \"" << each.Name << "\", " << peak << ", " << mean / peak << ", "
        << std::sqrt(variance) / peak << ",\n  {";
    for (std::size_t i = 0; i < traced.Orders.size(); ++i)
    {
      out << (i % Width == 0 && i > 0 ? "\n   " : "") << " "
          << std::lround(1e5 * traced.Orders[i] / peak) << ",";
    }
    out << " } }," << std::endl;
  }
}

//------------------------------------------------------------------------------
// What is kept is what the reference says today.
TEST(MultipleScatteringReference, Truths_AreReproduced)
{
  const std::vector<Case> cases = MakeCases();
  ASSERT_EQ(cases.size(), std::size(Truths));
  for (const std::size_t i : { 1u, 8u, 12u, 17u, 25u, 28u, 33u })
  {
    const Traced traced = Trace(cases[i], 100);
    double sum = 0.0;
    double variance = 0.0;
    double expected = 0.0;
    for (std::size_t k = 0; k < traced.Orders.size(); ++k)
    {
      sum += traced.Orders[k];
      variance += traced.Variance[k];
      expected += 1e-5 * Truths[i].Orders[k] * Truths[i].Peak;
    }
    EXPECT_EQ(cases[i].Name, Truths[i].Name);
    EXPECT_NEAR(sum, expected, 4.0 * std::sqrt(variance)) << cases[i].Name;
  }
}

//------------------------------------------------------------------------------
// The accuracy that is promised for the default tolerance: against Monte Carlo, each case; a table is
// printed.
TEST(MultipleScattering, Cases_DefaultTolerance_MatchReference)
{
  const std::vector<Case> cases = MakeCases();
  ASSERT_EQ(cases.size(), std::size(Truths));
  std::vector<double> errors;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    Solver solver;
    const Solver::Parameters parameters =
      Solver::Choose(1.0 / 255.0, cases[i].Depth, cases[i].Asymmetry);
    const Comparison c = Compare(Evaluate(solver, cases[i], parameters), Truths[i]);
    std::printf("%-30s mean %+.3f rms %.4f (truth's noise %.4f), %d sweeps\n",
      cases[i].Name.c_str(), c.Mean, c.Rms, Truths[i].Noise, solver.GetReport().Sweeps);
    EXPECT_LE(c.Rms, 0.05) << cases[i].Name;
    EXPECT_LE(std::abs(c.Mean), 0.05) << cases[i].Name;
    errors.push_back(c.Rms);
  }
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  std::printf("median rms %.4f\n", errors[errors.size() / 2]);
  EXPECT_LE(errors[errors.size() / 2], 0.012);
}

//------------------------------------------------------------------------------
// Finer grids and more directions err less; and without the peak function, errors are large.
TEST(MultipleScattering, Cases_FinerParameters_Converge)
{
  const std::vector<Case> cases = MakeCases();
  for (const std::size_t i : { 2u, 6u, 17u, 25u, 28u })
  {
    const auto getRms = [&](const Solver::Parameters& parameters)
    {
      Solver solver;
      return Compare(Evaluate(solver, cases[i], parameters), Truths[i]).Rms;
    };
    const double coarse = getRms(MakeParameters(6, 14, 1));
    const double middle = getRms(MakeParameters(12, 26, 2));
    const double fine = getRms(MakeParameters(32, 98, 3));
    std::printf("%-30s %.4f, %.4f, %.4f\n", cases[i].Name.c_str(), coarse, middle, fine);
    EXPECT_LT(fine, 0.6 * coarse) << cases[i].Name;
    EXPECT_LT(fine, 0.6 * middle) << cases[i].Name;
  }
  // The control: light of the peak left out.
  const std::size_t against = 23;
  Solver solver;
  solver.Update(cases[against].Media, MakeParameters(16, 26, 2));
  Solver::Texture texture;
  solver.Contract(cases[against].Eye, GetForward(cases[against]), false, texture);
  std::vector<double> values;
  for (const Ray& ray : MakeRays(cases[against]))
  {
    const Solver::Result result = solver.Evaluate(texture, ray, 128);
    values.push_back(result.Orders.x - result.Broad.x);
  }
  EXPECT_GT(Compare(values, Truths[against]).Rms, 0.1);
}

//------------------------------------------------------------------------------
// The estimate is above the error in 90 of 100 cases, and not by far.
TEST(MultipleScattering, Estimate_Cases_IsAboveError)
{
  const std::vector<Case> cases = MakeCases();
  int above = 0;
  std::vector<double> ratios;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    Solver solver;
    const double rms =
      Compare(Evaluate(solver, cases[i], MakeParameters(16, 26, 2), 64), Truths[i]).Rms;
    const double estimate =
      solver.Estimate(MakeRays(cases[i]), GetForward(cases[i]), cases[i].Angle <= 0.0, 64) /
      Truths[i].Peak;
    std::printf("%-30s rms %.4f estimate %.4f%s\n", cases[i].Name.c_str(), rms, estimate,
      estimate < rms ? " below" : "");
    above += estimate >= rms ? 1 : 0;
    ratios.push_back(estimate / std::max(rms, 1e-4));
  }
  std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
  std::printf(
    "above in %d of %zu, median ratio %.2f\n", above, cases.size(), ratios[ratios.size() / 2]);
  EXPECT_GE(10 * above, 9 * static_cast<int>(cases.size()));
  EXPECT_LT(ratios[ratios.size() / 2], 8.0);
}

//------------------------------------------------------------------------------
// A box with white walls and floor, whose medium absorbs nothing: what enters by the open top leaves by it.
// What is left is light that walls reflect at once: half of all directions have 3 % too little of a flux.
TEST(MultipleScattering, WhiteBox_AlbedoOne_KeepsEnergy)
{
  for (const double g : { 0.0, 0.7 })
  {
    Case each = MakeCase("white box", Kind::OPEN, 2.0, g);
    each.Media.High = Vec3(1.0);
    each.Media.Lights[0].Position = Vec3(0.3, 0.2, 0.9);
    std::fill_n(each.Media.FaceAlbedo, 5, 1.0);
    Solver::Parameters parameters = MakeParameters(32, 98, 3);
    parameters.Residual = 1e-4;
    Solver solver;
    solver.Update(each.Media, parameters);
    const std::vector<float>& moments = solver.GetMoments(0); // that of Y_10 is the flux
    constexpr std::size_t nodes = 33;
    double flux = 0.0;
    for (std::size_t i = 0; i < nodes * nodes; ++i)
    {
      const double area = (i % nodes % (nodes - 1) ? 1.0 : 0.5) *
        (i / nodes % (nodes - 1) ? 1.0 : 0.5) / ((nodes - 1.0) * (nodes - 1.0));
      flux += area * std::sqrt(4.0 * Pi / 3.0) * moments[(3 * nodes - 1) * nodes * nodes + i];
    }
    const double enters = 0.9 / vtkGodRays::length(each.Media.Lights[0].Position);
    std::cout << "g " << g << ": leaves " << flux / enters << " of what enters, "
              << solver.GetReport().Sweeps << " sweeps\n";
    EXPECT_NEAR(flux / enters, 1.0, 0.01);
  }
}

//------------------------------------------------------------------------------
TEST(MultipleScattering, Update_NothingChanged_DoesNotSolve)
{
  Case each = MakeCases()[1];
  Solver solver;
  EXPECT_TRUE(solver.Update(each.Media, MakeParameters(8, 14, 1)));
  EXPECT_FALSE(solver.Update(each.Media, MakeParameters(8, 14, 1)));
  EXPECT_TRUE(solver.Update(each.Media, MakeParameters(9, 14, 1)));
  each.Media.Lights[0].Color = Vec3(2.0);
  ++each.Media.Version;
  const std::vector<float> before = solver.GetMoments(0);
  EXPECT_TRUE(solver.Update(each.Media, MakeParameters(9, 14, 1)));
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_NEAR(solver.GetMoments(0)[i], 2.0f * before[i], 1e-5f);
  }
}

//------------------------------------------------------------------------------
// Random scenes, turned by 90 degrees or in other units, look the same; the control is a sun that stays.
TEST(MultipleScattering, RandomScenes_TurnedOrScaled_LookTheSame)
{
  GodRaysMediumScenes::Random random = { GodRaysFiltersTesting::MakeGenerator(5) };
  for (int number = 0; number < 10; ++number)
  {
    Case each = MakeCase("random", Kind::OPEN, random.Log(0.1, 5.0), random.Uniform(-0.2, 0.9),
      random.Uniform(0.8, 1.0));
    each.Media.High =
      Vec3(random.Uniform(0.6, 1.0), random.Uniform(0.6, 1.0), random.Uniform(0.6, 1.0));
    const Vec3 corner(random.Uniform(0.2, 0.4), random.Uniform(0.2, 0.4), random.Uniform(0.1, 0.3));
    each.Boxes.push_back({ corner, corner + 0.25, random.Uniform(0.0, 0.6) });
    each.Media.FaceAlbedo[number % 6] = random.Uniform(0.0, 0.5);
    each.Media.Lights[0].Position = random.Direction();
    if (number % 3 == 0)
    {
      SetLamp(each, each.Media.High * 0.9);
    }
    each.Focus = 0.5 * each.Media.High;
    each.Eye = each.Focus + 1.7 * random.Direction();
    Case turned = each;
    const auto turn = [](const Vec3& v) { return Vec3(-v.y, v.x, v.z); };
    const auto turnBox = [&](Vec3& low, Vec3& high)
    {
      const Vec3 a = turn(low);
      const Vec3 b = turn(high);
      low = vtkGodRays::min(a, b);
      high = vtkGodRays::max(a, b);
    };
    turnBox(turned.Media.Low, turned.Media.High);
    turnBox(turned.Boxes[0].Low, turned.Boxes[0].High);
    turned.Media.Lights[0].Position = turn(each.Media.Lights[0].Position);
    turned.Eye = turn(each.Eye);
    turned.Focus = turn(each.Focus);
    const double* const faces = each.Media.FaceAlbedo; // +x becomes +y, +y becomes -x
    const double turnedFaces[6] = { faces[3], faces[2], faces[0], faces[1], faces[4], faces[5] };
    std::copy_n(turnedFaces, 6, turned.Media.FaceAlbedo);
    Case wrong = turned;
    wrong.Media.Lights[0].Position = each.Media.Lights[0].Position;
    Case scaled = each;
    constexpr double unit = 1000.0;
    scaled.Media.High *= unit;
    scaled.Boxes[0].Low *= unit;
    scaled.Boxes[0].High *= unit;
    scaled.Eye *= unit;
    scaled.Focus *= unit;
    scaled.Media.Medium.Scale(1.0 / unit);
    if (!each.Media.Lights[0].Directional)
    {
      scaled.Media.Lights[0].Position *= unit;
      scaled.Media.Lights[0].Color *= unit * unit;
    }
    std::vector<double> values[4];
    double largest[4] = { 0.0 }; // differences from the first, and its largest value
    Case* const all[4] = { &each, &turned, &scaled, &wrong };
    for (int i = 0; i < 4; ++i)
    {
      SetOccluders(*all[i]);
      Solver solver;
      Solver::Parameters parameters = MakeParameters(10, 26, 2);
      parameters.Residual = 1e-5;
      values[i] = Evaluate(solver, *all[i], parameters, 32);
      for (std::size_t k = 0; k < values[i].size(); ++k)
      {
        largest[i] = std::max(largest[i], std::abs(values[i][k] - (i > 0 ? values[0][k] : 0.0)));
      }
    }
    EXPECT_LT(largest[1], 1e-3 * largest[0]) << number;
    EXPECT_LT(largest[2], 1e-3 * largest[0]) << number;
    EXPECT_GT(largest[3], 1e-2 * largest[0]) << number;
  }
}

//------------------------------------------------------------------------------
TEST(MultipleScattering, Threads_Several_GiveTheSameBytes)
{
  const Case each = MakeCases()[12];
  std::vector<float> moments[2];
  for (const bool several : { false, true })
  {
    const std::string before = vtkSMPTools::GetBackend();
    vtkSMPTools::SetBackend(several ? before.c_str() : "Sequential");
    Solver solver;
    solver.Update(each.Media, MakeParameters(12, 26, 2));
    moments[several] = solver.GetMoments(0);
    vtkSMPTools::SetBackend(before.c_str());
  }
  EXPECT_EQ(moments[0], moments[1]);
}

//------------------------------------------------------------------------------
// Light of one colour is solved once, that of several for each: the same numbers.
TEST(MultipleScattering, Colors_SolvedTogetherOrNot_AreTheSame)
{
  Case each = MakeCases()[6];
  each.Media.Lights[0].Color = Vec3(1.0, 0.5, 0.25);
  Solver together;
  together.Update(each.Media, MakeParameters(12, 26, 2));
  vtkGodRaysMedium::Component& part = each.Media.Medium.Components[0];
  part.Scattering[1] *= 0.5; // other colours, the same red
  part.Scattering[2] *= 0.2;
  Solver apart;
  apart.Update(each.Media, MakeParameters(12, 26, 2));
  EXPECT_EQ(together.GetMoments(0), apart.GetMoments(0));
  EXPECT_NE(together.GetMoments(1), apart.GetMoments(1));
  for (std::size_t i = 0; i < together.GetMoments(0).size(); ++i)
  {
    EXPECT_NEAR(together.GetMoments(2)[i], 0.25f * together.GetMoments(0)[i], 1e-7f);
  }
}

//------------------------------------------------------------------------------
// The peak function against its integrals: all of it, and the whole of one event. Its forward part is a
// moment.
TEST(MultipleScattering, Peak_PhaseFunctions_HaveTheirIntegrals)
{
  for (int kind = 0; kind <= vtkGodRaysLastPhaseFunction; ++kind)
  {
    const double g = 0.8;
    const Case each = MakeCase("phase", Kind::OPEN, 1.0, g, 1.0, View::SIDE, 0.0, kind);
    Solver solver;
    solver.Update(each.Media, MakeParameters(4, 14, 2));
    const vtkGodRaysForwardPeak& peak = solver.GetPeak();
    const double f = peak.ForwardPart;
    if (kind == vtkGodRays::PHASE_HENYEY_GREENSTEIN)
    {
      EXPECT_NEAR(f, g * g * g, 1e-5);
    }
    if (f == 0.0)
    {
      EXPECT_FALSE(kind > vtkGodRays::PHASE_RAYLEIGH);
      continue;
    }
    for (const double n : { 0.1, 1.0, 5.0 })
    {
      double sum = 0.0;
      constexpr int count = 4000;
      for (int i = 0; i < count; ++i)
      {
        const double x = (i + 0.5) / count;
        sum += 12.0 * Pi * x * x / count * peak.Get(1.0 - 2.0 * x * x * x, n);
      }
      const double expected = 1.0 - f + f * (1.0 - std::exp(-n)) / n - std::exp(-n);
      EXPECT_NEAR(sum, expected, 0.01) << kind << " " << n;
    }
  }
}

//------------------------------------------------------------------------------
// What has nothing to scatter, or too much, or is too thin, gives finite numbers that are not negative.
TEST(MultipleScattering, Scenes_Degenerate_GiveFiniteMoments)
{
  const std::pair<const char*, std::function<void(Case&)>> changes[] = {
    { "no light", [](Case& each) { each.Media.Lights.clear(); } },
    { "no media", [](Case& each) { each.Media.Medium.NumberOfComponents = 0; } },
    { "nothing scatters", [](Case& each) { SetMedium(each, 1.0, 0.5, 0.0, 2); } },
    { "opaque", [](Case& each) { SetMedium(each, 1e6, 0.5, 1.0, 2); } },
    { "thin box", [](Case& each) { each.Media.High.z = 1e-3; } },
    { "flat box", [](Case& each) { each.Media.High.y = 0.0; } },
    { "long box", [](Case& each) { each.Media.High.x = 50.0; } },
    { "peak", [](Case& each) { SetMedium(each, 1.0, 0.99, 1.0, 2); } },
    { "peak to the back", [](Case& each) { SetMedium(each, 1.0, -0.99, 1.0, 2); } },
    { "lamp at a node", [](Case& each) { SetLamp(each, Vec3(0.5, 0.5, 0.3)); } },
    { "all is solid",
      [](Case& each)
      {
        each.Boxes = { { Vec3(-1.0), Vec3(2.0), 0.5 } };
        SetOccluders(each);
      } },
    { "white faces", [](Case& each) { std::fill_n(each.Media.FaceAlbedo, 6, 0.9); } },
  };
  for (const auto& [name, change] : changes)
  {
    for (const int cells : { 2, 7 })
    {
      Case each = MakeCase(name, Kind::OPEN, 1.0, 0.5);
      change(each);
      Solver solver;
      Solver::Parameters parameters = MakeParameters(cells, 26, 2);
      const std::vector<double> values = Evaluate(solver, each, parameters, 8);
      double largest = 0.0;
      for (const double value : values)
      {
        EXPECT_TRUE(std::isfinite(value)) << name;
        largest = std::max(largest, value);
      }
      for (const double value : values)
      {
        EXPECT_GE(value, -0.2 * largest) << name; // moments are of a low degree
      }
      EXPECT_LT(solver.GetReport().Sweeps, 100) << name;
      std::cout << name << " " << largest << "\n";
    }
  }
}
