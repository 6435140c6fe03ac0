// quicksand render: draws a checkpoint, or moments of a run.
#include <array>
#include <cstdio>
#include <memory>
#include <set>
#include <vector>

#include "app/base/exit_code.h"
#include "app/base/nearest_name.h"
#include "app/cli/commands.h"
#include "app/options/moment_options.h"
#include "app/options/number_range.h"
#include "app/options/picture_options.h"
#include "app/run_folder/state_file.h"
#include "app/scene/scene_file.h"
#include "app/serve/film_page.h"
#include "app/view/film.h"
#include "app/view/history_view.h"
#include "core/base/errors.h"
#include "core/base/format.h"
#include "render/image/png.h"
#include "render/picture/renderer.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr auto kRanges = std::to_array<std::string_view>({"history", "moment"});

struct RenderArguments {
  std::vector<fs::path> sources;  // checkpoints, or the folder of a run
  fs::path out;
  std::vector<double> times;
  std::vector<std::string> titles;  // of panels
  bool film = false;
  MomentOptions moments;
  std::optional<std::string> range;
  PictureOptions picture;
};

struct Shown {
  World world;
  std::string scene, phase;
  View view;  // with what its own scene says of units, method and box
  std::string title;
};

// What tells states apart: the names of their files, or of the folders of runs; of their phases, where those are equal.
void name_by_places(const std::vector<fs::path>& places, std::vector<Shown>& shown) {
  std::vector<std::string> names;
  for (const fs::path& place : places) {
    const fs::path file = fs::absolute(place).lexically_normal();
    const bool of_run = file == RunFolder{file.parent_path()}.state();
    names.push_back((of_run ? file.parent_path().filename() : file.stem()).string());
  }
  const bool told_apart = std::set<std::string>(names.begin(), names.end()).size() == names.size();
  for (std::size_t k = 0; k < shown.size(); ++k)
    shown[k].title = told_apart ? names[k] : shown[k].phase;
}

// One picture with the names of scene and phase, or panels a, b, c, each with its title.
void write_picture(const RenderArguments& options, const std::vector<Shown>& shown) {
  require_png(options.out);
  if (options.out.has_parent_path()) make_writable({options.out.parent_path()});
  if (!options.titles.empty() && options.titles.size() != shown.size())
    throw InputError("--titles", "are " + std::to_string(options.titles.size()) +
                                     ", but the picture has " +
                                     count_text(std::ssize(shown), "panel"));
  if (shown.size() == 1 && options.titles.empty()) {
    const auto caption = std::to_array<std::string>({shown[0].scene, shown[0].phase});
    return write_png(options.out, Renderer().draw(shown[0].world, shown[0].view, caption));
  }
  constexpr std::size_t kMostPanels = 26;
  if (shown.size() > kMostPanels)
    throw InputError("a picture of " + std::to_string(shown.size()) + " panels",
                     "has more panels than there are letters; draw a film");
  std::vector<SideBySide> panels;
  panels.reserve(shown.size());
  for (const Shown& one : shown) {
    const std::string letter(1, static_cast<char>('a' + panels.size()));
    const std::string& title = options.titles.empty() ? one.title : options.titles[panels.size()];
    panels.push_back({one.world, one.view, letter + "  " + title});
  }
  write_png(options.out, Renderer().draw_panels(panels));
}

void render_states(const RenderArguments& options, const View& view) {
  if (!options.times.empty() || options.film || options.moments.given() || options.range)
    throw InputError(
        options.sources.front().string(),
        "is a single state; --time, --film, --from, --to and --range need the folder of a "
        "run");
  std::vector<Shown> shown;
  for (const fs::path& source : options.sources) {
    StateFile state = read_state(source);
    shown.push_back({std::move(state.checkpoint.world),
                     state.scenario.name,
                     state.phase,
                     still_of(state.scenario, view),
                     {}});
  }
  name_by_places(options.sources, shown);
  write_picture(options, shown);
}

// Whether scales are those of the whole history.
bool fixed_scales(const RenderArguments& options) {
  const std::string word = options.range.value_or(std::string(kRanges.front()));
  return named(kRanges, word, std::identity(), "--range " + word, "is not a range") ==
         kRanges.front();
}

void render_moments(const RenderArguments& options, const History& history,
                    const std::vector<std::size_t>& moments, const Scenario& scenario,
                    const View& view) {
  std::vector<Shown> shown;
  shown.reserve(moments.size());
  for (const std::size_t k : moments)
    shown.push_back({history.world(k), scenario.name, history.moments()[k].phase_name,
                     view_of(scenario, view), history.moments()[k].phase_name});
  write_picture(options, shown);
}

void render_film(const RenderArguments& options, const History& history, const Moments& moments,
                 const Scenario& scenario, const View& view, bool scales_of_run) {
  const RunFolder folder{options.out};
  if (holds_run(folder))
    throw InputError("--out " + options.out.string(),
                     "holds a run, whose film would be replaced; choose another folder");
  make_writable(folder);
  for (const fs::path& earlier : {folder.film(), folder.animation(), folder.film_page()})
    fs::remove(earlier);
  Film film(folder, scenario, view, 0);
  for (std::size_t k = moments.first; k < moments.end; ++k)
    film.add(history.world(k), history.moments()[k].phase_name);
  if (const std::string problem = film.finish(); !problem.empty())
    throw InputError(options.out.string(), problem);
  if (write_film_page(folder.film_page(), RunFolder{options.sources.front()}, view, moments.first,
                      moments.end, {.scales_of_run = scales_of_run}) == 0)
    std::fprintf(stderr, "quicksand: no %s: a single sample exceeds the size limit of a page\n",
                 folder.film_page().c_str());
}

void render_run(const RenderArguments& options, View view) {
  if (!options.times.empty() && (options.film || options.moments.given()))
    throw InputError("--time", "draws single moments; a film covers --from to --to");
  if (options.moments.given() && !options.film)
    throw InputError("--from and --to",
                     "apply to a film; add --film, or draw one moment with --time");
  if (!options.film) require_png(options.out);
  const bool fixed = fixed_scales(options);
  const History history = history_of(RunFolder{options.sources.front()});
  const Scenario scenario = read_scene({RunFolder{options.sources.front()}.scene(), {}, {}});
  const Moments moments = moments_between(history, options.moments);
  std::vector<std::size_t> shown;
  for (const double time : options.times) shown.push_back(moment_at(history, "--time", time));
  if (shown.empty()) shown.push_back(moments.end - 1);
  if (fixed) view = fixed_over(history, view);
  if (options.film)
    render_film(options, history, moments, scenario, view, fixed);
  else
    render_moments(options, history, shown, scenario, view);
}

int render(const RenderArguments& options) {
  const View view = view_from(options.picture);
  std::error_code ignored;
  if (!fs::is_directory(options.sources.front(), ignored))
    render_states(options, view);
  else if (options.sources.size() == 1)
    render_run(options, view);
  else
    throw InputError(options.sources[1].string(),
                     "follows the folder of a run, but only one run can be drawn; give states, or "
                     "several times of one run");
  std::printf("%s\n", options.out.c_str());
  return kFine;
}

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("render", "Draw a state, or redraw any moment or part of a run.");
  const auto options = std::make_shared<RenderArguments>();
  command
      ->add_option("source", options->sources,
                   "checkpoint, or folder of a run, finished or still running; several checkpoints "
                   "become panels a, b, c")
      ->type_name("STATE.cbor|DIR")
      ->required();
  command
      ->add_option("--out", options->out,
                   "picture to write; with --film, folder for frames/, film.png, film.mp4 and "
                   "film.html, a page that plays the run")
      ->type_name("IMAGE.png|DIR")
      ->required();
  command->option_defaults()->group("Moments of a run");
  command
      ->add_option("--time", options->times,
                   "draw the sample nearest to this time [sqrt(d/g)], or one panel for each of "
                   "several times; the last sample if absent")
      ->type_name("TIME[,TIME]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(in_range(between(0, 1e12, "sqrt(d/g)")));
  command
      ->add_option("--titles", options->titles,
                   "titles of the panels, one each; the names of the states, or the phases of the "
                   "moments, if absent")
      ->type_name("TEXT");
  command->add_flag("--film", options->film, "draw all samples and join them into a film");
  add_moment_options(*command, options->moments);
  command
      ->add_option("--range", options->range,
                   "data that set the colour range and the force scale where no number is given: "
                   "the whole history, or each moment by itself [history]")
      ->type_name("history|moment");
  add_picture_options(*command, options->picture);
  command->footer(
      "Moments are read from history.qsh in DIR, without computing anything again; they are as\n"
      "far apart as the samples of the run. In all pictures of a run the same colour means the\n"
      "same value, and the same width the same force.\n\n"
      "Examples:\n"
      "  quicksand render out/collapse --film --from 2 --to 4 --forces --out out/forces\n"
      "  quicksand render weak.cbor strong.cbor --titles '0.33 F_c' 'F_c' --out both.png");
  return {command, [options] { return render(*options); }};
}

}  // namespace quicksand
