// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGodRaysReferenceFilter.h"

#include "vtkDataArray.h"
#include "vtkGodRaysMath.h"
#include "vtkGodRaysSetGet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkGodRaysReferenceFilter);

namespace
{
constexpr double LargestFloat = std::numeric_limits<float>::max();

// The input's pixels, sanitised, with a border of zeros one pixel wide.
template <typename Scalar>
class PaddedImage
{
public:
  PaddedImage(const Scalar* pixels, int width, int height, int components)
    : Width(width)
    , Height(height)
    , Components(components)
    , RowLength(static_cast<std::size_t>(components) * (width + 2))
    , Values(this->RowLength * (height + 2))
  {
    const std::size_t length = static_cast<std::size_t>(components) * width;
    for (int y = 0; y < height; ++y)
    {
      const Scalar* row = pixels + y * length;
      std::transform(row, row + length, this->Values.data() + this->GetIndex(0, y),
        [](Scalar value)
        { return static_cast<Scalar>(vtkGodRays::Sanitize(value, LargestFloat)); });
    }
  }

  // The first value of the pixel, -1 <= x <= Width, -1 <= y <= Height.
  const Scalar* GetPixel(int x, int y) const { return this->Values.data() + this->GetIndex(x, y); }
  // From a pixel to the one above it, in values.
  std::size_t GetRowLength() const { return this->RowLength; }

  const int Width;
  const int Height;
  const int Components;

private:
  std::size_t GetIndex(int x, int y) const
  {
    return (y + 1) * this->RowLength + (x + 1) * static_cast<std::size_t>(this->Components);
  }

  const std::size_t RowLength;
  std::vector<Scalar> Values;
};

// 1/j
constexpr std::array<double, 36> MakeInverses()
{
  std::array<double, 36> inverses{};
  for (int j = 1; j < 36; ++j)
  {
    inverses[j] = 1.0 / j;
  }
  return inverses;
}
constexpr std::array<double, 36> Inverse = MakeInverses();

// The integrals over a stretch of a march: of (1-s)^2, 2 s (1-s) and s^2 times w(s), s in [0, 1],
// where w falls or grows exponentially from w(0) = start to w(1) = end. Nothing cancels: the series
// has positive terms, and the closed form is used where its own terms differ enough.
class BernsteinIntegrals
{
public:
  BernsteinIntegrals(double start, double end, double z) // z = ln(start/end)
  {
    if (z < 0.0)
    {
      this->SetFalling(end, start, -z);
      std::swap(this->First, this->Last);
    }
    else
    {
      this->SetFalling(start, end, z);
    }
  }

  // The integral of w times the product of two linear functions, given at s = 0 and s = 1.
  double OfProduct(double a0, double a1, double b0, double b1) const
  {
    return this->First * a0 * b0 + 0.5 * this->Middle * (a0 * b1 + a1 * b0) + this->Last * a1 * b1;
  }

private:
  void SetFalling(double start, double end, double z)
  {
    if (z < 2.0)
    {
      // end e^(z (1-s)) as a series in z.
      double term = end; // end z^j/j!
      const double negligible = 1e-18 * end;
      for (int j = 0; j < 32 && term > negligible; ++j)
      {
        const double weight = term * Inverse[j + 3];
        this->First += weight;
        this->Middle += 2.0 * weight * Inverse[j + 2];
        this->Last += 2.0 * term * Inverse[j + 1] * Inverse[j + 2] * Inverse[j + 3];
        term *= z * Inverse[j + 1];
      }
    }
    else
    {
      const double scale = 1.0 / (z * z * z);
      this->First = scale * (start * ((z - 2.0) * z + 2.0) - 2.0 * end);
      this->Middle = scale * 2.0 * (start * (z - 2.0) + end * (z + 2.0));
      this->Last = scale * (2.0 * start - end * ((z + 2.0) * z + 2.0));
    }
  }

  double First = 0.0;
  double Middle = 0.0;
  double Last = 0.0;
};

// One coordinate of a march, in pixels: the columns, or rows, of cells that it passes. A cell lies
// between two neighbouring lines of pixel centres; its number is that of the lower one.
class Walk
{
public:
  // From a pixel's centre by velocity [pixels per unit of t], where cells are -1 to size - 1.
  Walk(int pixel, double velocity, int size)
    : Speed(std::abs(velocity))
    , Step(velocity < 0.0 ? -1 : 1)
    , Size(size)
    , Cell(velocity < 0.0 ? pixel - 1 : pixel)
    , End(1.0 / this->Speed)
  {
  }

  int GetCell() const { return this->Cell; }
  bool IsInside() const { return this->Cell >= -1 && this->Cell < this->Size; }

  // When the march leaves the cell: computed, not stepped, so exact to rounding. May be infinite.
  double GetEnd() const { return this->End; }

  // The weights of the cell's lower and upper line at t, for a bilinear interpolation.
  std::array<double, 2> GetWeights(double t) const
  {
    const double travelled = t * this->Speed;
    const double ahead = vtkGodRays::clamp(travelled - this->Crossed, 0.0, 1.0);
    const double behind = vtkGodRays::clamp(this->Crossed + 1 - travelled, 0.0, 1.0);
    return this->Step < 0 ? std::array<double, 2>{ ahead, behind }
                          : std::array<double, 2>{ behind, ahead };
  }

  void Advance()
  {
    this->Cell += this->Step;
    ++this->Crossed;
    this->End = (this->Crossed + 1) / this->Speed;
  }

private:
  double Speed;
  int Step;
  int Size;
  int Cell;
  int Crossed = 0;
  double End;
};

// integral_0^1 e^(-k t) s(pixel + t velocity) dt, added to sums, one for each component.
template <typename Scalar>
void IntegrateMarch(const PaddedImage<Scalar>& image, int column, int row,
  const vtkGodRays::Vec2& velocity, double k, double* sums)
{
  Walk columns(column, velocity.x, image.Width);
  Walk rows(row, velocity.y, image.Height);
  double start = 0.0;
  double startWeight = 1.0;
  while (start < 1.0 && columns.IsInside() && rows.IsInside())
  {
    const double columnEnd = columns.GetEnd();
    const double rowEnd = rows.GetEnd();
    const double end = std::min({ columnEnd, rowEnd, 1.0 });
    const double endWeight = std::exp(-k * end);
    if (end > start)
    {
      const BernsteinIntegrals integrals(startWeight, endWeight, k * (end - start));
      const double h = end - start;
      const std::array<double, 2> x0 = columns.GetWeights(start);
      const std::array<double, 2> x1 = columns.GetWeights(end);
      const std::array<double, 2> y0 = rows.GetWeights(start);
      const std::array<double, 2> y1 = rows.GetWeights(end);
      const double lowerLeft = h * integrals.OfProduct(x0[0], x1[0], y0[0], y1[0]);
      const double lowerRight = h * integrals.OfProduct(x0[1], x1[1], y0[0], y1[0]);
      const double upperLeft = h * integrals.OfProduct(x0[0], x1[0], y0[1], y1[1]);
      const double upperRight = h * integrals.OfProduct(x0[1], x1[1], y0[1], y1[1]);
      const Scalar* low = image.GetPixel(columns.GetCell(), rows.GetCell());
      const Scalar* high = low + image.GetRowLength();
      const int next = image.Components;
      for (int c = 0; c < image.Components; ++c)
      {
        sums[c] += lowerLeft * low[c] + lowerRight * low[c + next] + upperLeft * high[c] +
          upperRight * high[c + next];
      }
    }
    if (columnEnd <= end)
    {
      columns.Advance();
    }
    if (rowEnd <= end)
    {
      rows.Advance();
    }
    start = end;
    startWeight = endWeight;
  }
}

// Everything about the sum but the image.
struct Sum
{
  double Density;
  double K;    // may be infinite
  double Gain; // of a constant image [no unit]
  vtkGodRays::Vec3 LightClip;
  double MarchScale;
};

Sum MakeSum(vtkGodRaysReferenceFilter* filter)
{
  const double logarithm = std::log(filter->GetDecay());
  const int n = filter->GetNumberOfSamples();
  Sum sum;
  sum.Density = filter->GetDensity();
  sum.K = -n * logarithm;
  const double samples = logarithm == 0.0 ? n : std::expm1(n * logarithm) / std::expm1(logarithm);
  sum.Gain = filter->GetExposure() * filter->GetWeight() * samples;
  const double* light = filter->GetLightClip();
  sum.LightClip = vtkGodRays::Vec3(light[0], light[1], light[2]);
  sum.MarchScale = filter->GetMarchScale();
  return sum;
}

// The result in a pixel, one number for each component.
template <typename Scalar>
void EvaluatePixel(const PaddedImage<Scalar>& image, const Sum& sum, int x, int y, double* result)
{
  using vtkGodRays::Vec2;
  const Vec2 size(image.Width, image.Height);
  const Vec2 ndc = (Vec2(2.0 * x + 1.0, 2.0 * y + 1.0) - size) / size;
  const Vec2 velocity =
    sum.Density * vtkGodRays::MarchVector(sum.LightClip, ndc, sum.MarchScale) * size;

  double gain = sum.Gain;
  std::fill(result, result + image.Components, 0.0);
  if (std::isinf(sum.K) || velocity == Vec2(0.0))
  {
    std::copy_n(image.GetPixel(x, y), image.Components, result);
  }
  else
  {
    IntegrateMarch(image, x, y, velocity, sum.K, result);
    gain /= vtkGodRays::MeanExponential(sum.K);
  }
  if (std::is_integral<Scalar>::value)
  {
    gain /= std::numeric_limits<Scalar>::max();
  }
  std::transform(
    result, result + image.Components, result, [gain](double value) { return gain * value; });
}

// Told the progress; returns whether to go on.
using Monitor = std::function<bool(double)>;

// Evaluate the pixels of extent, which counts from the image's lower left pixel. In bands, so that
// the calling thread, and it alone, tells of progress and can be told to stop; returns false then.
template <typename Scalar, typename Result>
bool Evaluate(const Monitor& monitor, const PaddedImage<Scalar>& image, const Sum& sum,
  const int extent[4], Result* results)
{
  const vtkIdType columns = extent[1] - extent[0] + 1;
  const vtkIdType count = columns * (extent[3] - extent[2] + 1);
  const vtkIdType band = std::max<vtkIdType>(count / 100, 256);
  for (vtkIdType first = 0; first < count; first += band)
  {
    if (!monitor(static_cast<double>(first) / count))
    {
      return false;
    }
    vtkSMPTools::For(first, std::min(first + band, count),
      [&](vtkIdType begin, vtkIdType end)
      {
        double values[vtkGodRaysRadialFilter::MaximumComponents];
        for (vtkIdType i = begin; i < end; ++i)
        {
          const int x = static_cast<int>(extent[0] + i % columns);
          const int y = static_cast<int>(extent[2] + i / columns);
          EvaluatePixel(image, sum, x, y, values);
          for (int c = 0; c < image.Components; ++c)
          {
            results[i * image.Components + c] = static_cast<Result>(
              std::is_same<Result, float>::value ? std::min(values[c], LargestFloat) : values[c]);
          }
        }
      });
  }
  return monitor(1.0);
}

// The same for scalars whose types are known at run time only.
bool Evaluate(const Monitor& monitor, const Sum& sum, vtkDataArray* scalars, const int size[2],
  const int extent[4], vtkDataArray* results)
{
  const int components = scalars->GetNumberOfComponents();
  auto evaluate = [&](auto* pixels)
  {
    using Scalar = std::remove_pointer_t<decltype(pixels)>;
    const PaddedImage<Scalar> image(pixels, size[0], size[1], components);
    void* values = results->GetVoidPointer(0);
    return results->GetDataType() == VTK_FLOAT
      ? Evaluate(monitor, image, sum, extent, static_cast<float*>(values))
      : Evaluate(monitor, image, sum, extent, static_cast<double*>(values));
  };
  void* pixels = scalars->GetVoidPointer(0);
  switch (scalars->GetDataType())
  {
    case VTK_UNSIGNED_CHAR:
      return evaluate(static_cast<unsigned char*>(pixels));
    case VTK_FLOAT:
      return evaluate(static_cast<float*>(pixels));
    default:
      return evaluate(static_cast<double*>(pixels));
  }
}

}

void vtkGodRaysReferenceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputScalarType: " << vtkImageScalarTypeNameMacro(this->OutputScalarType)
     << "\n";
}

void vtkGodRaysReferenceFilter::SetOutputScalarType(int type)
{
  if (type != VTK_DOUBLE && type != VTK_FLOAT)
  {
    vtkErrorMacro("OutputScalarType must be " << VTK_FLOAT << " (VTK_FLOAT) or " << VTK_DOUBLE
                                              << " (VTK_DOUBLE), not " << type << "; it stays "
                                              << this->OutputScalarType << ".");
    return;
  }
  if (this->OutputScalarType != type)
  {
    this->OutputScalarType = type;
    this->Modified();
  }
}

int vtkGodRaysReferenceFilter::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkImageData* image = vtkImageData::GetData(input[0]);
  vtkImageData* result = vtkImageData::GetData(output);
  vtkDataArray* scalars = this->GetUsableScalars(input, output);
  if (!scalars)
  {
    return 1; // the executive would only add that something failed
  }

  int whole[6];
  int extent[6];
  image->GetExtent(whole);
  output->GetInformationObject(0)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  result->SetExtent(extent);
  result->AllocateScalars(this->OutputScalarType, scalars->GetNumberOfComponents());
  vtkDataArray* results = result->GetPointData()->GetScalars();
  results->SetName(scalars->GetName());

  const int size[2] = { whole[1] - whole[0] + 1, whole[3] - whole[2] + 1 };
  const int part[4] = { extent[0] - whole[0], extent[1] - whole[0], extent[2] - whole[2],
    extent[3] - whole[2] };
  if (!Evaluate([this](double progress) { return this->TellProgress(progress); }, MakeSum(this),
        scalars, size, part, results))
  {
    result->Initialize();
  }
  return 1;
}
