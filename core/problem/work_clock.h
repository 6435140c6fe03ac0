// Where the time of a computation goes. Each moment of the thread that computes counts for one kind of work, so that
// the parts add up to the whole.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string_view>

namespace quicksand {

enum class Work : std::uint8_t {
  other,  // what has no name of its own
  contact_search,
  assembly,           // of the contact problem
  local_solver,       // all of it
  factorisation,      // of the interior point, with the filling-in of the matrix
  back_substitution,  // with the sums of momenta
  cones,              // what the interior point does contact by contact
  residual,           // with the velocities that impulses give
  sweeps,             // of Gauss-Seidel, relaxation and NSCD
  failure_criterion,  // what is not its solutions
  motion,             // of the bodies, with bonds and the energy balance
  measures,
  drawing,  // what it keeps the computation for: pictures are drawn and packed on other threads
  writing,
  waiting,  // for pictures that are still being drawn and packed, and joined to a film
  kinds
};

inline constexpr std::array<std::string_view, static_cast<std::size_t>(Work::kinds)> kWorkNames{
    "other",         "contact_search",    "assembly", "local_solver",
    "factorisation", "back_substitution", "cones",    "residual",
    "sweeps",        "failure_criterion", "motion",   "measures",
    "drawing",       "writing",           "waiting"};

using WorkSeconds = std::array<double, static_cast<std::size_t>(Work::kinds)>;

// Thrown out of a computation that WorkClock::meanwhile gives up.
struct GivenUp {};

class WorkClock {
 public:
  // From its beginning to its end this work is done, on a clock that may be null.
  class Span {
   public:
    Span(WorkClock* clock, Work work) : clock_(clock), before_(clock ? clock->now_ : work) {
      if (clock_) clock_->turn_to(work);
    }
    ~Span() {
      if (clock_) clock_->turn_to(before_);
    }
    Span(const Span&) = delete;
    Span& operator=(const Span&) = delete;

   private:
    WorkClock* clock_;
    Work before_;
  };

  // Of each kind of work up to now [s].
  WorkSeconds seconds() {
    turn_to(now_);
    return seconds_;
  }

  struct Counts {
    std::int64_t solutions = 0;              // of contact problems
    std::int64_t of_criterion = 0;           // of these, what the energy criterion asked for
    std::array<std::int64_t, 5> by_stage{};  // by SolverStage
    std::int64_t not_converged = 0;
  } counts;

  // Does what need not wait until a long computation ends; true gives the computation up. It must not change what is
  // computed with, nor throw. May be empty.
  std::function<bool()> meanwhile;
  // Where a computation has come to a place at which something else may be done. Throws GivenUp.
  static void look_up(WorkClock* clock) {
    if (!clock || !clock->meanwhile) return;
    const Span span(clock, Work::other);
    if (clock->meanwhile()) throw GivenUp{};
  }

 private:
  using Clock = std::chrono::steady_clock;

  void turn_to(Work work) {
    const Clock::time_point moment = Clock::now();
    seconds_[static_cast<std::size_t>(now_)] +=
        std::chrono::duration<double>(moment - since_).count();
    since_ = moment;
    now_ = work;
  }

  WorkSeconds seconds_{};
  Work now_ = Work::other;
  Clock::time_point since_ = Clock::now();
};

}  // namespace quicksand
