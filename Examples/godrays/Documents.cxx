// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Documents.h"

#include "Files.h"
#include "Keys.h"
#include "Values.h"

#include <algorithm>
#include <sstream>

namespace
{
//------------------------------------------------------------------------------
std::string Replace(std::string text, const std::string& from, const std::string& to)
{
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
  return text;
}

//------------------------------------------------------------------------------
/// As roff has it.
std::string ToRoff(const std::string& text)
{
  std::string escaped = Replace(Replace(text, "\\", "\\e"), "-", "\\-");
  return escaped.empty() || (escaped[0] != '.' && escaped[0] != '\'') ? escaped : "\\&" + escaped;
}

//------------------------------------------------------------------------------
bool IsFile(const OptionRow& option)
{
  return option.Form == "FILE";
}

//------------------------------------------------------------------------------
std::string MakeManual(const std::vector<OptionRow>& options)
{
  std::ostringstream text;
  text
    << ".TH GODRAYS 1 \"\" \"godrays " << GODRAYS_VERSION << "\" \"User Commands\"\n"
    << ".SH NAME\ngodrays \\- show files with god rays\n"
    << ".SH SYNOPSIS\n.B godrays\n[\\fIOPTION\\fR]... \\fIFILE\\fR...\n"
    << ".SH DESCRIPTION\nShows files with the shafts of light that appear where air scatters "
       "sunlight past things that block it: in a window, or with\n.B \\-\\-output\nin a picture. "
       "It reads "
    << ToRoff(GetExtensions()) << ".\n";
  std::string group;
  for (const OptionRow& option : options)
  {
    if (option.Group != group)
    {
      group = option.Group;
      text << (group == "Options" ? ".SH OPTIONS\n" : ".SS " + group + "\n");
    }
    text << ".TP\n\\fB" << ToRoff(Join(option.Names, ", ")) << "\\fR"
         << (option.Form.empty() ? "" : " \\fI" + ToRoff(option.Form) + "\\fR") << "\n"
         << ToRoff(option.Help) << ".\n";
  }
  text << ".SH KEYS\n";
  for (const KeyBinding& key : GetKeyBindings())
  {
    text << ".TP\n\\fB" << ToRoff(key.Keys) << "\\fR\n" << ToRoff(key.Help) << "\n";
  }
  text
    << ".SH EXIT STATUS\n0 when all went well, 2 for mistakes in the options, 3 for files that "
       "cannot "
       "be read or written, 4 for the display, 5 for a picture that is not as its "
       "\\fB\\-\\-reference\\fR, 1 for anything else.\n"
    << ".SH FILES\n.TP\n\\fI$XDG_CONFIG_HOME/godrays/config\\fR, \\fI~/.config/godrays/config\\fR\n"
       "Options that hold each time: a line for each, as in \\fBpreset = fog\\fR or "
       "\\fBedges\\fR. After a line with a pattern in brackets, as in \\fB[*.vti]\\fR, they are "
       "for "
       "first files whose names fit it. Those of the command line come last.\n";
  return text.str();
}

//------------------------------------------------------------------------------
std::string MakeBash(const std::vector<OptionRow>& options)
{
  std::vector<std::string> names;
  std::ostringstream cases;
  for (const OptionRow& option : options)
  {
    names.insert(names.end(), option.Names.begin(), option.Names.end());
    if (!option.Choices.empty())
    {
      cases << "    " << Join(option.Names, "|") << ") COMPREPLY=($(compgen -W '"
            << Join(option.Choices, " ") << "' -- \"$now\")); return ;;\n";
    }
    else if (!option.Form.empty() && !IsFile(option))
    {
      cases << "    " << Join(option.Names, "|") << ") return ;;\n";
    }
  }
  return "# bash completion of godrays\n_godrays() {\n  COMPREPLY=()\n  local "
         "now=${COMP_WORDS[COMP_CWORD]}\n"
         "  case ${COMP_WORDS[COMP_CWORD-1]} in\n" +
    cases.str() + "  esac\n  if [[ $now == -* ]]; then\n    COMPREPLY=($(compgen -W '" +
    Join(names, " ") +
    "' -- \"$now\"))\n  else\n    COMPREPLY=($(compgen -f -- \"$now\"))\n  fi\n}\n"
    "complete -o filenames -F _godrays godrays\n";
}

//------------------------------------------------------------------------------
std::string MakeZsh(const std::vector<OptionRow>& options)
{
  std::string text = "#compdef godrays\n_arguments \\\n";
  for (const OptionRow& option : options)
  {
    const auto escape = [](const std::string& words)
    {
      return Replace(
        Replace(Replace(Replace(words, "'", "'\\''"), "[", "\\["), "]", "\\]"), ":", "\\:");
    };
    const std::string values = option.Form.empty() ? ""
                                                   : ":" + escape(option.Form) + ":" +
        (IsFile(option)              ? "_files"
            : option.Choices.empty() ? ""
                                     : "(" + Join(option.Choices, " ") + ")");
    for (const std::string& name : option.Names)
    {
      text += "  '" + name + "[" + escape(option.Help) + "]" + values + "' \\\n";
    }
  }
  return text + "  '*:file:_files'\n";
}

//------------------------------------------------------------------------------
std::string MakeFish(const std::vector<OptionRow>& options)
{
  std::string text = "# fish completion of godrays\n";
  for (const OptionRow& option : options)
  {
    text += "complete -c godrays";
    for (const std::string& name : option.Names)
    {
      text += name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    if (!option.Form.empty())
    {
      text += IsFile(option) ? " -r" : " -x";
    }
    if (!option.Choices.empty())
    {
      text += " -a '" + Join(option.Choices, " ") + "'";
    }
    text += " -d '" + Replace(Replace(option.Help, "\\", "\\\\"), "'", "\\'") + "'\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string MakeOptionTable(const std::vector<OptionRow>& options)
{
  std::string text = "| option | what it is |\n|---|---|\n";
  for (const OptionRow& option : options)
  {
    text += "| `" + Join(option.Names, "`, `") + (option.Form.empty() ? "" : " " + option.Form) +
      "` | " + Replace(option.Help, "|", "\\|") + " |\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string MakeKeyTable()
{
  std::string text = "| key | what it does |\n|---|---|\n";
  for (const KeyBinding& key : GetKeyBindings())
  {
    text += "| " + key.Keys + " | " + key.Help + " |\n";
  }
  return text;
}
}

//------------------------------------------------------------------------------
const std::vector<std::string>& GetDocumentKinds()
{
  static const std::vector<std::string> kinds = { "man", "bash", "zsh", "fish", "options", "keys" };
  return kinds;
}

//------------------------------------------------------------------------------
std::string MakeDocument(const std::string& kind, const std::vector<OptionRow>& options)
{
  return kind == "man" ? MakeManual(options)
    : kind == "bash"   ? MakeBash(options)
    : kind == "zsh"    ? MakeZsh(options)
    : kind == "fish"   ? MakeFish(options)
    : kind == "keys"   ? MakeKeyTable()
                       : MakeOptionTable(options);
}
