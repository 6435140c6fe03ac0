// quicksand run: computes a scene and writes its results.
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/run_outcome.h"
#include "app/options/number_range.h"
#include "app/options/picture_options.h"
#include "app/options/scene_options.h"
#include "app/options/strict_options.h"
#include "app/options/threads_option.h"
#include "core/base/parallel.h"
#include "core/scene/scenario.h"

namespace quicksand {

namespace {

struct RunArguments {
  SceneRequest scene;
  RunOptions run;
  PictureOptions picture;
  bool no_frames = false, overwrite = false;
  std::int64_t threads = 0;
};

int run(RunArguments& options) {
  options.run.view = view_from(options.picture);
  options.run.frames = !options.no_frames;
  options.run.keep_earlier = !options.overwrite;
  const Scenario scenario = read_scene(options.scene);
  RunResult result;
  with_threads(thread_count(options.threads), [&] { result = run_scene(scenario, options.run); });
  return tell_outcome(result, options.run);
}

}  // namespace

Command add_run(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("run", "Run a scene and write pictures, numbers and checkpoints.");
  const auto options = std::make_shared<RunArguments>();
  command->add_option("--out", options->run.out, "folder for the results [out/<scene name>]")
      ->type_name("DIR");
  command->add_flag("--overwrite", options->overwrite, "replace the run already in the folder");
  command
      ->add_option("--continue", options->run.continued_from,
                   "continue from the state of an earlier run of this scene, with a different "
                   "step, solver or phases; `resume` continues with the same")
      ->type_name("STATE.cbor");
  add_threads_option(*command, options->threads, kThreadsOfOneRun);
  command->add_flag("--quiet", options->run.quiet, "print only where the results are");
  add_scene_options(*command, options->scene);
  command->option_defaults()->group("Output times");
  command
      ->add_option("--every", options->run.every,
                   "time between samples and frames [sqrt(d/g)], instead of the scene's")
      ->type_name("TIME")
      ->check(in_range(above(0, kLongestSampleTime, "sqrt(d/g)")));
  command
      ->add_option(
          "--checkpoint-every", options->run.checkpoint_every,
          "wall time between checkpoints [s]; one is also written at the end of each phase")
      ->type_name("SECONDS")
      ->check(in_range(between(0, kLongestCheckpointTime, "s")))
      ->capture_default_str();
  command
      ->add_option(
          "--history", options->run.history_limit,
          "size of history.qsh [MB] above which every second sample is dropped; 0: no history")
      ->type_name("MB")
      ->check(in_range(between(0, kLargestHistory, "MB")))
      ->capture_default_str();
  command->add_flag("--no-frames", options->no_frames, "compute without pictures");
  add_strict_options(*command, options->run.strict);
  add_picture_options(*command, options->picture);
  command->footer(
      "DIR receives scene.json, run.json, frames/, film.png (animated, for a browser), film.mp4\n"
      "(with ffmpeg), series.csv, history.qsh (the states of all samples, for `render` and\n"
      "`export`), summary.json and state.cbor. Ctrl-C abandons the current step and leaves\n"
      "complete results; `quicksand resume DIR` continues the run, even after a kill or a power\n"
      "cut.\n\n"
      "Examples:\n"
      "  quicksand run assets/scenes/collapse.json\n"
      "  quicksand run assets/scenes/collapse.json --out out/strong --set "
      "phases[1].force_over_cohesion=3");
  return {command, [options] { return run(*options); }};
}

}  // namespace quicksand
