// Takes the samples of a run: a row of series.csv and a frame each.
#pragma once

#include <optional>
#include <string>

#include "app/run/film.h"
#include "app/run/series.h"
#include "core/protocols.h"

namespace quicksand {

class Recorder {
 public:
  // `film` may be null: no frames. Both must outlive the recorder.
  Recorder(Series& series, Film* film) : series_(series), film_(film) {}

  // Counts what a step tells, until the next sample; a halved step made several.
  void count(const ProtocolState& before, const Protocol& after);
  // Does nothing if this world was sampled already: nothing moved, no body was added and no bond
  // healed.
  void sample(const World& world, const std::string& phase);

  // The last sample taken.
  const Row& last() const { return row_; }

 private:
  Series& series_;
  Film* film_;
  Row row_;      // the last sample
  Row pending_;  // counts since then
  int bodies_ = 0;
  std::int64_t healed_ = 0;  // bonds
};

}  // namespace quicksand
