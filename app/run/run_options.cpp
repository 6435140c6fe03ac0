#include "app/run/run_options.h"

#include "app/json/json_reader.h"
#include "app/json/json_writer.h"
#include "app/view/view_fields.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

void describe_strict(Fields& f, StrictBounds& strict) {
  f.number({"max_overlap", "deepest overlap accepted"}, between(0, 1, "d"), strict.max_overlap);
}

void describe(Fields& f, RunOptions& options) {
  f.number({"every", "time between samples, instead of the scene's"},
           above(0, kLongestSampleTime, "sqrt(d/g)"), options.every);
  f.flag({"frames", "whether pictures are drawn"}, options.frames);
  f.number(
      {"history", "size of history.qsh above which every second sample is dropped; 0: no history"},
      between(0, kLargestHistory, "MB"), options.history_limit);
  f.number({"checkpoint_every", "wall time between checkpoints"},
           between(0, kLongestCheckpointTime, "s"), options.checkpoint_every);
  f.optional_object({"strict", "bounds of the validation"}, options.strict, describe_strict);
  f.object({"view", "how pictures look"},
           [&](Fields& inner) { describe_view_of_run(inner, options.view); });
}

}  // namespace

void write_options(const std::filesystem::path& file, const RunOptions& options) {
  const auto visit = [](Fields& f, RunOptions& all) { describe(f, all); };
  write_whole(file, written_fields(options, visit).dump(2) + "\n");
}

RunOptions read_options(const std::filesystem::path& file) {
  RunOptions options;
  in_file(file, [&] {
    read_fields(read_json(file), "the options of a run", [&](Fields& f) { describe(f, options); });
  });
  return options;
}

}  // namespace quicksand
