// Which moments of a run's history a command is about.
#pragma once

#include <cstddef>
#include <optional>

#include "app/history/history.h"
#include "app/options/cli_app.h"

namespace quicksand {

struct MomentOptions {
  std::optional<double> from, to;  // [sqrt(d/g)]
  bool given() const { return from || to; }
};
// `--from TIME` and `--to TIME`.
void add_moment_options(CLI::App& command, MomentOptions& options);

// Number of the moment nearest to the time that an option gives. Throws InputError if the run has not been there.
std::size_t moment_at(const History& history, const char* option, double time);

// Numbers of the first moment and of that behind the last one; all if nothing is given. Throws InputError if there are
// none.
struct Moments {
  std::size_t first = 0, end = 0;
  std::size_t size() const { return end - first; }
};
Moments moments_between(const History& history, const MomentOptions& options);

}  // namespace quicksand
