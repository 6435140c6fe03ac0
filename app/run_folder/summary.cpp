#include "app/run_folder/summary.h"

#include <algorithm>
#include <array>
#include <cinttypes>

#include "app/base/build_info.h"
#include "app/run_folder/search_results.h"
#include "app/run_folder/validation.h"
#include "app/scene_json/si_scale.h"
#include "core/base/format.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

// Of all steps: quantiles, and the counts of bins whose lower ends are 10^(low + k/bins_per_decade).
Json spread(const LogHistogram& h) {
  const auto first = std::ranges::find_if(h.counts, [](std::int64_t n) { return n > 0; });
  const auto last =
      std::find_if(h.counts.rbegin(), h.counts.rend(), [](std::int64_t n) { return n > 0; }).base();
  return {{"median", h.quantile(0.5)},
          {"p90", h.quantile(0.9)},
          {"p99", h.quantile(0.99)},
          {"worst", h.largest},
          {"low", LogHistogram::kLowest +
                      static_cast<double>(first - h.counts.begin()) / LogHistogram::kBinsPerDecade},
          {"bins_per_decade", LogHistogram::kBinsPerDecade},
          {"counts",
           first < last ? std::vector<std::int64_t>(first, last) : std::vector<std::int64_t>{}}};
}

// Where the time of the run's last part went, and how many contact problems were solved by what.
Json work_split(const RunEnd& end, const ProtocolState& state) {
  Json seconds = Json::object();
  for (std::size_t k = 0; k < kWorkNames.size(); ++k)
    seconds[std::string(kWorkNames[k])] = end.work[k];
  const WorkClock::Counts& counts = end.work_counts;
  constexpr std::array kStages{"warm_start", "local_solver", "interior_point", "far_start",
                               "relaxation"};
  Json by_stage = Json::object();
  for (std::size_t k = 0; k < kStages.size(); ++k) by_stage[kStages[k]] = counts.by_stage[k];
  return {{"steps", end.computed_steps},
          {"wall_seconds", end.last_wall_seconds},
          {"seconds", std::move(seconds)},
          {"solutions", counts.solutions},
          {"solutions_of_failure_criterion", counts.of_criterion},
          {"solved_by", std::move(by_stage)},
          {"not_converged", counts.not_converged},
          {"halved_steps", state.halved_steps}};
}

Json si_units(const PhysicalScale& physical) {
  const SiScale si = si_scale(physical);
  return {{"d [m]", si.length},       {"m [kg]", si.mass},
          {"sqrt(d/g) [s]", si.time}, {"sqrt(g d) [m/s]", si.velocity},
          {"F_g [N]", si.force},      {"F_g d [J]", si.energy}};
}

constexpr const char* kWallSeconds = "wall_seconds";  // in both files

// A file that is damaged costs a number in a report, and no run.
double seconds_in(const Json& json) {
  if (!json.is_object() || !json.contains(kWallSeconds) || !json[kWallSeconds].is_number())
    return 0;
  return std::max(0.0, json[kWallSeconds].get<double>());
}

}  // namespace

std::string failure_kind(const RunEnd& end) {
  constexpr std::array kNames{"run_failed", "scene", "disk_full", "memory", "unexpected"};
  return kNames.at(static_cast<std::size_t>(end.cause));
}

Json json_of(const Value& value) {
  struct ToJson {
    Json operator()(std::monostate) const { return nullptr; }
    Json operator()(std::int64_t number) const { return number; }
    Json operator()(double number) const { return number; }
    Json operator()(const std::string& text) const { return text; }
  };
  return std::visit(ToJson{}, value);
}

std::string world_hash_text(const World& world) { return format("%016" PRIx64, world_hash(world)); }

Json summary(const Scenario& scenario, const World& world, const ProtocolState& state,
             const Row& last, const RunEnd& end) {
  Json json = {{"program", "quicksand"},
               {"version", build_info().version},
               {"commit", build_info().commit},
               {"scene", scenario.name},
               {"seed", scenario.seed},
               {"finished", end.how == RunEnd::How::finished},
               {"interrupted", end.how == RunEnd::How::interrupted},
               {"failure", end.failure.empty() ? Json(nullptr) : Json(end.failure)},
               {"failure_kind", end.failure.empty() ? Json(nullptr) : Json(failure_kind(end))},
               {"missed_rest", end.missed_rest},
               {"phases_finished", state.phase},
               {"phases", scenario.phases.size()}};
  Row row = last;
  row.take_energy(state);  // which may be later than the last sample, where a run could not go on
  for (const Quantity& quantity : quantities())
    json[std::string(quantity.name)] = json_of(quantity.get(row));
  json["steps"] = end.steps;
  json[kWallSeconds] = end.wall_seconds;
  json["steps_per_second"] = end.last_wall_seconds > 0
                                 ? static_cast<double>(end.computed_steps) / end.last_wall_seconds
                                 : 0;
  json["work"] = work_split(end, state);
  json["total_iterations"] = state.iterations;
  json["total_factorisations"] = state.factorisations;
  json["worst_residual"] = state.worst_residual;
  json["worst_overlap"] = worst_overlap(state, last.sample.max_overlap);
  json["worst_bond_gap"] = state.worst_bond_gap;
  json["unconverged_steps"] = state.unconverged_steps;
  json["halved_steps"] = state.halved_steps;
  json["bonds_broken_in_unconverged_steps"] = state.broken_in_unconverged;
  json["bond_breaks_withheld"] = state.breaks_withheld;
  if (scenario.step.nscd) {
    json["method"] = "nscd";
    json["sweeps"] = scenario.step.nscd->sweeps;
    json["step_errors"] = {{"residual [1]", spread(state.sweep_errors.residual)},
                           {"gap of bonds [d]", spread(state.sweep_errors.bond_gap)},
                           {"overlap [d]", spread(state.sweep_errors.penetration)}};
  } else {
    json["method"] = "exact";
  }
  json.update(search_results(scenario, state));
  json["model_terms"] = model_terms(scenario);
  json["world_hash"] = "0x" + world_hash_text(world);
  if (scenario.physical) json["units_in_si"] = si_units(*scenario.physical);
  return json;
}

Json summary_in(const RunFolder& folder) {
  try {
    Json json = read_json(folder.summary());
    return json.is_object() ? json : Json();
  } catch (const InputError&) {
    return nullptr;
  }
}

bool has_finished(const RunFolder& folder) {
  const Json summary = summary_in(folder);
  return !summary.is_null() && summary.value("finished", Json()) == true;
}

double computing_time_of(const RunFolder& folder) {
  if (const Json summary = summary_in(folder); !summary.is_null()) return seconds_in(summary);
  try {
    return seconds_in(read_json(folder.computing_time()));
  } catch (const InputError&) {
    return 0;
  }
}

void keep_computing_time(const RunFolder& folder, double seconds) {
  write_whole(folder.computing_time(), Json{{kWallSeconds, seconds}}.dump(2) + "\n");
}

void forget_computing_time(const RunFolder& folder) {
  std::error_code ignored;
  std::filesystem::remove(folder.computing_time(), ignored);
}

}  // namespace quicksand
