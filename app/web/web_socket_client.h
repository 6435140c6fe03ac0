// A client of the server, as a browser is one: for measurements and tests.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/whole_file.h"

namespace quicksand {

class WebSocketClient {
 public:
  // Connects to this machine. `headers` are further ones, each with its end of line. Throws std::runtime_error with the
  // first line of the answer where the server refuses.
  WebSocketClient(int port, const std::string& token, const std::string& headers = {});

  // Throw std::runtime_error where the connection has ended.
  void send_text(std::string_view text) { send(kText, text); }
  // That so many pictures were drawn.
  void send_drawn(std::uint32_t pictures);
  // Payload as they are, whatever the protocol says.
  void send_raw(std::string_view bytes);

  struct Message {
    bool binary = false;
    std::string bytes;
  };
  // The next message; nothing after so long, or where the server has closed.
  std::optional<Message> receive(std::chrono::milliseconds patience);
  bool closed() const { return closed_; }
  // The reason that the server gave; 0 if none.
  int close_code() const { return close_code_; }

 private:
  static constexpr std::uint8_t kText = 1, kBinary = 2, kClose = 8, kPing = 9, kPong = 10;

  void send(std::uint8_t kind, std::string_view bytes);
  // Waits for more bytes; false if none came.
  bool fill(std::chrono::steady_clock::time_point end);
  // A frame of the protocol, if all of it is there.
  std::optional<Message> take_frame();

  OpenFile socket_;
  std::string buffer_, message_;
  bool message_is_binary_ = false, closed_ = false;
  int close_code_ = 0;
};

}  // namespace quicksand
