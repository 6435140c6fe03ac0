#include "app/serve/film_page.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/json/base64.h"
#include "app/series/thinning.h"
#include "app/serve/frame_message.h"
#include "app/session/failure_rates.h"
#include "app/session/session.h"
#include "app/web/page_files.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

struct FilmFrame {
  Moment moment;
  std::string text;  // the frame's message in base64
};

void replace_one(std::string& text, std::string_view what, std::string_view by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos)
    throw InputError("assets/web/index.html", "has no " + std::string(what));
  text.replace(at, what.size(), by);
}

// Modules import each other by their bare names, which a map leads to the modules' texts.
std::string import_map(const PageParts& parts) {
  Json imports = Json::object();
  for (const auto& [path, part] : parts) {
    if (!path.ends_with(".js")) continue;
    std::string text = *part.bytes;
    constexpr std::string_view kBeside = "from \"./";
    for (std::size_t at = 0; (at = text.find(kBeside, at)) != std::string::npos;)
      text.erase(at + kBeside.size() - 2, 2);
    imports[path.substr(1)] = "data:text/javascript;charset=utf-8;base64," + base64(text);
  }
  return Json{{"imports", std::move(imports)}}.dump();
}

// JSON in an element of HTML: no letter of it ends the element.
std::string for_html(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char letter : text) letter == '<' ? void(safe += "\\u003c") : safe.push_back(letter);
  return safe;
}

// Everything but the data.
std::string page_around() {
  const PageParts parts = page_files();
  std::string style = *parts.at("/style.css").bytes;
  // The letters are those of the system.
  for (std::size_t at = 0; (at = style.find("@font-face")) != std::string::npos;)
    style.erase(at, style.find('\n', at) + 1 - at);
  std::string page = *parts.at("/index.html").bytes;
  replace_one(page, R"(<link rel="icon" href="icon.svg" type="image/svg+xml">)",
              R"(<link rel="icon" href="data:,">)");
  replace_one(page, R"(<link rel="stylesheet" href="style.css">)", "<style>" + style + "</style>");
  replace_one(page, R"(<script type="module" src="main.js"></script>)",
              "<script type=\"importmap\">" + import_map(parts) +
                  "</script>\n<script type=\"application/json\" id=\"film\"></script>\n"
                  "<script type=\"module\">import \"film.js\";</script>");
  return page;
}

Json data_of(const std::vector<FilmFrame>& frames) {
  std::vector<Moment> moments;
  Json texts = Json::array(), times = Json::array(), phases = Json::array();
  Json names = Json::object();
  moments.reserve(frames.size());
  for (const FilmFrame& frame : frames) {
    moments.push_back(frame.moment);
    texts.push_back(frame.text);
    times.push_back(frame.moment.time);
    phases.push_back(frame.moment.phase);
    names[std::to_string(frame.moment.phase)] = frame.moment.phase_name;
  }
  return {{"shaders", shaders_json()},
          {"frames", std::move(texts)},
          {"run",
           {{"sample_times", std::move(times)},
            {"sample_phases", std::move(phases)},
            {"failure_rates", failure_rates(moments)},
            {"phase_names", std::move(names)}}}};
}

FilmFrame frame_of(const Session& session) {
  const Moment& moment = session.timeline()->moment();
  return {moment, base64(frame_message(session, {{"kind", "frame"},
                                                 {"step", moment.step},
                                                 {"time", moment.time},
                                                 {"bodies", session.world().disks.size()},
                                                 {"scene", session.scenario().name},
                                                 {"phase", moment.phase},
                                                 {"phase_name", moment.phase_name},
                                                 {"follows", session.view.follow},
                                                 {"picked", nullptr}}))};
}

}  // namespace

std::size_t write_film_page(const std::filesystem::path& file, const RunFolder& run,
                            const View& view, std::size_t first, std::size_t end,
                            const FilmPageChoices& choices) {
  // Of a frame besides its text: its quotation marks, time, phase and rate, in digits.
  constexpr std::size_t kAround = 64;
  Session session;
  session.view = view;
  session.scales_of_run = choices.scales_of_run;
  session.open(run.path);
  session.view.window = view.window;
  session.view.follow = view.follow;
  Timeline& timeline = *session.timeline();
  std::string page = page_around();
  const std::size_t fixed = page.size() + for_html(shaders_json()).size() + 4096;
  std::vector<FilmFrame> frames;
  std::size_t stride = 1, bytes = fixed;
  for (std::size_t k = first; k < std::min(end, timeline.moments().size()); ++k) {
    if ((k - first) % stride != 0) continue;
    timeline.show(k);
    frames.push_back(frame_of(session));
    bytes += frames.back().text.size() + kAround;
    while (bytes > choices.most && frames.size() > 1) {
      keep_every_second(frames);
      stride *= 2;
      bytes = fixed;
      for (const FilmFrame& frame : frames) bytes += frame.text.size() + kAround;
    }
  }
  std::filesystem::remove(file);
  if (frames.empty() || bytes > choices.most) return 0;
  replace_one(page, R"(id="film"></script>)",
              "id=\"film\">" + for_html(data_of(frames)) + "</script>");
  write_whole(file, page);
  return frames.size();
}

}  // namespace quicksand
