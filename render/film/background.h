// Work on items, one after the other in the order in which they are given, on a thread of its own.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace quicksand {

template <class Item>
class Background {
 public:
  using Handle = std::function<void(Item)>;

  // `prepare` is called on the thread and gives what handles each item; that is destroyed there, too, so both may
  // hold what belongs to one thread, such as a drawing context. Throws what `prepare` throws.
  // `longest`: so many items may wait.
  Background(std::size_t longest, std::function<Handle()> prepare) : longest_(longest) {
    busy_ = true;
    thread_ = std::thread([this, prepare = std::move(prepare)] { work(prepare); });
    try {
      finish();
    } catch (...) {
      close();
      throw;
    }
  }
  // Handles what waits; errors at this point are lost, so call finish() before.
  ~Background() { close(); }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  // Waits while there are as many as may wait. Throws what an earlier item has thrown; later ones are dropped.
  void add(Item item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return failure_ != nullptr || items_.size() < longest_; });
    rethrow();
    items_.push_back(std::move(item));
    changed_.notify_all();
  }

  // Waits until all are handled. Throws what one of them has thrown.
  void finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return items_.empty() && !busy_; });
    rethrow();
  }

 private:
  void work(const std::function<Handle()>& prepare) {
    Handle handle;
    attempt([&] { handle = prepare(); });
    std::unique_lock lock(mutex_);
    while (true) {
      busy_ = false;
      changed_.notify_all();
      changed_.wait(lock, [this] { return closing_ || !items_.empty(); });
      if (items_.empty()) return;
      Item item = std::move(items_.front());
      items_.pop_front();
      busy_ = true;
      const bool drop = failure_ != nullptr;
      lock.unlock();
      changed_.notify_all();
      if (!drop) attempt([&] { handle(std::move(item)); });
      lock.lock();
    }
  }

  template <class Do>
  void attempt(const Do& once) {
    try {
      once();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

  void close() {
    {
      const std::lock_guard lock(mutex_);
      closing_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  std::size_t longest_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Item> items_;
  std::exception_ptr failure_;  // the first one
  bool busy_ = false;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace quicksand
