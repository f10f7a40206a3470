// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    GodRaysSourceTesting.h
 * @brief   what the tests of every source of scenes ask
 */

#ifndef GodRaysSourceTesting_h
#define GodRaysSourceTesting_h

#include "GodRaysFiltersTesting.h"

#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cstring>
#include <sstream>

namespace GodRaysSourceTesting
{
inline vtkDataSet* GetOutput(vtkAlgorithm* source, int port = 0)
{
  return vtkDataSet::SafeDownCast(source->GetOutputDataObject(port));
}

inline vtkDataSet* Update(vtkAlgorithm* source, double time, int port = 0)
{
  source->UpdateInformation();
  source->GetOutputInformation(port)->Set(
    vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), time);
  source->Update(port);
  return GetOutput(source, port);
}

inline std::string GetBytes(vtkDataArray* array)
{
  return { static_cast<const char*>(array->GetVoidPointer(0)),
    static_cast<std::size_t>(array->GetDataSize()) * array->GetDataTypeSize() };
}

// Everything that a source gives: points and arrays.
inline std::string GetBytes(vtkDataSet* data)
{
  std::string bytes;
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    bytes += GetBytes(data->GetPointData()->GetArray(i));
  }
  auto* points = vtkPointSet::SafeDownCast(data);
  return points && points->GetPoints() ? bytes + GetBytes(points->GetPoints()->GetData()) : bytes;
}

inline bool IsFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

// The same bytes for any number of threads.
inline void ExpectSameOnThreads(vtkAlgorithm* source, double time, int port = 0)
{
  const std::string expected = GetBytes(Update(source, time, port));
  EXPECT_FALSE(expected.empty());
  for (int threads : { 1, 2, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]
      {
        source->Modified();
        EXPECT_TRUE(GetBytes(Update(source, time, port)) == expected) << threads << " threads";
      });
  }
}

// Progress grows to 1; a stop leaves nothing, and the next execution everything.
inline void ExpectProgressAndAbort(vtkAlgorithm* source, double time, int port = 0)
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
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      auto* own = static_cast<Watch*>(data);
      own->Progress.push_back(algorithm->GetProgress());
      if (algorithm->GetProgress() >= own->StopAt)
      {
        algorithm->AbortExecuteOn();
      }
    });
  const unsigned long tag = source->AddObserver(vtkCommand::ProgressEvent, command);
  source->Modified();
  const vtkIdType points = Update(source, time, port)->GetNumberOfPoints();
  EXPECT_GT(points, 0);
  EXPECT_GE(watch.Progress.size(), 3u);
  EXPECT_TRUE(std::is_sorted(watch.Progress.begin(), watch.Progress.end()));
  EXPECT_EQ(watch.Progress.back(), 1.0);

  watch = {};
  watch.StopAt = 0.1;
  source->Modified();
  EXPECT_EQ(Update(source, time, port)->GetNumberOfPoints(), 0);
  watch = {};
  source->AbortExecuteOff(); // VTK 9.1 does so by itself
  source->Modified();
  EXPECT_EQ(Update(source, time, port)->GetNumberOfPoints(), points);
  source->RemoveObserver(tag);
}

// A parameter of one number: its default, both ends of its range, and what is refused.
template <typename Source>
struct Parameter
{
  const char* Name;
  void (Source::*Set)(double);
  double (Source::*Get)();
  double Default, Minimum, Maximum;
};

template <typename Source>
void ExpectParameters(Source* source, const std::vector<Parameter<Source>>& parameters)
{
  std::ostringstream stream;
  source->Print(stream);
  GodRaysFiltersTesting::ErrorListener errors(source);
  std::size_t count = 0;
  for (const Parameter<Source>& each : parameters)
  {
    SCOPED_TRACE(each.Name);
    auto get = [&] { return (source->*each.Get)(); };
    auto set = [&](double value) { (source->*each.Set)(value); };
    EXPECT_EQ(get(), each.Default);
    EXPECT_NE(stream.str().find("  " + std::string(each.Name) + ": "), std::string::npos);
    for (double value : { std::nan(""), HUGE_VAL, -HUGE_VAL })
    {
      const vtkMTimeType before = source->GetMTime();
      set(value);
      EXPECT_EQ(get(), each.Default);
      EXPECT_EQ(source->GetMTime(), before);
      ASSERT_EQ(errors.Texts.size(), ++count);
      EXPECT_NE(errors.Texts.back().find(each.Name), std::string::npos);
    }
    set(-1e300);
    EXPECT_EQ(get(), each.Minimum);
    set(1e300);
    EXPECT_EQ(get(), each.Maximum);
    const vtkMTimeType before = source->GetMTime();
    set(1e300);
    EXPECT_EQ(source->GetMTime(), before);
    set(0.5 * (each.Minimum + each.Maximum));
    EXPECT_GT(source->GetMTime(), before);
    set(each.Default);
  }
}
}

#endif
