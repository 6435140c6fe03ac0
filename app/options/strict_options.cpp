#include "app/options/strict_options.h"

#include "app/options/number_range.h"

namespace quicksand {

void add_strict_options(CLI::App& command, std::optional<StrictBounds>& bounds) {
  CLI::Option* strict = command.add_flag_callback(
      "--strict", [&bounds] { bounds.emplace(); },
      "exit with 1 if a step did not converge, a bond broke in "
      "such a step, bodies overlapped, or steps gained energy");
  strict->group("Validation");
  command
      .add_option_function<double>(
          "--max-overlap",
          [&bounds](double most) {
            if (bounds) bounds->max_overlap = most;
          },
          "deepest overlap that --strict accepts [d]")
      ->type_name("LENGTH")
      ->check(in_range(between(0, 1, "d")))
      ->default_str(number_text(StrictBounds{}.max_overlap))
      ->needs(strict)
      ->group("Validation");
}

}  // namespace quicksand
