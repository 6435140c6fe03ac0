// A scene that is computed: its protocol, step by step, and a sample whenever one is due.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "app/series/quantities.h"
#include "app/series/sample_times.h"
#include "core/base/errors.h"
#include "core/checkpoint/checkpoint.h"
#include "core/scene/scenario.h"

namespace quicksand {

// Where the samples stand: with a checkpoint of the same moment, all that is needed to sample on as if
// nothing had happened.
struct SamplesSoFar {
  std::int64_t step = -1;   // of the last sample; -1: there is none
  int bodies = 0;           // at the last sample
  std::int64_t healed = 0;  // bonds, at the last sample
  std::string phase;        // that the last step belongs to
  Row last;                 // the last sample; only what it says of steps, and its phase
  Row pending;              // counts since then
};

// What a phase finds when it begins is not what its scene needs: a vane, say, with grains in its way.
class PhaseRefused : public InputError {
 public:
  explicit PhaseRefused(const InputError& error) : InputError(error) {}
};

class SampledRun {
 public:
  // What becomes of a sample.
  using Sink = std::function<void(const Row&, const World&)>;

  // Goes on from `start`, which may be the beginning. `every`: time between samples instead of the
  // scene's [sqrt(d/g)].
  SampledRun(const Scenario& scenario, Checkpoint start, std::optional<double> every, Sink sink);
  // Takes over where the samples stood when `start` was written, before anything is computed.
  void go_on(const SamplesSoFar& samples);
  const SamplesSoFar& samples() const { return samples_; }

  // At most one time step, with a sample before the first one and whenever one is due or a phase ends. Throws
  // PhaseRefused, and what the sink throws.
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
  // Index of the phase that the last step belongs to.
  int phase_index() const { return phase_index_; }
  // The last sample taken.
  const Row& last() const { return samples_.last; }

 private:
  Progress advance_protocol();
  void count(const ProtocolState& before, double time);

  Protocol protocol_;
  std::optional<double> every_;
  Sink sink_;
  SampleTimes times_{0, 1, 0};
  int times_of_ = -1;  // phase that `times_` belongs to
  SamplesSoFar samples_;
  int phase_index_;
};

}  // namespace quicksand
