// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysFireSource.h"

#include "vtkGodRaysNoise.h"
#include "vtkGodRaysSetGet.h"
#include "vtkGodRaysSourceTools.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <numeric>

vtkStandardNewMacro(vtkGodRaysFireSource);

vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, SpawnRate, 0.0, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, Lifetime, 1e-3, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, TimeScale, 0.0, 1e3);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, EndTime, 0.0, 1e6);
vtkGodRaysSetFinite3Macro(vtkGodRaysFireSource, Center, -1e9, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, PositionRandomness, 0.0, 1e9);
vtkGodRaysSetFinite3Macro(vtkGodRaysFireSource, Velocity, -1e6, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, VelocityRandomness, 0.0, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, Turbulence, 0.0, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, TurbulenceSize, 1e-6, 1e6);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, Size, 0.0, 1e9);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, SizeRandomness, 0.0, 1.0);
vtkGodRaysSetFinite3Macro(vtkGodRaysFireSource, StartColor, 0.0, 1.0);
vtkGodRaysSetFinite3Macro(vtkGodRaysFireSource, EndColor, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, ColorRandomness, 0.0, 1.0);
vtkGodRaysSetFiniteMacro(vtkGodRaysFireSource, Opacity, 0.0, 1.0);

namespace
{
using vtkGodRaysNoise::Vector;

// What is random, each by numbers of its own.
enum Channel : unsigned int
{
  POSITION = 0, // 3 numbers
  VELOCITY = 3, // 3 numbers
  EXTENT = 6,
  COLOR = 7,  // 3 numbers
  EDDIES = 10 // 3 noises
};

// The random numbers of one particle, in [0, 1).
class Dice
{
public:
  Dice(int seed, vtkTypeInt64 birth)
    : Seed(static_cast<unsigned int>(seed))
    , Birth(static_cast<std::uint64_t>(birth))
  {
  }

  double Throw(unsigned int channel) const
  {
    return vtkGodRaysNoise::Uniform(vtkGodRaysNoise::MakeSeed(this->Seed, channel), this->Birth);
  }

  // A factor of 1 - deviation to 1 + deviation.
  double Vary(unsigned int channel, double deviation) const
  {
    return 1.0 + deviation * (2.0 * this->Throw(channel) - 1.0);
  }

  // Evenly over the unit ball.
  Vector FindPointInBall(unsigned int channel) const
  {
    const double z = 2.0 * this->Throw(channel) - 1.0;
    const double azimuth = 2.0 * vtkMath::Pi() * this->Throw(channel + 1);
    const double radius = std::cbrt(this->Throw(channel + 2));
    const double across = radius * std::sqrt(1.0 - z * z);
    return { across * std::cos(azimuth), across * std::sin(azimuth), radius * z };
  }

private:
  unsigned int Seed;
  std::uint64_t Birth;
};

vtkSmartPointer<vtkIdTypeArray> MakeCount(vtkIdType count)
{
  auto numbers = vtkSmartPointer<vtkIdTypeArray>::New();
  numbers->SetNumberOfTuples(count);
  std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + count, 0);
  return numbers;
}
}

struct vtkGodRaysFireSource::Particle
{
  double Age;
  double Size;
  double Position[3];
  double Color[4];
};

vtkGodRaysFireSource::vtkGodRaysFireSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkGodRaysFireSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Capacity: " << this->Capacity << "\n";
  os << indent << "SpawnRate: " << this->SpawnRate << "\n";
  os << indent << "Lifetime: " << this->Lifetime << "\n";
  os << indent << "TimeScale: " << this->TimeScale << "\n";
  os << indent << "EndTime: " << this->EndTime << "\n";
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2]
     << "\n";
  os << indent << "PositionRandomness: " << this->PositionRandomness << "\n";
  os << indent << "Velocity: " << this->Velocity[0] << " " << this->Velocity[1] << " "
     << this->Velocity[2] << "\n";
  os << indent << "VelocityRandomness: " << this->VelocityRandomness << "\n";
  os << indent << "Turbulence: " << this->Turbulence << "\n";
  os << indent << "TurbulenceSize: " << this->TurbulenceSize << "\n";
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "SizeRandomness: " << this->SizeRandomness << "\n";
  os << indent << "StartColor: " << this->StartColor[0] << " " << this->StartColor[1] << " "
     << this->StartColor[2] << "\n";
  os << indent << "EndColor: " << this->EndColor[0] << " " << this->EndColor[1] << " "
     << this->EndColor[2] << "\n";
  os << indent << "ColorRandomness: " << this->ColorRandomness << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}

int vtkGodRaysFireSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* information = output->GetInformationObject(0);
  information->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  vtkGodRaysSourceTools::SetTimeRange(information, this->EndTime);
  return 1;
}

vtkGodRaysFireSource::Particle vtkGodRaysFireSource::ComputeParticle(
  vtkTypeInt64 birth, double time) const
{
  const Dice dice(this->Seed, birth);
  Particle particle;
  particle.Age = vtkMath::ClampValue(time - birth / this->SpawnRate, 0.0, this->Lifetime);
  const double part = particle.Age / this->Lifetime;

  const Vector place = dice.FindPointInBall(POSITION);
  const Vector drift = dice.FindPointInBall(VELOCITY);
  Vector inEddies;
  for (int i = 0; i < 3; ++i)
  {
    particle.Position[i] = this->Center[i] + this->PositionRandomness * place[i] +
      particle.Age * (this->Velocity[i] + this->VelocityRandomness * drift[i]);
    inEddies[i] = particle.Position[i] / this->TurbulenceSize;
  }
  // The noise has three dimensions: time passes as a motion along x, which is as good as another one.
  inEddies[0] += time / this->Lifetime;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const auto seed = static_cast<unsigned int>(this->Seed);
    particle.Position[i] += particle.Age * this->Turbulence *
      vtkGodRaysNoise::GradientNoise(inEddies, vtkGodRaysNoise::MakeSeed(seed, EDDIES + i)).Value;
  }

  particle.Size = this->Size * (1.0 - part) * dice.Vary(EXTENT, this->SizeRandomness);
  for (unsigned int c = 0; c < 3; ++c)
  {
    const double color = this->StartColor[c] + part * (this->EndColor[c] - this->StartColor[c]);
    particle.Color[c] =
      vtkMath::ClampValue(color * dice.Vary(COLOR + c, this->ColorRandomness), 0.0, 1.0);
  }
  particle.Color[3] = this->Opacity * (1.0 - part);
  return particle;
}

int vtkGodRaysFireSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* information = output->GetInformationObject(0);
  vtkPolyData* fire = vtkPolyData::GetData(output);
  const double asked = vtkGodRaysSourceTools::GetTime(information, this->EndTime);
  const double time = asked * this->TimeScale;

  // Particles [first, end) live.
  const auto end = this->SpawnRate > 0.0
    ? static_cast<vtkTypeInt64>(std::floor(time * this->SpawnRate)) + 1
    : vtkTypeInt64(0);
  const auto old =
    static_cast<vtkTypeInt64>(std::floor((time - this->Lifetime) * this->SpawnRate)) + 1;
  const vtkTypeInt64 first = std::max({ old, end - this->Capacity, vtkTypeInt64(0) });
  const vtkTypeInt64 living = std::max(end - first, vtkTypeInt64(0));
  // Of these, those of the piece.
  const int pieces = std::max(1, information->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  const int piece = information->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const vtkTypeInt64 skipped = living * piece / pieces;
  const auto count = static_cast<vtkIdType>(living * (piece + 1) / pieces - skipped);

  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkFloatArray> sizes;
  vtkNew<vtkFloatArray> ages;
  points->SetNumberOfPoints(count);
  colors->SetName("Color");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(count);
  sizes->SetName("Size");
  sizes->SetNumberOfTuples(count);
  ages->SetName("Age");
  ages->SetNumberOfTuples(count);
  const bool finished = vtkGodRaysSourceTools::For(this, count,
    [&](vtkIdType begin, vtkIdType stop)
    {
      for (vtkIdType i = begin; i < stop; ++i)
      {
        const Particle particle = this->ComputeParticle(first + skipped + i, time);
        points->SetPoint(i, particle.Position);
        *sizes->GetPointer(i) = static_cast<float>(particle.Size);
        *ages->GetPointer(i) = static_cast<float>(particle.Age);
        std::transform(particle.Color, particle.Color + 4, colors->GetPointer(4 * i),
          [](double value) { return static_cast<unsigned char>(std::lround(255.0 * value)); });
      }
    });
  if (!finished)
  {
    fire->Initialize();
    return 1;
  }

  vtkNew<vtkCellArray> vertices;
  vertices->SetData(MakeCount(count + 1), MakeCount(count));
  fire->SetPoints(points);
  fire->SetVerts(vertices);
  fire->GetPointData()->SetScalars(colors);
  fire->GetPointData()->AddArray(sizes);
  fire->GetPointData()->AddArray(ages);
  fire->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), asked);
  return 1;
}
