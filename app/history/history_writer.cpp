#include "app/history/history_writer.h"

#include <array>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "app/history/record.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

std::ostream& write(std::ostream& file, std::span<const std::uint8_t> bytes) {
  return file.write(reinterpret_cast<const char*>(bytes.data()),
                    static_cast<std::streamsize>(bytes.size()));
}

bool read(std::istream& file, std::span<std::uint8_t> bytes) {
  return static_cast<bool>(
      file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())));
}

// Reads the stride of a file that is open; nothing if it is no history of this version.
std::optional<std::int64_t> stride_of(std::istream& file) {
  std::array<std::uint8_t, kFileHeadSize> head{};
  if (!read(file, head)) return std::nullopt;
  try {
    return stride_from(head);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

using HeadBytes = std::array<std::uint8_t, kRecordHeadSize>;

// The next head of a file that is open; nothing at its end and where it is damaged.
std::optional<RecordHead> next_head(std::istream& file, HeadBytes& bytes) {
  if (!read(file, bytes)) return std::nullopt;
  return head_from(bytes);
}

}  // namespace

HistoryWriter::HistoryWriter(fs::path path, std::int64_t kept_rows, std::int64_t limit)
    : path_(std::move(path)), limit_(limit) {
  if (kept_rows > 0) keep(kept_rows);
  if (size_ == 0) begin();
  append_from_here();
}

void HistoryWriter::begin() {
  WholeFile file(path_);
  write(file.stream(), file_head(stride_));
  file.finish();
  size_ = kFileHeadSize;
}

// Cuts the file behind the last record that stays. What cannot be read may be good, and stays, too.
void HistoryWriter::keep(std::int64_t rows) {
  std::ifstream file(path_, std::ios::binary);
  const std::optional<std::int64_t> stride = stride_of(file);
  std::error_code error;
  const auto refuse_unreadable = [&] {
    const bool unopened = !file.is_open() && fs::exists(path_, error);
    if (unopened || file.bad()) throw InputError(path_.string(), "cannot be read");
  };
  refuse_unreadable();
  if (!stride) return;
  const auto there = static_cast<std::uint64_t>(fs::file_size(path_, error));
  std::uint64_t end = kFileHeadSize;
  HeadBytes bytes{};
  while (const auto head = next_head(file, bytes)) {
    if (head->moment.row >= rows || head->packed > there - end - kRecordHeadSize) break;
    end += kRecordHeadSize + head->packed;
    file.seekg(static_cast<std::streamoff>(end));
  }
  refuse_unreadable();
  fs::resize_file(path_, end, error);
  if (error) refuse_to_write(path_, error.value());
  stride_ = *stride;
  size_ = static_cast<std::int64_t>(end);
}

void HistoryWriter::append_from_here() {
  file_.open(path_, std::ios::binary | std::ios::app);
  if (!file_) throw InputError(path_.string(), "cannot be written");
}

void HistoryWriter::add(const World& world, std::int64_t row, int phase,
                        std::string_view phase_name) {
  // Before a record and not after it: the extra sample of a run that is interrupted decides nothing.
  while (size_ > limit_ && stride_ <= row) thin_out();
  if (row % stride_ != 0) return;
  const Bytes record = record_of(world, row, phase, phase_name);
  write(file_, record).flush();
  require_written();
  size_ += static_cast<std::int64_t>(record.size());
}

void HistoryWriter::thin_out() {
  stride_ *= 2;
  file_.close();
  std::ifstream all(path_, std::ios::binary);
  const auto refuse_damaged = [&] {
    throw InputError(path_.string(), "was damaged while the run was computing");
  };
  if (!stride_of(all)) refuse_damaged();
  WholeFile fewer(path_);
  write(fewer.stream(), file_head(stride_));
  size_ = kFileHeadSize;
  HeadBytes bytes{};
  Bytes body;
  while (const auto head = next_head(all, bytes)) {
    if (head->moment.row % stride_ != 0) {
      all.seekg(static_cast<std::streamoff>(head->packed), std::ios::cur);
      continue;
    }
    body.resize(head->packed);
    if (!read(all, body)) refuse_damaged();
    write(write(fewer.stream(), bytes), body);
    size_ += static_cast<std::int64_t>(kRecordHeadSize + head->packed);
  }
  if (!all.eof()) refuse_damaged();
  fewer.finish();
  append_from_here();
}

void HistoryWriter::require_written() const {
  if (!file_) throw InputError(path_.string(), "cannot be written; is the disk full?");
}

void HistoryWriter::secure() const { bring_to_disk(path_); }

}  // namespace quicksand
