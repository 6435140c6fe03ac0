// The live connection. A line of garbage gets an answer that says so; a line longer than kLongestLine is
// passed over without being kept.
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>

#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/run/run_folder.h"
#include "app/session/play.h"
#include "app/session/transcript.h"
#include "core/errors.h"

namespace quicksand {

namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20U;  // [bytes]

struct Line {
  std::string text;
  bool too_long = false;
};

// Nothing at the end of the input.
std::optional<Line> read_line() {
  Line line;
  bool any = false;
  for (int c = std::getc(stdin); c != EOF; c = std::getc(stdin)) {
    any = true;
    if (c == '\n') break;
    if (line.text.size() < kLongestLine) {
      line.text.push_back(static_cast<char>(c));
    } else {
      line.too_long = true;
    }
  }
  return any ? std::optional(std::move(line)) : std::nullopt;
}

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
  make_writable(folder);
  const InterruptWatch watch;
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away ends the session, not the program
  Console console({folder.path, std::filesystem::current_path()});
  console.session().stop_asked = [&watch](const Session&) { return watch.interrupted(); };
  while (!console.quit && !watch.interrupted()) {
    const std::optional<Line> line = read_line();
    if (!line) break;
    if (is_blank(line->text) && !line->too_long) continue;
    const std::string text =
        answer(console, *line).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    // Nobody reads any more: the session is over.
    if (std::fputs(text.c_str(), stdout) == EOF || std::fflush(stdout) == EOF) break;
  }
  if (console.recording) console.recording->finish();
  return watch.interrupted() ? kInterrupted : kFine;
}

}  // namespace quicksand
