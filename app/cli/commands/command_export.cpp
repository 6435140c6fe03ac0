// quicksand export: writes checkpoints and histories in formats that other programs read.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/cli/commands.h"
#include "app/export/exporter.h"
#include "app/options/moment_options.h"
#include "app/run_folder/state_file.h"
#include "app/view/history_view.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

struct ExportArguments {
  std::vector<fs::path> sources;  // checkpoints, folders of runs
  std::string format;
  fs::path out;
  MomentOptions moments;
};

// A checkpoint, or the moments of a run: read one by one, so that only one is in memory.
struct Source {
  fs::path state;
  std::optional<History> history = {};
  Moments moments{0, 1};

  World world(std::size_t k) const {
    return history ? history->world(k) : read_state(state).checkpoint.world;
  }
};

std::vector<Source> sources_of(const ExportArguments& options) {
  std::vector<Source> sources;
  std::error_code ignored;
  for (const auto& path : options.sources) {
    const RunFolder run{path};
    if (std::ranges::any_of(
            std::to_array({path, run.history(), run.state()}),
            [&](const fs::path& read) { return fs::equivalent(read, options.out, ignored); }))
      throw InputError("--out " + options.out.string(),
                       "is the input; choose another file or folder");
    Source& source = sources.emplace_back(Source{path});
    if (fs::is_directory(path, ignored)) {
      source.history.emplace(history_of(RunFolder{path}));
      source.moments = moments_between(*source.history, options.moments);
    } else {
      if (options.moments.given())
        throw InputError(path.string(),
                         "is a single state; --from and --to need the folder of a run");
      read_state(path);  // so that nothing is written where one of several is none
    }
  }
  return sources;
}

int export_states(const ExportArguments& options) {
  const std::vector<Source> sources = sources_of(options);
  std::size_t states = 0;
  for (const Source& source : sources) states += source.moments.size();
  Exporter exporter(export_format(options.format), options.out, states);
  for (const Source& source : sources)
    for (std::size_t k = source.moments.first; k < source.moments.end; ++k)
      exporter.add(source.world(k));
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
      "export", "Write states in formats for ParaView, OVITO, spreadsheets and NumPy.");
  const auto options = std::make_shared<ExportArguments>();
  command
      ->add_option(
          "states", options->sources,
          "folders of runs, with all their samples, or checkpoints; give them in order of time")
      ->type_name("DIR|STATE.cbor")
      ->required();
  command->add_option("--format", options->format, "vtk, xyz, csv or npy")
      ->type_name("FORMAT")
      ->required();
  command->add_option("--out", options->out, "folder, or for xyz file, to write")
      ->type_name("PATH")
      ->required();
  add_moment_options(*command, options->moments);
  command->footer(
      "Formats:\n" + words() +
      "A folder receives disks, contacts, walls and outlines, one file each, and states.csv, one\n"
      "row per state. The files of several states are numbered (disks_0000.csv); for VTK there\n"
      "are also collections over time (disks.pvd). `quicksand list columns` lists their columns\n"
      "and units. Forces are zero in a state before the first step. Lines between the centres of\n"
      "contacts take the shortest path, through periodic sides where that is shorter.\n"
      "Checkpoints are written with every digit or bit; the samples of a run (history.qsh) hold\n"
      "positions to 1e-7 d, and angles, velocities and forces to seven digits.\n\n"
      "Examples:\n"
      "  quicksand export out/collapse --from 2 --to 4 --format vtk --out out/collapse/series\n"
      "  quicksand export out/collapse/state.cbor --format xyz --out collapse.xyz");
  return {command, [options] { return export_states(*options); }};
}

}  // namespace quicksand
