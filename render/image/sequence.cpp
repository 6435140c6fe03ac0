#include "render/image/sequence.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstdio>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/errors.h"
#include "render/image/png.h"

namespace quicksand {

namespace {

constexpr std::string_view kPrefix = "frame_";
constexpr std::string_view kSuffix = ".png";
constexpr std::size_t kDigits = 6;

// Number of frame_000012.png, -1 for any other name.
std::int64_t frame_number(const std::string& name) {
  if (name.size() < kPrefix.size() + kDigits + kSuffix.size()) return -1;
  if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix)) return -1;
  const std::string digits =
      name.substr(kPrefix.size(), name.size() - kPrefix.size() - kSuffix.size());
  const bool all_digits =
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  return all_digits && digits.size() <= 18 ? std::stoll(digits) : -1;
}

}  // namespace

std::filesystem::path frame_path(const std::filesystem::path& folder, std::int64_t number) {
  std::array<char, 40> name{};
  std::snprintf(name.data(), name.size(), "frame_%06lld.png", static_cast<long long>(number));
  return folder / name.data();
}

std::map<std::int64_t, std::filesystem::path> frame_files(const std::filesystem::path& folder) {
  std::map<std::int64_t, std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::int64_t number = frame_number(entry.path().filename().string());
    if (number >= 0) files.emplace(number, entry.path());
  }
  return files;
}

// The second thread and what it shares with the first.
struct Sequence::Writer {
  static constexpr std::size_t kLongestQueue = 4;  // pictures in memory

  std::filesystem::path folder;
  std::int64_t next = 0;

  std::mutex mutex;
  std::condition_variable changed;
  std::deque<std::pair<std::int64_t, Image>> queue;
  bool busy = false;
  bool closing = false;
  std::exception_ptr failure;
  std::thread thread;

  void work() {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [this] { return closing || !queue.empty(); });
      if (queue.empty()) return;
      const auto [number, image] = std::move(queue.front());
      queue.pop_front();
      busy = true;
      const bool skip = failure != nullptr;
      lock.unlock();
      changed.notify_all();
      std::exception_ptr error;
      try {
        if (!skip) write_png(frame_path(folder, number), image);
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      busy = false;
      if (error && !failure) failure = error;
      changed.notify_all();
    }
  }

  void rethrow() {
    if (failure) std::rethrow_exception(failure);
  }
};

Sequence::Sequence(std::filesystem::path folder, std::int64_t first)
    : writer_(std::make_unique<Writer>()) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw InputError(folder.string(), "cannot be made a folder for frames" +
                                          (error ? ": " + error.message() : std::string()));
  }
  for (const auto& [number, path] : frame_files(folder)) {
    if (number < first) continue;
    std::filesystem::remove(path, error);
    if (error) throw InputError(path.string(), "cannot be replaced: " + error.message());
  }
  writer_->folder = std::move(folder);
  writer_->next = first;
  writer_->thread = std::thread([writer = writer_.get()] { writer->work(); });
}

Sequence::~Sequence() {
  {
    const std::lock_guard lock(writer_->mutex);
    writer_->closing = true;
  }
  writer_->changed.notify_all();
  writer_->thread.join();
}

void Sequence::add(Image image) {
  {
    std::unique_lock lock(writer_->mutex);
    writer_->changed.wait(lock, [this] {
      return writer_->failure != nullptr || writer_->queue.size() < Writer::kLongestQueue;
    });
    writer_->rethrow();
    writer_->queue.emplace_back(writer_->next++, std::move(image));
  }
  writer_->changed.notify_all();
}

void Sequence::finish() {
  std::unique_lock lock(writer_->mutex);
  writer_->changed.wait(lock, [this] { return writer_->queue.empty() && !writer_->busy; });
  writer_->rethrow();
}

std::int64_t Sequence::next() const { return writer_->next; }

std::filesystem::path Sequence::folder() const { return writer_->folder; }

}  // namespace quicksand
