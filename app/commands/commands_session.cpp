// Commands about the session itself: print, include, quit.
#include "app/commands/command_definition.h"

namespace quicksand {

namespace {

constexpr std::string_view kSessionGroup = "Session";

struct Print {
  std::string text;
  void describe(Fields& f) { f.text({"text", "what to say", Presence::required}, text); }
  Json perform(Console& console, const std::string&) {
    if (console.print) console.print(text);
    return {{"text", text}};
  }
};

struct Include {
  std::string file;
  void describe(Fields& f) {
    f.text({"file", "another session file, relative to this one", Presence::required}, file);
  }
  Json perform(Console& console, const std::string& place) {
    console.include(console.beside(file), place + ".file");
    return Json::object();
  }
};

Json quit_session(Console& console) {
  console.quit = true;
  return Json::object();
}

}  // namespace

std::vector<SessionCommand> session_commands_proper() {
  return {define<Print>({"print", kSessionGroup, "Prints a text when the session gets there.",
                         R"({"command": "print", "text": "the packing stands"})"},
                        false),
          define<Include>({"include", kSessionGroup, "Performs the commands of another file.",
                           R"({"command": "include", "file": "prepare.json"})"},
                          false),
          define<Without<quit_session>>(
              {"quit", kSessionGroup, "Ends the session.", R"({"command": "quit"})"}, false)};
}

}  // namespace quicksand
