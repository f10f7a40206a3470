// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Clouds: coverage, softness, wind, evolution, both outputs alike, forms, bytes.

#include "GodRaysSourceTesting.h"
#include "vtkGodRaysCloudLayerSource.h"

#include <array>

using namespace GodRaysFiltersTesting;
using namespace GodRaysSourceTesting;
using Layer = vtkGodRaysCloudLayerSource;

namespace
{
double GetAlpha(vtkDataSet* data, vtkIdType point)
{
  return data->GetPointData()->GetScalars()->GetComponent(point, 3);
}

// The part of points that have more alpha than this.
double GetPart(vtkDataSet* data, double alpha)
{
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    count += GetAlpha(data, i) > alpha;
  }
  return static_cast<double>(count) / data->GetNumberOfPoints();
}

// Many clouds, up to the border.
void SetMany(Layer* layer)
{
  layer->SetCloudSize(10.0);
  layer->SetEdgeFade(0.0);
  layer->SetOpacity(1.0);
  layer->SetTextureResolution(200);
}
}

//------------------------------------------------------------------------------
TEST(CloudLayerSource, CoverageIsThePartOfTheSky)
{
  vtkNew<Layer> layer;
  SetMany(layer);
  for (double time : { 0.0, 17.0, 37.8 }) // the last one is at a whole coordinate of the noise
  {
    for (double coverage : { 0.1, 0.3, 0.5, 0.8 })
    {
      for (double softness : { 0.0, 0.4 })
      {
        layer->SetCoverage(coverage);
        layer->SetSoftness(softness);
        EXPECT_NEAR(GetPart(Update(layer, time, 1), 127.5), coverage, 0.03)
          << time << " " << softness;
      }
    }
  }
  layer->SetOctaves(1);
  layer->SetCoverage(0.3);
  EXPECT_NEAR(GetPart(Update(layer, 17.0, 1), 127.5), 0.3, 0.03);
  layer->SetOctaves(12);
  layer->SetGain(0.9);
  EXPECT_NEAR(GetPart(Update(layer, 17.0, 1), 127.5), 0.3, 0.03);
  layer->SetCoverage(0.0);
  EXPECT_EQ(GetPart(Update(layer, 5.0, 1), 0.0), 0.0);
  layer->SetCoverage(1.0);
  EXPECT_EQ(GetPart(Update(layer, 5.0, 1), 254.5), 1.0);
}

//------------------------------------------------------------------------------
TEST(CloudLayerSource, SoftnessIsTheWidthOfEdges)
{
  vtkNew<Layer> layer;
  SetMany(layer);
  double before = -1.0;
  for (double softness : { 0.0, 0.2, 0.5, 1.0 })
  {
    layer->SetSoftness(softness);
    vtkDataSet* data = Update(layer, 0.0, 1);
    const double edges = GetPart(data, 0.5) - GetPart(data, 254.5);
    EXPECT_TRUE(softness == 0.0 ? edges == 0.0 : edges > before + 0.1) << edges;
    before = edges;
  }
}

//------------------------------------------------------------------------------
// Without evolution the wind only moves the sky: by 20 points of the texture.
TEST(CloudLayerSource, TheWindMovesTheSky)
{
  vtkNew<Layer> layer;
  layer->SetEdgeFade(0.0);
  layer->SetTextureResolution(101); // 10 apart
  layer->SetWindSpeed(50.0);
  layer->SetEvolutionTime(1e9);
  vtkNew<vtkImageData> still;
  still->DeepCopy(vtkImageData::SafeDownCast(Update(layer, 0.0, 1)));
  for (double direction : { 0.0, 90.0 })
  {
    layer->SetWindDirection(direction);
    vtkDataSet* moved = Update(layer, 4.0, 1);
    const vtkIdType shift = direction == 0.0 ? 20 : 20 * 101;
    for (vtkIdType y = 20; y < 101; ++y)
    {
      for (vtkIdType x = 20; x < 101; ++x)
      {
        const vtkIdType i = x + 101 * y;
        ASSERT_NEAR(GetAlpha(moved, i), GetAlpha(still, i - shift), 1.0);
      }
    }
  }

  // With it, clouds become others, slowly.
  layer->SetWindSpeed(0.0);
  layer->SetEvolutionTime(60.0);
  auto differ = [&](double time)
  {
    vtkDataSet* data = Update(layer, time, 1);
    double sum = 0.0;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      sum += std::abs(GetAlpha(data, i) - GetAlpha(still, i)) / data->GetNumberOfPoints();
    }
    return sum;
  };
  const double soon = differ(0.5);
  EXPECT_GT(soon, 0.0);
  EXPECT_LT(soon, 15.0);
  EXPECT_GT(differ(60.0), 3.0 * soon);
}

//------------------------------------------------------------------------------
// A point of the geometry and the point of the texture at its coordinates are the same.
TEST(CloudLayerSource, GeometryAndTextureAreTheSameClouds)
{
  vtkNew<Layer> layer;
  layer->SetResolution(33);
  layer->SetTextureResolution(65);
  layer->SetColor(1.0, 0.5, 0.2);
  vtkDataSet* geometry = Update(layer, 12.0);
  vtkImageData* texture = layer->GetTexture();
  EXPECT_EQ(texture->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 12.0);
  ASSERT_EQ(geometry->GetNumberOfPoints(), 33 * 33);
  EXPECT_EQ(geometry->GetNumberOfCells(), 32 * 32);
  vtkDataArray* coordinates = geometry->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < geometry->GetNumberOfPoints(); ++i)
  {
    const int x = static_cast<int>(std::lround(64.0 * coordinates->GetComponent(i, 0)));
    const int y = static_cast<int>(std::lround(64.0 * coordinates->GetComponent(i, 1)));
    ASSERT_EQ(GetAlpha(geometry, i), texture->GetScalarComponentAsDouble(x, y, 0, 3));
    ASSERT_EQ(texture->GetScalarComponentAsDouble(x, y, 0, 1), 128.0);
    double p[3];
    geometry->GetPoint(i, p);
    ASSERT_NEAR(p[0], texture->GetPoint(x + 65 * y)[0], 1e-3);
    ASSERT_EQ(p[2], 100.0);
    if (std::max(std::abs(p[0]), std::abs(p[1])) > 499.0) // it has no border
    {
      ASSERT_EQ(GetAlpha(geometry, i), 0.0);
    }
  }
}

//------------------------------------------------------------------------------
TEST(CloudLayerSource, ADomeHasAltitudeAboveItsCentre)
{
  vtkNew<Layer> layer;
  ErrorListener errors(layer);
  layer->SetShape(Layer::DOME);
  vtkDataSet* data = Update(layer, 0.0);
  EXPECT_NEAR(data->GetPoint(64 + 129 * 64)[2], 100.0, 1e-4);
  EXPECT_NEAR(data->GetPoint(0)[2], 0.0, 1e-4);
  EXPECT_NEAR(data->GetPoint(64)[2], 100.0 * std::sqrt(0.5), 1e-4);
  EXPECT_TRUE(IsFinite(vtkPolyData::SafeDownCast(data)->GetPoints()->GetData()));
  layer->SetShape(2);
  ASSERT_EQ(errors.Texts.size(), 1u);
  EXPECT_NE(errors.Texts[0].find("Shape"), std::string::npos);
  EXPECT_EQ(layer->GetShape(), Layer::DOME);
}

//------------------------------------------------------------------------------
TEST(CloudLayerSource, GivesThePieceThatIsAskedFor)
{
  vtkNew<Layer> layer;
  layer->SetTextureResolution(65);
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(vtkImageData::SafeDownCast(Update(layer, 3.0, 1)));
  layer->Modified();
  layer->UpdateInformation();
  vtkInformation* information = layer->GetOutputInformation(1);
  information->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), 10, 19, 5, 7, 0, 0);
  layer->GetExecutive()->Update(1);
  ASSERT_EQ(layer->GetTexture()->GetNumberOfPoints(), 30);
  for (int y = 5; y < 8; ++y)
  {
    for (int x = 10; x < 20; ++x)
    {
      ASSERT_EQ(layer->GetTexture()->GetScalarComponentAsDouble(x, y, 0, 3),
        whole->GetScalarComponentAsDouble(x, y, 0, 3));
    }
  }
  layer->UpdatePiece(0, 2, 0);
  EXPECT_EQ(GetOutput(layer)->GetNumberOfPoints(), 129 * 129);
  layer->UpdatePiece(1, 2, 0);
  EXPECT_EQ(GetOutput(layer)->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
// The smallest clouds of the largest layer, at the end of the strongest wind: too fine for numbers.
TEST(CloudLayerSource, LastsToTheEndOfItsRanges)
{
  vtkNew<Layer> layer;
  layer->SetResolution(9);
  layer->SetTextureResolution(9);
  layer->SetEdgeFade(0.0);
  layer->SetWidth(1e9);
  layer->SetCloudSize(1e-6);
  layer->SetOctaves(16);
  layer->SetWindSpeed(1e6);
  layer->SetEndTime(1e6);
  layer->SetEvolutionTime(1e-3);
  for (double coverage : { 0.1, 0.9 })
  {
    layer->SetCoverage(coverage);
    vtkDataSet* data = Update(layer, 1e6);
    ASSERT_EQ(data->GetNumberOfPoints(), 81);
    EXPECT_EQ(GetPart(data, 127.5) > 0.5, coverage > 0.5);
  }
}

//------------------------------------------------------------------------------
TEST(CloudLayerSource, BytesDoNotDependOnThreads)
{
  vtkNew<Layer> layer;
  layer->SetTextureResolution(130);
  for (int port : { 0, 1 })
  {
    ExpectSameOnThreads(layer, 7.0, port);
    ExpectProgressAndAbort(layer, 7.0, port);
  }
  const std::string bytes = GetBytes(Update(layer, 7.0));
  layer->SetSeed(2);
  EXPECT_TRUE(GetBytes(Update(layer, 7.0)) != bytes);
}

//------------------------------------------------------------------------------
TEST(CloudLayerSource, ParametersAreClampedAndNeverNaN)
{
  vtkNew<Layer> layer;
  ExpectParameters<Layer>(layer,
    { { "Width", &Layer::SetWidth, &Layer::GetWidth, 1000.0, 1e-6, 1e9 },
      { "Altitude", &Layer::SetAltitude, &Layer::GetAltitude, 100.0, -1e9, 1e9 },
      { "CloudSize", &Layer::SetCloudSize, &Layer::GetCloudSize, 150.0, 1e-6, 1e9 },
      { "Gain", &Layer::SetGain, &Layer::GetGain, 0.5, 0.0, 1.0 },
      { "Coverage", &Layer::SetCoverage, &Layer::GetCoverage, 0.5, 0.0, 1.0 },
      { "Softness", &Layer::SetSoftness, &Layer::GetSoftness, 0.4, 0.0, 1.0 },
      { "EdgeFade", &Layer::SetEdgeFade, &Layer::GetEdgeFade, 0.3, 0.0, 1.0 },
      { "Opacity", &Layer::SetOpacity, &Layer::GetOpacity, 0.95, 0.0, 1.0 },
      { "WindSpeed", &Layer::SetWindSpeed, &Layer::GetWindSpeed, 10.0, 0.0, 1e6 },
      { "WindDirection", &Layer::SetWindDirection, &Layer::GetWindDirection, 0.0, -360.0, 360.0 },
      { "EvolutionTime", &Layer::SetEvolutionTime, &Layer::GetEvolutionTime, 60.0, 1e-3, 1e9 },
      { "EndTime", &Layer::SetEndTime, &Layer::GetEndTime, 60.0, 0.0, 1e6 } });
}
