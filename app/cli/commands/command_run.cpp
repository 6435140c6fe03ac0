// quicksand run: computes a scene and writes its results.
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/run_outcome.h"
#include "app/json/json_reader.h"
#include "app/options/picture_options.h"
#include "app/options/strict_options.h"
#include "app/options/threads_option.h"
#include "app/scene/scene_options.h"
#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "core/scene/scenario.h"

namespace quicksand {

namespace {

struct RunArguments {
  SceneRequest scene;
  RunOptions run;
  PictureOptions picture;
  StrictOptions strict;
  std::optional<double> every;
  std::optional<std::string> continued_from;
  bool no_frames = false, overwrite = false;
  std::int64_t threads = 0;
};

int run(RunArguments& options) {
  if (options.every && !(*options.every > 0 && *options.every <= kLongestSampleTime)) {
    throw InputError(
        "--every " + number_text(*options.every),
        "must be a time above 0, at most " + number_text(kLongestSampleTime) + " sqrt(d/g)");
  }
  const double pause = options.run.checkpoint_every;
  if (!(pause >= 0 && pause <= kLongestCheckpointTime)) {
    throw InputError("--checkpoint-every " + number_text(pause),
                     "must be a time from 0 to " + number_text(kLongestCheckpointTime) + " s");
  }
  options.run.view = view_from(options.picture);
  options.run.every = options.every;
  options.run.frames = !options.no_frames;
  options.run.keep_earlier = !options.overwrite;
  options.run.strict = strict_from(options.strict);
  if (options.continued_from) options.run.continued_from = *options.continued_from;
  const Scenario scenario = read_scene(options.scene);
  RunResult result;
  with_threads(thread_count(options.threads), [&] { result = run_scene(scenario, options.run); });
  return tell_outcome(result, options.run);
}

}  // namespace

Command add_run(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("run", "run a scene: frames, numbers and a checkpoint");
  const auto options = std::make_shared<RunArguments>();
  add_scene_options(*command, options->scene);
  command->add_option("--out", options->run.out, "folder of the results [out/<scene name>]")
      ->type_name("DIR");
  command->add_flag("--overwrite", options->overwrite, "replace the run that the folder holds");
  command
      ->add_option("--every", options->every,
                   "time between samples and frames [sqrt(d/g)], instead of the scene's")
      ->type_name("TIME");
  command
      ->add_option("--continue", options->continued_from,
                   "go on from the state of an earlier run of this scene, with other step, solver "
                   "or phases; `resume` goes on with the same")
      ->type_name("STATE.cbor");
  command
      ->add_option("--checkpoint-every", options->run.checkpoint_every,
                   "wall time between checkpoints [s]; there is one at each end of a phase, too")
      ->type_name("SECONDS")
      ->capture_default_str();
  command->add_flag("--no-frames", options->no_frames, "compute without pictures");
  add_threads_option(*command, options->threads, kThreadsOfOneRun);
  command->add_flag("--quiet", options->run.quiet, "print nothing but where the results are");
  add_strict_options(*command, options->strict);
  add_picture_options(*command, options->picture);
  command->footer(
      "DIR receives scene.json, run.json, frames/, film.png (animated, for a browser), film.mp4 "
      "(with\n"
      "ffmpeg), series.csv, summary.json and state.cbor. Ctrl-C ends a run after the present step "
      "with complete "
      "results;\n`quicksand resume DIR` goes on, after a kill or a power cut, too.\n\n"
      "Example:\n"
      "  quicksand run assets/scenes/collapse.json --out out/strong "
      "--set phases[1].force_over_cohesion=3");
  return {command, [options] { return run(*options); }};
}

}  // namespace quicksand
