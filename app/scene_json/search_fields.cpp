// The searches (push with a threshold, pull, shear, adiabatic deposit), as fields of a scene file.
#include "app/scene_json/phase_fields.h"

namespace quicksand {

namespace {

constexpr std::size_t kMaxDepths = 1000;
constexpr std::string_view kTrialEnds[] = {"rest", "body_rest"};
constexpr std::int64_t kMaxGrains = 100'000;  // at a depth

void describe_interval(Fields& f, double& tolerance) {
  f.number({"tolerance", "width of the resulting interval, relative to its upper end"},
           between(1e-9, 0.5, "1"), tolerance);
}

void describe_trials(Fields& f, SearchTrials& t, const ContactLaw& law) {
  const Limits limits = above(0, 1e12, "F_g");
  std::optional<double> force = t.first_force;
  std::optional<double> force_over_cohesion;
  f.number({"first_force",
            "force of the first trial; doubled or halved at first, then the interval is halved"},
           limits, force);
  f.number({"first_force_over_cohesion", "the same, in units of the grains' cohesion force"},
           above(0, 1e6, "F_c"), force_over_cohesion);
  f.exactly_one({"first_force", "first_force_over_cohesion"});
  describe_interval(f, t.tolerance);
  f.number({"rest_speed", "a trial counts as held when no body is faster than this ..."},
           above(0, 1e6, "sqrt(g d)"), t.rest_speed);
  f.number({"rest_time", "... for this long"}, between(0, kMaxTime, "sqrt(d/g)"), t.rest_time);
  f.number({"max_time", "time after which a trial ends in any case: undecided, counted as held"},
           above(0, kMaxTime, "sqrt(d/g)"), t.max_time);
  f.choice({"until",
            "a trial ends when everything is at rest, or as soon as the pulled body is at rest and "
            "no bond has failed for rest_time"},
           kTrialEnds, t.until);
  if (f.reading())
    t.first_force = given_force(f, "first_force", limits, force, force_over_cohesion, law);
}

}  // namespace

void describe_fields(Fields& f, PullPhase& p, const Scenario& scenario) {
  describe_trials(f, p.trials, scenario.grain_law);
  f.number({"distance", "rise at which the intruder counts as out; absent: above the packing"},
           above(0, 1e6, "d"), p.distance);
}

void describe_fields(Fields& f, ShearPhase& p, const Scenario& scenario) {
  f.numbers({"depths", "depths of the grains below the top of the packing", Presence::required},
            between(0, 1e6, "d"), kMaxDepths, p.depths);
  f.integer({"grains_per_depth",
             "number of grains drawn at random within half a diameter of the depth; all of them if "
             "there are fewer"},
            1, kMaxGrains, p.grains_per_depth);
  f.number({"distance", "displacement along x at which a grain counts as moved"},
           above(0, 1e6, "d"), p.distance);
  describe_trials(f, p.trials, scenario.grain_law);
  if (f.reading() && p.depths.empty()) f.refuse("depths", "is an empty list; give a depth [d]");
}

void describe_critical_drive(Fields& f, const char* help, double first, bool at_given_speed,
                             double ramp_time, std::optional<CriticalDrive>& threshold) {
  f.optional_object({"threshold", help}, threshold,
                    [](Fields& g, CriticalDrive& t) { describe_interval(g, t.tolerance); });
  if (!f.reading() || !threshold) return;
  if (at_given_speed)
    f.refuse("threshold",
             "seeks a force or torque, but a velocity is given; drive by force or torque instead");
  if (first <= 0) f.refuse("threshold", "needs a drive above 0, that of the first trial");
  if (ramp_time > 0) f.refuse("ramp_time", "must be 0 where a threshold is sought");
}

void describe_threshold(Fields& f, PushPhase& p) {
  f.optional_object(
      {"threshold",
       "instead of a single push, finds the smallest force with which the intruder enters, by "
       "trials from the same state; force is that of the first trial, and each trial ends as the "
       "push would"},
      p.threshold, [](Fields& g, Threshold& t) {
        g.number({"distance", "travel at which it counts as entered; its diameter if absent"},
                 above(0, 1e6, "d"), t.distance);
        describe_interval(g, t.tolerance);
      });
  if (f.reading() && p.threshold && p.force <= 0)
    f.refuse("threshold", "needs a force above 0, that of the first trial");
}

void describe_adiabatic(Fields& f, DepositPhase& p) {
  f.optional_object(
      {"adiabatic",
       "deposits whole specimens, each with a longer interval, until the volume fraction no longer "
       "changes; the last one is kept"},
      p.adiabatic, [](Fields& g, Adiabatic& a) {
        g.number({"tolerance", "relative change of the volume fraction at which this ends"},
                 above(0, 1, "1"), a.tolerance);
        g.number({"factor", "factor from one interval to the next"}, between(1.1, 1000, "1"),
                 a.factor);
        g.number({"max_interval", "longest interval tried"}, above(0, kMaxTime, "sqrt(d/g)"),
                 a.max_interval);
      });
  if (!f.reading() || !p.adiabatic) return;
  if (p.interval == 0) f.refuse("interval", "is 0, must be above 0 sqrt(d/g) with adiabatic");
  if (p.adiabatic->max_interval < p.interval) {
    f.refuse("adiabatic.max_interval", "is below interval, the first one");
  }
}

}  // namespace quicksand
