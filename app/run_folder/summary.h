// summary.json: the final values of a run under the names of series.csv, and how it was computed.
#pragma once

#include <cstdint>
#include <string>

#include "app/json/json_text.h"
#include "app/run_folder/run_folder.h"
#include "app/series/quantities.h"
#include "core/problem/work_clock.h"
#include "core/protocol/protocol.h"
#include "core/scene/scenario.h"

namespace quicksand {

struct RunEnd {
  enum class How : std::uint8_t { finished, interrupted, failed };
  enum class Cause : std::uint8_t {
    step,        // did not converge
    scene,       // a phase refused what it found
    disk_full,   // results could not be written
    memory,      // there was not enough
    unexpected,  // such as an OpenGL that can no longer draw
  };
  How how = How::finished;
  std::string failure;              // a sentence, if failed
  Cause cause = Cause::step;        // if failed
  bool missed_rest = false;         // the last phase ended at its max_time instead
  std::int64_t steps = 0;           // of this run, before it was interrupted too
  std::int64_t computed_steps = 0;  // of its last part, since it was last resumed
  double wall_seconds = 0;          // of all its parts, pictures included
  double last_wall_seconds = 0;     // of its last part
  WorkSeconds work{};               // where these went
  WorkClock::Counts work_counts{};  // of that part
};

// The cause of a failure as messages and summary.json name it: "run_failed" where it is a step, else the name above.
std::string failure_kind(const RunEnd& end);

// The value as JSON; null if there is none.
Json json_of(const Value& value);

std::string world_hash_text(const World& world);  // 16 hexadecimal digits

Json summary(const Scenario& scenario, const World& world, const ProtocolState& state,
             const Row& last, const RunEnd& end);

// That of a folder. Null if there is none or it is not whole: then there are no results that count.
Json summary_in(const RunFolder& folder);
// Whether it says that the run has finished: the summary is the last that a run writes.
bool has_finished(const RunFolder& folder);

// How long a run has computed, all its parts together [s]: as its summary says, or up to its last checkpoint; 0 if
// neither is there. Until there is a summary this is kept in a file of its own, as the bytes of a state are those of a run
// that was never interrupted.
double computing_time_of(const RunFolder& folder);
// Throws InputError if it cannot be written.
void keep_computing_time(const RunFolder& folder, double seconds);
// Once the summary has it.
void forget_computing_time(const RunFolder& folder);

}  // namespace quicksand
