#include "app/series/series.h"

#include "core/base/errors.h"
#include "core/base/fnv.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

// The header and up to `most` rows after it, each with its end of line; a row without is cut short.
// Empty if the header is another one.
std::string whole_lines(const std::filesystem::path& path, std::int64_t most, std::int64_t& rows) {
  rows = 0;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  std::string text = series_header() + "\n";
  if (!std::getline(file, line) || line + "\n" != text) return {};
  while (rows < most && std::getline(file, line) && !file.eof()) {
    text += line + "\n";
    ++rows;
  }
  return text;
}

std::uint64_t checksum_of(std::string_view text, std::uint64_t before = kFnvStart) {
  for (const char c : text) before = fnv1a(before, static_cast<unsigned char>(c));
  return before;
}

}  // namespace

std::string series_header() { return joined(quantities(), ",", &Quantity::name); }

bool has_rows(const std::filesystem::path& path, std::int64_t rows, std::uint64_t checksum) {
  std::int64_t found = 0;
  const std::string text = whole_lines(path, rows, found);
  return found == rows && (checksum == 0 || checksum_of(text) == checksum);
}

Series::Series(std::filesystem::path path, std::int64_t kept_rows) : path_(std::move(path)) {
  std::string text = series_header() + "\n";
  if (kept_rows > 0) {
    text = whole_lines(path_, kept_rows, rows_);
    if (rows_ < kept_rows)
      throw InputError(path_.string(),
                       "has other columns or fewer rows than the run to be continued; continue it "
                       "in another folder with --out");
  }
  checksum_ = checksum_of(text);
  write_whole(path_, text);
  file_.open(path_, std::ios::binary | std::ios::app);
  if (!file_) throw InputError(path_.string(), "cannot be written");
}

void Series::add(const Values& row) {
  const std::string line = joined(row, ",", text_of) + "\n";
  file_ << line << std::flush;
  if (!file_) throw InputError(path_.string(), "cannot be written; is the disk full?");
  ++rows_;
  checksum_ = checksum_of(line, checksum_);
}

}  // namespace quicksand
