// Curves of what was measured on the way.
#include <imgui.h>

#include <algorithm>
#include <functional>

#include "app/panel/panel_frame.h"

namespace quicksand::gui {
namespace {

using Reading = std::function<std::optional<double>(const Row&)>;

Curve curve_of(const Session& session, const Reading& reading) {
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
  const bool loaded = frame.session.loaded();
  const char* none = loaded ? "no samples yet" : "no scene";

  Curve bonds = curve_of(frame.session, [](const Row& r) { return r.sample.active_bond_fraction; });
  bonds.nothing = loaded ? "no contacts yet" : none;
  w.plot("active bonds", "Active bonds / contacts", bonds);

  Curve coordination = curve_of(
      frame.session, [](const Row& r) -> std::optional<double> { return r.sample.coordination; });
  coordination.nothing = none;
  w.plot("coordination", "Coordination number", coordination);

  Curve depth = curve_of(frame.session, [](const Row& r) -> std::optional<double> {
    if (!r.sample.has_intruder) return std::nullopt;
    return r.sample.depth;
  });
  depth.unit = "d";
  depth.nothing = loaded ? "no intruder" : none;
  w.plot("depth", "Intruder depth", depth);

  Curve resistance = curve_of(frame.session, [](const Row& r) -> std::optional<double> {
    if (!r.sample.has_intruder) return std::nullopt;
    return r.sample.resistance;
  });
  resistance.unit = "F_g";
  resistance.nothing = depth.nothing;
  w.plot("resistance", "Resistance to the intruder", resistance);

  Curve residual = curve_of(frame.session, [](const Row& r) -> std::optional<double> {
    if (r.residual <= 0) return std::nullopt;
    return r.residual;
  });
  residual.logarithmic = true;
  residual.nothing = loaded ? "nothing solved yet" : none;
  w.plot("residual", "Residual", residual);
  w.end_section();
}

}  // namespace quicksand::gui
