// Curves of what was measured on the way.
#include <imgui.h>

#include <algorithm>
#include <optional>

#include "app/panel/panel_frame.h"

namespace quicksand::gui {
namespace {

struct Plot {
  const char *quantity, *name, *title;
  const char* nothing;  // why a scene has given no values, if it has not
  bool logarithmic = false;
};
constexpr Plot kOverTime[] = {
    {"active_bond_fraction", "active share", "Active share", "no contacts yet"},
    {"coordination", "coordination", "Coordination number", "no samples yet"},
    {"depth", "depth", "Intruder depth", "no intruder"},
    {"resistance", "resistance", "Resistance to the intruder", "no intruder"},
    {"residual", "residual", "Residual", "nothing solved yet", true}};

std::string unit_of(std::size_t quantity) {
  const std::string_view unit = quantities()[quantity].unit;
  return unit == "1" ? std::string() : std::string(unit);
}

// A run that is shown marks where it was at the moment.
Curve curve_of(const Session& session, const Plot& plot) {
  const std::size_t place = place_of(plot.quantity);
  const std::size_t times = place_of("time");
  Curve curve{.logarithmic = plot.logarithmic,
              .unit = unit_of(place),
              .nothing = session.loaded() ? plot.nothing : "no scene"};
  if (!session.loaded()) return curve;
  if (session.timeline() != nullptr) curve.cursor = session.world().time;
  for (const Values& row : session.history()) {
    const std::optional<double> value = number_in(row[place]), time = number_in(row[times]);
    if (!time || !value || (plot.logarithmic && *value <= 0)) continue;
    curve.x.push_back(*time);
    curve.y.push_back(*value);
  }
  return curve;
}

// Of one kind of phase alone, over the way of its intruder.
Curve drive_curve(const Session& session, std::string_view phase, const char* load,
                  const char* way) {
  const std::size_t phases = place_of("phase"), times = place_of("time");
  const std::size_t loads = place_of(load), ways = place_of(way);
  Curve curve{.unit = unit_of(loads), .nothing = "not yet driven"};
  for (const Values& row : session.history()) {
    const std::optional<double> x = number_in(row[ways]), y = number_in(row[loads]);
    if (row[phases] != Value(std::string(phase)) || !x || !y) continue;
    curve.x.push_back(*x);
    curve.y.push_back(*y);
    if (session.timeline() != nullptr && number_in(row[times]) <= session.world().time)
      curve.cursor = *x;
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
  if (has_phase(session, PenetratePhase::kName))
    w.plot("resistance over depth", "Resistance over depth [d]",
           drive_curve(session, PenetratePhase::kName, "resistance", "depth"));
  if (has_phase(session, VanePhase::kName))
    w.plot("torque over angle", "Torque over angle [rad]",
           drive_curve(session, VanePhase::kName, "intruder_torque", "intruder_angle"));
  if (has_phase(session, SlidePhase::kName))
    w.plot("shear force over distance", "Shear force over distance [d]",
           drive_curve(session, SlidePhase::kName, "shear_force", "piston_x"));
}

}  // namespace

void show_plots(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  if (!w.begin_section("Plots", true)) return;
  show_drives(frame);
  ImGui::PushFont(w.fonts().small);
  w.caption("Over time [√(d/g)], with the last value.");
  ImGui::PopFont();
  for (const Plot& plot : kOverTime) w.plot(plot.name, plot.title, curve_of(frame.session, plot));
  w.end_section();
}

}  // namespace quicksand::gui
