// What was done by hand, as a session file that replays to the same world.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "app/json/json_text.h"
#include "core/world/world.h"

namespace quicksand {

class InteractionRecording {
 public:
  // A command that succeeded. What only concerns a window, such as start and pause, is left out: the
  // steps themselves are in the recording.
  void add(const Json& command);
  // Steps that were made since the last command, and phases that ended after them without one.
  void add_steps(std::int64_t steps, int phases_ended_after = 0);

  bool empty() const { return last_.is_null(); }
  // From here on nothing is added: so that who commands without end does not take all memory.
  bool full() const { return full_; }
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20U;
  // The text of the session file, a command a line; its last one expects the hash of this world, unless the recording is
  // full and has fallen behind. `shown`: the sample of a run where playing has led to.
  std::string session(const World& world, std::optional<std::size_t> shown = {}) const;

 private:
  void append(Json command);

  std::string earlier_;  // lines of all but the last command
  Json last_;            // null: none
  bool full_ = false;
};

}  // namespace quicksand
