#include "app/history/history.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/errors.h"
#include "core/base/memory.h"

namespace quicksand {

namespace {

// As many bytes as are there, up to the size of the buffer.
std::size_t read_at(int file, std::uint64_t offset, std::span<std::uint8_t> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got =
        pread(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

std::uint64_t size_of(int file) {
  struct stat status {};
  return fstat(file, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

}  // namespace

History::History(std::filesystem::path path)
    : path_(std::move(path)), file_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (file_.number() < 0)
    throw InputError(path_.string(), "cannot be read: " + std::string(strerror(errno)));
  scan();
}

void History::fail(std::uint64_t offset, const std::string& problem) const {
  throw InputError(path_.string(), "byte " + std::to_string(offset) + ": " + problem);
}

void History::scan() {
  const std::uint64_t size = size_of(file_.number());
  if (end_ == 0) {
    std::array<std::uint8_t, kFileHeadSize> head{};
    if (read_at(file_.number(), 0, head) < head.size())
      throw InputError(path_.string(), "is not the history of a run: it is too short");
    try {
      stride_from(head);
    } catch (const std::runtime_error& problem) {
      throw InputError(path_.string(), problem.what());
    }
    end_ = kFileHeadSize;
  }
  std::array<std::uint8_t, kRecordHeadSize> bytes{};
  while (size - end_ >= kRecordHeadSize && read_at(file_.number(), end_, bytes) == bytes.size()) {
    const auto head = head_from(bytes);
    if (!head) fail(end_, "no record begins here; the file is damaged");
    const Moment& moment = head->moment;
    if (!moments_.empty() &&
        !(moment.row > moments_.back().row && moment.time >= moments_.back().time))
      fail(end_, "the record is not later than the one before it");
    if (head->packed > size - end_ - kRecordHeadSize) break;
    places_.push_back({end_, *head});
    moments_.push_back(moment);
    end_ += kRecordHeadSize + head->packed;
  }
}

// Whether the file at this path is no longer what was read of it: a resumed run cuts it short, a long one puts another
// in its place.
bool History::replaced() const {
  struct stat now {
  }, then{};
  if (stat(path_.c_str(), &now) != 0 || fstat(file_.number(), &then) != 0) return true;
  if (now.st_ino != then.st_ino || now.st_dev != then.st_dev) return true;
  if (size_of(file_.number()) < end_) return true;
  if (places_.empty()) return false;
  std::array<std::uint8_t, kRecordHeadSize> bytes{};
  return read_at(file_.number(), places_.back().offset, bytes) < bytes.size() ||
         head_from(bytes) != places_.back().head;
}

bool History::ends_within_record() const { return size_of(file_.number()) > end_; }

bool History::refresh() {
  if (replaced()) {
    History now(path_);
    if (now.moments_.empty()) return false;
    now.replacements_ = replacements_ + 1;
    *this = std::move(now);
    return true;
  }
  const std::size_t before = moments_.size();
  scan();
  return moments_.size() != before;
}

std::size_t History::nearest(double time) const {
  const auto later = std::ranges::upper_bound(moments_, time, {}, &Moment::time);
  const auto at = static_cast<std::size_t>(later - moments_.begin());
  if (later == moments_.end()) return at - 1;
  const double after = later->time;
  if (at > 0 && time - moments_[at - 1].time <= after - time) return at - 1;
  const auto end = std::ranges::upper_bound(moments_, after, {}, &Moment::time);
  return static_cast<std::size_t>(end - moments_.begin()) - 1;
}

World History::world(std::size_t k) const {
  const Place& place = places_[k];
  const std::uint64_t start = place.offset + kRecordHeadSize;
  // The head may be of another file since, but never asks for more than there is.
  const std::uint64_t size = size_of(file_.number());
  if (start > size || place.head.packed > size - start)
    fail(place.offset, "the record no longer exists; the run was resumed in the meantime");
  Bytes bytes(place.head.packed);
  if (read_at(file_.number(), start, bytes) < bytes.size()) fail(place.offset, "cannot be read");
  try {
    return world_from_record(place.head, bytes);
  } catch (const NotEnoughMemory& problem) {
    throw NotEnoughMemory(path_.string() + ": " + problem.what());
  } catch (const std::bad_alloc&) {
    throw NotEnoughMemory(path_.string() + ": there is not enough memory to read it");
  } catch (const std::runtime_error& problem) {
    fail(place.offset, std::string("the record is damaged: ") + problem.what());
  }
}

}  // namespace quicksand
