// One request to a server of this machine, as bytes.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <string>

namespace quicksand::test {

// All that comes back until the server closes, or until nothing has come for so long [s].
inline std::string exchange_bytes(int port, const std::string& bytes, int patience = 20) {
  const int number = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const timeval wait{.tv_sec = patience, .tv_usec = 0};
  setsockopt(number, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
  std::string answer;
  if (connect(number, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
      ::send(number, bytes.data(), bytes.size(), MSG_NOSIGNAL) >= 0) {
    std::array<char, 65536> room{};
    for (ssize_t got = 0; (got = recv(number, room.data(), room.size(), 0)) > 0;)
      answer.append(room.data(), static_cast<std::size_t>(got));
  }
  close(number);
  return answer;
}

// The answer to GET, with its head.
inline std::string http_get(int port, const std::string& path, const std::string& headers = {},
                            const std::string& method = "GET") {
  return exchange_bytes(port, method + " " + path +
                                  " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
                                  "\r\nConnection: close\r\n" + headers + "\r\n");
}

}  // namespace quicksand::test
