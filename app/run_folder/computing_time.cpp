#include "app/run_folder/computing_time.h"

#include <algorithm>

#include "app/run_folder/summary.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

constexpr const char* kSeconds = "wall_seconds";  // in both files

// A file that is damaged costs a number in a report, and no run.
double seconds_in(const Json& json) {
  if (!json.is_object() || !json.contains(kSeconds) || !json[kSeconds].is_number()) return 0;
  return std::max(0.0, json[kSeconds].get<double>());
}

}  // namespace

double computing_time_of(const RunFolder& folder) {
  if (const Json summary = summary_in(folder); !summary.is_null()) return seconds_in(summary);
  try {
    return seconds_in(read_json(folder.computing_time()));
  } catch (const InputError&) {
    return 0;
  }
}

void keep_computing_time(const RunFolder& folder, double seconds) {
  write_whole(folder.computing_time(), Json{{kSeconds, seconds}}.dump(2) + "\n");
}

void forget_computing_time(const RunFolder& folder) {
  std::error_code ignored;
  std::filesystem::remove(folder.computing_time(), ignored);
}

}  // namespace quicksand
