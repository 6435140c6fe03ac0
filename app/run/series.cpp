#include "app/run/series.h"

#include <charconv>

#include "app/run/run_folder.h"
#include "core/errors.h"

namespace quicksand {

namespace {

// Value of a row's `step` column; -1 if the row is cut short.
std::int64_t step_of(const std::string& row) {
  const std::size_t comma = row.find(',');
  if (comma == std::string::npos) return -1;
  std::int64_t step = -1;
  std::from_chars(row.data() + comma + 1, row.data() + row.size(), step);
  return step;
}

}  // namespace

std::string series_header() {
  std::string header;
  for (const Quantity& quantity : quantities()) {
    header += (header.empty() ? "" : ",") + std::string(quantity.name);
  }
  return header;
}

Series::Series(std::filesystem::path path, std::optional<std::int64_t> up_to_step)
    : path_(std::move(path)) {
  std::string text = series_header() + "\n";
  std::ifstream earlier;
  if (up_to_step) earlier.open(path_);
  if (earlier.is_open()) {
    std::string line;
    std::getline(earlier, line);
    if (line + "\n" != text) {
      throw InputError(path_.string(),
                       "has other columns than this version writes; continue the "
                       "run in another folder with --out");
    }
    while (std::getline(earlier, line)) {
      const std::int64_t step = step_of(line);
      if (step < 0 || step > *up_to_step) break;
      text += line + "\n";
      last_step_ = step;
      ++rows_;
    }
    earlier.close();
  }
  write_whole(path_, text);
  file_.open(path_, std::ios::binary | std::ios::app);
  if (!file_) throw InputError(path_.string(), "cannot be written");
}

void Series::add(const Row& row) {
  std::string line;
  for (const Quantity& quantity : quantities()) {
    if (&quantity != quantities().data()) line += ',';
    line += text_of(quantity.get(row));
  }
  file_ << line << '\n' << std::flush;
  if (!file_) throw InputError(path_.string(), "cannot be written; is the disk full?");
  ++rows_;
  last_step_ = row.sample.step;
}

}  // namespace quicksand
