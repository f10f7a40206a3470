// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Suggestions.h"

#include <algorithm>

namespace
{
//------------------------------------------------------------------------------
/**
 * The distance of Damerau and Levenshtein, in its form of optimal string alignment.
 */
std::size_t GetDistance(const std::string& a, const std::string& b)
{
  std::vector<std::vector<std::size_t>> table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
  {
    for (std::size_t j = 0; j <= b.size(); ++j)
    {
      if (i == 0 || j == 0)
      {
        table[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      table[i][j] = std::min({ table[i - 1][j] + 1, table[i][j - 1] + 1, replaced });
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
      {
        table[i][j] = std::min(table[i][j], table[i - 2][j - 2] + 1);
      }
    }
  }
  return table[a.size()][b.size()];
}
}

//------------------------------------------------------------------------------
std::string Suggest(const std::string& word, const std::vector<std::string>& names)
{
  std::size_t nearest = word.size() / 3 + 1;
  std::string best;
  for (const std::string& name : names)
  {
    const std::size_t distance = GetDistance(word, name);
    if (distance < nearest)
    {
      nearest = distance;
      best = name;
    }
  }
  for (const std::string& name : names)
  {
    if (best.empty() && word.size() >= 4 && name.rfind(word, 0) == 0)
    {
      best = name;
    }
  }
  return best.empty() ? "" : "; did you mean " + best + "?";
}
