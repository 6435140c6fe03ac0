// A session steered by its clients: it answers, draws, records.
#include "app/serve/served_session.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "app/run_folder/summary.h"
#include "app/serve/serve.h"
#include "tests/support/files.h"
#include "tests/support/program.h"
#include "tests/support/session_server.h"

namespace quicksand::test {
namespace {

std::size_t count_of(const Json& head, const char* name) {
  for (const Json& array : head["arrays"])
    if (array[0] == name) return array[2].get<std::size_t>();
  return 0;
}

TEST(ServedSession, APictureHoldsEachBodyAndWhatTheViewShows) {
  SessionServer server("chain");
  Page page(server);
  Json head = page.picture();
  EXPECT_EQ(head["scene"], "chain");
  const auto bodies = head["bodies"].get<std::size_t>();
  EXPECT_GT(bodies, 1U);
  EXPECT_EQ(count_of(head, "disks"), 3 * bodies);
  EXPECT_EQ(count_of(head, "colour"), bodies);
  EXPECT_EQ(count_of(head, "bonds"), 0U) << "the view shows none";
  page.ask({{"command", "view"}, {"bonds", true}, {"orientation", true}, {"theme", "dark"}});
  page.ask({{"command", "run"}, {"steps", 2}});
  do head = page.picture();
  while (head["step"] != 2);
  EXPECT_GT(count_of(head, "bonds"), 0U);
  EXPECT_EQ(count_of(head, "angle"), bodies);
  EXPECT_EQ(head["theme"], "dark");
  EXPECT_EQ(count_of(head, "colours") % 3, 0U);
}

TEST(ServedSession, EachPictureNamesAMethodThatDoesNotSolveItsSteps) {
  SessionServer nscd("paper_method"), exact("chain");
  EXPECT_EQ(Page(nscd).picture()["method"], "NSCD, 100 sweeps");
  EXPECT_EQ(Page(exact).picture()["method"], "");
}

TEST(ServedSession, TellsTheStateThatThePageDrawsItsControlsFrom) {
  SessionServer server("chain");
  Page page(server);
  Json state;
  while (const auto heard = page.receive(std::chrono::seconds(60))) {
    if (heard->binary) continue;
    state = Json::parse(heard->bytes);
    break;
  }
  EXPECT_EQ(state["kind"], "state");
  EXPECT_EQ(state["scene"], "chain");
  EXPECT_GT(state["scenes"].size(), 5U);
  bool friction = false;
  for (const Json& group : state["parameters"])
    for (const Json& p : group["parameters"])
      if (p["path"] == "contact.friction") friction = p["low"] == 0 && p["unit"] == "1";
  EXPECT_TRUE(friction) << state["parameters"].dump(1);
}

TEST(ServedSession, AnswersQuestionsAboutABodyAndRefusesOthers) {
  SessionServer server("chain");
  Page page(server);
  page.ask({{"command", "run"}, {"steps", 5}});
  const Json x = page.ask({{"command", "pick"}, {"body", 1}})["result"]["position"];
  const Json body = page.ask({{"ask", "body"}, {"at", x}})["result"];
  EXPECT_EQ(body["body"], 1);
  EXPECT_GT(body["contacts"].size(), 0U);
  EXPECT_TRUE(body["contacts"][0]["normal"].is_number());
  EXPECT_TRUE(page.ask({{"ask", "body"}, {"at", {1e6, 1e6}}})["result"]["body"].is_null());
  for (const Json& wrong :
       {Json{{"ask", "x"}}, Json{{"ask", "body"}}, Json{{"ask", "body"}, {"at", {1, "a"}}}})
    EXPECT_EQ(page.ask(wrong)["ok"], false) << wrong;
}

TEST(ServedSession, WhatClientsDidReplaysToTheSameWorld) {
  SessionServer server("collapse");
  Page page(server), other(server);
  page.ask({{"command", "set"}, {"path", "contact.friction"}, {"value", 0.4}});
  page.ask({{"command", "pace"}, {"steps_per_frame", 20}});
  page.ask({{"command", "start"}});
  other.ask({{"command", "view"}, {"colour", "speed"}});
  for (int i = 0; i < 3; ++i) page.picture();
  other.ask({{"command", "apply"}, {"body", 0}, {"force", {30, 0}}});
  while (page.picture()["step"] < 60) {
  }
  page.ask({{"command", "pause"}});
  page.ask({{"command", "apply"}, {"body", 0}, {"force", {0, 0}}});
  page.ask({{"command", "run"}, {"steps", 4}});
  EXPECT_EQ(page.ask({{"command", "run"}, {"steps", -4}})["ok"], false);
  // A run without end, which another client ends.
  page.send_text(R"({"command": "run"})");
  std::int64_t step = 0;
  while ((step = other.picture()["step"].get<std::int64_t>()) < 120) {
  }
  EXPECT_EQ(other.ask({{"ask", "body"}, {"at", {0, 0}}})["ok"], true)
      << "answered in the middle of a run";
  other.ask({{"command", "pause"}});
  const std::string file = page.ask({{"ask", "recording"}})["result"]["file"];
  const Json recording = Json::parse(contents(server.folder() / file));
  ServedSession& live = server.stop();
  EXPECT_EQ(recording, Json::parse(live.recording()));
  EXPECT_EQ(recording["commands"].back()["hash"],
            world_hash_text(live.console().session().world()));
  const Outcome replay =
      run_program({"session", file, "--out", "replay", "--quiet"}, server.folder());
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
}

TEST(ServedSession, TheSeriesThatIsFetchedHasARowASample) {
  SessionServer server("chain");
  Page page(server);
  page.ask({{"command", "run"}, {"steps", 20}});
  EXPECT_EQ(page.ask({{"ask", "series"}})["result"]["file"], "series.csv");
  const std::string text = contents(server.folder() / "series.csv");
  const auto rows = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  EXPECT_EQ(rows, 1 + server.stop().console().session().history().size());
}

// Of which each first step is solved by factorisations, between which the session looks up.
void load_computed_chain(ServedSession& served) {
  served.begin({{"command", "load"}, {"scene", "chain"}});
  served.begin({{"command", "set"}, {"path", "solver.method"}, {"value", "interior_point"}});
}

// What changes the view alone does not wait for the end of a step, and changes nothing of it.
TEST(ServedSession, ChangesTheViewWhileAStepIsSolved) {
  std::vector<std::uint64_t> hashes;
  for (const bool looks : {false, true}) {
    const TemporaryFolder folder;
    Exchange exchange;
    ServedSession served({folder.path()}, exchange);
    load_computed_chain(served);
    Session& session = served.console().session();
    bool asked = false;
    const std::function<bool()> look_up = session.meanwhile;
    const auto look_at_it = [&] {
      asked = true;
      exchange.want_frame_after(exchange.newest(Newest::frame).number);
      exchange.give({1, R"({"command": "view", "colour": "speed", "id": 7})"});
      exchange.give({1, R"({"command": "pick", "body": 1, "id": 8})"});
      const std::int64_t step = session.world().step;
      EXPECT_FALSE(look_up());
      EXPECT_EQ(session.world().step, step);
      EXPECT_EQ(session.view.colouring, Colouring::speed);
      const std::vector<ClientText> answers = exchange.take_answers();
      ASSERT_EQ(answers.size(), 2U);
      EXPECT_EQ(Json::parse(answers[0].text)["id"], 7);
      EXPECT_EQ(session.picked, 1);
      EXPECT_NE(exchange.newest(Newest::frame).bytes, nullptr);
    };
    session.meanwhile = [&] {
      if (looks && !asked) look_at_it();
      return false;
    };
    served.begin({{"command", "run"}, {"steps", 6}});
    EXPECT_EQ(asked, looks);
    hashes.push_back(world_hash(session.world()));
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

// A pause does not wait for the end of a step that takes long, and what has been computed replays.
TEST(ServedSession, GivesAStepUpForAPause) {
  const TemporaryFolder folder;
  Exchange exchange;
  ServedSession served({folder.path()}, exchange);
  load_computed_chain(served);
  Session& session = served.console().session();
  session.meanwhile = [&, look_up = session.meanwhile] {
    exchange.give({1, R"({"command": "pause"})"});
    return look_up();
  };
  const Json ended = served.console().perform({{"command", "run"}, {"steps", 6}});
  EXPECT_EQ(ended["ended_by"], word_of(RunStop::cut_short));
  EXPECT_EQ(session.world().step, 0);
}

// Its steps are not all counted before the slice that computes them ends.
TEST(ServedSession, ARecordingThatIsAskedForInMidSliceReplays) {
  const TemporaryFolder folder;
  Exchange exchange;
  ServedSession served({folder.path()}, exchange);
  served.begin({{"command", "load"}, {"scene", "chain"}});
  served.begin({{"command", "pace"}, {"steps_per_frame", 5}});
  served.begin({{"command", "start"}});
  Session& session = served.console().session();
  const std::function<bool(const Session&)> listen = session.stop_asked;
  bool asked = false;
  session.stop_asked = [&](const Session& s) {
    if (s.world().step == 3 && !asked) {
      exchange.give({1, R"({"ask": "recording", "id": 1})"});
      asked = true;
    }
    return listen(s);
  };
  served.take_turn();
  served.take_turn();
  ASSERT_TRUE(asked);
  const Outcome replay = run_program({"session", "recording.json", "--quiet"}, folder.path());
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
}

// A deposit without dynamics is there at once; so is one that follows the last step.
TEST(ServedSession, PhasesThatTakeNoStepReplay) {
  const TemporaryFolder folder;
  Exchange exchange;
  ServedSession served({folder.path()}, exchange);
  served.begin(parse_json(R"({"command": "load", "scene": {"name": "two", "gravity": {},
    "box": {"width": 8, "height": 8}, "contact": {"friction": 0.3, "cohesion_force": 100},
    "bodies": [{"position": [4, 0.5]}], "step": {"dt": 1e-2},
    "phases": [{"type": "settle", "max_time": 0.05, "until_rest": false}, {"type": "heal"},
               {"type": "deposit", "grains": 5, "interval": 0}]}})"));
  served.begin({{"command", "pace"}, {"steps_per_frame", 4}});
  served.begin({{"command", "start"}});
  for (int turn = 0; turn < 4; ++turn) served.take_turn();
  Session& session = served.console().session();
  EXPECT_TRUE(session.finished());
  EXPECT_EQ(session.world().disks.size(), 6U);
  folder.write("by_hand.json", served.recording());
  const Outcome replay = run_program({"session", "by_hand.json", "--quiet"}, folder.path());
  EXPECT_EQ(replay.exit_code, 0) << replay.err;
}

TEST(ServedSession, WalksThroughARunWithTheSameCommandsAsTheWindow) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"run", "chain", "--no-frames", "--out", "run", "--quiet"}, folder.path())
                .exit_code,
            0);
  SessionServer server((folder.path() / "run").string());
  Page page(server);
  Json head = page.picture();
  const auto samples = head["timeline"]["samples"].get<int>();
  ASSERT_GT(samples, 3);
  EXPECT_EQ(head["timeline"]["sample"], samples - 1);
  const double end = head["time"];
  EXPECT_EQ(page.ask({{"command", "show"}, {"sample", 1}})["result"]["sample"], 1);
  do head = page.picture();
  while (head["timeline"]["sample"] != 1);
  EXPECT_LT(head["time"], end);
  EXPECT_EQ(page.ask({{"command", "show"}, {"sample", samples}})["ok"], false);
  EXPECT_EQ(page.ask({{"command", "start"}})["ok"], false) << "nothing computes";
}

TEST(ServedSession, PlaysARunToItsEndAndGoesOnFromThere) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"run", "chain", "--no-frames", "--out", "run", "--quiet"}, folder.path())
                .exit_code,
            0);
  SessionServer server((folder.path() / "run").string());
  Page page(server), other(server);
  const Json first = other.picture();
  page.ask({{"command", "show"}, {"sample", 0}});
  page.ask({{"command", "play"}, {"on", true}});
  Json head;
  do head = page.picture();
  while (head["timeline"]["sample"] != first["timeline"]["sample"] ||
         head["timeline"]["playing"] != false);
  EXPECT_EQ(head["time"], first["time"]);
  const std::string file = page.ask({{"ask", "recording"}})["result"]["file"];
  EXPECT_EQ(run_program({"session", file, "--out", "replay", "--quiet"}, server.folder()).exit_code,
            0);
  EXPECT_EQ(page.ask({{"command", "open"}, {"run", "/"}})["ok"], false) << "no other folder";
  const Json answer = page.ask({{"command", "go_on"}});
  EXPECT_EQ(answer["result"]["time"], first["time"]) << "from the state of the run";
  do head = page.picture();
  while (head.contains("timeline"));
  EXPECT_EQ(server.stop().console().session().timeline(), nullptr);
}

// A vane among grains, which the start of its phase refuses; the phase before is of two steps.
Json load_refused_vane() {
  return Json::parse(R"({"command": "load", "scene": {
    "box": {"width": 8, "height": 8, "sides": "periodic", "floor": true},
    "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 10},
    "bodies": [{"position": [4, 0.5]}, {"position": [4, 1.5]}, {"position": [4, 2.5]},
               {"position": [4, 3.5]}], "step": {"dt": 1e-3},
    "phases": [{"type": "settle", "max_time": 2e-3, "until_rest": false},
               {"type": "vane", "shape": {"radius": 1.2}, "depth": 2, "torque": 5}]}})");
}

TEST(ServedSession, ARefusedPhaseStopsComputingAndNotTheServer) {
  const TemporaryFolder folder;
  Exchange exchange;
  ServedSession served({folder.path()}, exchange);
  served.begin(load_refused_vane());
  served.begin({{"command", "pace"}, {"steps_per_frame", 50}});
  served.begin({{"command", "start"}});
  for (int turn = 0; turn < 3; ++turn) served.take_turn();
  EXPECT_FALSE(served.console().session().running);
  bool told = false;
  for (const ClientText& text : exchange.take_answers())
    told = told || text.text.find("phases[1].clear") != std::string::npos;
  EXPECT_TRUE(told);
  EXPECT_EQ(served.console().session().world().step, 2);
  folder.write("by_hand.json", served.recording());
  EXPECT_EQ(run_program({"session", "by_hand.json", "--quiet"}, folder.path()).exit_code, 0);
}

TEST(ServedSession, APictureThatCannotBeDrawnIsTold) {
  const TemporaryFolder folder;
  Exchange exchange;
  ServedSession served({folder.path(), true}, exchange);
  served.begin({{"command", "load"}, {"scene", "chain"}});
  served.console().session().view.width = kLargestPicture + 1;
  exchange.want_frame_after(exchange.newest(Newest::frame).number);
  EXPECT_NO_THROW(served.take_turn());
  const std::vector<ClientText> answers = exchange.take_answers();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_NE(answers[0].text.find("cannot be drawn"), std::string::npos) << answers[0].text;
}

TEST(ServedSession, AnErrorThatEndsTheServerDoesNotTakeAlongWhatWasDone) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "by_hand.json";
  Exchange exchange;
  ServedSession served({folder.path()}, exchange);
  served.begin({{"command", "load"}, {"scene", "chain"}});
  served.begin({{"command", "start"}});
  const auto fails = [&served]() -> bool {
    if (served.console().session().world().step > 0) throw std::length_error("beyond repair");
    return false;
  };
  EXPECT_THROW(serve_until(fails, served, file), std::length_error);
  EXPECT_EQ(contents(file), served.recording());
}

}  // namespace
}  // namespace quicksand::test
