// A phase under way. Each kind has its own in a file of its name; what it must remember between steps it keeps in the
// memory of the stage, which checkpoints hold.
#pragma once

#include <memory>

#include "core/protocol/search.h"
#include "core/protocol/stage.h"
#include "core/scene/phases.h"

namespace quicksand {

class RunningPhase {
 public:
  virtual ~RunningPhase() = default;

  virtual SearchKind searches_for() const { return SearchKind::none; }
  // Entered in a state that was read from a file: whether what begin() made is there.
  virtual bool can_go_on(const Stage&) const { return true; }
  virtual void begin(Stage& stage) = 0;
  // Throws InputError where the phase cannot go on from the world as it is.
  virtual void before_step(Stage&) {}
  // The world has been moved on: by a step, or by each part of one that was halved. The forces are those of the part.
  virtual void after_part(Stage&) {}
  virtual bool finished(Stage& stage) = 0;
  virtual void end(Stage&) {}
  // Share that is done, as far as it can be known [0..1].
  virtual double progress(const Stage& stage) const = 0;
  // Just ended: whether it waits for rest and ended at its max_time instead.
  virtual bool missed_rest(const Stage& stage) const = 0;
  // Under way, a person gave it other settings than `before`, its earlier ones.
  virtual void settings_changed(Stage& stage, const Phase& before) = 0;
  // A force that it set at its beginning is to act again, whatever has been put in its place.
  virtual void renew_force(Stage&) {}
};

// What the phases have in common that have these fields among their settings.
template <class Settings>
class RunningPhaseOf : public RunningPhase {
 public:
  explicit RunningPhaseOf(const Settings& settings) : settings_(settings) {}

  double progress(const Stage& stage) const override {
    if constexpr (requires { settings_.trials; }) return search_progress(stage, settings_.trials);
    if constexpr (requires { settings_.max_time; }) return stage.since_start() / settings_.max_time;
    return 1;
  }
  bool missed_rest(const Stage& stage) const override {
    if (searches_for() != SearchKind::none) return false;
    if constexpr (requires { settings_.until_rest; }) {
      if (!settings_.until_rest) return false;
    }
    if constexpr (requires { settings_.rest_time; })
      return stage.lasted(settings_.max_time) &&
             (stage.state.rest_since < 0 ||
              !stage.due(stage.state.rest_since + settings_.rest_time, settings_.rest_time));
    return false;
  }
  void settings_changed(Stage& stage, const Phase&) override {
    if constexpr (requires { settings_.bonding; })
      stage.form_bonds(settings_.bonding, settings_.bonds);
  }

 protected:
  const Settings& settings() const { return settings_; }

 private:
  Settings settings_;
};

std::unique_ptr<RunningPhase> running(const DepositPhase& settings);
std::unique_ptr<RunningPhase> running(const SettlePhase& settings);
std::unique_ptr<RunningPhase> running(const PushPhase& settings);
std::unique_ptr<RunningPhase> running(const PullPhase& settings);
std::unique_ptr<RunningPhase> running(const ShearPhase& settings);
std::unique_ptr<RunningPhase> running(const HealPhase& settings);
std::unique_ptr<RunningPhase> running(const PistonPhase& settings);
std::unique_ptr<RunningPhase> running(const PenetratePhase& settings);
std::unique_ptr<RunningPhase> running(const VanePhase& settings);
std::unique_ptr<RunningPhase> running(const SlidePhase& settings);

inline std::unique_ptr<RunningPhase> running(const Phase& phase) {
  return std::visit([](const auto& settings) { return running(settings); }, phase.kind);
}

}  // namespace quicksand
