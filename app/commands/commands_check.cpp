// Commands that read and check: measure, expect. Those about the session itself: print, include, quit.
#include "app/commands/command_definition.h"
#include "app/export/exporter.h"
#include "app/json/name_field.h"
#include "app/run_folder/measurements.h"
#include "app/run_folder/summary.h"
#include "app/session/condition.h"
#include "app/view/image_comparison.h"
#include "core/base/errors.h"
#include "render/image/png.h"

namespace quicksand {

namespace {

constexpr std::string_view kCheckGroup = "Checks";

struct Measure {
  std::string quantity;
  std::string folder;

  void describe(Fields& f) {
    f.text({"quantity", "one of `quicksand list quantities`; all if absent"}, quantity);
    describe_output(
        f,
        {"folder",
         "in the output folder; receives measures.json, profile.csv and distributions, as "
         "quicksand measure writes them"},
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
    describe_output(
        f, {"out", "in the output folder: a folder, or for xyz a file", Presence::required}, out);
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

struct ExpectHash {
  std::string hash;

  void describe(Fields& f) {
    f.text({"hash", "16 hexadecimal digits, as transcripts show it", Presence::required}, hash);
    constexpr std::size_t kDigits = 16;
    if (f.reading() &&
        (hash.size() != kDigits || hash.find_first_not_of("0123456789abcdef") != std::string::npos))
      f.refuse("hash",
               "is \"" + hash + "\", must be 16 digits from 0 to f, as transcripts show it");
  }
  Json perform(Console& console, const std::string&) {
    const std::string now = world_hash_text(console.session().world());
    if (now != hash)
      throw CommandFailure("the world's hash is " + now + ", expected " + hash +
                           "; another version, compiler or machine computes another time history");
    return {{"hash", now}};
  }
};

struct ExpectImage {
  std::string image, reference;
  std::int64_t tolerance = kSameLook;

  void describe(Fields& f) {
    describe_input(f, {"image", "PNG of this session", Presence::required}, image);
    describe_input(f,
                   {"reference", "PNG that it must look like, relative to the command file",
                    Presence::required},
                   reference);
    f.integer({"tolerance", "largest difference of a channel of a pixel [1/255]"}, 0, 255,
              tolerance);
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
  void describe(Fields& f) { f.text({"text", "what to say", Presence::required}, text); }
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
      define<Measure>({"measure", kCheckGroup, "Tells quantities of the present moment.",
                       R"({"command": "measure", "quantity": "coordination"})"}),
      define<Export>({"export", kCheckGroup,
                      "Writes the present state for ParaView, OVITO, spreadsheets or NumPy.",
                      R"({"command": "export", "format": "vtk", "out": "half_way"})"}),
      define<ExpectQuantity>(
          {"expect", kCheckGroup, "Fails unless a quantity lies within bounds.",
           R"({"command": "expect", "quantity": "active_bond_fraction", "at_least": 0.9})"}),
      define<ExpectHash>({"expect_hash", kCheckGroup,
                          "Fails unless the world is this one, bit by bit.",
                          R"({"command": "expect_hash", "hash": "0123456789abcdef"})"}),
      define<ExpectImage>(
          {"expect_image", kCheckGroup,
           "Fails unless a picture looks like a reference; the differences are written beside it.",
           R"({"command": "expect_image", "image": "a.png", "reference": "reference/a.png"})"},
          false)};
}

std::vector<SessionCommand> session_commands_proper() {
  return {define<Print>({"print", kSessionGroup, "Prints a text when the session gets there.",
                         R"({"command": "print", "text": "the packing stands"})"},
                        false),
          define<Include>({"include", kSessionGroup, "Performs the commands of another file.",
                           R"({"command": "include", "file": "prepare.json"})"},
                          false),
          define<Without<quit_session>>(
              {"quit", kSessionGroup, "Ends the session.", R"({"command": "quit"})"}, false)};
}

}  // namespace quicksand
