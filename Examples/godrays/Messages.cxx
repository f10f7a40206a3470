// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "System.h"
#include "Temporary.h"

#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace
{
int userError = System::Errors;
std::string crashCause;
std::string crashLine; // with the last error of VTK, which may abort after one
int crashCode = 1;

//------------------------------------------------------------------------------
void EndAfterCrash(int)
{
  // Only functions that a signal handler may call.
  Temporary::RemoveAll();
  System::Write(userError, crashLine.data(), crashLine.size());
  System::EndNow(crashCode);
}

//------------------------------------------------------------------------------
std::string OneLine(std::string text)
{
  // "ERROR: In file.cxx, line 12\nvtkClass (0x1234): what happened\n\n"
  const auto body = text.find("): ");
  if (body != std::string::npos && text.find("0x") < body)
  {
    text = text.substr(body + 3);
  }
  else if (text.rfind("ERROR: In", 0) == 0 || text.rfind("Generic Warning: In", 0) == 0)
  {
    text = text.substr(std::min(text.find('\n'), text.size()));
  }
  std::string line;
  for (const char letter : text)
  {
    const bool space = std::isspace(static_cast<unsigned char>(letter));
    if (!space)
    {
      // What a damaged file has in the place of a word is not for terminals.
      line += std::iscntrl(static_cast<unsigned char>(letter)) ? '?' : letter;
    }
    else if (!line.empty() && line.back() != ' ')
    {
      line += ' ';
    }
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.'))
  {
    line.pop_back();
  }
  return line;
}

//------------------------------------------------------------------------------
class Collector : public vtkOutputWindow
{
public:
  static Collector* New();
  vtkTypeMacro(Collector, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    Collector::Add(this->Errors, text);
    if (!crashCause.empty() && !this->Errors.empty())
    {
      crashLine = crashCause + " (VTK says: " + this->Errors.back() + ")\n";
    }
  }
  void DisplayWarningText(const char* text) override { Collector::Add(this->Warnings, text); }
  void DisplayGenericWarningText(const char* text) override
  {
    Collector::Add(this->Warnings, text);
  }

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;

private:
  static void Add(std::vector<std::string>& list, const char* text)
  {
    const std::string line = OneLine(text ? text : "");
    if (!line.empty() && std::find(list.begin(), list.end(), line) == list.end())
    {
      list.push_back(line);
    }
  }
};
vtkStandardNewMacro(Collector);
}

//------------------------------------------------------------------------------
Messages::Messages(bool catchStandardError, const std::string& onCrash, int exitCode)
  : Collector(vtkSmartPointer<::Collector>::New())
  , Former(vtkOutputWindow::GetInstance())
  , FormerErrors(System::Errors)
  , FormerCause(crashCause)
  , FormerCode(crashCode)
{
  vtkOutputWindow::SetInstance(this->Collector);
  if (!catchStandardError)
  {
    return;
  }
  crashCause = onCrash;
  crashLine = onCrash + "\n";
  crashCode = exitCode;
  this->Printed = std::tmpfile();
  this->FormerErrors = System::DivertErrors(this->Printed);
  if (userError == System::Errors)
  {
    userError = this->FormerErrors;
  }
  System::CatchCrashes(EndAfterCrash);
}

//------------------------------------------------------------------------------
Messages::~Messages()
{
  vtkOutputWindow::SetInstance(this->Former);
  if (this->FormerErrors != System::Errors)
  {
    System::RestoreErrors(this->FormerErrors);
    crashCause = this->FormerCause;
    crashLine = crashCause + "\n";
    crashCode = this->FormerCode;
    if (userError == this->FormerErrors)
    {
      userError = System::Errors;
      System::CatchCrashes(nullptr);
    }
  }
  if (this->Printed)
  {
    std::fclose(this->Printed);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> Messages::GetErrors() const
{
  return static_cast<::Collector*>(this->Collector.Get())->Errors;
}

//------------------------------------------------------------------------------
std::vector<std::string> Messages::GetWarnings() const
{
  return static_cast<::Collector*>(this->Collector.Get())->Warnings;
}

//------------------------------------------------------------------------------
std::string Messages::GetPrinted() const
{
  std::string text;
  if (this->Printed)
  {
    std::fflush(stderr);
    std::rewind(this->Printed);
    for (int letter = std::fgetc(this->Printed); letter != EOF; letter = std::fgetc(this->Printed))
    {
      text += static_cast<char>(letter);
    }
  }
  return text;
}

//------------------------------------------------------------------------------
void Messages::Show(const std::string& text)
{
  System::Write(userError, text.data(), text.size());
}

//------------------------------------------------------------------------------
bool Messages::IsTerminal()
{
  return System::IsTerminal(userError);
}
