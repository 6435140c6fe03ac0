// quicksand export: writes checkpoints in formats that other programs read.
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/cli/commands.h"
#include "app/export/exporter.h"
#include "app/run_folder/state_file.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

struct ExportArguments {
  std::vector<std::filesystem::path> states;
  std::string format;
  std::filesystem::path out;
};

int export_states(const ExportArguments& options) {
  std::error_code ignored;
  for (const auto& state : options.states)
    if (std::filesystem::equivalent(state, options.out, ignored))
      throw InputError("--out " + options.out.string(), "is the state that is read");
  Exporter exporter(export_format(options.format), options.out, options.states.size());
  for (const auto& state : options.states) exporter.add(read_state(state).checkpoint.world);
  exporter.finish();
  std::printf("%s\n", options.out.c_str());
  return kFine;
}

std::string words() {
  std::string text;
  for (const ExportFormat& format : export_formats()) {
    text += "  " + std::string(format.word) + "  " + std::string(format.help) + "\n";
  }
  return text;
}

}  // namespace

Command add_export(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "export", "Write states in formats of ParaView, OVITO, spreadsheets and NumPy.");
  const auto options = std::make_shared<ExportArguments>();
  command->add_option("states", options->states, "checkpoints of runs, in the order of their times")
      ->type_name("STATE.cbor")
      ->required();
  command->add_option("--format", options->format, "vtk, xyz, csv or npy")
      ->type_name("FORMAT")
      ->required();
  command->add_option("--out", options->out, "folder, or for xyz the file, that receives them")
      ->type_name("PATH")
      ->required();
  command->footer(
      "Formats, all with every digit or bit:\n" + words() +
      "A folder receives disks, contacts and walls, a file each, and states.csv, a row a state.\n"
      "Several states are numbered (disks_0000.csv), and VTK's have collections over time\n"
      "(disks.pvd). `quicksand list columns` says what is in them, and in which units. Without a\n"
      "step before the state, forces are zero. Lines between the centres of contacts go the\n"
      "nearest way, through periodic sides where that is shorter.\n\n"
      "Examples:\n"
      "  quicksand export out/collapse/state.cbor --format vtk --out out/collapse/vtk\n"
      "  quicksand export out/collapse/state.cbor --format xyz --out collapse.xyz");
  return {command, [options] { return export_states(*options); }};
}

}  // namespace quicksand
