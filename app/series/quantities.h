// What a run reports: every quantity with name, unit, meaning and where it comes from, in one table.
// Columns of series.csv, final values of summary.json and `quicksand list quantities` are this table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/measures/measures.h"
#include "core/protocol/protocol_state.h"

namespace quicksand {

// One sample with what the steps since the last sample tell.
struct Row {
  Sample sample;
  std::string phase;     // name of the phase that the sample belongs to
  double residual = 0;   // worst since the last sample [1]
  double gap_error = 0;  // worst since the last sample, over the tolerance [1]
  double velocity_change =
      0;  // worst known since the last sample, over the mean; 0: none known [1]
  std::int64_t iterations = 0;      // of the solver since the last sample [1]
  std::int64_t factorisations = 0;  // of the solver since the last sample [1]
  std::int64_t unconverged = 0;     // steps since the last sample [1]
  std::int64_t trial = 0;           // Search::trial; 0: no force is sought
  double trial_force = 0;           // Search::force [F_g]
  // Since the last sample, in steps in which a piston slides: its horizontal force on the bodies, and their time.
  double shear_impulse = 0, shear_time = 0;  // [F_g sqrt(d/g), sqrt(d/g)]
  // Sums over all steps so far [F_g d], those of trials included.
  double external_work = 0, energy_dissipated = 0, energy_gained = 0;
  void take_energy(const ProtocolState& state);
};

// monostate: there is no such value in this sample.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;
Value or_none(const std::optional<double>& value);

struct Quantity {
  std::string_view name;
  std::string_view unit;  // "1" if none
  std::string_view help;
  Value (*get)(const Row& row);
  bool of_steps = false;  // counted over steps, which a state alone does not know
};

std::span<const Quantity> quantities();
// Where it stands among them. Throws std::out_of_range if none has this name.
std::size_t place_of(std::string_view quantity);

// What a row of series.csv holds: the value of each of quantities(), in their order.
using Values = std::vector<Value>;
Values values_of(const Row& row);
// None of a text, or where there is no value.
std::optional<double> number_in(const Value& value);

// Shortest text that reads back as the same value; empty for no value.
std::string text_of(const Value& value);

}  // namespace quicksand
