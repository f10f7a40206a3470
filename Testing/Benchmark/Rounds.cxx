// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rounds.h"

#include <benchmark/benchmark.h>

#include <cstdio>

namespace
{
/// One line a benchmark.
class LineReporter : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override
  {
    for (const Run& run : runs)
    {
      std::printf("%-48s %3ld rounds of %8.1f ms\n", run.run_name.function_name.c_str(),
        static_cast<long>(run.iterations), run.GetAdjustedRealTime());
    }
    std::fflush(stdout);
  }
};

void RunRounds(benchmark::State& state, std::vector<RoundsItem>& items)
{
  int round = 0;
  for (auto _ : state)
  {
    double total = 0.0;
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      RoundsItem& item = items[(i + round) % items.size()];
      item.Seconds.push_back(item.Run());
      total += item.Seconds.back();
    }
    state.SetIterationTime(total);
    ++round;
  }
}
}

//------------------------------------------------------------------------------
void MeasureRounds(const std::string& name, std::vector<RoundsItem>& items, int rounds, bool warmUp)
{
  if (warmUp)
  {
    for (RoundsItem& item : items)
    {
      item.Run();
    }
  }
  benchmark::RegisterBenchmark(
    name.c_str(), [&items](benchmark::State& state) { RunRounds(state, items); })
    ->Iterations(rounds)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
  LineReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter, ".");
  benchmark::ClearRegisteredBenchmarks();
}

//------------------------------------------------------------------------------
std::vector<double> GetSeconds(const std::vector<RoundsItem>& items, const std::string& name)
{
  for (const RoundsItem& item : items)
  {
    if (item.Name == name)
    {
      return item.Seconds;
    }
  }
  return {};
}
