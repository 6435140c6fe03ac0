// quicksand resume: goes on with a run that did not reach its end, whatever ended it.
#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/run_outcome.h"
#include "app/options/strict_options.h"
#include "app/options/threads_option.h"
#include "app/run/resumption.h"
#include "app/run_folder/folder_lock.h"
#include "app/scene/scene_file.h"
#include "core/base/errors.h"
#include "core/base/parallel.h"
#include "core/checkpoint/checkpoint.h"
#include "core/measures/measures.h"
#include "core/scene/scenario.h"

namespace quicksand {

namespace {

struct ResumeArguments {
  std::string folder;
  bool quiet = false;
  std::int64_t threads = 0;
  std::optional<StrictBounds> strict;
};

void require_run(const RunFolder& folder) {
  for (const auto& file : {folder.scene(), folder.options()})
    if (!is_there(file))
      throw InputError(folder.path.string(),
                       "is not the folder of a run: it has no " + file.filename().string());
  refuse_special_files(folder);
}

int tell_finished(const RunFolder& folder, const RunOptions& options) {
  std::printf("the run in %s is finished\n", folder.path.c_str());
  if (!options.strict) return tell_validation({});
  const Checkpoint end = read_checkpoint(folder.state());
  return tell_validation(validation_failures(end.protocol, measure(end.world), *options.strict));
}

int resume(const ResumeArguments& asked) {
  const RunFolder folder{asked.folder};
  require_run(folder);
  RunOptions options = read_options(folder.options());
  options.out = folder.path;
  options.quiet = asked.quiet;
  options.lock = false;
  if (asked.strict) options.strict = asked.strict;
  const Scenario scenario = read_scene({folder.scene(), {}, {}});
  const FolderLock lock = lock_run(folder.path);
  const Resumption resumption = resumption_of(folder, options.frames);
  switch (resumption.how) {
    case Resumption::How::finished:
      return tell_finished(folder, options);
    case Resumption::How::goes_on:
      options.continued_from = folder.state();
      break;
    case Resumption::How::starts_again:
      if (!asked.quiet)
        std::fprintf(stderr, "the run starts again from its beginning: %s\n",
                     resumption.why.c_str());
      break;
  }
  RunResult result;
  with_threads(thread_count(asked.threads), [&] { result = run_scene(scenario, options); });
  return tell_outcome(result, options);
}

}  // namespace

Command add_resume(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "resume", "Continue a run that was killed, interrupted or ran out of disk space.");
  const auto options = std::make_shared<ResumeArguments>();
  command->add_option("folder", options->folder, "folder of the run")->type_name("DIR")->required();
  add_threads_option(*command, options->threads, kThreadsOfOneRun);
  command->add_flag("--quiet", options->quiet, "print only where the results are");
  add_strict_options(*command, options->strict);
  command->footer(
      "The results are those of an uninterrupted run. Rows and frames after the last checkpoint\n"
      "are computed again; without a usable checkpoint the run starts over.\n\n"
      "Examples:\n"
      "  quicksand resume out/collapse\n"
      "  quicksand resume out/collapse --strict --threads 2");
  return {command, [options] { return resume(*options); }};
}

}  // namespace quicksand
