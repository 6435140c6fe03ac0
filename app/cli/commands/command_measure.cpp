// quicksand measure: numbers of a state, over regions, over height and as distributions, and what has changed since an
// earlier one.
#include <charconv>
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/cli/commands.h"
#include "app/json/json_reader.h"
#include "app/options/moment_options.h"
#include "app/options/number_range.h"
#include "app/run_folder/measurements.h"
#include "app/scene/scene_file.h"
#include "app/view/history_view.h"
#include "core/base/errors.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

struct MeasureArguments {
  fs::path state;  // or the folder of a run
  std::optional<double> time;
  std::optional<std::string> since;  // a time, or a checkpoint
  fs::path out;
  bool json = false;
  MeasureChoices choices;
  double slice = 5;  // [d]
};

// The regions must not overlap: which of both a grain is in would be our choice.
void check_regions(const MeasureArguments& options, const World& world) {
  const int intruder = world.intruder();
  if (intruder < 0) return;
  const double radius = half_width(world, intruder);
  const double channel = radius + options.choices.channel_margin;
  if (2 * radius * options.choices.intact_distance >= channel) return;
  throw InputError("--intact-distance " + number_text(options.choices.intact_distance),
                   "begins inside the channel, which reaches to " +
                       number_text(channel / (2 * radius)) + " widths of the intruder");
}

// A sample of a run as its history keeps it.
StateFile state_at(const fs::path& run, const char* option, double time) {
  const History history = history_of(RunFolder{run});
  const std::size_t k = moment_at(history, option, time);
  StateFile state;
  state.scenario = read_scene({RunFolder{run}.scene(), {}, {}});
  state.checkpoint.world = history.world(k);
  state.phase = history.moments()[k].phase_name;
  return state;
}

StateFile measured_state(const MeasureArguments& options) {
  const bool of_run = is_folder(options.state);
  if (options.time && !of_run)
    throw InputError(options.state.string(), "is a single state; --time needs the folder of a run");
  if (options.time) return state_at(options.state, "--time", *options.time);
  return read_state(of_run ? RunFolder{options.state}.state() : options.state);
}

StateFile earlier_state(const MeasureArguments& options) {
  const std::string& since = *options.since;
  double time = 0;
  const char* end = since.data() + since.size();
  const auto [stop, error] = std::from_chars(since.data(), end, time);
  if (error != std::errc() || stop != end) return read_state(since);
  if (!is_folder(options.state))
    throw InputError("--since " + since,
                     "is a time, which needs the folder of a run; give the earlier STATE.cbor");
  return state_at(options.state, "--since", time);
}

Changes changes_since(const MeasureArguments& options, const StateFile& state) {
  const StateFile earlier = earlier_state(options);
  const World &before = earlier.checkpoint.world, &now = state.checkpoint.world;
  const std::string where = "--since " + *options.since;
  if (!same_specimen(before, now))
    throw InputError(where,
                     "belongs to another specimen: box or disks differ, or some were removed or "
                     "replaced in between");
  if (before.time > now.time)
    throw InputError(where, "is later, at " + message_number(before.time) +
                                " sqrt(d/g), than the measured state, at " +
                                message_number(now.time));
  // A scene that starts from a state may have another seed than that of its specimen.
  if (earlier.scenario.seed != state.scenario.seed)
    std::fprintf(stderr,
                 "warning: %s: has the seed %s and the measured state %s; unless one started from "
                 "the other, these are two specimens\n",
                 where.c_str(), std::to_string(earlier.scenario.seed).c_str(),
                 std::to_string(state.scenario.seed).c_str());
  return changes_between(before, now);
}

int measure_and_report(const MeasureArguments& options) {
  const StateFile state = measured_state(options);
  check_regions(options, state.checkpoint.world);
  Measurements m = measure_state(state, options.choices, options.slice);
  if (options.since) m.changes = changes_since(options, state);
  if (!options.out.empty()) write_measurements(options.out, m);
  const std::string text = options.json ? to_json(m).dump(2) + "\n" : text_of(m);
  std::fputs(text.c_str(), stdout);
  return kFine;
}

}  // namespace

Command add_measure(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "measure", "Measure a state of a run: regions, profile, angles, forces and changes.");
  const auto options = std::make_shared<MeasureArguments>();
  constexpr double kFar = 1e6;
  command->add_option("state", options->state, "folder of a run, or a checkpoint")
      ->type_name("DIR|STATE.cbor")
      ->required();
  command
      ->add_option("--time", options->time,
                   "measure the sample of the run nearest to this time [sqrt(d/g)]; its last state "
                   "if absent")
      ->type_name("TIME")
      ->check(in_range(between(0, 1e12, "sqrt(d/g)")));
  command
      ->add_option("--since", options->since,
                   "report the changes since this time of the run, or since this checkpoint")
      ->type_name("TIME|STATE.cbor");
  command->add_option("--out", options->out, "folder for measures.json and CSV files")
      ->type_name("DIR");
  command->add_flag("--json", options->json, "print measures.json instead of a table");
  command->option_defaults()->group("Regions");
  command->add_option("--slice", options->slice, "thickness of the profile's slices [d]")
      ->type_name("LENGTH")
      ->check(in_range(between(0.1, kFar, "d")))
      ->capture_default_str();
  command
      ->add_option("--channel-margin", options->choices.channel_margin,
                   "the channel: grain centres nearer to the intruder's trajectory (of its centre "
                   "or, if it is tall, of its axis) than its half width plus this [d]")
      ->type_name("LENGTH")
      ->check(in_range(between(0, kFar, "d")))
      ->capture_default_str();
  command
      ->add_option("--intact-distance", options->choices.intact_distance,
                   "the intact region: grain centres farther from that trajectory than this "
                   "[widths of the intruder; for a disk, its diameter]")
      ->type_name("NUMBER")
      ->check(in_range(between(0, kFar, "widths of the intruder")))
      ->capture_default_str();
  command
      ->add_option("--above-begins", options->choices.above_begins,
                   "height over the intruder's centre from which a grain counts as above it: 1 its "
                   "top, -1 its lowest point [radii of a disk]")
      ->type_name("NUMBER")
      ->check(in_range(between(-kFar, kFar, "radii")))
      ->capture_default_str();
  command
      ->add_option(
          "--contact-gap", options->choices.contact_gap,
          "pairs up to this gap count as contacts [d]; up to the cohesion range, or 5e-5 d "
          "without cohesion, if absent")
      ->type_name("LENGTH")
      ->check(in_range(between(0, 1, "d")));
  command->footer(
      "Regions: the whole specimen; the channel swept by the intruder; the intact region, far\n"
      "from its trajectory; kept_bonds, the grains whose initial bonds all hold, and lost_bonds,\n"
      "those that have lost one or more. A contact counts towards a region by the share of its\n"
      "grains in it. The stress of a slice of the profile is that of the grains with their\n"
      "centre in it, without intruders, over the width between the sides times the slice's\n"
      "whole thickness: where a slice is not full, as at the top, it shows too little.\n"
      "DIR receives measures.json, profile.csv, bond_angles.csv, contact_orientations.csv,\n"
      "contact_forces.csv and bond_tensions.csv; with --since, displacements.csv, one row per\n"
      "grain. A profile of more than 10000 slices is left out, and the output says so.\n"
      "A grain counts as displaced if it moved by more than d/2.\n\n"
      "Examples:\n"
      "  quicksand measure out/collapse --time 13 --since 5.96\n"
      "  quicksand measure out/collapse/state.cbor --out out/collapse/measures --slice 2");
  return {command, [options] { return measure_and_report(*options); }};
}

}  // namespace quicksand
