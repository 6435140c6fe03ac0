// One request to a server of this machine, as bytes.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>

#include <array>
#include <string>

#include "core/base/whole_file.h"

namespace quicksand::test {

// A connection to a server of this machine from one of its own addresses, 127.x.y.z.
inline OpenFile connection_from(const char* own, int port) {
  OpenFile connection(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  inet_pton(AF_INET, own, &address.sin_addr);
  bind(connection.number(), reinterpret_cast<sockaddr*>(&address), sizeof address);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  connect(connection.number(), reinterpret_cast<sockaddr*>(&address), sizeof address);
  return connection;
}

// All that comes back until the server closes, or until nothing has come for so long [s].
inline std::string exchange_bytes(int port, const std::string& bytes, int patience = 20) {
  const OpenFile connection = connection_from("127.0.0.1", port);
  const int number = connection.number();
  const timeval wait{.tv_sec = patience, .tv_usec = 0};
  setsockopt(number, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
  std::string answer;
  if (::send(number, bytes.data(), bytes.size(), MSG_NOSIGNAL) >= 0) {
    std::array<char, 65536> room{};
    for (ssize_t got = 0; (got = recv(number, room.data(), room.size(), 0)) > 0;)
      answer.append(room.data(), static_cast<std::size_t>(got));
  }
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
