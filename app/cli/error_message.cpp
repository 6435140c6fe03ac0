#include "app/cli/error_message.h"

#include <cstdio>

#include "app/base/exit_code.h"
#include "app/base/status_line.h"
#include "app/json/json_text.h"

namespace quicksand {

namespace {

// {"error": {...}} without what is empty, in a line.
void print_json(const Json& error) {
  Json told = Json::object();
  for (const auto& [key, value] : error.items())
    if (value != "") told[key] = value;
  std::fprintf(stderr, "%s\n",
               Json{{"error", told}}.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
}

std::string indented(const std::string& lines) {
  std::string text = lines.empty() ? "" : "  ";
  for (const char c : lines) text += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return text.empty() ? text : text + "\n";
}

}  // namespace

int tell_error(const InputError& error) {
  const std::string where = error.where().empty() ? "" : error.where() + ": ";
  if (program_listens())
    print_json({{"kind", "input"},
                {"message", error.what()},
                {"where", error.where()},
                {"file", error.file()},
                {"path", error.path()},
                {"nearest", error.nearest()}});
  else
    std::fprintf(stderr, "quicksand: %s%s\n", where.c_str(), error.what());
  return kBadInput;
}

int tell_failed(const FailureMessage& failure) {
  if (program_listens())
    print_json({{"kind", failure.kind},
                {"message", failure.message},
                {"how_to_go_on", failure.how_to_go_on}});
  else
    std::fprintf(stderr, "quicksand: %s\n%s", failure.message.c_str(),
                 indented(failure.how_to_go_on).c_str());
  return kRunFailed;
}

}  // namespace quicksand
