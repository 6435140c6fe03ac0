// From a campaign to its runs.
#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "app/campaign/campaign.h"
#include "app/campaign/results_table.h"
#include "app/json/json_reader.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_override.h"
#include "app/scene/scene_report.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/base/format.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSeed = "seed";
constexpr std::uint64_t kMaxSeed = std::uint64_t{1} << 53U;  // as in a scene
// Listed bodies of all runs together, which are in memory at the same time.
constexpr std::size_t kMaxListedBodies = 5'000'000;

// 00012 is the first run of point 12, 00012_3 its fourth: a longer list, more values of the grid's first parameter
// and more realizations keep the names of the runs that are there already.
std::string id_of(std::size_t point, std::int64_t realization) {
  return format("%05zu", point) +
         (realization > 0 ? "_" + std::to_string(realization) : std::string());
}

// Each path is given in one place only, and none is also a column of its own in results.csv.
void check_paths(const Campaign& campaign) {
  std::map<std::string, std::string> given;
  const auto add = [&](const Json& values, const std::string& place) {
    for (const auto& [path, value] : values.items()) {
      const auto [known, is_new] = given.try_emplace(path, place);
      if (!is_new && known->second != place) {
        throw InputError(place + ": " + path, "is given in " + known->second + ", too");
      }
      if (place != "set" && path != kSeed && is_results_column(path)) {
        throw InputError(place + ": " + path,
                         "is also a column of results.csv; vary the fields inside it");
      }
    }
  };
  add(campaign.set, "set");
  for (const Json& point : campaign.list) add(point, "list");
  add(campaign.grid, "grid");
  for (const auto& [path, values] : campaign.grid.items())
    if (!values.is_array() || values.empty())
      throw InputError("grid: " + path, "must be a list of at least one value");
  if (campaign.realizations > 1 && campaign.grid.contains(kSeed)) {
    throw InputError("grid: seed", "clashes with realizations, which count seeds up themselves");
  }
}

void check_number_of_runs(const Campaign& campaign) {
  std::int64_t runs = campaign.realizations;
  const auto times = [&](std::size_t count) {
    if (count > static_cast<std::size_t>(kMaxRuns / runs)) {
      throw InputError("", "has more than " + std::to_string(kMaxRuns) +
                               " runs: realizations times the lists' lengths");
    }
    runs *= static_cast<std::int64_t>(count);
  };
  if (campaign.list.is_array()) times(campaign.list.size());
  for (const Json& values : campaign.grid) times(values.size());
}

// All combinations of an entry of the list with values of the grid, the last path varying fastest.
std::vector<ParameterValues> points_of(const Campaign& campaign) {
  std::vector<ParameterValues> points;
  for (const Json& entry : campaign.list) {
    ParameterValues values;
    for (const auto& [path, value] : entry.items()) values.emplace_back(path, value);
    points.push_back(std::move(values));
  }
  if (points.empty()) points.emplace_back();
  for (const auto& [path, values] : campaign.grid.items()) {
    std::vector<ParameterValues> longer;
    for (const ParameterValues& point : points) {
      for (const Json& value : values) {
        longer.push_back(point);
        longer.back().emplace_back(path, value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

class Expansion {
 public:
  Expansion(const Campaign& campaign, fs::path file, fs::path out)
      : campaign_(campaign), file_(std::move(file)), out_(std::move(out)) {}

  std::vector<Job> jobs() {
    in_file(file_, [&] {
      check_paths(campaign_);
      check_number_of_runs(campaign_);
    });
    for (const ParameterValues& point : points_of(campaign_)) add(point);
    std::vector<Job> jobs;
    for (std::size_t p = 0; p < points_.size(); ++p)
      for (std::int64_t k = 0; k < campaign_.realizations; ++k)
        jobs.push_back(realization(points_[p], k, id_of(p, k)));
    return jobs;
  }

 private:
  struct Point {
    ParameterValues values;
    Job first;                // its first realization
    std::size_t physics = 0;  // hash of its scene but for the seed
  };

  void add(const ParameterValues& values) {
    Job job;
    try {
      Json scene = campaign_.scene;
      for (const auto& [path, value] : campaign_.set.items()) set_value(scene, path, value, path);
      for (const auto& [path, value] : values) set_value(scene, path, value, path);
      job.scenario = scenario_from_json(scene);
      validate(job.scenario);
      check_start(job.scenario);
      job.values = columns(scene);
      check_realizations(job.scenario);
    } catch (const InputError& error) {
      refuse(error, values, id_of(points_.size(), 0));
    }
    Scenario physics = job.scenario;
    physics.seed = 0;
    points_.push_back({values, std::move(job), std::hash<std::string>()(to_text(physics))});
  }

  Job realization(const Point& point, std::int64_t k, const std::string& id) {
    Job job = point.first;
    job.scenario.seed += static_cast<std::uint64_t>(k);
    job.id = id;
    job.folder = {out_ / "runs" / id};
    const auto [known, is_new] = known_.try_emplace({point.physics, job.scenario.seed}, id);
    if (!is_new) refuse(InputError("", "is the same as run " + known->second), point.values, id);
    return job;
  }

  [[noreturn]] void refuse(const InputError& error, const ParameterValues& point,
                           const std::string& id) const {
    const std::string& where = error.where();
    const std::string place = where.empty() ? ": (" : " (" + origin(where) + "; ";
    const std::string values = point.empty() ? std::string() : ": " + values_text(point);
    throw error.in(file_.string(), place + "run " + id + values + ")");
  }

  // What the runs' parameters are at this point, also where only another point of the list names them.
  ParameterValues columns(const Json& scene) const {
    ParameterValues values;
    for (const std::string& path : paths_) {
      if (path != kSeed) values.emplace_back(path, value_at(scene, path));
    }
    return values;
  }

  void check_realizations(const Scenario& first) {
    if (first.seed + static_cast<std::uint64_t>(campaign_.realizations - 1) > kMaxSeed) {
      throw InputError(kSeed, "is too large for " + std::to_string(campaign_.realizations) +
                                  " realizations; at most 2^53 is possible");
    }
    bodies_ += first.disks.size() * static_cast<std::size_t>(campaign_.realizations);
    if (bodies_ > kMaxListedBodies) {
      throw InputError("bodies", "are too many to hold for all runs at once; at most " +
                                     std::to_string(kMaxListedBodies) + " are possible");
    }
  }

  // Reads a state to start from once for all runs that ask the same of it.
  void check_start(const Scenario& scenario) {
    if (scenario.start_from.empty()) return;
    // What the state must suit.
    Scenario asked = scenario;
    asked.disks.clear();
    const Json json = to_json(asked);
    const std::string wants =
        json.at("box").dump() + json.at("phases").dump() + (scenario.step.nscd ? "nscd" : "");
    if (!checked_.insert(scenario.start_from + wants).second) return;
    start_world(scenario);
  }

  // Where in the campaign file a value is from.
  std::string origin(const std::string& where) const {
    const auto names = [&](const Json& values) {
      for (const auto& [path, value] : values.items()) {
        if (where == path || where.starts_with(path + ".") || where.starts_with(path + "[")) {
          return true;
        }
      }
      return false;
    };
    if (names(campaign_.grid)) return "from grid";
    if (std::ranges::any_of(campaign_.list, names)) return "from list";
    if (names(campaign_.set)) return "from set";
    return "from scene";
  }

  const Campaign& campaign_;
  fs::path file_, out_;
  std::vector<std::string> paths_ = parameter_paths(campaign_);
  std::vector<Point> points_;
  std::size_t bodies_ = 0;
  std::map<std::pair<std::size_t, std::uint64_t>, std::string> known_;  // runs by scene and seed
  std::set<std::string> checked_;
};

}  // namespace

std::vector<Job> campaign_jobs(const Campaign& campaign, const fs::path& file,
                               const fs::path& out) {
  return Expansion(campaign, file, out).jobs();
}

std::vector<std::string> warnings_of(std::span<const Job> jobs) {
  std::map<std::string, std::size_t> runs;
  for (const Job& job : jobs)
    for (const std::string& warning : scene_warnings(job.scenario)) ++runs[warning];
  std::vector<std::string> warnings;
  warnings.reserve(runs.size());
  for (const auto& [warning, count] : runs)
    warnings.push_back(std::to_string(count) + " of " + count_text(std::ssize(jobs), "run") + ", " +
                       warning);
  return warnings;
}

}  // namespace quicksand
