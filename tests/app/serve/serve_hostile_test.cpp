// What clients send who mean no good, or have gone: it takes no memory for good, and nothing falls over.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/bounded_memory.h"
#include "tests/support/session_server.h"

namespace quicksand::test {
namespace {

// Those that come again and again while a step is under way leave nothing behind.
TEST(ServeHostile, WhatClientsThatLeftHadWaitingIsDropped) {
  const TemporaryFolder folder;
  Exchange exchange;
  ServedSession served({folder.path()}, exchange);
  served.begin({{"command", "load"}, {"scene", "chain"}});
  served.begin({{"command", "set"}, {"path", "solver.method"}, {"value", "interior_point"}});
  const std::string large = R"({"command": "set", "path": "gravity.magnitude", "value": 2)" +
                            std::string(60'000, ' ') + "}";
  Session& session = served.console().session();
  ClientId client = 1;
  session.meanwhile = [&, look_up = session.meanwhile] {
    for (int turn = 0; turn < 10; ++turn) {
      for (int i = 0; i < 120; ++i) exchange.give({client, large});
      look_up();
      exchange.forget(client++);
    }
    return look_up();
  };
  exchange.give({1'000'000, R"({"command": "run", "steps": 20, "id": 1})"});
  while (served.console().session().world().step < 20) served.take_turn();
  served.take_turn();
  EXPECT_GT(client, 20U);
  EXPECT_EQ(served.recording().find("gravity.magnitude"), std::string::npos);
  int answered = 0;
  for (const ClientText& answer : exchange.take_answers())
    if (const Json json = Json::parse(answer.text); json.value("ok", false)) ++answered;
  EXPECT_EQ(answered, 1) << "the run";
}

// Each that stays is refused beyond its part of the room.
TEST(ServeHostile, LargeMessagesWaitUpToABound) {
  const TemporaryFolder folder;
  Exchange exchange;
  ServedSession served({folder.path()}, exchange);
  served.begin({{"command", "load"}, {"scene", "chain"}});
  const std::string large = R"({"command": "set", "path": "gravity.magnitude", "value": 2)" +
                            std::string(60'000, ' ') + "}";
  Session& session = served.console().session();
  session.stop_asked = [&, listen = session.stop_asked](const Session& now) {
    for (int i = 0; i < 200; ++i) exchange.give({1, large});
    return listen(now);
  };
  served.begin({{"command", "run"}, {"steps", 5}});
  std::size_t refused = 0;
  for (const ClientText& answer : exchange.take_answers())
    if (answer.text.find("too many commands") != std::string::npos) ++refused;
  EXPECT_GT(refused, 100U);
}

TEST(ServeHostile, TextsThatAreNoUtf8AreRefusedAndHarmNobody) {
  const SessionServer server;
  Page page(server);
  for (const std::string text : {"\xFF\xFE", "{\"command\": \"\xC3\"}",
                                 "{\"command\": \"load\", \"scene\": \"\xED\xA0\x80\"}",
                                 "{\"ask\": \"\xF5\", \"id\": 3}", "{\"\x80\": 1}"}) {
    try {
      Page bad(server);
      bad.send_text(text);
      while (const auto heard = bad.receive(std::chrono::seconds(20))) {
        if (heard->binary || heard->bytes.find("\"ok\"") == std::string::npos) continue;
        EXPECT_EQ(Json::parse(heard->bytes)["ok"], false);
        break;
      }
    } catch (const std::runtime_error&) {
      // Closed: as good.
    }
    EXPECT_EQ(page.ask({{"command", "run"}, {"steps", 1}})["ok"], true);
  }
}

// The recording compares a force with the one before it, which may act on a region instead of a body.
TEST(ServeHostile, ForcesOnRegionsAreRecordedOneByOne) {
  SessionServer server("chain");
  Page page(server);
  const Json region{{"command", "apply"},
                    {"inside", {{"center", {5, 2}}, {"half_axes", {50, 50}}}},
                    {"force", {1, 0}}};
  for (int i = 0; i < 3; ++i) {
    const Json answer = page.ask(region);
    EXPECT_EQ(answer["ok"], true) << answer;
  }
  EXPECT_EQ(page.ask({{"command", "apply"}, {"body", 1}, {"force", {1, 0}}})["ok"], true);
  EXPECT_EQ(page.ask(region)["ok"], true);
  const Json commands = Json::parse(server.stop().recording())["commands"];
  EXPECT_EQ(commands.size(), 1 + 3 + 1 + 1 + 1U) << commands;
}

std::size_t resident_pages() {
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident;
}

// It gets no picture before it has drawn those that it got, and answers of others are not kept for it.
TEST(ServeHostile, AClientThatNeverReadsTakesNoMoreMemory) {
  if (!kMemoryCanBeBounded) GTEST_SKIP() << "the address sanitizer keeps what is freed";
  const SessionServer server("collapse", {.messages_per_second = 1e6, .most_at_once = 1e6});
  const Page slow(server);
  Page quick(server);
  quick.ask({{"command", "start"}});
  for (int i = 0; i < 50; ++i) quick.picture();
  const std::size_t before = resident_pages();
  for (int i = 0; i < 300; ++i) {
    quick.picture();
    quick.ask({{"command", "view"}, {"bonds", i % 2 == 0}});
  }
  constexpr std::size_t kMost = (std::size_t{16} << 20U) / 4096;
  EXPECT_LT(resident_pages(), before + kMost);
}

}  // namespace
}  // namespace quicksand::test
