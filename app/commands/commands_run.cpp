// Commands that compute: run, start, pause, apply.
#include "app/commands/command_definition.h"
#include "app/json/json_reader.h"
#include "app/session/condition.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr std::string_view kRunGroup = "Run";
constexpr std::int64_t kMostSteps = 1'000'000'000'000;

// Throws if the simulation stopped because a step failed.
void require_success(const Session& session) {
  if (!session.failed()) return;
  throw CommandFailure("the simulation stopped at t = " + number_text(session.world().time) + ": " +
                       session.protocol().failure());
}

struct RunCommand {
  std::int64_t steps = 0;
  std::optional<double> time;
  bool phase_end = false;
  std::optional<Condition> until;

  void describe(Fields& f) {
    f.integer({"steps", "ends after so many; 0: no such end"}, 0, kMostSteps, steps);
    f.number({"time", "ends after so long, from now"}, above(0, 1e9, "sqrt(d/g)"), time);
    f.flag({"phase_end", "ends with the present phase"}, phase_end);
    f.optional_object({"until", "ends as soon as this holds after a step"}, until,
                      describe_condition);
  }

  Json perform(Console& console, const std::string& place) {
    Session& session = console.session();
    const std::int64_t first = session.world().step;
    RunUntil end;
    if (steps > 0) end.steps = steps;
    end.time = time;
    end.phase_end = phase_end;
    if (until)
      end.condition = [&](const Session& s) {
        return holds(*until, quantity_of(s, until->quantity, place));
      };
    const RunStop stop = session.run(end);
    require_success(session);
    if (until && stop == RunStop::finished)
      throw CommandFailure("the scene ended before " + until->quantity + " was " +
                           words_of(*until));
    return {{"ended_by", word_of(stop)},
            {"steps", session.world().step - first},
            {"phase", session.phase_name()}};
  }
};

Json start_computing(Console& console) {
  console.session().running = true;
  return Json::object();
}

struct Pace {
  std::int64_t steps_per_frame = 1;

  void describe(Fields& f) {
    f.integer({"steps_per_frame", "number of steps", Presence::required}, 1, 1'000'000,
              steps_per_frame);
  }
  Json perform(Console& console, const std::string&) {
    console.session().steps_per_frame = steps_per_frame;
    return Json::object();
  }
};

Json pause_computing(Console& console) {
  console.session().running = false;
  return Json::object();
}

// Grains whose centres lie in it: a circle, or a lens.
struct Ellipse {
  Vec2 center{0, 0}, half_axes{1, 1};  // [d]

  // Or its nearest image, where the sides are periodic.
  bool contains(const Vec2& point, const Box& box) const {
    Vec2 away = point - center;
    away.x() -= box.image_shift(away.x());
    return away.cwiseQuotient(half_axes).squaredNorm() <= 1;
  }
};

struct Apply {
  std::int64_t body = 0;
  std::optional<Ellipse> inside;
  Vec2 force{0, 0};

  void describe(Fields& f) {
    constexpr double kFar = 1e6;
    f.integer({"body", "its number"}, 0, 100'000'000, body);
    f.optional_object({"inside", "all grains whose centres lie in an ellipse now"}, inside,
                      [](Fields& g, Ellipse& e) {
                        g.vector({"center", "its centre [x, y]", Presence::required},
                                 between(-kFar, kFar, "d"), e.center);
                        g.vector({"half_axes", "half its width and height", Presence::required},
                                 above(0, kFar, "d"), e.half_axes);
                      });
    f.exactly_one({"body", "inside"});
    f.vector({"force", "components [x, y], on each body; [0, 0] ends it", Presence::required},
             between(-1e12, 1e12, "F_g"), force);
  }
  Json perform(Console& console, const std::string& place) {
    const World& world = console.session().world();
    const Disks& disks = world.disks;
    if (!inside && body >= disks.size())
      throw InputError(place + ".body", std::to_string(body) + " does not exist; there are " +
                                            std::to_string(disks.size()) + ", numbered from 0");
    std::vector<int> bodies;
    for (int k = 0; k < disks.size(); ++k)
      if (inside ? disks.role[k] == Role::grain && inside->contains(disks.position[k], world.box)
                 : k == body)
        bodies.push_back(k);
    if (bodies.empty()) throw InputError(place + ".inside", "no grain has its centre there");
    for (const int k : bodies) console.session().apply(k, force);
    return {{"bodies", bodies.size()}};
  }
};

}  // namespace

std::vector<SessionCommand> run_commands() {
  return {define<RunCommand>(
              {"run", kRunGroup,
               "Computes until the first of its ends; without any, to the end of the scene.",
               R"({"command": "run", "time": 0.5})"}),
          define<Without<start_computing>>({"start", kRunGroup,
                                            "Lets every frame of the panel compute.",
                                            R"({"command": "start"})"}),
          define<Pace>(
              {"pace", kRunGroup, "Sets how many steps a frame of the panel computes after start.",
               R"({"command": "pace", "steps_per_frame": 10})"},
              false),
          define<Without<pause_computing>>(
              {"pause", kRunGroup, "Ends what start began.", R"({"command": "pause"})"}),
          define<Apply>({"apply", kRunGroup,
                         "Lets a force act on the centre of a body, or of each grain of a region, "
                         "from now on, instead of the one that acted, besides its weight.",
                         R"({"command": "apply", "body": 12, "force": [100, 0]})"})};
}

}  // namespace quicksand
