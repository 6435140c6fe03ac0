// Commands that walk through a run that was computed before: open, show, play, go_on.
#include <algorithm>

#include "app/commands/command_definition.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr std::string_view kTimelineGroup = "Timeline";
constexpr std::int64_t kMostSamples = 1'000'000'000;

Timeline& timeline_of(Console& console) {
  Timeline* timeline = console.session().timeline();
  if (timeline == nullptr)
    throw CommandFailure(
        "no run is open; open one first: {\"command\": \"open\", \"run\": \"out/collapse\"}");
  return *timeline;
}

Json told(const Timeline& timeline) {
  const Moment& moment = timeline.moment();
  return {{"sample", timeline.shown()},
          {"samples", timeline.moments().size()},
          {"time", moment.time},
          {"step", moment.step},
          {"phase", moment.phase_name}};
}

struct OpenRun {
  std::string run;

  void describe(Fields& f) {
    describe_input(
        f,
        {"run", "folder of the run, relative to the session file or absolute", Presence::required},
        run);
  }
  Json perform(Console& console, const std::string&) {
    console.session().open(console.beside(run));
    return told(timeline_of(console));
  }
};

struct Show {
  std::optional<double> time;
  std::int64_t sample = -1, by = 0, phase = -1;

  void describe(Fields& f) {
    f.number({"time", "the sample nearest to this time"}, between(0, 1e12, "sqrt(d/g)"), time);
    f.integer({"sample", "number of the sample, from 0"}, -1, kMostSamples, sample);
    f.integer({"by", "this many samples forward, or back if negative, up to the last or first"},
              -kMostSamples, kMostSamples, by);
    f.integer({"phase", "the first sample of the phase with this number, from 0"}, -1, 10'000,
              phase);
    f.exactly_one({"time", "sample", "by", "phase"});
  }

  Json perform(Console& console, const std::string& place) {
    Timeline& timeline = timeline_of(console);
    timeline.refresh();
    timeline.show(chosen(timeline, place));
    return told(timeline);
  }

  std::size_t chosen(const Timeline& timeline, const std::string& place) const {
    const std::vector<Moment>& moments = timeline.moments();
    const auto last = static_cast<std::int64_t>(moments.size()) - 1;
    if (time) {
      if (*time < moments.front().time || *time > moments.back().time)
        throw InputError(place + ".time", "must be a number from " +
                                              message_number(moments.front().time) + " to " +
                                              message_number(moments.back().time) +
                                              " sqrt(d/g), the times of the run");
      return timeline.nearest(*time);
    }
    if (sample > last)
      throw InputError(place + ".sample", "must be at most " + std::to_string(last) +
                                              ", the number of the last sample");
    if (sample >= 0) return static_cast<std::size_t>(sample);
    if (phase >= 0) {
      const auto first = std::ranges::find(moments, phase, &Moment::phase);
      if (first == moments.end())
        throw InputError(place + ".phase", "the run has no sample of phase " +
                                               std::to_string(phase) + "; its last is " +
                                               std::to_string(moments.back().phase));
      return static_cast<std::size_t>(first - moments.begin());
    }
    const auto now = static_cast<std::int64_t>(timeline.shown());
    return static_cast<std::size_t>(std::clamp<std::int64_t>(now + by, 0, last));
  }
};

struct Play {
  bool on = true, loop = false;
  double speed = 1;

  void seed(const Console& console) {
    const Timeline* timeline = console.session().timeline();
    if (timeline == nullptr) return;
    loop = timeline->loop;
    speed = timeline->speed;
  }
  void describe(Fields& f) {
    f.flag({"on", "false: pauses"}, on);
    f.number({"speed", "samples per frame of the panel"}, between(0.01, 1000, "1"), speed);
    f.flag({"loop", "whether it starts over at the end"}, loop);
  }
  Json perform(Console& console, const std::string&) {
    Timeline& timeline = timeline_of(console);
    // Who plays from the end plays again.
    const bool over = timeline.shown() + 1 == timeline.moments().size();
    if (on && !timeline.playing && over) timeline.show(0);
    timeline.playing = on;
    timeline.speed = speed;
    timeline.loop = loop;
    return told(timeline);
  }
};

Json go_on(Console& console) {
  timeline_of(console);
  Session& session = console.session();
  session.go_on();
  return {{"time", session.world().time}, {"phase", session.phase_name()}};
}

}  // namespace

std::vector<SessionCommand> timeline_commands() {
  return {define<OpenRun>(
              {"open", kTimelineGroup,
               "Shows a run, finished or still running, from its history, instead of computing.",
               R"({"command": "open", "run": "out/collapse"})"},
              false),
          define<Show>({"show", kTimelineGroup, "Shows another moment of the run.",
                        R"({"command": "show", "time": 3.2})"},
                       false),
          define<Play>({"play", kTimelineGroup,
                        "Steps through the samples of the run, frame by frame of the panel; what "
                        "is absent stays as it is.",
                        R"({"command": "play", "speed": 0.5})"},
                       false),
          define<Without<go_on>>({"go_on", kTimelineGroup,
                                  "Continues computing from the checkpoint of the run nearest to "
                                  "the moment shown: its state.cbor, or its beginning.",
                                  R"({"command": "go_on"})"},
                                 false)};
}

}  // namespace quicksand
