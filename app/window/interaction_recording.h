// What was done by hand, as a session file that replays to the same world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/json/json_text.h"
#include "core/world/world.h"

namespace quicksand {

class InteractionRecording {
 public:
  // A command that succeeded. What only concerns a window, such as start and pause, is left out: the
  // steps themselves are in the recording.
  void add(const Json& command);
  // Steps that were made since the last command.
  void add_steps(std::int64_t steps);

  bool empty() const { return commands_.empty(); }
  // The session file; its last command expects the hash of this world. `shown`: the sample of a run where playing has
  // led to.
  Json session(const World& world, std::optional<std::size_t> shown = {}) const;

 private:
  std::vector<Json> commands_;
};

}  // namespace quicksand
