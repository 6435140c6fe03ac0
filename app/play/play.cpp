#include "app/play/play.h"

#include <cstdio>

#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/base/shell_text.h"
#include "app/commands/session_file.h"
#include "app/commands/transcript.h"
#include "app/run/progress_line.h"
#include "app/run_folder/folder_lock.h"
#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

class PlayedFile {
 public:
  PlayedFile(const PlayOptions& options, SessionFile file)
      : options_(options),
        file_(std::move(file)),
        folder_{options.out.empty() ? fs::path("out") / file_.name : options.out},
        lock_(lock_run(folder_.path)),
        console_({folder_.path, fs::absolute(options.file).parent_path()}),
        transcript_(folder_.path / kTranscript) {
    console_.print = [this](const std::string& text) {
      progress_.end();
      std::printf("%s\n", text.c_str());
      std::fflush(stdout);
    };
    console_.session().stop_asked = [this](const Session& session) {
      progress_.show(session.protocol());
      return watch_.interrupted();
    };
    console_.session().meanwhile = [this] { return watch_.interrupted(); };
  }

  int complete() {
    for (std::size_t i = 0; i < file_.commands.size() && !console_.quit; ++i) {
      if (options_.stop_after && static_cast<int>(i) >= *options_.stop_after) break;
      if (watch_.interrupted()) return interrupted(i);
      const Answer answer = perform(i);
      if (watch_.interrupted()) return interrupted(i + 1);
      if (answer.ok) continue;
      ++failures_;
      complain(i, answer);
      if (!options_.keep_going) break;
    }
    console_.finish_recording();
    progress_.end();
    std::fprintf(stderr, "%zu of %zu commands%s; transcript and files are in %s\n", performed_,
                 file_.commands.size(),
                 failures_ > 0 ? (", " + std::to_string(failures_) + " failed").c_str() : "",
                 folder_.path.string().c_str());
    return failures_ > 0 ? kRunFailed : kFine;
  }

 private:
  Answer perform(std::size_t i) {
    const Json& command = file_.commands[i];
    Answer answer = answer_to(console_, command, place_of(i));
    ++performed_;
    Json line = {{"n", i + 1}};
    if (i < file_.lines.size()) line["line"] = file_.lines[i];
    line["command"] = command;
    line.update(to_json(answer, console_));
    line["seconds"] = answer.seconds;
    transcript_.add(line);
    return answer;
  }

  void complain(std::size_t i, const Answer& answer) const {
    progress_.end();
    const std::string inside = answer.where.empty() ? "" : ": " + answer.where;
    std::fprintf(stderr, "quicksand: %s%s: %s\n  the command: %s\n", file_.where(i).c_str(),
                 inside.c_str(), answer.problem.c_str(), file_.commands[i].dump().c_str());
    if (options_.keep_going) return;
    std::fprintf(stderr, "  to stop before it: %s session %s --stop-after %zu\n",
                 program_name().c_str(), shell_text(options_.file).c_str(), i);
  }

  // Saves what was computed.
  int interrupted(std::size_t done) {
    progress_.end();
    const std::string saved = console_.save_cut_short();
    std::fprintf(stderr, "interrupted after %zu of %zu commands%s\n", done, file_.commands.size(),
                 saved.c_str());
    return kInterrupted;
  }

  InterruptWatch watch_;
  const PlayOptions& options_;
  SessionFile file_;
  RunFolder folder_;
  FolderLock lock_;
  Console console_;
  Transcript transcript_;
  mutable ProgressLine progress_{StatusLine::style_of_stderr(options_.quiet)};
  std::size_t performed_ = 0;
  int failures_ = 0;
};

}  // namespace

int play_session(const PlayOptions& options) {
  return PlayedFile(options, read_session_file(options.file)).complete();
}

}  // namespace quicksand
