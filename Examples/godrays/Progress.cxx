// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "Messages.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <algorithm>

namespace
{
constexpr std::chrono::milliseconds BeforeFirst(1000);
constexpr std::chrono::milliseconds OnTerminal(200);
constexpr std::chrono::milliseconds Elsewhere(10000);
bool isQuiet = false;
}

//------------------------------------------------------------------------------
Progress::Progress(vtkObject* step, const std::string& what)
  : Step(step)
  , What(what)
  , Next(Clock::now() + BeforeFirst)
  , Terminal(Messages::IsTerminal())
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long, void* self, void* fraction)
    { static_cast<Progress*>(self)->Update(fraction ? *static_cast<double*>(fraction) : 0.0); });
  this->Observer = step->AddObserver(vtkCommand::ProgressEvent, command);
}

//------------------------------------------------------------------------------
Progress::~Progress()
{
  this->Step->RemoveObserver(this->Observer);
  if (this->Shown && this->Terminal)
  {
    Messages::Show("\r\033[K");
  }
}

//------------------------------------------------------------------------------
void Progress::SetQuiet(bool quiet)
{
  isQuiet = quiet;
}

//------------------------------------------------------------------------------
void Progress::Update(double fraction)
{
  this->Fraction = std::max(this->Fraction, fraction); // some readers step back
  const auto now = Clock::now();
  if (isQuiet || now < this->Next)
  {
    return;
  }
  this->Next = now + (this->Terminal ? OnTerminal : Elsewhere);
  this->Shown = true;
  const std::string percent = std::to_string(static_cast<int>(100.0 * this->Fraction)) + " %";
  Messages::Show(this->Terminal ? "\r" + this->What + ": " + percent + "\033[K"
                                : this->What + ": " + percent + "\n");
}

//------------------------------------------------------------------------------
Waiting::Waiting(const std::string& what)
{
  if (isQuiet || !Messages::IsTerminal())
  {
    return;
  }
  this->Teller = std::thread(
    [this, what]
    {
      std::unique_lock<std::mutex> lock(this->Lock);
      int seconds = 0;
      while (!this->End.wait_for(lock, BeforeFirst, [this] { return this->HasEnded; }))
      {
        Messages::Show("\r" + what + ": " + std::to_string(++seconds) + " s\033[K");
      }
      if (seconds > 0)
      {
        Messages::Show("\r\033[K");
      }
    });
}

//------------------------------------------------------------------------------
Waiting::~Waiting()
{
  if (this->Teller.joinable())
  {
    {
      const std::lock_guard<std::mutex> lock(this->Lock);
      this->HasEnded = true;
    }
    this->End.notify_one();
    this->Teller.join();
  }
}
