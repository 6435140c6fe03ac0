#include "app/window/interaction_recording.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "app/run_folder/summary.h"

namespace quicksand {

namespace {

constexpr auto kOfTheWindow =
    std::to_array<std::string_view>({"start", "pause", "pace", "play", "quit"});

std::string_view command_in(const Json& command) {
  return command["command"].get_ref<const std::string&>();
}

std::string line_of(const Json& command) {
  return "  " + command.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void InteractionRecording::add(const Json& command) {
  const std::string_view name = command_in(command);
  if (full_ || std::ranges::find(kOfTheWindow, name) != kOfTheWindow.end()) return;
  // While the mouse moves, only the last force before the next step counts.
  const bool replaces = name == "apply" && !empty() && command_in(last_) == "apply" &&
                        last_.contains("body") && command.contains("body") &&
                        last_["body"] == command["body"];
  if (replaces) {
    last_.update(command);  // a torque that it leaves as it is stays
  } else {
    append(command);
  }
}

void InteractionRecording::add_steps(std::int64_t steps, int phases_ended_after) {
  if (full_) return;
  const bool goes_on =
      !empty() && command_in(last_) == "run" && last_.size() == 2 && last_.contains("steps");
  if (steps > 0 && goes_on) {
    last_["steps"] = last_["steps"].get<std::int64_t>() + steps;
  } else if (steps > 0) {
    append({{"command", "run"}, {"steps", steps}});
  }
  for (int k = 0; k < phases_ended_after; ++k) append({{"command", "run"}, {"phase_end", true}});
}

void InteractionRecording::append(Json command) {
  std::string line = empty() ? std::string() : line_of(last_) + ",\n";
  full_ = earlier_.size() + line.size() + line_of(command).size() > kMostBytes;
  if (full_) return;
  earlier_ += line;
  last_ = std::move(command);
}

std::string InteractionRecording::session(const World& world,
                                          std::optional<std::size_t> shown) const {
  std::string text = "{\"description\": \"Recorded by hand in a window.\",\n\"commands\": [\n";
  if (full_)
    text =
        "{\"description\": \"Recorded by hand in a window; the end did not fit.\",\n"
        "\"commands\": [\n";
  text += earlier_;
  std::vector<Json> end;
  if (!empty()) end.push_back(last_);
  if (shown && !full_) end.push_back({{"command", "show"}, {"sample", *shown}});
  if (!full_) end.push_back({{"command", "expect_hash"}, {"hash", world_hash_text(world)}});
  for (std::size_t i = 0; i < end.size(); ++i)
    text += line_of(end[i]) + (i + 1 < end.size() ? ",\n" : "\n");
  return text + "]}\n";
}

}  // namespace quicksand
