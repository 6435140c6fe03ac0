// The server against those who keep to its rules and those who do not: neither stops nor slows what it serves.
#include "app/web/server.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/support/http_request.h"
#include "tests/support/session_server.h"

namespace quicksand::test {
namespace {

const std::string kQuery = "?token=" + SessionServer::kToken;

bool begins(const std::string& answer, int status) {
  return answer.starts_with("HTTP/1.1 " + std::to_string(status)) ||
         answer.starts_with("HTTP/1.0 " + std::to_string(status));
}

TEST(Server, GivesThePageToThoseWhoKnowTheToken) {
  const SessionServer server;
  const std::string answer = http_get(server.port(), "/" + kQuery);
  EXPECT_TRUE(begins(answer, 200)) << answer;
  EXPECT_NE(answer.find("the page"), std::string::npos);
  for (const char* header :
       {"content-security-policy: default-src 'none'", "nosniff", "HttpOnly; SameSite=Strict"})
    EXPECT_NE(answer.find(header), std::string::npos) << answer;
  EXPECT_EQ(answer.find("unsafe"), std::string::npos) << "nothing inline is admitted";
  const std::string cookie =
      "Cookie: quicksand_" + std::to_string(server.port()) + "=" + SessionServer::kToken + "\r\n";
  EXPECT_TRUE(begins(http_get(server.port(), "/", cookie), 200)) << "by the cookie";
}

TEST(Server, RefusesWrongTokensHostsOriginsAndMethods) {
  const SessionServer server;
  EXPECT_TRUE(begins(http_get(server.port(), "/"), 401));
  EXPECT_TRUE(begins(http_get(server.port(), "/?token=0123"), 401));
  EXPECT_TRUE(begins(http_get(server.port(), "/files/state.cbor"), 401));
  EXPECT_TRUE(
      begins(http_get(server.port(), "/" + kQuery, "Origin: http://evil.example\r\n"), 403));
  EXPECT_TRUE(begins(http_get(server.port(), "/" + kQuery, "Content-Length: 0\r\n", "POST"), 405));
  EXPECT_TRUE(
      begins(exchange_bytes(
                 server.port(),
                 "GET /" + kQuery + " HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n"),
             403))
      << "a name that a page from elsewhere has made point here";
}

// As `curl -I` asks.
TEST(Server, TellsTheHeadOfAnAnswerWithoutItsBody) {
  const SessionServer server;
  Page page(server);
  ASSERT_EQ(page.ask({{"command", "save"}, {"file", "state.cbor"}})["ok"], true);
  for (const char* path : {"/", "/files/state.cbor"}) {
    const std::string whole = http_get(server.port(), path + kQuery);
    const std::string head = http_get(server.port(), path + kQuery, {}, "HEAD");
    EXPECT_TRUE(begins(head, 200)) << head;
    EXPECT_TRUE(head.ends_with("\r\n\r\n")) << head;
    const auto length = [](const std::string& answer) {
      const std::size_t at = answer.find("content-length: ");
      return at == std::string::npos ? answer : answer.substr(at, answer.find('\r', at) - at);
    };
    EXPECT_EQ(length(head), length(whole)) << path;
  }
  EXPECT_TRUE(begins(http_get(server.port(), "/", {}, "HEAD"), 401)) << "without the token";
}

TEST(Server, RefusesWebSocketsAlike) {
  const SessionServer server;
  const auto refusal = [&](const std::string& token, const std::string& headers) -> std::string {
    try {
      const WebSocketClient client(server.port(), token, headers);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "admitted";
  };
  EXPECT_NE(refusal("wrong", "").find("401"), std::string::npos) << refusal("wrong", "");
  EXPECT_NE(refusal("", "").find("401"), std::string::npos);
  EXPECT_NE(refusal(SessionServer::kToken, "Origin: http://evil.example\r\n").find("403"),
            std::string::npos);
  EXPECT_EQ(refusal(SessionServer::kToken, ""), "admitted");
}

TEST(Server, FilesOfTheFolderAndNoOthersCanBeFetched) {
  const SessionServer server;
  Page page(server);
  ASSERT_EQ(page.ask({{"command", "save"}, {"file", "state.cbor"}})["ok"], true);
  std::filesystem::create_symlink("/etc/passwd", server.folder() / "link");
  std::filesystem::create_directory(server.folder() / "sub");
  const std::string state = http_get(server.port(), "/files/state.cbor" + kQuery);
  EXPECT_TRUE(begins(state, 200));
  EXPECT_NE(state.find("attachment"), std::string::npos);
  for (const char* path :
       {"/files/../files/state.cbor/../../../etc/passwd", "/files/%2e%2e/%2e%2e/etc/passwd",
        "/files//etc/passwd", "/files/link", "/files/sub", "/files/", "/files/..%2fx",
        "/../../etc/passwd", "/files/.%00", "//etc/passwd", "/assets/web/main.js"}) {
    const std::string answer = http_get(server.port(), path + kQuery);
    EXPECT_FALSE(begins(answer, 200)) << path;
    EXPECT_EQ(answer.find("root:"), std::string::npos) << path;
  }
}

TEST(Server, AdmitsEightClientsAndTheNextWhenOneHasGone) {
  const SessionServer server;
  std::vector<std::unique_ptr<Page>> pages;
  for (int i = 0; i < 8; ++i) pages.push_back(std::make_unique<Page>(server));
  EXPECT_THROW(Page{server}, std::runtime_error);
  for (auto& page : pages) EXPECT_EQ(page->picture()["kind"], "frame");
  pages.pop_back();
  EXPECT_EQ(pages.front()->ask({{"command", "pause"}})["ok"], true);
  std::unique_ptr<Page> late;
  for (int i = 0; i < 200 && !late; ++i) {
    try {
      late = std::make_unique<Page>(server);
    } catch (const std::runtime_error&) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  ASSERT_TRUE(late);
  EXPECT_EQ(late->picture()["kind"], "frame");
}

// Closed for a reason within the time that the client waits.
int close_code_of(WebSocketClient& client) {
  while (client.receive(std::chrono::seconds(60))) {
  }
  return client.closed() ? client.close_code() : -1;
}

TEST(Server, ClosesOnMessagesThatAreTooLargeOrTooMany) {
  const SessionServer server("chain",
                             {.message = 1000, .messages_per_second = 1, .most_at_once = 5});
  Page large(server);
  large.send_text(std::string(1001, ' '));
  EXPECT_EQ(close_code_of(large), 1009);
  Page many(server);
  try {
    for (int i = 0; i < 1000; ++i) many.send_text("{}");
  } catch (const std::runtime_error&) {
    // Closed before all were sent.
  }
  EXPECT_EQ(close_code_of(many), 1008);
  Page fine(server);
  EXPECT_EQ(fine.ask({{"command", "run"}, {"steps", 2}})["step"], 2);
}

TEST(Server, ClosesOnSilence) {
  const SessionServer server("chain", {.ping_after = 1, .hang_up_after = 2, .time_to_ask = 1});
  EXPECT_EQ(exchange_bytes(server.port(), "", 30), "") << "no request comes";
  Page silent(server);
  std::this_thread::sleep_for(std::chrono::seconds(4));
  EXPECT_NE(close_code_of(silent), -1) << "it answered no ping";
}

TEST(Server, OneAddressThatOpensConnectionsAndIsSilentKeepsNobodyOut) {
  const SessionServer server;
  std::vector<OpenFile> idle;
  for (int i = 0; i < 200; ++i) idle.push_back(connection_from("127.0.0.2", server.port()));
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(begins(http_get(server.port(), "/" + kQuery), 200));
  const Page page(server);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

TEST(Server, GarbageInTheProtocolEndsThatClientOnly) {
  const SessionServer server;
  Page good(server);
  for (const std::string& garbage :
       {std::string(5000, '\xFF'), std::string("\x81\x02hi"), std::string("GET / HTTP/1.1\r\n\r\n"),
        std::string("\x8F\x80\0\0\0\0", 6),
        std::string("\x81\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 10)}) {
    Page bad(server);
    bad.send_raw(garbage);
    EXPECT_EQ(good.ask({{"command", "run"}, {"steps", 1}})["ok"], true);
  }
  for (const std::string& request :
       {std::string(100000, 'A'), std::string("GET\r\n\r\n"), std::string("\0\1\2\3", 4),
        "GET /" + std::string(20000, 'a') + " HTTP/1.1\r\nHost: x\r\n\r\n"})
    EXPECT_FALSE(begins(exchange_bytes(server.port(), request, 2), 200));
  EXPECT_EQ(good.ask({{"command", "run"}, {"steps", 1}})["step"], 6);
}

TEST(Server, AThousandConnectionsInTurnLeaveNothingBehind) {
  const SessionServer server;
  Page good(server);
  for (int i = 0; i < 1000; ++i) {
    try {
      if (i % 3 == 0) {
        const Page page(server);
      } else {
        const WebSocketClient wrong(server.port(), i % 3 == 1 ? "wrong" : SessionServer::kToken,
                                    "Origin: http://evil\r\n");
      }
    } catch (const std::runtime_error&) {
      // Refused, or there are eight that have not been seen to go.
    }
  }
  EXPECT_EQ(good.ask({{"command", "run"}, {"steps", 3}})["step"], 3);
}

TEST(Server, ASlowReaderGetsFewerPicturesAndHoldsUpNobody) {
  const SessionServer server("chain");
  const Page slow(server);  // reads nothing
  Page quick(server);
  quick.ask({{"command", "pace"}, {"steps_per_frame", 2}});
  quick.ask({{"command", "start"}});
  for (int i = 0; i < 30; ++i) quick.picture();
  EXPECT_GT(quick.ask({{"command", "pause"}})["step"], 50);
}

TEST(Server, AClientThatAsksForMuchAndReadsNothingIsClosed) {
  const SessionServer server("collapse", {.messages_per_second = 1e6, .most_at_once = 1e6});
  WebSocketClient greedy(server.port(), SessionServer::kToken);
  bool closed = false;
  for (int i = 0; i < 1000000 && !closed; ++i) {
    try {
      greedy.send_text(R"({"command": "view", "bonds": true, "id": 1})");
    } catch (const std::runtime_error&) {
      closed = true;
    }
  }
  EXPECT_TRUE(closed);
  Page good(server);
  EXPECT_EQ(good.ask({{"command", "pause"}})["ok"], true);
}

}  // namespace
}  // namespace quicksand::test
