#include "app/options/strict_options.h"

#include "app/json/json_reader.h"
#include "core/base/errors.h"

namespace quicksand {

void add_strict_options(CLI::App& command, StrictOptions& options) {
  CLI::Option* strict = command.add_flag(
      "--strict", options.strict,
      "exit with 1 if a step did not converge, a bond broke in such a step, bodies overlapped, or "
      "steps gained energy");
  command
      .add_option("--max-overlap", options.max_overlap, "deepest overlap that --strict accepts [d]")
      ->type_name("LENGTH")
      ->capture_default_str()
      ->needs(strict);
}

std::optional<StrictBounds> strict_from(const StrictOptions& options) {
  if (!options.strict) return std::nullopt;
  if (!(options.max_overlap >= 0 && options.max_overlap <= 1))
    throw InputError("--max-overlap " + number_text(options.max_overlap),
                     "must be a length from 0 to 1 d");
  return StrictBounds{options.max_overlap};
}

}  // namespace quicksand
