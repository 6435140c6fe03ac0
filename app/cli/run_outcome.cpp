#include "app/cli/run_outcome.h"

#include <cstdio>

#include "app/base/exit_code.h"
#include "app/base/shell_text.h"
#include "app/cli/error_message.h"
#include "app/json/json_reader.h"
#include "app/options/picture_options.h"

namespace quicksand {

namespace {

// Goes on with other settings than those that failed, from the beginning where there is no state.
std::string continue_command(const RunFolder& folder, const RunOptions& options) {
  return program_name() + " run " + shell_text(folder.scene()) +
         (is_there(folder.state()) ? " --continue " + shell_text(folder.state())
                                   : std::string(" --overwrite")) +
         " --out " + shell_text(folder.path) +
         (options.every ? " --every " + number_text(*options.every) : "") +
         (options.checkpoint_every != RunOptions{}.checkpoint_every
              ? " --checkpoint-every " + number_text(options.checkpoint_every)
              : "") +
         (options.history_limit != RunOptions{}.history_limit
              ? " --history " + number_text(options.history_limit)
              : "") +
         (options.strict ? " --strict --max-overlap " + number_text(options.strict->max_overlap)
                         : "") +
         (options.frames ? picture_words(options.view) : " --no-frames");
}

// What to look at next.
void tell_next(const RunFolder& folder) {
  const std::string program = program_name();
  for (const auto& film : {folder.film(), folder.animation()})
    if (is_there(film)) {
      std::printf("  film, for a browser:  %s\n", film.c_str());
      break;
    }
  std::printf("  report:               %s report %s\n", program.c_str(),
              shell_text(folder.path).c_str());
  if (is_there(folder.history()))
    std::printf("  timeline:             %s window %s\n", program.c_str(),
                shell_text(folder.path).c_str());
  std::printf("  panel:                %s window %s\n", program.c_str(),
              shell_text(folder.scene()).c_str());
}

int tell_failure(const RunResult& result, const RunOptions& options) {
  const RunEnd& end = result.end;
  const std::string folder = result.folder.path.string();
  const std::string kind = failure_kind(end);
  const std::string so_far = "results so far are in " + folder + "\n";
  const std::string resume = program_name() + " resume " + shell_text(result.folder.path);
  switch (end.cause) {
    case RunEnd::Cause::disk_full:
      return tell_failed({kind, "the run ended early: " + end.failure,
                          "what was written is in " + folder +
                              "\nonce it can be written again, continue with: " + resume});
    case RunEnd::Cause::memory:
      return tell_failed({kind, "the run ended early: " + end.failure,
                          so_far + "where there is more memory, continue with: " + resume});
    case RunEnd::Cause::unexpected:
      return tell_failed({kind, "the run ended early by an unexpected error: " + end.failure,
                          so_far + "continue with: " + resume});
    case RunEnd::Cause::scene:
      return tell_failed({kind, "the run failed: " + end.failure,
                          so_far + "change the scene there, as in: " +
                              continue_command(result.folder, options) + " --set PATH=VALUE"});
    case RunEnd::Cause::step:
      break;
  }
  const auto [what, setting] = other_steps(result.most_halvings);
  return tell_failed(
      {kind, "the run failed: " + end.failure,
       so_far + "continue with" + what + ": " + continue_command(result.folder, options) + setting +
           "\nor, to accept such steps as they are, with --set step.on_unconverged=continue"});
}

}  // namespace

OtherSteps other_steps(int most_halvings) {
  // Beyond, shorter steps are no answer to what does not converge. [1]
  constexpr int kManyHalvings = 16;
  if (most_halvings < kManyHalvings)
    return {"", " --set step.max_halvings=" + std::to_string(kManyHalvings)};
  return {" a larger tolerance, here or as solver_tolerance of the phase",
          " --set solver.tolerance=1e-4"};
}

int tell_validation(const std::string& reasons) {
  if (reasons.empty()) return kFine;
  return tell_failed({"validation", "--strict: validation failed: " + reasons});
}

int tell_outcome(const RunResult& result, const RunOptions& options) {
  const std::string folder = result.folder.path.string();
  const auto steps = static_cast<long long>(result.end.computed_steps);
  if (!options.quiet)
    for (const std::string& note : result.notes) std::fprintf(stderr, "%s\n", note.c_str());
  switch (result.end.how) {
    case RunEnd::How::finished:
      std::printf("%lld steps in %.1f s; results are in %s\n", steps, result.end.last_wall_seconds,
                  folder.c_str());
      if (!options.quiet) tell_next(result.folder);
      return tell_validation(result.invalid);
    case RunEnd::How::interrupted:
      std::printf(
          "interrupted after %lld steps; results so far are in %s\n"
          "  continue with: %s resume %s\n",
          steps, folder.c_str(), program_name().c_str(), shell_text(result.folder.path).c_str());
      return kInterrupted;
    case RunEnd::How::failed:
      return tell_failure(result, options);
  }
  return kRunFailed;
}

}  // namespace quicksand
