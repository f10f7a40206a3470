// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tells how far a long step is, on the standard error output: in one line that grows on a
 * terminal, every ten seconds elsewhere; nothing during the first second.
 */

#ifndef Progress_h
#define Progress_h

#include <chrono>             // For std::chrono
#include <condition_variable> // For std::condition_variable
#include <mutex>              // For std::mutex
#include <string>             // For std::string
#include <thread>             // For std::thread

class vtkObject;

class Progress
{
public:
  Progress(vtkObject* step, const std::string& what);
  ~Progress();

  Progress(const Progress&) = delete;
  void operator=(const Progress&) = delete;

  /**
   * Whether nothing is told of any step. Default is false.
   */
  static void SetQuiet(bool quiet);

private:
  void Update(double fraction);

  using Clock = std::chrono::steady_clock;

  vtkObject* Step;
  std::string What;
  unsigned long Observer;
  Clock::time_point Next;
  double Fraction = 0.0;
  bool Terminal;
  bool Shown = false;
};

/**
 * Tells, on a terminal, for how many seconds a step without a measure of its own has gone on; nothing
 * during the first second, or where Progress is quiet. It takes back what it wrote.
 */
class Waiting
{
public:
  explicit Waiting(const std::string& what);
  ~Waiting();

  Waiting(const Waiting&) = delete;
  void operator=(const Waiting&) = delete;

private:
  std::mutex Lock;
  std::condition_variable End;
  bool HasEnded = false;
  std::thread Teller;
};

#endif
