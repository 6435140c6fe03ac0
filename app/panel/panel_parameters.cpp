// The scene's parameters, generated from the description of the scene format.
#include <imgui.h>

#include "app/panel/panel_frame.h"
#include "app/session/parameters.h"
#include "render/base/nice_numbers.h"

namespace quicksand::gui {
namespace {

bool is_number(const Parameter& p) {
  return p.kind == Parameter::Kind::number || p.kind == Parameter::Kind::integer;
}

std::string help_of(const Parameter& p) {
  std::string help = p.help;
  if (!help.empty() && help.back() != '.') help += '.';
  if (is_number(p)) {
    const std::string unit = unit_text(p.unit);
    help += "\nFrom " + std::string(p.above_low ? "above " : "") + short_number(p.low) + " to " +
            short_number(p.high) + (unit.empty() ? "" : " " + unit) + ".";
  }
  if (p.value.is_null()) help += "\nThis scene does not model it.";
  return help;
}

void show_parameter(PanelFrame& frame, const Parameter& p) {
  Widgets& w = frame.widgets;
  const Widgets::Label label{p.label, capitalised(p.label), help_of(p), unit_text(p.unit)};
  std::optional<Json> given;
  if (p.value.is_null()) {
    w.no_number(label);
  } else if (is_number(p)) {
    const bool integer = p.kind == Parameter::Kind::integer;
    if (const auto value = w.number(label, p.value.get<double>(), integer)) {
      given = integer ? Json(static_cast<std::int64_t>(*value)) : Json(*value);
    }
  } else if (p.kind == Parameter::Kind::flag) {
    if (const auto on = w.checkbox(label, p.value.get<bool>())) given = *on;
  } else if (const auto word = w.combo(label, p.words, p.value.get<std::string>())) {
    given = *word;
  }
  if (!frame.notes.error.empty() && frame.notes.refused_path == p.path)
    w.refusal(p.label + " refused", capitalised(frame.notes.refusal) + ".");
  if (given) frame.command("set", {{"path", p.path}, {"value", *given}});
}

}  // namespace

void show_parameters(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  if (!w.begin_section("Parameters", false)) return;
  if (frame.session.loaded()) {
    const std::string last = frame.session.last_change();
    {
      const Widgets::Disabled disabled(w, last.empty());
      if (w.button({"Undo", "Undo",
                    last.empty() ? "Nothing was changed."
                                 : "Undoes the change of " + last + ". Ctrl+Z."},
                   w.field_width()))
        frame.command("undo");
    }
    bool first = true;
    for (const ParameterGroup& group : parameters_of(frame.session.scenario())) {
      if (w.begin_group(group.name, first)) {
        for (const Parameter& parameter : group.parameters) show_parameter(frame, parameter);
        w.end_section();
      }
      first = false;
    }
  }
  w.end_section();
}

}  // namespace quicksand::gui
