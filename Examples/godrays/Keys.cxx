// SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Keys.h"

#include <algorithm>
#include <cctype>

//------------------------------------------------------------------------------
const std::vector<KeyBinding>& GetKeyBindings()
{
  static const std::vector<KeyBinding> bindings = {
    { "H, ?", { "h", "question", "F1" }, Command::Help, 0, "show or hide this help" },
    { "Home, R", { "Home", "r", "Return" }, Command::Home, 0,
      "the camera and the light of the beginning" },
    { "G", { "g" }, Command::Rays, 0, "rays on or off" },
    { "N", { "n" }, Command::Look, 1, "next preset" },
    { "Shift+N", { "N" }, Command::Look, -1, "previous preset" },
    { "+", { "plus", "equal", "KP_Add" }, Command::Intensity, 1, "stronger rays" },
    { "-", { "minus", "KP_Subtract" }, Command::Intensity, -1, "weaker rays" },
    { "]", { "bracketright" }, Command::Exposure, 1, "brighter physical sky (--sky)" },
    { "[", { "bracketleft" }, Command::Exposure, -1, "darker physical sky" },
    { "Right", { "Right" }, Command::Azimuth, 1, "light to the right; Shift: five times as far" },
    { "Left", { "Left" }, Command::Azimuth, -1, "light to the left" },
    { "Up", { "Up" }, Command::Elevation, 1, "light up" },
    { "Down", { "Down" }, Command::Elevation, -1, "light down" },
    { "L", { "l" }, Command::Handle, 0, "show or hide the handle by which the light is dragged" },
    { "T", { "t" }, Command::Sliders, 0, "show or hide sliders for the numbers of the rays" },
    { "O", { "o" }, Command::RaysAlone, 0, "the rays alone, or the scene with them" },
    { "V", { "v" }, Command::View, 1, "next view: scene, occlusion, rays, depth, error" },
    { "Shift+V", { "V" }, Command::View, -1, "previous view" },
    { "D", { "d" }, Command::Split, 0, "divide: without rays on the left; drag the divider" },
    { "U", { "u" }, Command::Background, 0, "next background" },
    { "B", { "b" }, Command::ScalarBar, 0, "scalar bar on or off" },
    { "X", { "x" }, Command::Axes, 0, "axes on or off" },
    { "M", { "m" }, Command::Grid, 0, "grid with coordinates on or off" },
    { "K", { "k" }, Command::Style, 0, "drag as a trackball, or over a level horizon" },
    { "Z", { "z" }, Command::Status, 0, "status line on or off" },
    { "PageDown", { "Next" }, Command::File, 1, "next file (--each)" },
    { "PageUp", { "Prior" }, Command::File, -1, "previous file (--each)" },
    { ".", { "period" }, Command::Time, 1, "next time step" },
    { ",", { "comma" }, Command::Time, -1, "previous time step" },
    { "Space", { "space" }, Command::Play, 0, "play or stop the time steps" },
    { "F5", { "F5" }, Command::Reload, 0, "read the files again" },
    { "S, F12", { "s", "F12" }, Command::Screenshot, 0, "write the picture to the present folder" },
    { "C", { "c" }, Command::PrintOptions, 0, "print camera, light and look as options" },
    { "Q, Esc", { "q", "Escape" }, Command::Quit, 0, "end" },
  };
  return bindings;
}

//------------------------------------------------------------------------------
const KeyBinding* FindKeyBinding(const std::string& symbol)
{
  const auto find = [](const std::string& name) -> const KeyBinding*
  {
    for (const KeyBinding& binding : GetKeyBindings())
    {
      if (std::find(binding.Symbols.begin(), binding.Symbols.end(), name) != binding.Symbols.end())
      {
        return &binding;
      }
    }
    return nullptr;
  };
  const KeyBinding* found = find(symbol);
  if (!found && symbol.size() == 1)
  {
    found = find(std::string(1, static_cast<char>(std::tolower(symbol[0]))));
  }
  return found;
}

//------------------------------------------------------------------------------
std::string GetKeyLines()
{
  std::string lines;
  for (const KeyBinding& binding : GetKeyBindings())
  {
    lines += (lines.empty() ? "" : "\n") + binding.Keys +
      std::string(10 - std::min<std::size_t>(binding.Keys.size(), 9), ' ') + binding.Help;
  }
  return lines;
}
