#include "app/options/strict_options.h"

#include "app/options/number_range.h"

namespace quicksand {

void add_strict_options(CLI::App& command, StrictOptions& options) {
  CLI::Option* strict = command.add_flag("--strict", options.strict,
                                         "exit with 1 if a step did not converge, a bond broke in "
                                         "such a step, bodies overlapped, or steps gained energy");
  strict->group("Validation");
  command
      .add_option("--max-overlap", options.bounds.max_overlap,
                  "deepest overlap that --strict accepts [d]")
      ->type_name("LENGTH")
      ->check(in_range(between(0, 1, "d")))
      ->capture_default_str()
      ->needs(strict)
      ->group("Validation");
}

std::optional<StrictBounds> strict_from(const StrictOptions& options) {
  return options.strict ? std::optional(options.bounds) : std::nullopt;
}

}  // namespace quicksand
