// The server of the page: HTTP for its files and those of the run, a WebSocket for all that moves. It has a thread of
// its own, in which libwebsockets lives; that library stays behind this file.
//
// What a client can do to it is bounded: the size and the rate of its messages, their number that waits, the number of
// clients, the connections of one address, the time that it stays silent. A client gets the newest picture when it has
// drawn an earlier one, so that a slow one gets fewer.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/web/exchange.h"
#include "app/web/page_files.h"

namespace quicksand {

struct ServerLimits {
  std::size_t clients = 8;
  std::size_t message = std::size_t{64} << 10U;  // [bytes]
  double messages_per_second = 200;              // in the mean
  double most_at_once = 400;                     // messages
  int ping_after = 20, hang_up_after = 45;       // of silence [s]
  int time_to_ask = 5;                           // from the connection to the request [s]
};

struct ServerOptions {
  std::string address = "127.0.0.1";
  int port = 0;      // 0: any that is free
  std::string host;  // by which it may be called besides the address
  std::string token;
  std::filesystem::path folder;  // whose files can be fetched
  ServerLimits limits{};
};

class Server {
 public:
  // Listens from now on. Throws InputError if it cannot.
  Server(ServerOptions options, PageParts parts, Exchange& exchange);
  ~Server();

  int port() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quicksand
