// A client of `serve` that measures.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "app/json/json_text.h"
#include "app/web/web_socket_client.h"

namespace quicksand::bench {

// A client that draws at once and counts.
class Viewer {
 public:
  using Clock = std::chrono::steady_clock;
  using milliseconds = std::chrono::milliseconds;

  Viewer(int port, const std::string& token) : client_(port, token) {}

  // The next picture, if it comes in time: its head.
  std::optional<std::string> picture(milliseconds patience) {
    const auto end = Clock::now() + patience;
    while (Clock::now() < end) {
      const auto message =
          client_.receive(std::chrono::duration_cast<milliseconds>(end - Clock::now()));
      if (!message || !message->binary) continue;
      std::string head = message->bytes.substr(sizeof(std::uint32_t), 4096);
      if (head.find("\"frame\"") > 100) continue;
      client_.send_drawn(++pictures_);
      bytes_ += message->bytes.size();
      return head;
    }
    return std::nullopt;
  }
  void say(const Json& command) { client_.send_text(command.dump()); }
  std::uint32_t pictures() const { return pictures_; }
  std::size_t bytes() const { return bytes_; }

 private:
  WebSocketClient client_;
  std::uint32_t pictures_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace quicksand::bench
