// A session that is served and measured.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/bench/bench.h"
#include "app/scene_json/scenario_json.h"
#include "app/serve/served_session.h"
#include "app/web/access.h"
#include "app/web/server.h"
#include "core/base/parallel.h"
#include "core/checkpoint/checkpoint.h"

namespace quicksand::bench {

inline double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// The served session, computing in a thread of its own as long as this lives.
class Served {
 public:
  Served(const Options& options, const Checkpoint& state, const Scenario& scene)
      : token_(random_token()), session_({options.out, false}, exchange_) {
    const auto file = std::filesystem::absolute(options.out / "served.cbor");
    write_checkpoint(file, {state.world, state.protocol, to_text(scene)});
    session_.begin({{"command", "restore"}, {"file", file.string()}});
    session_.begin({{"command", "pace"}, {"steps_per_frame", 1000000}});
    server_.emplace(ServerOptions{.token = token_, .folder = options.out}, PageParts{}, exchange_);
  }

  int port() const { return server_->port(); }
  const std::string& token() const { return token_; }

  // Computes for so long while `meanwhile` runs; the number of steps a second.
  template <class Meanwhile>
  double steps_per_second(double seconds, Meanwhile meanwhile) {
    std::atomic<bool> ends{false};
    std::thread others([&] { meanwhile(ends); });
    const auto begin = std::chrono::steady_clock::now();
    session_.interrupted = [&] { return seconds_since(begin) >= seconds; };
    session_.console().session().running = true;
    const std::int64_t first = session_.console().session().world().step;
    with_threads(1, [&] {
      while (seconds_since(begin) < seconds) session_.take_turn();
    });
    const double rate = static_cast<double>(session_.console().session().world().step - first) /
                        seconds_since(begin);
    ends = true;
    session_.console().session().running = false;
    // What clients wait for comes after the end.
    session_.interrupted = nullptr;
    others.join();
    if (session_.console().session().finished())
      throw std::runtime_error("the served scene ended before it was measured");
    return rate;
  }

 private:
  std::string token_;
  Exchange exchange_;
  ServedSession session_;
  std::optional<Server> server_;
};

}  // namespace quicksand::bench
