#include "app/web/web_socket_client.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cstring>
#include <stdexcept>

namespace quicksand {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kPatience{20};  // for the answer to the first request

OpenFile connection_to(int port) {
  OpenFile connection(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const int number = connection.number();
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (number < 0 || connect(number, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0)
    throw std::runtime_error(std::string("cannot connect: ") + std::strerror(errno));
  const int on = 1;
  setsockopt(number, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return connection;
}

}  // namespace

WebSocketClient::WebSocketClient(int port, const std::string& token, const std::string& headers)
    : socket_(connection_to(port)) {
  const std::string host = "127.0.0.1:" + std::to_string(port);
  send_raw("GET /live?token=" + token + " HTTP/1.1\r\nHost: " + host +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Protocol: quicksand\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
           headers + "\r\n");
  const auto end = Clock::now() + kPatience;
  std::size_t head = 0;
  while ((head = buffer_.find("\r\n\r\n")) == std::string::npos && fill(end)) {
  }
  const std::string first = buffer_.substr(0, buffer_.find("\r\n"));
  if (!first.starts_with("HTTP/1.1 101"))
    throw std::runtime_error(first.empty() ? "closed without an answer" : first);
  buffer_.erase(0, head + 4);
}

void WebSocketClient::send_raw(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) throw std::runtime_error("the server has closed the connection");
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

// Clients must mask what they send; a mask of zeros is one.
void WebSocketClient::send(std::uint8_t kind, std::string_view bytes) {
  constexpr unsigned kLast = 0x80, kMasked = 0x80, kTwoBytes = 126, kEightBytes = 127;
  std::string frame(1, static_cast<char>(kLast | kind));
  const std::size_t size = bytes.size();
  const auto add = [&](std::size_t value, unsigned count) {
    for (unsigned i = count; i-- > 0;) frame += static_cast<char>(value >> (8 * i) & 0xFFU);
  };
  if (size < kTwoBytes) {
    add(kMasked | size, 1);
  } else if (size < 65536) {
    add(kMasked | kTwoBytes, 1);
    add(size, 2);
  } else {
    add(kMasked | kEightBytes, 1);
    add(size, 8);
  }
  frame.append(4, '\0').append(bytes);
  send_raw(frame);
}

void WebSocketClient::send_drawn(std::uint32_t pictures) {
  std::string bytes(sizeof pictures, '\0');
  std::memcpy(bytes.data(), &pictures, sizeof pictures);
  send(kBinary, bytes);
}

bool WebSocketClient::fill(Clock::time_point end) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
  pollfd ready{.fd = socket_.number(), .events = POLLIN, .revents = 0};
  if (poll(&ready, 1, static_cast<int>(std::max<std::int64_t>(0, left.count()))) <= 0) return false;
  std::array<char, 65536> room{};
  const ssize_t got = recv(socket_.number(), room.data(), room.size(), 0);
  if (got <= 0) {
    closed_ = true;
    return false;
  }
  buffer_.append(room.data(), static_cast<std::size_t>(got));
  return true;
}

std::optional<WebSocketClient::Message> WebSocketClient::take_frame() {
  const auto byte = [this](std::size_t i) { return static_cast<unsigned char>(buffer_[i]); };
  if (buffer_.size() < 2) return std::nullopt;
  std::size_t size = byte(1) & 0x7FU, head = 2;
  const std::size_t more = size == 126 ? 2 : size == 127 ? 8 : 0;
  if (buffer_.size() < head + more) return std::nullopt;
  if (more > 0) size = 0;
  for (std::size_t i = 0; i < more; ++i) size = size << 8U | byte(head + i);
  head += more;
  if (buffer_.size() < head + size) return std::nullopt;
  const bool last = (byte(0) & 0x80U) != 0;
  const unsigned kind = byte(0) & 0x0FU;
  const std::string body = buffer_.substr(head, size);
  buffer_.erase(0, head + size);
  if (kind == kPing) send(kPong, body);
  if (kind == kClose) {
    closed_ = true;
    if (body.size() >= 2)
      close_code_ = static_cast<unsigned char>(body[0]) << 8 | static_cast<unsigned char>(body[1]);
  }
  if (kind >= kClose) return closed_ ? std::nullopt : take_frame();
  if (kind != 0) message_is_binary_ = kind == kBinary;
  message_ += body;
  if (!last) return take_frame();
  Message whole{message_is_binary_, std::move(message_)};
  message_.clear();
  return whole;
}

std::optional<WebSocketClient::Message> WebSocketClient::receive(
    std::chrono::milliseconds patience) {
  const auto end = Clock::now() + patience;
  while (true) {
    if (auto whole = take_frame()) return whole;
    if (closed_ || !fill(end)) return std::nullopt;
  }
}

}  // namespace quicksand
