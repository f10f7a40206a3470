// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// The reference filter as a filter: types, values that cannot be summed, extents, threads,
// progress, errors, parameters.

#include "GodRaysFiltersTesting.h"

#include "vtkGodRaysReferenceFilter.h"

#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <array>
#include <cfloat>
#include <limits>
#include <sstream>

using namespace GodRaysFiltersTesting;

namespace
{
using Filter = vtkGodRaysReferenceFilter;
using Pipeline = vtkStreamingDemandDrivenPipeline;
}

// --- Values -----------------------------------------------------------------------------------

//------------------------------------------------------------------------------
TEST(ReferenceFilterPipeline, TakesEveryTypeAndNumberOfComponents)
{
  std::mt19937 generator = MakeGenerator(11);
  vtkNew<Filter> filter;
  filter->SetLightPosition(0.9, 0.2);
  for (int components = 1; components <= 4; ++components)
  {
    Picture bytes = MakeNoise(3, 5, components, generator);
    Picture fractions = bytes;
    for (std::size_t i = 0; i < bytes.Values.size(); ++i)
    {
      bytes.Values[i] = std::floor(256.0 * bytes.Values[i]);
      fractions.Values[i] = bytes.Values[i] / 255.0;
    }
    const Picture fromBytes = Scatter(filter, bytes, VTK_UNSIGNED_CHAR);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfScalarComponents(), components);
    EXPECT_EQ(filter->GetOutput()->GetScalarType(), VTK_DOUBLE);
    EXPECT_LT(GetLargestDifference(fromBytes, Scatter(filter, fractions)), 1e-15);
    EXPECT_EQ(Scatter(filter, bytes, VTK_FLOAT).Values, Scatter(filter, bytes, VTK_DOUBLE).Values);

    // Each component as if it were alone; float as double, rounded.
    for (int c = 0; c < components; ++c)
    {
      const Picture alone =
        Scatter(filter, MakePicture(3, 5, [&](int x, int y) { return fractions.Get(x, y, c); }));
      EXPECT_NEAR(alone.Get(2, 1), fromBytes.Get(2, 1, c), 1e-15);
    }
    filter->SetOutputScalarTypeToFloat();
    const Picture rounded = Scatter(filter, bytes, VTK_UNSIGNED_CHAR);
    EXPECT_EQ(filter->GetOutput()->GetScalarType(), VTK_FLOAT);
    for (std::size_t i = 0; i < rounded.Values.size(); ++i)
    {
      EXPECT_EQ(rounded.Values[i], static_cast<float>(fromBytes.Values[i]));
    }
    filter->SetOutputScalarTypeToDouble();
  }
}

//------------------------------------------------------------------------------
TEST(ReferenceFilterPipeline, UnusableValuesCountAsZeroOrTheLargest)
{
  std::mt19937 generator = MakeGenerator(12);
  vtkNew<Filter> filter;
  filter->SetLightPosition(0.5, 0.5);
  const Picture clean = MakeNoise(9, 9, 1, generator);
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  const double rows[][2] = { { nan, 0.0 }, { -1.0, 0.0 }, { -infinity, 0.0 }, { infinity, FLT_MAX },
    { 1e300, FLT_MAX } };
  for (const double(&row)[2] : rows)
  {
    for (int type : { VTK_FLOAT, VTK_DOUBLE })
    {
      if (type == VTK_FLOAT && row[0] == 1e300)
      {
        continue;
      }
      Picture dirty = clean;
      Picture taken = clean;
      dirty.At(2, 3) = row[0];
      taken.At(2, 3) = row[1];
      EXPECT_EQ(Scatter(filter, dirty, type).Values, Scatter(filter, taken, type).Values) << row[0];
    }
  }
}

//------------------------------------------------------------------------------
TEST(ReferenceFilterPipeline, KeepsItsPrecisionForHighDynamicRange)
{
  std::mt19937 generator = MakeGenerator(13);
  vtkNew<Filter> filter;
  filter->SetLightPosition(0.4, 0.6);
  Picture picture = MakeNoise(13, 9, 1, generator);
  for (double factor : { 65504.0, 1e30 })
  {
    Picture bright = picture;
    for (double& value : bright.Values)
    {
      value *= factor;
    }
    const Picture expected = Scatter(filter, picture);
    const Picture rays = Scatter(filter, bright);
    for (std::size_t i = 0; i < rays.Values.size(); ++i)
    {
      ASSERT_NEAR(rays.Values[i] / factor, expected.Values[i], 1e-15);
    }
  }

  // One pixel of 1e30 does not disturb marches that do not pass it, and floats do not overflow.
  Picture spike = picture;
  spike.At(12, 8) = 1e30;
  const Picture before = Scatter(filter, picture);
  EXPECT_EQ(Scatter(filter, spike).Get(0, 0), before.Get(0, 0));
  spike.At(12, 8) = FLT_MAX;
  filter->SetExposure(100.0);
  filter->SetOutputScalarTypeToFloat();
  EXPECT_EQ(Scatter(filter, spike).Get(12, 8), FLT_MAX);
}

// --- The pipeline -----------------------------------------------------------------------------

//------------------------------------------------------------------------------
TEST(ReferenceFilterPipeline, BytesDoNotDependOnThreadsOrOnTheExtentAsked)
{
  std::mt19937 generator = MakeGenerator(14);
  vtkNew<Filter> filter;
  filter->SetLightPosition(0.3, 0.6);
  const Picture picture = MakeNoise(129, 97, 3, generator);
  filter->SetInputData(MakeImage(picture));
  filter->Update();
  const Picture expected = FromImage(filter->GetOutput());
  for (const char* backend : { "Sequential", "STDThread", "TBB" })
  {
#ifdef __SANITIZE_THREAD__
    if (backend == std::string("TBB"))
    {
      continue; // Debian's library was not compiled for ThreadSanitizer, which does not see how it waits
    }
#endif
    for (int threads : { 1, 2, 3 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, backend, false },
        [&]()
        {
          filter->Modified();
          filter->Update();
        });
      EXPECT_EQ(FromImage(filter->GetOutput()).Values, expected.Values) << backend << threads;
    }
  }
  filter->Modified();
  filter->UpdateExtent(std::array<int, 6>{ 40, 44, 90, 96, 0, 0 }.data());
  const Picture part = FromImage(filter->GetOutput());
  ASSERT_EQ(part.Width, 5);
  ASSERT_EQ(part.Height, 7);
  for (int i = 0; i < 35; ++i)
  {
    EXPECT_EQ(part.Get(i % 5, i / 5, 1), expected.Get(40 + i % 5, 90 + i / 5, 1));
  }
}

//------------------------------------------------------------------------------
TEST(ReferenceFilterPipeline, KeepsGeometryAndNames)
{
  std::mt19937 generator = MakeGenerator(15);
  const Picture picture = MakeNoise(8, 6, 1, generator);
  vtkNew<Filter> filter;
  filter->SetLightPosition(0.3, 0.6);
  const Picture expected = Scatter(filter, picture);
  vtkSmartPointer<vtkImageData> image = MakeImage(picture);
  image->SetExtent(-3, 4, 10, 15, 7, 7);
  image->SetSpacing(0.5, 2.0, 3.0);
  image->SetOrigin(1.0, 2.0, 3.0);
  image->GetPointData()->GetScalars()->SetName("Radiance");
  filter->SetInputData(image);
  filter->Update();
  vtkImageData* output = filter->GetOutput();
  EXPECT_EQ(FromImage(output).Values, expected.Values);
  EXPECT_EQ(output->GetExtent()[2], 10);
  EXPECT_EQ(output->GetExtent()[4], 7);
  EXPECT_EQ(output->GetSpacing()[1], 2.0);
  EXPECT_EQ(output->GetOrigin()[2], 3.0);
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Radiance");
  EXPECT_NE(FromImage(image).Values, expected.Values); // the input is left alone

  // An array that is chosen by name.
  vtkSmartPointer<vtkDataArray> chosen = image->GetPointData()->GetScalars();
  vtkNew<vtkImageData> named;
  named->CopyStructure(image);
  named->GetPointData()->AddArray(chosen);
  filter->SetInputData(named);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radiance");
  filter->Update();
  EXPECT_EQ(FromImage(filter->GetOutput()).Values, expected.Values);

  // Upstream is asked for all of the image, even for one pixel.
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(image);
  producer->SetWholeExtent(image->GetExtent());
  filter->SetInputConnection(producer->GetOutputPort());
  filter->UpdateExtent(std::array<int, 6>{ 4, 4, 15, 15, 7, 7 }.data());
  EXPECT_EQ(FromImage(filter->GetOutput()).Get(0, 0), expected.Get(7, 5));
  const int* asked = filter->GetInputInformation()->Get(Pipeline::UPDATE_EXTENT());
  EXPECT_TRUE(std::equal(asked, asked + 6, image->GetExtent()));
}

//------------------------------------------------------------------------------
TEST(ReferenceFilterPipeline, TellsProgressAndStops)
{
  struct Watch
  {
    std::vector<double> Progress;
    double StopAt = 2.0;
  } watch;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* filter = static_cast<Filter*>(caller);
      auto* own = static_cast<Watch*>(data);
      own->Progress.push_back(filter->GetProgress());
      if (filter->GetProgress() >= own->StopAt)
      {
        filter->AbortExecuteOn();
      }
    });
  std::mt19937 generator = MakeGenerator(16);
  vtkNew<Filter> filter;
  ErrorListener errors(filter);
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->SetInputData(MakeImage(MakeNoise(129, 97, 1, generator)));
  filter->Update();
  EXPECT_GT(watch.Progress.size(), 20u);
  EXPECT_TRUE(std::is_sorted(watch.Progress.begin(), watch.Progress.end()));
  EXPECT_EQ(watch.Progress.back(), 1.0);

  watch = {};
  watch.StopAt = 0.3;
  filter->Modified();
  filter->Update();
  EXPECT_TRUE(std::none_of(watch.Progress.begin(), watch.Progress.end(),
    [](double progress) { return progress > 0.35 && progress < 1.0; }));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  watch = {};
  filter->AbortExecuteOff(); // VTK 9.1 does so by itself
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 129 * 97);
  EXPECT_TRUE(errors.Texts.empty());
}

//------------------------------------------------------------------------------
TEST(ReferenceFilterPipeline, TellsWhyItCannot)
{
  vtkNew<Filter> filter;
  ErrorListener errors(filter);
  ErrorListener executiveErrors(filter->GetExecutive());
  std::size_t count = 0;
  auto expectError = [&](vtkImageData* input, const char* cause, const char* remedy)
  {
    SCOPED_TRACE(cause);
    filter->SetInputData(MakeImage(Picture(2, 2)));
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 4);
    filter->SetInputDataObject(0, input);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    ASSERT_EQ(errors.Texts.size(), ++count);
    EXPECT_NE(errors.Texts.back().find(cause), std::string::npos) << errors.Texts.back();
    EXPECT_NE(errors.Texts.back().find(remedy), std::string::npos) << errors.Texts.back();
  };
  expectError(nullptr, "there is no input", "SetInputConnection()");
  vtkNew<vtkImageData> empty;
  expectError(empty, "the input is empty: it has 0 x 0 x 0 points", "allocate it");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 2, 1);
  expectError(bare, "no scalars", "SetInputArrayToProcess()");
  vtkSmartPointer<vtkImageData> volume = MakeImage(Picture(3, 4));
  volume->SetDimensions(3, 2, 2);
  expectError(volume, "3 x 2 x 2 points", "vtkExtractVOI");
  volume->SetDimensions(1, 3, 4);
  expectError(volume, "not a picture in x and y: it has 1 x 3 x 4 points", "vtkImagePermute");
  expectError(MakeImage(Picture(3, 4, 5)), "has 5 components", "vtkImageExtractComponents");
  for (int type : { VTK_INT, VTK_SHORT, VTK_SIGNED_CHAR })
  {
    vtkNew<vtkImageData> typed;
    typed->SetDimensions(3, 2, 1);
    typed->AllocateScalars(type, 1);
    typed->GetPointData()->GetScalars()->SetName("Numbers");
    expectError(typed, "the array \"Numbers\" is of type", "vtkImageCast");
  }
  EXPECT_TRUE(executiveErrors.Texts.empty());
}

// --- Parameters -------------------------------------------------------------------------------

//------------------------------------------------------------------------------
TEST(ReferenceFilterPipeline, ParametersAreClampedAndNeverNaN)
{
  vtkNew<Filter> filter;
  ErrorListener errors(filter);
  struct Row
  {
    const char* Name;
    void (Filter::*Set)(double);
    double (Filter::*Get)();
    double Default, Minimum, Maximum;
  };
  const Row rows[] = {
    { "Density", &Filter::SetDensity, &Filter::GetDensity, 0.97, 0.0, 2.0 },
    { "Decay", &Filter::SetDecay, &Filter::GetDecay, 1.0, 0.0, 1.05 },
    { "Weight", &Filter::SetWeight, &Filter::GetWeight, 0.013, 0.0, 100.0 },
    { "Exposure", &Filter::SetExposure, &Filter::GetExposure, 1.0, 0.0, 100.0 },
    { "MarchScale", &Filter::SetMarchScale, &Filter::GetMarchScale, 1.0, -1e30, 1e30 },
  };
  const double unusable[] = { std::nan(""), HUGE_VAL, -HUGE_VAL };
  std::size_t count = 0;
  for (const Row& row : rows)
  {
    SCOPED_TRACE(row.Name);
    auto get = [&] { return (filter->*row.Get)(); };
    auto set = [&](double value) { (filter->*row.Set)(value); };
    EXPECT_EQ(get(), row.Default);
    for (double value : unusable)
    {
      const vtkMTimeType before = filter->GetMTime();
      set(value);
      EXPECT_EQ(get(), row.Default);
      EXPECT_EQ(filter->GetMTime(), before);
      ASSERT_EQ(errors.Texts.size(), ++count);
      EXPECT_NE(errors.Texts.back().find(row.Name), std::string::npos);
    }
    set(-1e300);
    EXPECT_EQ(get(), row.Minimum);
    set(1e300);
    EXPECT_EQ(get(), row.Maximum);
    const vtkMTimeType before = filter->GetMTime();
    set(1e300);
    EXPECT_EQ(filter->GetMTime(), before);
    set(0.5);
    EXPECT_GT(filter->GetMTime(), before);
  }

  for (double value : unusable)
  {
    filter->SetLightClip(0.0, value, 1.0);
    filter->SetLightPosition(value, 0.0);
    filter->SetLightDirection(0.0, value);
    count += 3;
    EXPECT_EQ(errors.Texts.size(), count);
    EXPECT_EQ(filter->GetMarchScale(), 0.5);
    EXPECT_EQ(filter->GetLightClip()[1], 0.0);
  }
  filter->SetOutputScalarType(VTK_INT);
  EXPECT_EQ(errors.Texts.size(), ++count);
  EXPECT_EQ(filter->GetOutputScalarType(), VTK_DOUBLE);

  filter->SetLightClip(-1e300, 0.25, 1e300);
  EXPECT_EQ(filter->GetLightClip()[0], -1e30);
  EXPECT_EQ(filter->GetLightClip()[2], 1e30);
  const vtkMTimeType before = filter->GetMTime();
  filter->SetLightClip(-1e30, 0.25, 1e30);
  EXPECT_EQ(filter->GetMTime(), before);
  filter->SetLightPosition(0.75, -1.0);
  EXPECT_EQ(filter->GetLightClip()[0], 0.5);
  EXPECT_EQ(filter->GetLightClip()[1], -3.0);
  EXPECT_EQ(filter->GetLightClip()[2], 1.0);
  EXPECT_EQ(filter->GetMarchScale(), 1.0);
  EXPECT_GT(filter->GetMTime(), before);
  filter->SetNumberOfSamples(0);
  EXPECT_EQ(filter->GetNumberOfSamples(), 1);
  filter->SetNumberOfSamples(50000);
  EXPECT_EQ(filter->GetNumberOfSamples(), 10000);
}

//------------------------------------------------------------------------------
TEST(ReferenceFilterPipeline, PrintsEveryParameter)
{
  vtkNew<Filter> filter;
  filter->SetLightDirection(0.25, -1.0);
  filter->SetOutputScalarTypeToFloat();
  std::ostringstream stream;
  filter->Print(stream);
  const std::string text = stream.str();
  for (const char* line :
    { "Density: 0.97\n", "Decay: 1\n", "Weight: 0.013\n", "Exposure: 1\n", "NumberOfSamples: 100\n",
      "LightClip: 0.5 -2 0\n", "MarchScale: 1\n", "OutputScalarType: float\n" })
  {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}
