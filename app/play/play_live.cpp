// The live connection. A line of garbage gets an answer that says so; a line longer than kLongestLine is
// passed over without being kept.
#include <poll.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>

#include "app/base/exit_code.h"
#include "app/base/interrupt.h"
#include "app/commands/transcript.h"
#include "app/play/play.h"
#include "app/run_folder/folder_lock.h"
#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20U;  // [bytes]

struct Line {
  std::string text;
  bool too_long = false;
};

// Lines of standard input. Waits for them in a way that Ctrl-C ends at once.
class Input {
 public:
  explicit Input(const InterruptWatch& watch) : watch_(watch) {}

  // Nothing at the end of the input, or when it was interrupted.
  std::optional<Line> next() {
    Line line;
    bool any = false;
    while (at_ < filled_ || fill()) {
      any = true;
      const char c = buffer_[at_++];
      if (c == '\n') return line;
      if (line.text.size() < kLongestLine) {
        line.text.push_back(c);
      } else {
        line.too_long = true;
      }
    }
    return any ? std::optional(std::move(line)) : std::nullopt;
  }

 private:
  bool fill() {
    // What comes without end never waits.
    if (watch_.interrupted()) return false;
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (poll(&input, 1, -1) < 0) return false;
    const ssize_t got = read(STDIN_FILENO, buffer_.data(), buffer_.size());
    at_ = 0;
    filled_ = got > 0 ? static_cast<std::size_t>(got) : 0;
    return got > 0;
  }

  const InterruptWatch& watch_;
  std::array<char, 65536> buffer_{};
  std::size_t at_ = 0, filled_ = 0;
};

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t\r") == std::string::npos;
}

Json answer(Console& console, const Line& line) {
  Answer malformed;
  malformed.malformed = true;
  Json command;
  try {
    if (line.too_long)
      throw InputError("", "is longer than " + std::to_string(kLongestLine) + " bytes");
    command = parse_json(line.text);
  } catch (const InputError& error) {
    malformed.where = "line";
    malformed.problem = error.what();
    return to_json(malformed, console);
  }
  // Who sends many commands at once can tell the answers apart by an id of his own.
  Json id;
  if (command.is_object() && command.contains("id")) {
    id = command["id"];
    command.erase("id");
  }
  Json json = to_json(answer_to(console, command, "command"), console);
  if (!id.is_null()) json["id"] = id;
  return json;
}

}  // namespace

int play_live(const std::filesystem::path& out) {
  const RunFolder folder{out.empty() ? std::filesystem::path("out") / "live" : out};
  const FolderLock lock = lock_run(folder.path);
  const InterruptWatch watch;
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away ends the session, not the program
  Console console({folder.path, std::filesystem::current_path()});
  console.session().stop_asked = [&watch](const Session&) { return watch.interrupted(); };
  console.session().meanwhile = [&watch] { return watch.interrupted(); };
  Input input(watch);
  while (!console.quit && !watch.interrupted()) {
    const std::optional<Line> line = input.next();
    if (!line || watch.interrupted()) break;
    if (is_blank(line->text) && !line->too_long) continue;
    const std::string text =
        answer(console, *line).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    // Nobody reads any more: the session is over.
    if (std::fputs(text.c_str(), stdout) == EOF || std::fflush(stdout) == EOF) break;
  }
  if (watch.interrupted()) {
    std::fprintf(stderr, "interrupted%s\n", console.save_cut_short().c_str());
    return kInterrupted;
  }
  console.finish_recording();
  return kFine;
}

}  // namespace quicksand
