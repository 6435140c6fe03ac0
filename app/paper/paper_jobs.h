// The runs of the paper's experiments: specimens, and what is done to them, each from the state that the
// run before it left.
//
// The scenes are assets/paper/*.json; here they are cut to size, varied and chained. Runs that several
// figures need are made once.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/job.h"

namespace quicksand {

// What the paper leaves open of its method, standard nonsmooth contact dynamics. The defaults are what the rule of the
// experiment nscd_setting chooses; its report is in assets/paper/nscd_setting.
struct NscdSetting {
  int sweeps = 100;
  double deposit_step =
      2e-3;  // also the interval between grains: the paper has one grain a step [sqrt(d/g)]
  double fast_step = 1.4e-3;  // of push, pull, piston and shear [sqrt(d/g)]
  double drop_velocity = 0;   // [sqrt(g d)]
  bool operator==(const NscdSetting&) const = default;
};

// How much of the paper's programme is computed.
struct PaperScale {
  double width = 51, height = 199;  // of the box [d]
  int realizations = 10;
  std::vector<double> push_forces{0.1, 0.33, 0.67, 1, 2, 3};  // [F_c]
  double push_step = 1e-3;  // of pushes [sqrt(d/g)]; with 1e-2 many bonds too many break
  std::vector<double> time_steps{1e-2, 3e-3, 1e-3};  // for each failure criterion [sqrt(d/g)]
  // Whether a quicker deposition makes a denser specimen, which it does by its own weight: not in low boxes, nor where
  // a grain a step is as quick.
  bool denser_if_quicker = true;
  std::vector<double> shear_depths{0.1, 0.25, 0.4, 0.55, 0.7};  // over the packing's height [1]
  int grains_per_depth = 10;
  double shear_distance = 20;     // [d]
  double shear_tolerance = 0.05;  // relative width of the interval of force [1]
  double shear_time = 20;         // of a trial, at most [sqrt(d/g)]
  double force_tolerance = 0.05;  // of thresholds and pull-out forces: the same [1]
  double interval = 1e-2;         // between the grains of a deposition [sqrt(d/g)]
  // By NSCD, whose sweeps leave a noise above most speeds of rest: the longest time of a phase that waits for rest, twice
  // of the piston's, of a push, in which debris falls through all of the channel, and of a trial [sqrt(d/g)].
  double nscd_wait = 15, nscd_push = 60, nscd_trial = 8;
  // Also what no figure or number of the paper shows: without figures that are asked for, the studies among them, and
  // within a figure, specimens and forces that it has beyond the paper.
  bool studies = true;
  // Engaged: by the paper's own method.
  std::optional<NscdSetting> nscd = {};
};
PaperScale quick_scale();
// Everything by NSCD.
void make_nscd(PaperScale& scale, const NscdSetting& setting);
// The piston by NSCD. The paper gives the compacted state and no load; any that stops there will do, and where it stops
// is chosen by a rule of the experiment nscd_setting.
struct PistonLoad nscd_piston();

// A deposition that makes specimens as dense as the paper's: a grain every 0.001, in steps of as much.
inline constexpr const char* kDenseDeposition = "interval_0.001";
ParameterValues dense_deposition();
// One that makes a denser specimen by NSCD: grains come faster.
inline constexpr const char* kHardDrop = "drop_harder";
ParameterValues hard_drop(const NscdSetting& setting);

// Runs that differ by their seed only, as indices into PaperJobs::jobs().
struct RunGroup {
  std::string name;               // "sample.push_1_friction_0.6"
  std::vector<std::size_t> runs;  // (realizations)
  ParameterValues laws;           // changes that hold for all that follows, such as friction
};

// The same specimens, pushed with one force after the other.
struct PushCurve {
  std::vector<double> forces;    // (k) [F_c]
  std::vector<RunGroup> pushes;  // (k)
};

// What the paper does not say of its piston.
struct PistonLoad {
  double force = 30;  // on the paper's width; on others the pressure is the same [F_c]
  // Time over which it rises. What is pressed at once falls in faster than a piston can press, and ends in a shock
  // through all of a high specimen, in which no step converges. [sqrt(d/g) for each d of height]
  double ramp = 0.1;
  double mass = 2000;  // on the paper's width, shared as the force is [grain masses]
  // Engaged: it is taken away as soon as the bodies fill this share of the room between it and the floor. [1]
  std::optional<double> volume_fraction = {};
};

class PaperJobs {
 public:
  // Results will be in `out`/runs. Reads the scenes; throws InputError.
  PaperJobs(PaperScale scale, std::filesystem::path out);

  const PaperScale& scale() const { return scale_; }
  const std::filesystem::path& folder() const { return out_; }
  const std::vector<Job>& jobs() const { return jobs_; }

  // `tag` names what is different, "" for nothing; `set` are changes of this scene alone, `laws` also of
  // what follows. The same tag must mean the same changes.
  RunGroup samples(const std::string& tag = {}, const ParameterValues& laws = {},
                   const ParameterValues& set = {});
  // With the scale's time step, if none is given [sqrt(d/g)].
  RunGroup pushes(const RunGroup& samples, double force_over_cohesion, const std::string& tag = {},
                  const ParameterValues& laws = {}, std::optional<double> dt = {});
  // With each of the scale's forces.
  PushCurve push_curve(const RunGroup& samples);
  // The same without the strongest, with which an intruder passes specimens of any density.
  PushCurve push_curve_below_strongest(const RunGroup& samples);
  // Searches for the smallest force with which the intruder enters by `distance` [d].
  RunGroup thresholds(const RunGroup& samples, double distance);
  // After bonds were restored: all, or so many of them, drawn at random. [1]
  RunGroup pulls(const RunGroup& pushes, double first_force_over_cohesion, double restored = 1);
  RunGroup pistons(const RunGroup& samples, const std::string& tag, const PistonLoad& load);
  // With the load of the scale's method.
  RunGroup pistons(const RunGroup& samples);
  // `top`: about where the packing ends [d].
  RunGroup shears(const RunGroup& states, double top, double first_force);
  // What `plan` asks for, by NSCD with another setting than the scale's, so many realizations.
  RunGroup by(const NscdSetting& setting, std::size_t realizations,
              const std::function<RunGroup()>& plan);

 private:
  PushCurve push_curve(const RunGroup& samples, std::vector<double> forces);
  RunGroup add(const std::string& scene, const std::string& name, const RunGroup* after,
               ParameterValues laws, const ParameterValues& set);

  PaperScale scale_;
  std::filesystem::path out_;
  std::vector<Job> jobs_;
  std::map<std::string, RunGroup> known_;
};

}  // namespace quicksand
