// quicksand run: computes a scene and writes its results.
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/json/json_reader.h"
#include "app/picture_options.h"
#include "app/run/run_scene.h"
#include "app/scene/scene_options.h"
#include "app/shell_text.h"
#include "core/errors.h"

namespace quicksand {

namespace {

struct Options {
  SceneRequest scene;
  RunOptions run;
  PictureOptions picture;
  std::optional<double> every;
  std::optional<std::string> continued_from;
  bool no_frames = false;
};

std::string continue_command(const RunFolder& folder, const Options& options) {
  return "quicksand run " + shell_text(folder.scene()) + " --continue " +
         shell_text(folder.state()) + " --out " + shell_text(folder.path) +
         (options.every ? " --every " + number_text(*options.every) : "") +
         (options.no_frames ? " --no-frames" : "");
}

int report(const RunResult& result, const Options& options) {
  const std::string folder = result.folder.path.string();
  const std::string go_on = continue_command(result.folder, options);
  if (!result.notes.empty() && !options.run.quiet) {
    std::fprintf(stderr, "%s\n", result.notes.c_str());
  }
  switch (result.end.how) {
    case RunEnd::How::finished:
      std::printf("%lld steps in %.1f s; results are in %s\n",
                  static_cast<long long>(result.end.steps), result.end.wall_seconds,
                  folder.c_str());
      return kFine;
    case RunEnd::How::interrupted:
      std::printf("interrupted after %lld steps; results so far are in %s\n  continue with: %s\n",
                  static_cast<long long>(result.end.steps), folder.c_str(), go_on.c_str());
      return kInterrupted;
    case RunEnd::How::failed:
      if (result.end.unwritable) {
        std::fprintf(stderr, "quicksand: the run ended early: %s\n  what was written is in %s\n",
                     result.end.failure.c_str(), folder.c_str());
        return kRunFailed;
      }
      std::fprintf(
          stderr,
          "quicksand: the run failed: %s\n  results so far are in %s\n"
          "  continue with: %s --set step.max_halvings=16\n"
          "  or, to take such steps as they are, with --set step.on_unconverged=continue\n",
          result.end.failure.c_str(), folder.c_str(), go_on.c_str());
      return kRunFailed;
  }
  return kRunFailed;
}

int run(Options& options) {
  if (options.every && !(*options.every > 0)) {
    throw InputError("--every " + number_text(*options.every), "must be a time above 0 sqrt(d/g)");
  }
  options.run.view = view_from(options.picture);
  options.run.every = options.every;
  options.run.frames = !options.no_frames;
  if (options.continued_from) options.run.continued_from = *options.continued_from;
  const Scenario scenario = read_scene(options.scene);
  return report(run_scene(scenario, options.run), options);
}

}  // namespace

Command add_run(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("run", "run a scene: frames, numbers and a checkpoint");
  const auto options = std::make_shared<Options>();
  add_scene_options(*command, options->scene);
  command->add_option("--out", options->run.out, "folder of the results [out/<scene name>]")
      ->type_name("DIR");
  command
      ->add_option("--every", options->every,
                   "time between samples and frames [sqrt(d/g)], instead of the scene's")
      ->type_name("TIME");
  command
      ->add_option("--continue", options->continued_from,
                   "go on from the state of an interrupted or failed run of this scene")
      ->type_name("STATE.cbor");
  command->add_flag("--no-frames", options->no_frames, "compute without pictures");
  command->add_flag("--quiet", options->run.quiet, "print nothing but where the results are");
  add_picture_options(*command, options->picture);
  command->footer(
      "DIR receives scene.json, frames/, film.mp4 (if ffmpeg is there), series.csv, summary.json\n"
      "and state.cbor. Ctrl-C ends a run after the present step with complete results.\n\n"
      "Example:\n"
      "  quicksand run assets/scenes/collapse.json --out out/strong "
      "--set phases[1].force_over_cohesion=3");
  return {command, [options] { return run(*options); }};
}

}  // namespace quicksand
