// How far the files of a run have come at a checkpoint. It is kept in the checkpoint, so that a run that goes
// on writes the rows and frames that an unbroken one would have written.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/series/sampled_run.h"

namespace quicksand {

struct RunPosition {
  std::int64_t rows = 0;        // of series.csv, and frames where there are some
  std::uint64_t checksum = 0;   // of these rows; 0: not known, of a state of an earlier version
  std::int64_t first_step = 0;  // step of the world when the run began
  SamplesSoFar samples;
};

std::vector<std::uint8_t> to_bytes(const RunPosition& position);

// Nothing if the bytes are not those of a position.
std::optional<RunPosition> position_from(const std::vector<std::uint8_t>& bytes);

}  // namespace quicksand
