// What passes between the thread that serves and the thread that computes. Neither waits for the other: messages of
// clients wait in a queue that is bounded in all, and of pictures, states and plots only the newest is kept.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace quicksand {

using ClientId = std::uint64_t;
constexpr ClientId kEveryClient = 0;

struct ClientText {
  ClientId client = kEveryClient;
  std::string text;
};

// Of which clients get the newest, whenever they have room.
enum class Newest : std::uint8_t { frame, state, plots };
constexpr std::size_t kNewestKinds = 3;

// Bytes that are not changed any more.
using Payload = std::shared_ptr<const std::string>;

struct Published {
  Payload bytes;
  std::uint64_t number = 0;  // counts what was published; 0: nothing yet
};

// How many messages may wait at once, and how large they may be together.
struct WaitingLimits {
  std::size_t messages, bytes;
};
// So much of a client: one that floods a queue keeps no other out.
constexpr WaitingLimits kMostOfOneClient{.messages = 128, .bytes = std::size_t{2} << 20U};
// So much in all: eight clients have room.
constexpr WaitingLimits kMostOfAll{.messages = 8 * kMostOfOneClient.messages,
                                   .bytes = 8 * kMostOfOneClient.bytes};

// Whether one more message may wait beside those that do; `text_of` finds the ClientText of each.
template <class Queue, class TextOf = std::identity>
bool has_room(const Queue& queue, const ClientText& more, TextOf text_of = {}) {
  WaitingLimits own{1, more.text.size()}, all = own;
  for (const auto& waiting : queue) {
    const ClientText& text = std::invoke(text_of, waiting);
    ++all.messages;
    all.bytes += text.text.size();
    if (text.client != more.client) continue;
    ++own.messages;
    own.bytes += text.text.size();
  }
  return own.messages <= kMostOfOneClient.messages && own.bytes <= kMostOfOneClient.bytes &&
         all.messages <= kMostOfAll.messages && all.bytes <= kMostOfAll.bytes;
}

class Exchange {
 public:
  // Of the serving thread. A message for the computing one; false: too much waits.
  bool give(ClientText message);
  // A client has gone: what it had waiting is dropped, here and by the computing thread, so that one that comes again and
  // again leaves nothing behind.
  void forget(ClientId client);
  // A client has room for the next picture, after this one.
  void want_frame_after(std::uint64_t number);
  Published newest(Newest kind) const;
  // What is to be told to clients, since the last call.
  std::vector<ClientText> take_answers();

  // Of the computing thread. The messages since the last call; waits at most so long for the first one or, if there is
  // another picture, for a client that takes it.
  std::vector<ClientText> take(std::chrono::milliseconds wait, bool another_picture);
  bool something_waits() const;
  // Those who have gone since the last call. To be asked after take(), which returns nothing of theirs later.
  std::vector<ClientId> take_gone();
  // Whether some client would take a picture now.
  bool frame_wanted() const;
  void publish(Newest kind, std::string bytes);
  void answer(ClientId client, std::string text);
  // Told, in the computing thread, that there is something to serve. To be set before the threads meet.
  std::function<void()> wake_server;

 private:
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<ClientText> waiting_;
  std::vector<ClientText> answers_;
  std::vector<ClientId> gone_;
  std::array<Published, kNewestKinds> newest_;
  bool wanted_ = false;
};

}  // namespace quicksand
