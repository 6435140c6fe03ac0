// A session that is served inside the test: one thread computes, one serves, and clients talk to them.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <string>
#include <thread>

#include "app/scene/opening.h"
#include "app/serve/served_session.h"
#include "app/web/server.h"
#include "app/web/web_socket_client.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {

class SessionServer {
 public:
  // `file`: a scene, or the folder of a run.
  explicit SessionServer(const std::string& file = "chain", ServerLimits limits = {})
      : live_({folder_.path(), false}, exchange_) {
    live_.begin(opening_command(file));
    server_.emplace(
        ServerOptions{.token = kToken, .folder = folder_.path(), .limits = limits},
        PageParts{{"/", {"text/html", std::make_shared<const std::string>("the page")}}},
        exchange_);
    live_.interrupted = [this] { return ends_.load(); };
    computing_ = std::thread([this] {
      while (!ends_) live_.take_turn();
    });
  }
  ~SessionServer() { stop(); }
  SessionServer(const SessionServer&) = delete;
  SessionServer& operator=(const SessionServer&) = delete;

  // Ends computing: then the session can be looked at.
  ServedSession& stop() {
    ends_ = true;
    if (computing_.joinable()) computing_.join();
    return live_;
  }
  int port() const { return server_->port(); }
  const std::filesystem::path& folder() const { return folder_.path(); }

  inline static const std::string kToken = "0123456789abcdef0123456789abcdef";

 private:
  TemporaryFolder folder_;
  Exchange exchange_;
  ServedSession live_;
  std::optional<Server> server_;
  std::atomic<bool> ends_{false};
  std::thread computing_;
};

// A client that knows the token, as the page does what it must: it counts the pictures.
class Page : public WebSocketClient {
 public:
  explicit Page(const SessionServer& server)
      : WebSocketClient(server.port(), SessionServer::kToken) {}

  // The answer to a message; what comes before it is passed over.
  Json ask(Json message) {
    message["id"] = ++id_;
    send_text(message.dump());
    while (const auto heard = receive(kPatience)) {
      if (heard->binary) {
        drawn(heard->bytes);
        continue;
      }
      Json answer = Json::parse(heard->bytes);
      if (answer.value("id", Json()) == id_) return answer;
    }
    throw std::runtime_error("no answer to " + message.dump());
  }

  // The head of the next picture.
  Json picture() {
    while (const auto heard = receive(kPatience))
      if (heard->binary)
        if (Json head = drawn(heard->bytes); head["kind"] == "frame") return head;
    throw std::runtime_error("no picture came");
  }

  static Json head_of(const std::string& bytes) {
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof size);
    return Json::parse(bytes.substr(sizeof size, size));
  }

 private:
  static constexpr std::chrono::seconds kPatience{60};

  Json drawn(const std::string& bytes) {
    Json head = head_of(bytes);
    if (head["kind"] == "frame") send_drawn(++pictures_);
    return head;
  }

  int id_ = 0;
  std::uint32_t pictures_ = 0;
};

}  // namespace quicksand::test
