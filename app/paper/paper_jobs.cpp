#include "app/paper/paper_jobs.h"

#include <algorithm>
#include <cmath>

#include "app/base/assets.h"
#include "app/json/json_reader.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_override.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/base/format.h"
#include "core/scene/validate.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

// A scene by NSCD: the settings that its name and phases ask for. What rests is slower than the sweeps' own noise,
// some 0.02 sqrt(g d) in a standing specimen.
void make_nscd(Json& scene, const PaperScale& scale, const std::string& file) {
  constexpr double kRestSpeed = 0.05;  // [sqrt(g d)]
  const NscdSetting& setting = *scale.nscd;
  set_value(scene, "method", "nscd", file);
  scene["nscd"] = {{"sweeps", setting.sweeps}, {"order", "random"}};
  bool deposits = false;
  for (Json& phase : scene["phases"]) {
    const std::string type = phase["type"];
    phase.erase("solver_tolerance");
    if (phase.contains("rest_speed")) phase["rest_speed"] = kRestSpeed;
    if (phase.contains("max_time"))
      phase["max_time"] = type == "push" ? scale.nscd_push : scale.nscd_wait;
    if (type == "deposit") {
      deposits = true;
      phase["interval"] = setting.deposit_step;
      phase["drop_velocity"] = setting.drop_velocity;
      phase["bonds"] = "every_touch";
    } else if (type == "settle" && deposits) {
      phase["bonding"] = true;
      phase["bonds"] = "every_touch";
    } else if (type == "pull" || type == "shear") {
      phase["until"] = "body_rest";
      phase["max_time"] = scale.nscd_trial;
    } else if (type == "piston") {
      phase["max_time"] = 2 * scale.nscd_wait;
    }
  }
  scene["step"]["dt"] = deposits ? setting.deposit_step : setting.fast_step;
}

}  // namespace

PaperScale quick_scale() {
  return {.width = 24,
          .height = 50,
          .realizations = 2,
          .push_forces = {0.1, 0.33, 1, 3},
          .push_step = 1e-2,
          .time_steps = {1e-2, 3e-3},
          .denser_if_quicker = false,
          .shear_depths = {0.2, 0.45, 0.7},
          .grains_per_depth = 1,
          .shear_distance = 2,
          .shear_tolerance = 0.25,
          .shear_time = 8,
          .force_tolerance = 0.125,
          .nscd_wait = 8,
          .nscd_push = 21,
          .nscd_trial = 2.5,
          .studies = false};
}

void make_nscd(PaperScale& scale, const NscdSetting& setting) {
  scale.nscd = setting;
  scale.interval = setting.deposit_step;
  scale.push_step = setting.fast_step;
  scale.denser_if_quicker = false;
  scale.shear_time = scale.nscd_trial;
}

PistonLoad nscd_piston() {
  return {.force = 10, .ramp = 0.08, .mass = 200, .volume_fraction = 0.73};
}

ParameterValues dense_deposition() { return {{"step.dt", 1e-3}, {"phases[0].interval", 1e-3}}; }

ParameterValues hard_drop(const NscdSetting& setting) {
  return {{"phases[0].drop_velocity", setting.drop_velocity + 5}};
}

PaperJobs::PaperJobs(PaperScale scale, fs::path out)
    : scale_(std::move(scale)), out_(std::move(out)) {}

RunGroup PaperJobs::add(const std::string& scene, const std::string& name, const RunGroup* after,
                        ParameterValues laws, const ParameterValues& set) {
  if (const auto known = known_.find(name); known != known_.end()) return known->second;
  RunGroup group{.name = name, .runs = {}, .laws = after ? after->laws : ParameterValues{}};
  group.laws.insert(group.laws.end(), laws.begin(), laws.end());

  const fs::path file = assets_folder() / "paper" / (scene + ".json");
  Json json = parse_json(read_scene_text(file));
  ParameterValues changes{{"box.width", scale_.width}, {"box.height", scale_.height}};
  changes.insert(changes.end(), group.laws.begin(), group.laws.end());
  changes.insert(changes.end(), set.begin(), set.end());
  if (scale_.nscd) make_nscd(json, scale_, file.string());
  for (const auto& [path, value] : changes) set_value(json, path, value, file.string());

  Job job;
  job.values = changes;
  for (std::size_t k = 0; k < static_cast<std::size_t>(scale_.realizations); ++k) {
    const std::string number = format("%02zu", k);
    job.id = name + "/" + number;
    job.folder = {fs::absolute(out_ / "runs" / name / number).lexically_normal()};
    if (after) {
      job.after = after->runs[k];
      set_value(json, "start_from", jobs_[*job.after].folder.state().string(), file.string());
    }
    try {
      job.scenario = scenario_from_json(json);
      job.scenario.seed += k;
      validate(job.scenario);
    } catch (const InputError& error) {
      throw InputError(file.string() + ": " + error.where(), error.what());
    }
    group.runs.push_back(jobs_.size());
    jobs_.push_back(job);
  }
  return known_[name] = group;
}

RunGroup PaperJobs::samples(const std::string& tag, const ParameterValues& laws,
                            const ParameterValues& set) {
  ParameterValues changes{{"phases[0].height", scale_.height},
                          {"phases[0].interval", scale_.interval}};
  changes.insert(changes.end(), set.begin(), set.end());
  return add("sample", tag.empty() ? "sample" : "sample_" + tag, nullptr, laws, changes);
}

RunGroup PaperJobs::pushes(const RunGroup& samples, double force_over_cohesion,
                           const std::string& tag, const ParameterValues& laws,
                           std::optional<double> dt) {
  return add(
      "push",
      samples.name + ".push_" + number_text(force_over_cohesion) + (tag.empty() ? "" : "_" + tag),
      &samples, laws,
      {{"phases[0].force_over_cohesion", force_over_cohesion},
       {"step.dt", dt.value_or(scale_.push_step)}});
}

PushCurve PaperJobs::push_curve(const RunGroup& samples, std::vector<double> forces) {
  PushCurve curve{std::move(forces), {}};
  for (const double force : curve.forces) curve.pushes.push_back(pushes(samples, force));
  return curve;
}

PushCurve PaperJobs::push_curve(const RunGroup& samples) {
  return push_curve(samples, scale_.push_forces);
}

PushCurve PaperJobs::push_curve_below_strongest(const RunGroup& samples) {
  std::vector<double> forces = scale_.push_forces;
  if (forces.size() > 1) forces.erase(std::ranges::max_element(forces));
  return push_curve(samples, std::move(forces));
}

RunGroup PaperJobs::thresholds(const RunGroup& samples, double distance) {
  constexpr double kFirstForce = 0.1;  // [F_c]
  constexpr double kMostTime = 20;     // of a trial [sqrt(d/g)]
  return add(
      "push", samples.name + ".threshold", &samples, {},
      {{"phases[0].force_over_cohesion", kFirstForce},
       {"phases[0].threshold", {{"distance", distance}, {"tolerance", scale_.force_tolerance}}},
       {"phases[0].until", "intruder_rest"},
       {"phases[0].max_time", kMostTime},
       {"step.dt", scale_.push_step}});
}

RunGroup PaperJobs::pulls(const RunGroup& pushes, double first_force_over_cohesion,
                          double restored) {
  std::string name = pushes.name + ".pull";
  ParameterValues set{{"phases[1].first_force_over_cohesion", first_force_over_cohesion},
                      {"phases[1].tolerance", scale_.force_tolerance}};
  if (restored < 1) {
    name += "_restored_" + number_text(restored);
    set.insert(set.end(),
               {{"phases[0].waited", -std::log1p(-restored)}, {"phases[0].healing_time", 1}});
  }
  return add("pull", name, &pushes, {}, set);
}

RunGroup PaperJobs::by(const NscdSetting& setting, std::size_t realizations,
                       const std::function<RunGroup()>& plan) {
  const PaperScale usual = scale_;
  make_nscd(scale_, setting);
  // Settings are compared when the intruders have stopped and debris still falls.
  scale_.nscd_push = scale_.nscd_wait;
  scale_.realizations = static_cast<int>(realizations);
  RunGroup group = plan();
  scale_ = usual;
  return group;
}

RunGroup PaperJobs::pistons(const RunGroup& samples) {
  return pistons(samples, "", scale_.nscd ? nscd_piston() : PistonLoad{});
}

RunGroup PaperJobs::pistons(const RunGroup& samples, const std::string& tag,
                            const PistonLoad& load) {
  // The pressure, and the mass that it drives, are those on the paper's width.
  const double share = scale_.width / PaperScale{}.width;
  ParameterValues set{{"phases[0].mass", load.mass * share},
                      {"phases[0].force_over_cohesion", load.force * share},
                      {"phases[0].ramp_time", load.ramp * scale_.height}};
  if (load.volume_fraction) set.emplace_back("phases[0].volume_fraction", *load.volume_fraction);
  return add("piston", samples.name + ".piston" + (tag.empty() ? "" : "_" + tag), &samples, {},
             set);
}

RunGroup PaperJobs::shears(const RunGroup& states, double top, double first_force) {
  Json depths = Json::array();
  for (const double share : scale_.shear_depths) depths.push_back(share * top);
  return add("shear", states.name + ".shear", &states, {},
             {{"phases[0].depths", depths},
              {"phases[0].grains_per_depth", scale_.grains_per_depth},
              {"phases[0].distance", scale_.shear_distance},
              {"phases[0].tolerance", scale_.shear_tolerance},
              {"phases[0].max_time", scale_.shear_time},
              {"phases[0].first_force", first_force}});
}

}  // namespace quicksand
