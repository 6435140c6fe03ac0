// How the panel looks: its colours, fonts and distances.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "render/base/view.h"

namespace quicksand::gui {

struct Look {
  ImU32 panel = 0;    // behind the widgets
  ImU32 ink = 0;      // text
  ImU32 faint = 0;    // units, captions
  ImU32 line = 0;     // between sections, around fields
  ImU32 field = 0;    // where values stand
  ImU32 button = 0;   // as are headers that are pointed at
  ImU32 hovered = 0;  // a button that is pointed at
  ImU32 pressed = 0;
  ImU32 accent = 0;  // what is on, what to do first
  ImU32 accent_hovered = 0;
  ImU32 on_accent = 0;  // text upon it
  ImU32 warning = 0;
  ImU32 on_warning = 0;
  ImU32 error = 0;
  ImU32 on_error = 0;
  ImU32 curve = 0;
};
const Look& look(Theme theme);

struct Fonts {
  ImFont* text = nullptr;
  ImFont* bold = nullptr;
  ImFont* small = nullptr;
  ImFont* index = nullptr;  // of symbols
  // Contents of the files, which the fonts go on to read.
  std::vector<std::vector<unsigned char>> files;
};
// Adds the fonts to the present context. Throws RenderError.
Fonts load_fonts(float scale);

// Sets colours and distances of the present context.
void apply(const Look& look, float scale);

std::string capitalised(std::string text);
// "sqrt(d/g)" with a sign for the root; "1" becomes nothing, "grain masses" m_g.
std::string unit_text(const std::string& unit);

}  // namespace quicksand::gui
