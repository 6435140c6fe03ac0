// Commands that read and check: measure, expect. Those about the session itself: print, include, quit.
#include "app/commands/command_definition.h"
#include "app/export/exporter.h"
#include "app/json/name_field.h"
#include "app/run_folder/measurements.h"
#include "app/run_folder/summary.h"
#include "app/session/condition.h"
#include "app/view/image_comparison.h"
#include "core/base/errors.h"
#include "core/measures/critical_force.h"
#include "render/image/png.h"

namespace quicksand {

namespace {

constexpr std::string_view kCheckGroup = "Checks";

struct Measure {
  std::string quantity;
  std::string folder;

  void describe(Fields& f) {
    f.text({"quantity", "one of `quicksand list quantities`; all if absent"}, quantity);
    describe_output(f,
                    {"folder",
                     "folder in the output folder, for measures.json, profile.csv and "
                     "distributions, as written by quicksand measure"},
                    folder);
    if (!quantity.empty())
      known_in_field(f, "quantity", quantity, quantities(), &Quantity::name, "quantity");
  }
  Json perform(Console& console, const std::string& place) {
    const Session& session = console.session();
    Json result = Json::object();
    if (!quantity.empty()) {
      const auto value = quantity_of(session, quantity, place + ".quantity");
      result[quantity] = value ? Json(*value) : Json(nullptr);
      if (console.print)
        console.print(quantity + (value ? " = " + number_text(*value) : " has no value"));
    } else {
      const Row row = session.measure_now();
      for (const Quantity& known : quantities()) {
        if (!known.of_steps) result[std::string(known.name)] = json_of(known.get(row));
      }
    }
    if (!folder.empty()) {
      constexpr double kSlice = 5;  // [d]
      const auto path = console.output(folder, place + ".folder");
      const StateFile state{{session.world(), session.protocol().state(), {}},
                            session.protocol().scenario(),
                            session.phase_name()};
      const Measurements measured = measure_state(state, {}, kSlice);
      write_measurements(path, measured);
      result["folder"] = path.string();
      if (!measured.profile_left_out.empty())
        result["profile_left_out"] = measured.profile_left_out;
    }
    return result;
  }
};

struct Export {
  std::string format, out;

  void describe(Fields& f) {
    f.text({"format", "vtk, xyz, csv or npy", Presence::required}, format);
    describe_output(f, {"out", "folder, or for xyz file, in the output folder", Presence::required},
                    out);
    if (!f.reading()) return;
    try {
      export_format(format);
    } catch (const InputError& error) {
      f.refuse("format", error.what());
    }
  }
  Json perform(Console& console, const std::string& place) {
    const auto path = console.output(out, place + ".out");
    export_state(console.session().world(), export_format(format), path);
    return {{"out", path.string()}};
  }
};

struct ExpectQuantity {
  Condition condition;

  void describe(Fields& f) { describe_condition(f, condition); }
  Json perform(Console& console, const std::string& place) {
    const auto value = quantity_of(console.session(), condition.quantity, place);
    if (!holds(condition, value))
      throw CommandFailure(condition.quantity + " is " +
                           (value ? number_text(*value) : std::string("not there")) +
                           ", expected " + words_of(condition));
    return {{condition.quantity, *value}};
  }
};

// Of all bodies that the last search has brought to an end.
struct ExpectCriticalForce {
  Condition bounds;

  void describe(Fields& f) { describe_bounds(f, bounds, "F_g; of a vane F_g d"); }
  Json perform(Console& console, const std::string&) {
    const std::vector<CriticalForce>& found = console.session().protocol().state().critical_forces;
    if (found.empty()) throw CommandFailure("no search has found a critical force yet");
    int bodies = 0;
    for (const CriticalForce& force : found) {
      if (force.phase != found.back().phase) continue;
      ++bodies;
      const bool above = !bounds.at_least || force.force_low >= *bounds.at_least;
      const bool below =
          !bounds.at_most || (force.force_high && *force.force_high <= *bounds.at_most);
      if (!above || !below)
        throw CommandFailure("the critical force of body " + std::to_string(force.body) +
                             " lies between " + number_text(force.force_low) + " and " +
                             (force.force_high ? number_text(*force.force_high) : "infinity") +
                             ", expected " + words_of(bounds));
    }
    return {{"bodies", bodies}};
  }
};

struct ExpectHash {
  std::string hash;

  void describe(Fields& f) {
    f.text({"hash",
            "16 hexadecimal digits, as transcripts show them; 0x in front, as in summary.json, is "
            "allowed",
            Presence::required},
           hash);
    constexpr std::size_t kDigits = 16;
    if (f.reading() && hash.starts_with("0x")) hash.erase(0, 2);
    if (f.reading() &&
        (hash.size() != kDigits || hash.find_first_not_of("0123456789abcdef") != std::string::npos))
      f.refuse("hash",
               "is \"" + hash + "\", must be 16 digits from 0 to f, as transcripts show it");
  }
  Json perform(Console& console, const std::string&) {
    const std::string now = world_hash_text(console.session().world());
    if (now != hash)
      throw CommandFailure(
          "the world's hash is " + now + ", expected " + hash +
          "; a different version, compiler or machine computes a different time history");
    return {{"hash", now}};
  }
};

struct ExpectImage {
  std::string image, reference;
  std::int64_t tolerance = kSameLook;

  void describe(Fields& f) {
    describe_input(f, {"image", "PNG written by this session", Presence::required}, image);
    describe_input(f,
                   {"reference", "PNG that it must look like, relative to the command file",
                    Presence::required},
                   reference);
    f.integer({"tolerance", "largest difference allowed in a colour channel of a pixel [1/255]"}, 0,
              255, tolerance);
  }
  Json perform(Console& console, const std::string& place) {
    const ImageComparison result = compare_images(console.input(image), console.beside(reference),
                                                  static_cast<int>(tolerance));
    if (result.same) return {{"worst", result.difference.worst}};
    std::string seen;
    if (result.difference.picture.width > 0) {
      const auto path = console.output(image + ".difference.png", place);
      write_png(path, result.difference.picture);
      seen = "; see " + path.string();
    }
    throw CommandFailure(result.text + seen);
  }
};

constexpr std::string_view kSessionGroup = "Session";

struct Print {
  std::string text;
  void describe(Fields& f) { f.text({"text", "text to print", Presence::required}, text); }
  Json perform(Console& console, const std::string&) {
    if (console.print) console.print(text);
    return {{"text", text}};
  }
};

struct Include {
  std::string file;
  void describe(Fields& f) {
    describe_input(f, {"file", "another session file, relative to this one", Presence::required},
                   file);
  }
  Json perform(Console& console, const std::string& place) {
    console.include(console.beside(file), place + ".file");
    return Json::object();
  }
};

Json quit_session(Console& console) {
  console.quit = true;
  return Json::object();
}

}  // namespace

std::vector<SessionCommand> check_commands() {
  return {
      define<Measure>({"measure", kCheckGroup, "Reports quantities at the current moment.",
                       R"({"command": "measure", "quantity": "coordination"})"}),
      define<Export>({"export", kCheckGroup,
                      "Writes the current state for ParaView, OVITO, spreadsheets or NumPy.",
                      R"({"command": "export", "format": "vtk", "out": "half_way"})"}),
      define<ExpectQuantity>(
          {"expect", kCheckGroup, "Fails unless a quantity lies within bounds.",
           R"({"command": "expect", "quantity": "active_bond_fraction", "at_least": 0.9})"}),
      define<ExpectCriticalForce>(
          {"expect_critical_force", kCheckGroup,
           "Fails unless the intervals that the last search found lie wholly within bounds.",
           R"({"command": "expect_critical_force", "at_least": 900, "at_most": 1100})"}),
      define<ExpectHash>({"expect_hash", kCheckGroup,
                          "Fails unless the world has this hash, bit by bit.",
                          R"({"command": "expect_hash", "hash": "0123456789abcdef"})"}),
      define<ExpectImage>(
          {"expect_image", kCheckGroup,
           "Fails unless a picture looks like a reference; the differences are written beside it.",
           R"({"command": "expect_image", "image": "a.png", "reference": "reference/a.png"})"},
          false)};
}

std::vector<SessionCommand> session_commands_proper() {
  return {
      define<Print>({"print", kSessionGroup, "Prints a text when the session gets to this command.",
                     R"({"command": "print", "text": "the packing stands"})"},
                    false),
      define<Include>({"include", kSessionGroup, "Runs the commands of another file.",
                       R"({"command": "include", "file": "prepare.json"})"},
                      false),
      define<Without<quit_session>>(
          {"quit", kSessionGroup, "Ends the session.", R"({"command": "quit"})"}, false)};
}

}  // namespace quicksand
