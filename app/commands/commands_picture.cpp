// Commands about pictures: view, camera, pick, snapshot, record.
#include <algorithm>

#include "app/commands/command_definition.h"
#include "app/session/disk_at.h"
#include "app/view/view_fields.h"
#include "core/base/errors.h"
#include "render/base/camera.h"
#include "render/image/png.h"
#include "render/picture/frame.h"

namespace quicksand {

namespace {

constexpr std::string_view kPictureGroup = "Pictures";
struct ViewCommand {
  View view;

  void seed(const Console& console) { view = console.session().view; }
  void describe(Fields& f) { describe_view(f, view); }
  Json perform(Console& console, const std::string& place) {
    try {
      check(view);
    } catch (const InputError& error) {
      throw InputError(place + "." + error.where(), error.what());
    }
    console.session().view = view;
    return Json::object();
  }
};

// A part of a slender box, seen closer, leaves room at its sides: shown as wide as the picture, but no
// wider than the box.
WorldRect widened(WorldRect window, const View& view, const Box& box) {
  const double wide = window.size().y() * view.width / view.height;
  const double more = std::min(wide, box.width) - window.size().x();
  if (more > 0) {
    window.low.x() -= more / 2;
    window.high.x() += more / 2;
  }
  return window;
}

struct CameraCommand {
  int fit = 0;
  std::optional<bool> follow;
  std::optional<double> zoom;
  std::optional<Vec2> at;
  std::optional<WorldRect> window;

  void describe(Fields& f) {
    constexpr std::string_view kFits[] = {"as_before", "box", "content"};
    constexpr std::string_view kFollow[] = {"as_before", "none", "intruder"};
    constexpr double kFar = 1e7;
    f.word({"fit", "shows the whole box, or all bodies"}, kFits, fit);
    int word = follow ? 1 + static_cast<int>(*follow) : 0;
    f.word({"follow", "what to keep in the middle"}, kFollow, word);
    if (word > 0) follow = word == 2;
    f.number({"zoom", "zoom factor; above 1: closer"}, between(1e-3, 1e3, "1"), zoom);
    f.vector({"at", "place that stays fixed while zooming, [x, y]; the middle if absent"},
             between(-kFar, kFar, "d"), at);
    describe_window(f, window);
  }

  Json perform(Console& console, const std::string&) {
    Session& session = console.session();
    View& view = session.view;
    if (fit > 0) {
      view.fit = fit == 1 ? Fit::box : Fit::content;
      view.window.reset();
      session.view.follow = false;
    }
    if (window) view.window = window;
    if (follow) session.view.follow = *follow;
    if (zoom) {
      const WorldRect shown = view_window(session.world(), session.shown());
      const Vec2 fixed = at.value_or((shown.low + shown.high) / 2);
      constexpr double kNearest = 1e-3, kFarthest = 1e7;  // [d]
      const Vec2 size = shown.size() / *zoom;
      if (size.minCoeff() >= kNearest && size.maxCoeff() <= kFarthest)
        view.window =
            widened({fixed + (shown.low - fixed) / *zoom, fixed + (shown.high - fixed) / *zoom},
                    view, session.world().box);
    }
    const WorldRect shown = view_window(session.world(), session.shown());
    return {{"low", {shown.low.x(), shown.low.y()}}, {"high", {shown.high.x(), shown.high.y()}}};
  }
};

struct Pick {
  std::optional<Vec2> at;
  std::int64_t body = -1;

  void describe(Fields& f) {
    f.vector({"at", "the body at this place, [x, y]"}, between(-1e7, 1e7, "d"), at);
    f.integer({"body", "the body with this number; without body and at: none"}, -1, 100'000'000,
              body);
  }
  Json perform(Console& console, const std::string& place) {
    Session& session = console.session();
    const World& world = session.world();
    if (body >= world.disks.size())
      throw InputError(place + ".body", std::to_string(body) + " does not exist; there are " +
                                            std::to_string(world.disks.size()));
    const int found = at ? disk_at(world, *at) : static_cast<int>(body);
    session.picked = found >= 0 ? std::optional(found) : std::nullopt;
    if (found < 0) return {{"body", nullptr}};
    const Vec2& x = world.disks.position[found];
    const Vec3& v = world.disks.velocity[found];
    return {{"body", found},
            {"position", {world.wrapped_x(x.x()), x.y()}},
            {"radius", world.disks.radius[found]},
            {"velocity", {v.x(), v.y()}},
            {"angular_velocity", v.z()}};
  }
};

constexpr std::string_view kWhat[] = {"view", "panel"};

struct Snapshot {
  std::string file;
  int what = 0;
  int width = 0, height = 0;
  std::optional<double> scale;

  void seed(const Console& console) {
    width = console.session().view.width;
    height = console.session().view.height;
  }
  Snapshot() : width(View{}.width), height(View{}.height) {}
  void describe(Fields& f) {
    describe_output(f, {"file", "PNG in the output folder", Presence::required}, file);
    f.word({"what", "the view alone, or the panel with the view beside it"}, kWhat, what);
    describe_size(f, width, height);
    f.number({"scale", "scale of the panel's text and controls"}, between(0.5, 4, "1"), scale);
    if (f.reading() && !file.ends_with(".png")) f.refuse("file", "must end in .png");
  }
  Json perform(Console& console, const std::string& place) {
    if (what == 0 && !console.session().loaded())
      throw CommandFailure("there is no scene to draw; without one, only the panel can be drawn");
    const auto path = console.output(file, place + ".file");
    write_png(path, what == 1 ? console.draw_panel(width, height, scale)
                              : console.draw_view(width, height));
    return {{"file", path.string()}};
  }
};

struct Record {
  bool on = true;
  std::string folder = "recording";
  int what = 0;
  std::optional<double> every;

  void describe(Fields& f) {
    f.flag({"on", "false: ends the recording, with the current moment as its last sample",
            Presence::required},
           on);
    describe_output(f,
                    {"folder",
                     "folder in the output folder, for frames, series.csv, film.png and, with "
                     "ffmpeg, film.mp4"},
                    folder);
    f.word({"what", "the view alone, or the panel with the view beside it"}, kWhat, what);
    f.number({"every", "time between frames; the scene's if absent"}, above(0, 1e9, "sqrt(d/g)"),
             every);
  }
  Json perform(Console& console, const std::string& place) {
    if (!on) {
      if (!console.recording) throw CommandFailure("nothing is being recorded");
      Json result = console.finish_recording();
      console.session().sample_every(std::nullopt);
      return result;
    }
    if (console.recording)
      throw CommandFailure(
          "a recording is under way; end it with {\"command\": \"record\", \"on\": false}");
    if (console.session().timeline())
      throw CommandFailure(
          "a run is shown and nothing is computed that could be recorded; `quicksand render RUN "
          "--film` draws its film, and go_on continues computing from it");
    const auto path = console.output(folder, place + ".folder");
    const bool panel = what == 1;
    console.recording = std::make_unique<Recording>(path, [&console, panel] {
      const View& view = console.session().view;
      return panel ? console.draw_panel(view.width, view.height, std::nullopt)
                   : console.draw_view(view.width, view.height);
    });
    console.session().sample_every(every);
    console.recording->add(console.session().measure_now());
    return {{"folder", path.string()}};
  }
};

}  // namespace

std::vector<SessionCommand> picture_commands() {
  return {
      define<ViewCommand>({"view", kPictureGroup,
                           "Changes how the packing is drawn; what is absent stays as it is.",
                           R"({"command": "view", "colour": "pressure", "theme": "dark"})"},
                          false),
      define<CameraCommand>({"camera", kPictureGroup, "Chooses the part of the world to show.",
                             R"({"command": "camera", "follow": "intruder", "zoom": 3})"}),
      define<Pick>({"pick", kPictureGroup,
                    "Chooses the body that the panel inspects, and reports its state.",
                    R"({"command": "pick", "at": [15, 10]})"}),
      define<Snapshot>(
          {"snapshot", kPictureGroup, "Writes a picture, as large as the view if no size is given.",
           R"({"command": "snapshot", "file": "half_way.png"})"},
          false),
      define<Record>({"record", kPictureGroup, "Starts or stops writing frames and series.csv.",
                      R"({"command": "record", "on": true, "folder": "film", "every": 0.02})"})};
}

}  // namespace quicksand
