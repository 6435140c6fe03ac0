// The course of a scene: its protocol, step by step, and a sample whenever one is due.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/run/quantities.h"
#include "app/run/sample_times.h"
#include "core/checkpoint.h"

namespace quicksand {

class Course {
 public:
  // What becomes of a sample.
  using Sink = std::function<void(const Row&, const World&)>;

  // Goes on from `start`, which may be the beginning. `every`: time between samples instead of the
  // scene's [sqrt(d/g)].
  Course(const Scenario& scenario, Checkpoint start, std::optional<double> every, Sink sink);

  // At most one time step, with a sample before the first one and whenever one is due or a phase ends.
  Progress advance();
  // Samples the present world, unless it was sampled already: nothing moved, no body was added and no
  // bond healed.
  void sample();

  // Time between samples from now on; that of the scene if absent [sqrt(d/g)].
  void sample_every(std::optional<double> every);

  const Protocol& protocol() const { return protocol_; }
  Protocol& protocol() { return protocol_; }
  const World& world() const { return protocol_.world(); }
  std::string phase_name() const;  // of the present phase; "end" after the last
  // The last sample taken.
  const Row& last() const { return row_; }

 private:
  void count(const ProtocolState& before);

  Protocol protocol_;
  std::optional<double> every_;
  Sink sink_;
  std::string phase_;  // that the last step belongs to
  SampleTimes times_{0, 1, 0};
  int times_of_ = -1;  // phase that `times_` belongs to
  Row row_;            // the last sample
  Row pending_;        // counts since then
  int bodies_ = 0;
  std::int64_t healed_ = 0;  // bonds
};

}  // namespace quicksand
