// quicksand measure: numbers of a checkpoint, over regions, over height and as distributions.
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/cli/commands.h"
#include "app/json/json_reader.h"
#include "app/options/number_range.h"
#include "app/run_folder/measurements.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

struct MeasureArguments {
  std::filesystem::path state;
  std::filesystem::path out;
  bool json = false;
  MeasureChoices choices;
  double slice = 5;  // [d]
};

// The regions must not overlap: which of both a grain is in would be our choice.
void check_regions(const MeasureArguments& options, const World& world) {
  const int intruder = world.intruder();
  if (intruder < 0) return;
  const double radius = world.disks.radius[intruder];
  const double channel = radius + options.choices.channel_margin;
  if (2 * radius * options.choices.intact_distance >= channel) return;
  throw InputError("--intact-distance " + number_text(options.choices.intact_distance),
                   "begins inside the channel, which reaches to " +
                       number_text(channel / (2 * radius)) + " diameters of the intruder");
}

int measure_and_report(const MeasureArguments& options) {
  const StateFile state = read_state(options.state);
  check_regions(options, state.checkpoint.world);
  const Measurements m = measure_state(state, options.choices, options.slice);
  if (!options.out.empty()) write_measurements(options.out, m);
  const std::string text = options.json ? to_json(m).dump(2) + "\n" : text_of(m);
  std::fputs(text.c_str(), stdout);
  return kFine;
}

}  // namespace

Command add_measure(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "measure", "Measure the state of a run: regions, profile, angles, forces.");
  const auto options = std::make_shared<MeasureArguments>();
  constexpr double kFar = 1e6;
  command->add_option("state", options->state, "checkpoint of a run")
      ->type_name("STATE.cbor")
      ->required();
  command->add_option("--out", options->out, "folder that receives measures.json and CSV files")
      ->type_name("DIR");
  command->add_flag("--json", options->json, "print measures.json instead of a table");
  command->option_defaults()->group("Regions");
  command->add_option("--slice", options->slice, "thickness of the profile's slices [d]")
      ->type_name("LENGTH")
      ->check(in_range(between(0.1, kFar, "d")))
      ->capture_default_str();
  command
      ->add_option("--channel-margin", options->choices.channel_margin,
                   "the channel: centres nearer to the trajectory of the intruder's centre than "
                   "its radius and this [d]")
      ->type_name("LENGTH")
      ->check(in_range(between(0, kFar, "d")))
      ->capture_default_str();
  command
      ->add_option("--intact-distance", options->choices.intact_distance,
                   "the intact region: centres farther from that trajectory than this [diameters "
                   "of the intruder]")
      ->type_name("NUMBER")
      ->check(in_range(between(0, kFar, "diameters of the intruder")))
      ->capture_default_str();
  command
      ->add_option("--above-begins", options->choices.above_begins,
                   "where above the intruder begins, over its centre: 1 its top, -1 its lowest "
                   "point [radii of the intruder]")
      ->type_name("NUMBER")
      ->check(in_range(between(-kFar, kFar, "radii of the intruder")))
      ->capture_default_str();
  command->footer(
      "Regions: the whole specimen; the channel that the intruder swept; what is intact because it "
      "is\n"
      "far from there; and kept_bonds, the grains whose initial bonds all hold. A contact counts "
      "for\n"
      "a region by the share of its grains in it.\n"
      "DIR receives measures.json, profile.csv, bond_angles.csv, contact_orientations.csv,\n"
      "contact_forces.csv and bond_tensions.csv.\n\n"
      "Examples:\n"
      "  quicksand measure out/collapse/state.cbor\n"
      "  quicksand measure out/collapse/state.cbor --out out/collapse/measures --slice 2");
  return {command, [options] { return measure_and_report(*options); }};
}

}  // namespace quicksand
