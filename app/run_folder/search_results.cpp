#include "app/run_folder/search_results.h"

#include "app/json/json_reader.h"
#include "core/base/format.h"
#include "core/base/whole_file.h"
#include "core/measures/critical_force.h"
#include "core/measures/drive_result.h"
#include "core/measures/shear_strength.h"

namespace quicksand {

namespace {

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

const char* word_of(SearchKind kind) {
  constexpr const char* kWords[] = {"none", "pull",      "shear", "adiabatic",
                                    "push", "penetrate", "vane"};
  return kWords[static_cast<std::size_t>(kind)];
}

Json json_of(const CriticalForce& found) {
  return {{"phase", found.phase},
          {"kind", word_of(found.kind)},
          {"body", found.body},
          {"x", found.position.x()},
          {"y", found.position.y()},
          {"depth", found.depth},
          {"weight_above", found.weight_above},
          {"force_low", found.force_low},
          {"force_held", found.force_held},
          {"force_high", or_null(found.force_high)},
          {"trials", found.trials},
          {"undecided", found.undecided}};
}

Json json_of(const AdiabaticDeposit& sample) {
  return {{"phase", sample.phase},
          {"interval", sample.interval},
          {"volume_fraction", sample.volume_fraction},
          {"change", or_null(sample.change)},
          {"coordination", sample.coordination},
          {"grains", sample.grains}};
}

// A vane also tells what strength field practice would compute from its torque, a piston that slides the ratios of shear to
// normal force.
Json json_of(const DriveResult& found) {
  constexpr const char* kDrives[] = {"penetrate", "vane", "slide"};
  Json json = {{"phase", found.phase},
               {"drive", kDrives[static_cast<std::size_t>(found.drive)]},
               {"peak", or_null(found.peak)},
               {"peak_at", or_null(found.peak_at)},
               {"residual", or_null(found.residual)},
               {"sensitivity", or_null(sensitivity(found))},
               {"mean", or_null(found.mean)},
               {"way", found.way},
               {"cleared", found.cleared}};
  if (found.normal_load) {
    const double normal = *found.normal_load;
    json["normal_load"] = normal;
    const auto ratio = [&](const std::optional<double>& force) {
      return force && normal > 0 ? Json(*force / normal) : Json(nullptr);
    };
    json["peak_friction"] = ratio(found.peak);
    json["residual_friction"] = ratio(found.residual);
    json["mean_friction"] = ratio(found.mean);
    json["inertial_number"] = or_null(found.inertial_number);
  }
  if (found.drive != Drive::vane) return json;
  json["radius"] = found.radius;
  const auto strength = [&](const std::optional<double>& torque) {
    return torque ? Json(vane_strength(*torque, found.radius)) : Json(nullptr);
  };
  json["peak_strength"] = strength(found.peak);
  json["residual_strength"] = strength(found.residual);
  json["mean_strength"] = strength(found.mean);
  return json;
}

Json json_of(const StrengthAtDepth& at) {
  return {{"depth", at.depth},
          {"grains", at.grains},
          {"never_moved", at.never_moved},
          {"mean", at.strength ? Json(at.strength->value) : Json(nullptr)},
          {"standard_error", at.strength ? or_null(at.strength->error) : Json(nullptr)},
          {"weight_above", or_null(at.weight_above)}};
}

Json json_of(const ShearStrength& strength, int phase) {
  Json depths = Json::array();
  for (const StrengthAtDepth& at : strength.depths) depths.push_back(json_of(at));
  Json json = {{"phase", phase}, {"depths", std::move(depths)}};
  const auto add = [&](const char* key, const std::optional<Line>& line, auto member) {
    json[key] = line ? or_null((*line).*member) : Json(nullptr);
  };
  add("slope", strength.against_depth, &Line::slope);
  add("slope_error", strength.against_depth, &Line::slope_error);
  add("intercept", strength.against_depth, &Line::intercept);
  add("intercept_error", strength.against_depth, &Line::intercept_error);
  add("effective_friction", strength.against_weight, &Line::slope);
  add("effective_friction_error", strength.against_weight, &Line::slope_error);
  return json;
}

template <class Item>
Json list_of(const std::vector<Item>& items) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(json_of(item));
  return list;
}

// A header of the keys, then a row an entry; null is empty.
std::string table_of(const Json& entries) {
  std::string text;
  const auto cell = [&](bool first, const std::string& value) {
    text += (first ? "" : ",") + value;
  };
  for (const auto& [key, value] : entries.front().items()) cell(text.empty(), key);
  for (const Json& entry : entries) {
    text += '\n';
    bool first = true;
    for (const auto& [key, value] : entry.items()) {
      cell(first, value.is_null()     ? std::string()
                  : value.is_string() ? value.get<std::string>()
                                      : value.dump());
      first = false;
    }
  }
  return text + '\n';
}

}  // namespace

Json search_results(const Scenario& scenario, const ProtocolState& state) {
  Json json = Json::object();
  if (!state.critical_forces.empty()) json["critical_forces"] = list_of(state.critical_forces);
  if (!state.adiabatic_deposits.empty()) json["adiabatic"] = list_of(state.adiabatic_deposits);
  if (!state.drive_results.empty()) json["drives"] = list_of(state.drive_results);
  for (std::size_t k = 0; k < state.adiabatic_deposits.size(); ++k) {
    const AdiabaticDeposit& last = state.adiabatic_deposits[k];
    const bool followed = k + 1 < state.adiabatic_deposits.size() &&
                          state.adiabatic_deposits[k + 1].phase == last.phase;
    if (followed || last.phase >= state.phase) continue;
    const auto* deposit =
        std::get_if<DepositPhase>(&scenario.phases[static_cast<std::size_t>(last.phase)].kind);
    if (!deposit || !deposit->adiabatic) continue;  // the scene is another by now
    const double tolerance = deposit->adiabatic->tolerance;
    if (last.change && std::abs(*last.change) < tolerance) continue;
    json["adiabatic_unsettled"].push_back(
        {{"phase", last.phase}, {"change", or_null(last.change)}, {"tolerance", tolerance}});
  }
  for (std::size_t k = 0; k < scenario.phases.size(); ++k) {
    const auto* shear = std::get_if<ShearPhase>(&scenario.phases[k].kind);
    const auto phase = static_cast<int>(k);
    if (!shear || phase > state.phase) continue;
    json["shear_strength"].push_back(
        json_of(shear_strength(state.critical_forces, phase, shear->depths), phase));
  }
  return json;
}

bool is_bracketed(const Json& critical_force) {
  const Json& low = critical_force.at("force_low");
  return critical_force.value("force_held", low) == low;
}

std::vector<std::string> search_warnings(const Json& results, int phases_finished) {
  std::vector<std::string> warnings;
  int never = 0, unforced = 0, always = 0, unbracketed = 0;
  for (const Json& found : results.value("critical_forces", Json::array())) {
    if (found.at("force_high").is_null()) ++never;
    if (found.at("force_high") == 0)
      ++unforced;
    else if (found.at("force_low") == 0)
      ++always;
    if (!is_bracketed(found)) ++unbracketed;
  }
  const auto bodies = [](int n) { return count_text(n, "body", "bodies"); };
  const std::string times =
      "2^" + std::to_string(ForceBracket::kMostDoublings) + " times the first one";
  if (never > 0) warnings.push_back("No force up to " + times + " moved " + bodies(never) + ".");
  if (unforced > 0) warnings.push_back(bodies(unforced) + " moved without any force.");
  if (always > 0)
    warnings.push_back(bodies(always) + " moved at every force down to the first one over 2^" +
                       std::to_string(ForceBracket::kMostDoublings) + ".");
  if (unbracketed > 0)
    warnings.push_back(bodies(unbracketed) +
                       " did not come to rest in the trial with force_low: it ran out of time "
                       "(max_time), so the lower end of the interval is not confirmed; force_held "
                       "is the largest force at which they did.");
  for (const Json& deposit : results.value("adiabatic_unsettled", Json::array())) {
    const Json& change = deposit.at("change");
    warnings.push_back(
        "The adiabatic deposit ended at its max_interval, before its volume fraction settled "
        "within " +
        number_text(deposit.at("tolerance").get<double>()) +
        (change.is_null() ? std::string(": it has a single specimen.")
                          : ": the last change was " + number_text(change.get<double>()) + "."));
  }
  for (const Json& shear : results.value("shear_strength", Json::array())) {
    if (shear.at("phase") >= phases_finished) continue;
    for (const Json& at : shear.at("depths"))
      if (at.at("grains") == 0 && at.at("never_moved") == 0)
        warnings.push_back("No grain was found within 0.5 d of the depth " +
                           number_text(at.at("depth").get<double>()) + " d.");
  }
  return warnings;
}

void write_search_tables(const RunFolder& folder, const ProtocolState& state) {
  if (!state.critical_forces.empty())
    write_whole(folder.critical_forces(), table_of(list_of(state.critical_forces)));
  if (!state.adiabatic_deposits.empty())
    write_whole(folder.adiabatic(), table_of(list_of(state.adiabatic_deposits)));
}

}  // namespace quicksand
