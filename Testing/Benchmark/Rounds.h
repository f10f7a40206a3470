// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause

// Paired timing. One iteration of a Google Benchmark is a round: everything that is compared runs
// once in it, in an order that rotates from round to round, so that what else the machine does
// meets all alike. Ratios are taken within a round, then their median over the rounds.

#ifndef Rounds_h
#define Rounds_h

#include <functional>
#include <string>
#include <vector>

struct RoundsItem
{
  std::string Name;
  std::function<double()> Run; // returns the time that it took [s]
  std::vector<double> Seconds; // one for each round
};

/**
 * Run so many rounds of the items, after one round that does not count if warmUp is set. Prints a
 * line.
 */
void MeasureRounds(
  const std::string& name, std::vector<RoundsItem>& items, int rounds, bool warmUp = true);

/// The samples of an item; none if there is no such item.
std::vector<double> GetSeconds(const std::vector<RoundsItem>& items, const std::string& name);

#endif
