// Commands that compute: run, start, pause, apply, and those that begin a phase.
#include <utility>
#include <variant>

#include "app/commands/command_definition.h"
#include "app/run_folder/search_results.h"
#include "app/scene/scene_file.h"
#include "app/scene_json/phase_fields.h"
#include "app/scene_json/scene_fields.h"
#include "app/session/condition.h"
#include "core/base/errors.h"
#include "core/base/format.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"

namespace quicksand {

namespace {

constexpr std::string_view kRunGroup = "Run";
constexpr std::int64_t kMostSteps = 1'000'000'000'000;

// Entries of lists that were not there before, or were others.
Json new_entries(const Json& before, const Json& now) {
  Json entries = Json::object();
  for (const auto& [key, list] : now.items()) {
    const Json old = before.value(key, Json::array());
    for (std::size_t k = 0; k < list.size(); ++k)
      if (k >= old.size() || old[k] != list[k]) entries[key].push_back(list[k]);
  }
  return entries;
}

Json results_so_far(const Session& session) {
  return search_results(session.protocol().scenario(), session.protocol().state());
}

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
    f.integer({"steps", "ends after this many steps; 0: no such limit"}, 0, kMostSteps, steps);
    f.number({"time", "ends after this time, from now"}, above(0, 1e9, "sqrt(d/g)"), time);
    f.flag({"phase_end", "ends with the current phase"}, phase_end);
    f.optional_object({"until", "ends as soon as this condition holds after a step"}, until,
                      describe_condition);
  }

  Json perform(Console& console, const std::string& place) {
    Session& session = console.session();
    if (session.finished() && (steps > 0 || time))
      throw CommandFailure(
          "all phases have ended, so that nothing would be computed; begin another one first, for "
          R"(example {"command": "settle", "max_time": 1, "until_rest": false})");
    const std::int64_t first = session.world().step;
    const int first_phase = session.protocol().state().phase;
    const Json found_before = results_so_far(session);
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
    if (until && stop == RunStop::finished) {
      const std::optional<double> reached = quantity_of(session, until->quantity, place);
      throw CommandFailure("the scene ended before " + until->quantity + " was " +
                           words_of(*until) + "; at the end it " +
                           (reached ? "was " + message_number(*reached) : "had no value"));
    }
    Json result = {{"ended_by", word_of(stop)},
                   {"steps", session.world().step - first},
                   {"phase", session.phase_name()}};
    const Json found = new_entries(found_before, results_so_far(session));
    result.update(found);
    const bool ended = session.protocol().state().phase != first_phase;
    if (ended && session.protocol().missed_rest()) result["missed_rest"] = true;
    if (console.print)
      for (const std::string& warning : search_warnings(found, session.protocol().state().phase))
        console.print(warning);
    return result;
  }
};

Json start_computing(Console& console) {
  if (console.session().timeline())
    throw CommandFailure("a run is shown as it was computed; go_on continues computing from it");
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
  std::optional<Vec2> force;
  std::optional<double> torque;

  void describe(Fields& f) {
    constexpr double kFar = 1e6, kMost = 1e12;
    f.integer({"body", "number of the body"}, 0, 100'000'000, body);
    f.optional_object({"inside", "all grains whose centres are now inside an ellipse"}, inside,
                      [](Fields& g, Ellipse& e) {
                        g.vector({"center", "its centre, [x, y]", Presence::required},
                                 between(-kFar, kFar, "d"), e.center);
                        g.vector({"half_axes", "half its width and height", Presence::required},
                                 above(0, kFar, "d"), e.half_axes);
                      });
    f.exactly_one({"body", "inside"});
    f.vector({"force",
              "force on each body, components [x, y]; [0, 0] removes it; absent: that of before"},
             between(-kMost, kMost, "F_g"), force);
    f.number(
        {"torque", "torque on each body, counter-clockwise; 0 removes it; absent: that of before"},
        between(-kMost, kMost, "F_g d"), torque);
    if (f.reading() && !force && !torque)
      f.refuse("force", "is missing; give force, torque or both");
  }
  Json perform(Console& console, const std::string& place) {
    const World& world = console.session().world();
    const Disks& disks = world.disks;
    if (!inside && body >= disks.size())
      throw InputError(place + ".body", std::to_string(body) + " does not exist; there are " +
                                            std::to_string(disks.size()) + ", numbered from 0");
    std::vector<int> bodies;
    for (int k = 0; k < disks.size(); ++k)
      if (inside
              ? disks.role[k] == DiskRole::grain && inside->contains(disks.position[k], world.box)
              : k == body)
        bodies.push_back(k);
    if (bodies.empty()) throw InputError(place + ".inside", "no grain has its centre there");
    if (!inside) refuse_held(world, place);
    for (const int k : bodies) console.session().apply(k, force, torque);
    if (inside && console.print)
      console.print((!torque  ? "a force on "
                     : !force ? "a torque on "
                              : "a force and a torque on ") +
                    (bodies.size() == 1 ? "" : std::string("each of ")) +
                    count_text(std::ssize(bodies), "grain"));
    return {{"bodies", bodies.size()}};
  }

  // A force that moves nothing would pass for one that the packing resists.
  void refuse_held(const World& world, const std::string& place) const {
    const Vec3& inverse_mass = world.disks.inverse_mass[static_cast<int>(body)];
    const auto refuse = [&](const char* key, const char* moved) {
      throw InputError(place + "." + key, "does not " + std::string(moved) + " body " +
                                              std::to_string(body) +
                                              ", which is fixed or driven at a given velocity");
    };
    if (force && !force->isZero() && inverse_mass.head<2>().isZero()) refuse("force", "move");
    if (torque && *torque != 0 && inverse_mass.z() == 0) refuse("torque", "turn");
  }
};

}  // namespace

std::vector<SessionCommand> run_commands() {
  return {
      define<RunCommand>({"run", kRunGroup,
                          "Computes until the first of these conditions is met; without any, to "
                          "the end of the scene. The result says missed_rest where the last phase "
                          "that ended waits for rest and ended at its max_time instead.",
                          R"({"command": "run", "time": 0.5})"}),
      define<Without<start_computing>>({"start", kRunGroup,
                                        "Makes every frame of the panel compute.",
                                        R"({"command": "start"})"}),
      define<Pace>(
          {"pace", kRunGroup, "Sets how many steps a frame of the panel computes after start.",
           R"({"command": "pace", "steps_per_frame": 10})"},
          false),
      define<Without<pause_computing>>(
          {"pause", kRunGroup, "Stops the computation begun by start.", R"({"command": "pause"})"}),
      define<Apply>(
          {"apply", kRunGroup,
           "Applies a force to the centre of a body, or of each grain in a region, or a torque, "
           "from now on, in addition to its weight and in place of the force, or the torque, "
           "applied before. Where a phase drives the body, the forces of the phase replace both. "
           "The bonds present at the first apply count as initial, unless a phase has already set "
           "the initial bonds.",
           R"({"command": "apply", "body": 12, "force": [100, 0]})"})};
}

// Commands that end the present phase and begin another, one a kind. Their arguments are those of the phase in a scene.
namespace {

constexpr std::string_view kPhaseGroup = "Phases";

// Stands for a scene where there is none yet: whatever depends on it is admissible.
const Scenario& any_scene() {
  static const Scenario scene = [] {
    Scenario s;
    s.grain_law.cohesion_force = 1;
    s.box.width = 1;
    return s;
  }();
  return scene;
}

// Throws InputError if the phase cannot follow on the present state.
void check_phase(const Session& session, const Phase& phase, const std::string& place) {
  Scenario scenario = session.protocol().scenario();
  const ProtocolState& now = session.protocol().state();
  // Where it begins; what comes later was checked without it.
  const auto place_in_list = static_cast<std::size_t>(now.phase) + (now.entered ? 1 : 0);
  scenario.phases.resize(std::min(scenario.phases.size(), place_in_list));
  scenario.phases.push_back(phase);
  try {
    validate(scenario);
  } catch (const InputError& error) {
    throw InputError(place, error.what());
  }
  const World& world = session.world();
  const Phase* present = session.protocol().phase();
  const auto* piston = present && now.entered ? std::get_if<PistonPhase>(&present->kind) : nullptr;
  // The phase under way ends, and takes its piston with it.
  const std::size_t leaving = piston && piston->remove ? 1 : 0;
  const std::string problem =
      problem_of_beginning(phase, world,
                           {.phase = "this phase",
                            .walls = world.walls.size() - leaving,
                            .piston_stands = leaving == 0 && pressing_piston(world) >= 0});
  if (!problem.empty()) throw InputError(place, "cannot begin: the world " + problem);
  scenario.disks.clear();
  scenario.phases.assign(1, phase);
  require_memory(scenario, world.disks.size(), place);
}

template <class Kind>
struct Begin {
  Phase phase;
  const Scenario* scenario = &any_scene();

  Begin() { phase.kind = Kind{}; }
  void seed(const Console& console) { scenario = &console.session().scenario(); }
  void describe(Fields& f) { describe_kind(f, phase, *scenario); }
  Json perform(Console& console, const std::string& place) {
    Session& session = console.session();
    check_phase(session, phase, place);
    session.begin_phase(phase);
    return {{"phase", session.protocol().state().phase}};
  }
};

using Kinds = decltype(Phase::kind);

template <std::size_t... kinds>
std::vector<SessionCommand> rows(std::index_sequence<kinds...> /*all*/) {
  return {define<Begin<std::variant_alternative_t<kinds, Kinds>>>(
      {phase_kinds()[kinds].name, kPhaseGroup, phase_kinds()[kinds].sentence,
       phase_kinds()[kinds].example})...};
}

}  // namespace

std::vector<SessionCommand> phase_commands() {
  return rows(std::make_index_sequence<std::variant_size_v<Kinds>>{});
}

}  // namespace quicksand
