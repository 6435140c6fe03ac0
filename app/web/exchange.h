// What passes between the thread that serves and the thread that computes. Neither waits for the other: messages of
// clients wait in a bounded queue, and of pictures, states and plots only the newest is kept.
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

class Exchange {
 public:
  // So many messages of a client wait at most: one that floods the queue keeps no other out.
  static constexpr std::ptrdiff_t kMostOfOneClient = 128;

  // Of the serving thread. A message for the computing one; false: too many of this client wait.
  bool give(ClientText message);
  // A client has room for the next picture, after this one.
  void want_frame_after(std::uint64_t number);
  Published newest(Newest kind) const;
  // What is to be told to clients, since the last call.
  std::vector<ClientText> take_answers();

  // Of the computing thread. The messages since the last call; waits at most so long for the first one or, if there is
  // another picture, for a client that takes it.
  std::vector<ClientText> take(std::chrono::milliseconds wait, bool another_picture);
  bool something_waits() const;
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
  std::array<Published, kNewestKinds> newest_;
  bool wanted_ = false;
};

}  // namespace quicksand
