// Curves of what was measured on the way.
#include <imgui.h>

#include <algorithm>
#include <optional>

#include "app/panel/panel_frame.h"

namespace quicksand::gui {
namespace {

using Reading = std::optional<double> (*)(const Row&);

template <double Sample::*Value>
std::optional<double> of_intruder(const Row& row) {
  return row.sample.has_intruder ? std::optional(row.sample.*Value) : std::nullopt;
}

struct Plot {
  const char *name, *title, *unit;
  const char* nothing;  // why a scene has given no values, if it has not
  Reading reading;
  bool logarithmic = false;
};
constexpr Plot kOverTime[] = {
    {"active share", "Active share", "", "no contacts yet",
     [](const Row& r) { return r.sample.active_bond_fraction; }},
    {"coordination", "Coordination number", "", "no samples yet",
     [](const Row& r) { return std::optional(r.sample.coordination); }},
    {"depth", "Intruder depth", "d", "no intruder", of_intruder<&Sample::depth>},
    {"resistance", "Resistance to the intruder", "F_g", "no intruder",
     of_intruder<&Sample::resistance>},
    {"residual", "Residual", "", "nothing solved yet",
     [](const Row& r) { return r.residual > 0 ? std::optional(r.residual) : std::nullopt; }, true}};

Curve curve_of(const Session& session, Reading reading) {
  Curve curve;
  if (!session.loaded()) return curve;
  if (session.timeline() != nullptr) curve.cursor = session.world().time;
  for (const Row& row : session.history()) {
    if (const std::optional<double> value = reading(row)) {
      curve.x.push_back(row.sample.time);
      curve.y.push_back(*value);
    }
  }
  return curve;
}

// Of one kind of phase alone, over the way of its intruder. A run that is shown marks where it was at the moment.
Curve drive_curve(const Session& session, std::string_view phase, double (*load)(const Sample&),
                  double Sample::*way) {
  Curve curve;
  curve.nothing = "not yet driven";
  for (const Row& row : session.history()) {
    if (row.phase != phase || !row.sample.has_intruder) continue;
    curve.x.push_back(row.sample.*way);
    curve.y.push_back(load(row.sample));
    if (session.timeline() != nullptr && row.sample.time <= session.world().time)
      curve.cursor = curve.x.back();
  }
  return curve;
}

bool has_phase(const Session& session, std::string_view name) {
  return session.loaded() && std::ranges::any_of(session.phases(), [&](const Phase& phase) {
           return phase_name(phase) == name;
         });
}

void show_drives(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  const Session& session = frame.session;
  if (has_phase(session, PenetratePhase::kName)) {
    Curve curve = drive_curve(
        session, PenetratePhase::kName, [](const Sample& s) { return s.resistance; },
        &Sample::depth);
    curve.unit = "F_g";
    w.plot("resistance over depth", "Resistance over depth [d]", curve);
  }
  if (has_phase(session, VanePhase::kName)) {
    Curve curve = drive_curve(
        session, VanePhase::kName, [](const Sample& s) { return s.reaction.torque; },
        &Sample::intruder_angle);
    curve.unit = "F_g d";
    w.plot("torque over angle", "Torque over angle [rad]", curve);
  }
}

}  // namespace

void show_plots(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  if (!w.begin_section("Plots", true)) return;
  show_drives(frame);
  ImGui::PushFont(w.fonts().small);
  w.caption("Over time [√(d/g)], with the last value.");
  ImGui::PopFont();
  for (const Plot& plot : kOverTime) {
    Curve curve = curve_of(frame.session, plot.reading);
    curve.unit = plot.unit;
    curve.nothing = frame.session.loaded() ? plot.nothing : "no scene";
    curve.logarithmic = plot.logarithmic;
    w.plot(plot.name, plot.title, curve);
  }
  w.end_section();
}

}  // namespace quicksand::gui
