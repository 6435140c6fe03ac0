// What the server knows of one client: what it has said so far, and what it has not got yet.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <string>
#include <string_view>

#include "app/web/exchange.h"
#include "app/web/server.h"

namespace quicksand {

class Client {
 public:
  Client(ClientId id, const ServerLimits& limits) : id_(id), limits_(limits) {}

  ClientId id() const { return id_; }

  // A piece of a message. A binary one, of four bytes, says which picture was drawn; others are texts.
  // Nothing is heard after a message that is too large or one too many.
  enum class Heard : std::uint8_t { piece, text, seen, refused };
  Heard hear(std::string_view piece, bool binary, bool ends);
  // Why the connection closes, or none.
  enum class Refusal : std::uint8_t { none, too_large, too_many };
  Refusal refusal() const { return refusal_; }
  std::string take_text();

  void answer(std::string text) {
    answer_bytes_ += text.size();
    answers_.push_back(std::move(text));
  }
  // It has asked for much and reads nothing.
  bool is_stuck() const { return answers_.size() > kMostAnswers || answer_bytes_ > kMostBytes; }
  // Whether it may get another picture: it has drawn all but the last.
  bool has_room() const { return frame_ - std::min(seen_, frame_) < kPicturesUnderWay; }
  // The number, among those published, of the picture that it got last.
  std::uint64_t last_frame() const { return sent_[static_cast<std::size_t>(Newest::frame)]; }

  struct Message {
    Payload bytes;  // null: there is nothing to send
    bool binary = false;
  };
  // What it gets next.
  Message next(Exchange& exchange);
  // The bytes with so much room before them, kept for the next time.
  std::string& room_for(const std::string& bytes, std::size_t before);

 private:
  static constexpr std::size_t kMostAnswers = 300;
  // An answer holds the command, so that all that may wait of a client has room in its answers.
  static constexpr std::size_t kMostBytes = 4 * kMostOfOneClient.bytes;
  static constexpr std::uint64_t kPicturesUnderWay = 2;

  bool may_speak();

  ClientId id_;
  ServerLimits limits_;
  std::string said_;  // of the present message
  Refusal refusal_ = Refusal::none;
  std::deque<std::string> answers_;
  std::size_t answer_bytes_ = 0;                    // of those
  std::array<std::uint64_t, kNewestKinds> sent_{};  // numbers of what it got
  std::uint64_t frame_ = 0, seen_ = 0;  // pictures that it got, and has drawn, counted for it
  std::string room_;
  double allowance_ = 0;  // messages that it may send now
  std::chrono::steady_clock::time_point counted_{};
};

}  // namespace quicksand
