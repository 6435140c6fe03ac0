#include "app/series/quantities.h"

#include <algorithm>
#include <stdexcept>

#include "app/json/json_reader.h"

namespace quicksand {

namespace {

// The intruder's values exist only where there is one.
template <class Number>
Value of_intruder(const Row& row, Number value) {
  return row.sample.has_intruder ? Value(value) : Value();
}

Value of_stress(const Row& row, double Stress::*part) {
  return row.sample.stress ? Value((*row.sample.stress).*part) : Value();
}

Value of_fabric(const Row& row, double Fabric::*part) {
  return row.sample.fabric ? Value((*row.sample.fabric).*part) : Value();
}

// A trial is there only while a critical force is sought.
template <class Number>
Value of_trial(const Row& row, Number value) {
  return row.trial > 0 ? Value(value) : Value();
}

const Quantity kQuantities[] = {
    {"time", "sqrt(d/g)", "time since the beginning",
     [](const Row& r) -> Value { return r.sample.time; }},
    {"step", "1", "time steps since the beginning",
     [](const Row& r) -> Value { return r.sample.step; }},
    {"phase", "1", "name of the phase", [](const Row& r) -> Value { return r.phase; }},
    {"grains", "1", "number of grains, without intruders",
     [](const Row& r) -> Value { return r.sample.grains; }},
    {"kinetic_energy", "F_g d", "kinetic energy of translation",
     [](const Row& r) -> Value { return r.sample.energy.kinetic; }},
    {"rotational_energy", "F_g d", "kinetic energy of rotation",
     [](const Row& r) -> Value { return r.sample.energy.rotational; }},
    {"potential_energy", "F_g d", "energy in gravity, relative to the origin",
     [](const Row& r) -> Value { return r.sample.energy.potential; }},
    {"max_speed", "sqrt(g d)", "speed of the fastest body",
     [](const Row& r) -> Value { return r.sample.max_speed; }},
    {"packing_top", "d", "height of the highest grain's top",
     [](const Row& r) -> Value { return r.sample.packing_top; }},
    {"volume_fraction", "1",
     "share of area filled by bodies, an intruder among them, in the lower 70 % of the packing; "
     "with "
     "closed or periodic sides, and without tilted walls",
     [](const Row& r) { return or_none(r.sample.volume_fraction); }},
    {"coordination", "1", "mean number of grains, walls and intruders that touch a grain",
     [](const Row& r) -> Value { return r.sample.coordination; }},
    {"coordination_loaded", "1", "... of those that carry a force or a bond",
     [](const Row& r) -> Value { return r.sample.coordination_loaded; }},
    {"contacts", "1", "number of touching contacts",
     [](const Row& r) -> Value { return r.sample.contacts; }},
    {"active_bond_fraction", "1", "active bonds over touching contacts",
     [](const Row& r) { return or_none(r.sample.active_bond_fraction); }},
    {"remaining_bond_fraction", "1",
     "active bonds over initial bonds: those active when the intruder or piston was placed, or at "
     "the start with initial_bonds",
     [](const Row& r) { return or_none(r.sample.remaining_bond_fraction); }},
    {"bonds_active", "1", "number of active bonds",
     [](const Row& r) -> Value { return r.sample.bonds_active; }},
    {"bonds_formed", "1", "bonds formed since the beginning",
     [](const Row& r) -> Value { return r.sample.bonds_formed; }},
    {"bonds_broken", "1", "bonds broken since the beginning",
     [](const Row& r) -> Value { return r.sample.bonds_broken; }},
    {"max_overlap", "d", "deepest overlap of two bodies",
     [](const Row& r) -> Value { return r.sample.max_overlap; }},
    {"intruder_x", "d", "x of the intruder's centre",
     [](const Row& r) { return of_intruder(r, r.sample.intruder_position.x()); }},
    {"intruder_y", "d", "y of the intruder's centre",
     [](const Row& r) { return of_intruder(r, r.sample.intruder_position.y()); }},
    {"intruder_velocity_x", "sqrt(g d)", "x velocity of the intruder's centre",
     [](const Row& r) { return of_intruder(r, r.sample.intruder_velocity.x()); }},
    {"intruder_velocity_y", "sqrt(g d)", "y velocity of the intruder's centre, positive upward",
     [](const Row& r) { return of_intruder(r, r.sample.intruder_velocity.y()); }},
    {"resistance", "F_g", "upward force of the contacts of the last step on the intruder",
     [](const Row& r) { return of_intruder(r, r.sample.resistance); }},
    {"depth", "d",
     "depth of the intruder's lowest point below the packing's top when it was placed",
     [](const Row& r) { return of_intruder(r, r.sample.depth); }},
    {"weight_above_column", "1",
     "weight of the grains directly above the intruder over that of all grains",
     [](const Row& r) { return of_intruder(r, r.sample.weight_above.column); }},
    {"weight_above_level", "1",
     "weight of the grains higher than the intruder over that of all grains",
     [](const Row& r) { return of_intruder(r, r.sample.weight_above.level); }},
    {"channel_grains", "1", "number of grains where the intruder has passed",
     [](const Row& r) { return of_intruder(r, r.sample.around_intruder.channel.grains); }},
    {"channel_coordination", "1", "mean number of touching neighbours of a grain in the channel",
     [](const Row& r) { return or_none(r.sample.around_intruder.channel.coordination); }},
    {"channel_active_bond_fraction", "1", "active bonds over touching contacts in the channel",
     [](const Row& r) { return or_none(r.sample.around_intruder.channel.active_bond_fraction); }},
    {"channel_remaining_bond_fraction", "1",
     "active initial bonds over initial bonds in the channel",
     [](const Row& r) {
       return or_none(r.sample.around_intruder.channel.remaining_bond_fraction);
     }},
    {"intact_grains", "1",
     "number of grains farther from the intruder's trajectory than 6 of its diameters",
     [](const Row& r) { return of_intruder(r, r.sample.around_intruder.intact.grains); }},
    {"intact_coordination", "1",
     "mean number of touching neighbours of a grain in the intact region",
     [](const Row& r) { return or_none(r.sample.around_intruder.intact.coordination); }},
    {"intact_active_bond_fraction", "1", "active bonds over touching contacts in the intact region",
     [](const Row& r) { return or_none(r.sample.around_intruder.intact.active_bond_fraction); }},
    {"intact_remaining_bond_fraction", "1",
     "active initial bonds over initial bonds in the intact region",
     [](const Row& r) { return or_none(r.sample.around_intruder.intact.remaining_bond_fraction); }},
    {"residual", "1", "worst residual of the solver since the last sample",
     [](const Row& r) -> Value { return r.residual; }, true},
    {"gap_error", "1",
     "worst gap error of a loaded contact since the last sample, over its tolerance",
     [](const Row& r) -> Value { return r.gap_error; }, true},
    {"velocity_change", "1",
     "worst change of velocity in the last iteration of a step since the last sample, over the "
     "mean velocity, where it is known",
     [](const Row& r) { return r.velocity_change > 0 ? Value(r.velocity_change) : Value(); }, true},
    {"iterations", "1", "iterations of the solver since the last sample",
     [](const Row& r) -> Value { return r.iterations; }, true},
    {"factorisations", "1", "factorisations of the solver since the last sample",
     [](const Row& r) -> Value { return r.factorisations; }, true},
    {"unconverged", "1", "steps since the last sample that did not converge",
     [](const Row& r) -> Value { return r.unconverged; }, true},
    {"trial", "1", "number of the trial in this phase, from 1; searches of forces only",
     [](const Row& r) { return of_trial(r, r.trial); }, true},
    {"trial_force", "F_g", "force of the trial on its body; of a vane its torque, in F_g d",
     [](const Row& r) { return of_trial(r, r.trial_force); }, true},
    {"bonds_healed", "1", "bonds restored by healing since the beginning",
     [](const Row& r) -> Value { return r.sample.bonds_healed; }},
    {"piston_y", "d", "height of the piston's surface",
     [](const Row& r) { return or_none(r.sample.piston_y); }},
    {"coordination_within_1e-3", "1", "mean number of neighbours of a grain up to a gap of 1e-3 d",
     [](const Row& r) -> Value { return r.sample.within[0].coordination; }},
    {"coordination_within_1e-2", "1", "mean number of neighbours of a grain up to a gap of 1e-2 d",
     [](const Row& r) -> Value { return r.sample.within[1].coordination; }},
    {"active_bonds_within_1e-3", "1", "active bonds over pairs up to a gap of 1e-3 d",
     [](const Row& r) { return or_none(r.sample.within[0].active_bond_fraction); }},
    {"active_bonds_within_1e-2", "1", "active bonds over pairs up to a gap of 1e-2 d",
     [](const Row& r) { return or_none(r.sample.within[1].active_bond_fraction); }},
    {"intruder_angle", "rad", "rotation since it was placed, counter-clockwise",
     [](const Row& r) { return of_intruder(r, r.sample.intruder_angle); }},
    {"intruder_torque", "F_g d", "torque of the contacts of the last step on the intruder",
     [](const Row& r) { return of_intruder(r, r.sample.reaction.torque); }},
    {"resistance_normal", "F_g", "part of the resistance due to normal forces",
     [](const Row& r) { return of_intruder(r, r.sample.reaction.normal); }},
    {"resistance_tangential", "F_g", "part of the resistance due to friction",
     [](const Row& r) { return of_intruder(r, r.sample.reaction.tangential); }},
    {"resistance_front", "F_g",
     "part of the resistance where the intruder's surface faces down within 45 degrees",
     [](const Row& r) { return of_intruder(r, r.sample.reaction.front); }},
    {"resistance_flank", "F_g", "part of the resistance elsewhere, except at the shaft",
     [](const Row& r) { return of_intruder(r, r.sample.reaction.flank); }},
    {"resistance_shaft", "F_g", "part of the resistance at the shaft",
     [](const Row& r) { return of_intruder(r, r.sample.reaction.shaft); }},
    {"stress_xx", "F_g/d",
     "horizontal normal stress of the contact forces of the last step (Love-Weber) in all bodies, "
     "over the area between the sides from the packing's bottom to its top; compression positive; "
     "where sides are closed or periodic and no wall is tilted",
     [](const Row& r) { return of_stress(r, &Stress::xx); }},
    {"stress_yy", "F_g/d", "... vertical normal stress",
     [](const Row& r) { return of_stress(r, &Stress::yy); }},
    {"stress_xy", "F_g/d",
     "... shear stress, the mean of its xy and yx components; negative where what is above a "
     "horizontal plane pushes what is below towards +x",
     [](const Row& r) { return of_stress(r, &Stress::xy); }},
    {"fabric_anisotropy", "1",
     "difference of the eigenvalues of the fabric tensor, the mean of n (x) n over touching pairs "
     "of grains, loaded or not: 0 if all directions are equally frequent, 1 if there is only one",
     [](const Row& r) { return of_fabric(r, &Fabric::anisotropy); }},
    {"fabric_direction", "rad",
     "axis along which such contacts are most frequent, from +x; 0 and pi are the same",
     [](const Row& r) { return of_fabric(r, &Fabric::direction); }},
    {"floor_load", "F_g", "downward force of the contacts of the last step on the floors",
     [](const Row& r) { return or_none(r.sample.loads.floor); }},
    {"side_load", "F_g",
     "downward force of the contacts of the last step on the side walls, by friction if they are "
     "upright",
     [](const Row& r) { return or_none(r.sample.loads.side); }},
    {"side_thrust", "F_g",
     "sum over all side walls of the normal force of the contacts of the last step, positive if "
     "bodies press on them: of two opposite walls, twice the thrust on one",
     [](const Row& r) { return or_none(r.sample.loads.side_thrust); }},
    {"piston_load", "F_g",
     "sum over pistons and other walls that face down of the normal force of the contacts of the "
     "last step",
     [](const Row& r) { return or_none(r.sample.loads.piston); }},
    {"piston_shear", "F_g",
     "horizontal force of the same walls on the bodies in the last step, positive towards +x",
     [](const Row& r) { return or_none(r.sample.loads.piston_shear); }},
    {"shear_force", "F_g",
     "horizontal force of a piston that slides on the bodies, positive towards +x: mean since the "
     "last sample",
     [](const Row& r) {
       return r.shear_time > 0 ? Value(r.shear_impulse / r.shear_time) : Value();
     },
     true},
    {"piston_x", "d",
     "x of the point that fixes the piston: how far it has slid, of one that a phase placed",
     [](const Row& r) { return or_none(r.sample.piston_x); }},
    {"external_work", "F_g d",
     "work of gravity, forces and prescribed motion since the run began, trials included",
     [](const Row& r) -> Value { return r.external_work; }, true},
    {"energy_dissipated", "F_g d", "energy lost since the run began",
     [](const Row& r) -> Value { return r.energy_dissipated; }, true},
    {"energy_gained", "F_g d",
     "excess energy since the run began, of steps that ended with more than they began with and "
     "received",
     [](const Row& r) -> Value { return r.energy_gained; }, true},
};

}  // namespace

void Row::take_energy(const ProtocolState& state) {
  external_work = state.external_work;
  energy_dissipated = state.energy_dissipated;
  energy_gained = state.energy_gained;
}

Value or_none(const std::optional<double>& value) { return value ? Value(*value) : Value(); }

std::span<const Quantity> quantities() { return kQuantities; }

std::size_t place_of(std::string_view quantity) {
  const auto* found = std::ranges::find(kQuantities, quantity, &Quantity::name);
  if (found == std::end(kQuantities)) throw std::out_of_range(std::string(quantity));
  return static_cast<std::size_t>(found - std::begin(kQuantities));
}

Values values_of(const Row& row) {
  Values values;
  values.reserve(std::size(kQuantities));
  for (const Quantity& quantity : kQuantities) values.push_back(quantity.get(row));
  return values;
}

std::optional<double> number_in(const Value& value) {
  if (const double* real = std::get_if<double>(&value)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::nullopt;
}

std::string text_of(const Value& value) {
  struct Text {
    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(std::int64_t number) const { return std::to_string(number); }
    std::string operator()(double number) const { return number_text(number); }
    std::string operator()(const std::string& text) const { return text; }
  };
  return std::visit(Text{}, value);
}

}  // namespace quicksand
