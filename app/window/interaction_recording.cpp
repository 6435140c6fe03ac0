#include "app/window/interaction_recording.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/run_folder/summary.h"

namespace quicksand {

namespace {

constexpr auto kOfTheWindow =
    std::to_array<std::string_view>({"start", "pause", "pace", "play", "quit"});

std::string_view command_in(const Json& command) {
  return command["command"].get_ref<const std::string&>();
}

}  // namespace

void InteractionRecording::add(const Json& command) {
  const std::string_view name = command_in(command);
  if (std::ranges::find(kOfTheWindow, name) != kOfTheWindow.end()) return;
  // While the mouse moves, only the last force before the next step counts.
  const bool replaces = name == "apply" && !commands_.empty() &&
                        command_in(commands_.back()) == "apply" &&
                        commands_.back()["body"] == command["body"];
  if (replaces) commands_.pop_back();
  commands_.push_back(command);
}

void InteractionRecording::add_steps(std::int64_t steps) {
  if (steps == 0) return;
  const bool goes_on = !commands_.empty() && command_in(commands_.back()) == "run" &&
                       commands_.back().size() == 2 && commands_.back().contains("steps");
  if (goes_on) {
    commands_.back()["steps"] = commands_.back()["steps"].get<std::int64_t>() + steps;
  } else {
    commands_.push_back({{"command", "run"}, {"steps", steps}});
  }
}

Json InteractionRecording::session(const World& world, std::optional<std::size_t> shown) const {
  Json commands = commands_;
  if (shown) commands.push_back({{"command", "show"}, {"sample", *shown}});
  commands.push_back({{"command", "expect_hash"}, {"hash", world_hash_text(world)}});
  return {{"description", "Recorded by hand in a window."}, {"commands", std::move(commands)}};
}

}  // namespace quicksand
