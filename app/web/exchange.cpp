#include "app/web/exchange.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace quicksand {

namespace {
std::size_t index_of(Newest kind) { return static_cast<std::size_t>(kind); }
}  // namespace

bool Exchange::give(ClientText message) {
  {
    const std::lock_guard lock(mutex_);
    if (!has_room(waiting_, message)) return false;
    waiting_.push_back(std::move(message));
  }
  arrived_.notify_one();
  return true;
}

void Exchange::forget(ClientId client) {
  const std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [client](const ClientText& text) { return text.client == client; });
  gone_.push_back(client);
}

void Exchange::want_frame_after(std::uint64_t number) {
  {
    const std::lock_guard lock(mutex_);
    if (number < newest_[index_of(Newest::frame)].number) return;  // there is one already
    wanted_ = true;
  }
  arrived_.notify_one();
}

Published Exchange::newest(Newest kind) const {
  const std::lock_guard lock(mutex_);
  return newest_[index_of(kind)];
}

std::vector<ClientText> Exchange::take_answers() {
  const std::lock_guard lock(mutex_);
  return std::exchange(answers_, {});
}

std::vector<ClientText> Exchange::take(std::chrono::milliseconds wait, bool another_picture) {
  std::unique_lock lock(mutex_);
  if (wait.count() > 0)
    arrived_.wait_for(lock, wait,
                      [&] { return !waiting_.empty() || (another_picture && wanted_); });
  std::vector<ClientText> messages(std::make_move_iterator(waiting_.begin()),
                                   std::make_move_iterator(waiting_.end()));
  waiting_.clear();
  return messages;
}

bool Exchange::something_waits() const {
  const std::lock_guard lock(mutex_);
  return !waiting_.empty() || !gone_.empty();
}

std::vector<ClientId> Exchange::take_gone() {
  const std::lock_guard lock(mutex_);
  return std::exchange(gone_, {});
}

bool Exchange::frame_wanted() const {
  const std::lock_guard lock(mutex_);
  return wanted_;
}

void Exchange::publish(Newest kind, std::string bytes) {
  auto kept = std::make_shared<const std::string>(std::move(bytes));
  {
    const std::lock_guard lock(mutex_);
    Published& newest = newest_[index_of(kind)];
    newest.bytes = std::move(kept);
    ++newest.number;
    if (kind == Newest::frame) wanted_ = false;
  }
  if (wake_server) wake_server();
}

void Exchange::answer(ClientId client, std::string text) {
  {
    const std::lock_guard lock(mutex_);
    answers_.push_back({client, std::move(text)});
  }
  if (wake_server) wake_server();
}

}  // namespace quicksand
