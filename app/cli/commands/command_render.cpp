// quicksand render: draws a checkpoint, or moments of a run.
#include <array>
#include <cstdio>
#include <memory>

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
#include "render/image/png.h"
#include "render/picture/renderer.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr auto kRanges = std::to_array<std::string_view>({"history", "moment"});

struct RenderArguments {
  fs::path source;  // checkpoint, or folder of a run
  fs::path out;
  std::optional<double> time;
  bool film = false;
  MomentOptions moments;
  std::optional<std::string> range;
  PictureOptions picture;
};

void require_png(const fs::path& out) {
  if (out.extension() != ".png")
    throw InputError(out.string(), "must end in .png; that is what is written");
}

void render_state(const RenderArguments& options, const View& view) {
  if (options.time || options.film || options.moments.given() || options.range)
    throw InputError(options.source.string(),
                     "is one state; --time, --film, --from, --to and --range need the folder of a "
                     "run");
  require_png(options.out);
  const StateFile state = read_state(options.source);
  const auto caption = std::to_array<std::string>({state.scenario.name, state.phase});
  write_png(options.out,
            Renderer().draw(state.checkpoint.world, view_of(state.scenario, view), caption));
}

// Whether scales are those of the whole history.
bool fixed_scales(const RenderArguments& options) {
  const std::string word = options.range.value_or(std::string(kRanges.front()));
  return named(kRanges, word, std::identity(), "--range " + word, "is no range") == kRanges.front();
}

void render_moment(const RenderArguments& options, const History& history, std::size_t k,
                   const Scenario& scenario, const View& view) {
  const auto caption = std::to_array<std::string>({scenario.name, history.moments()[k].phase_name});
  write_png(options.out, Renderer().draw(history.world(k), view_of(scenario, view), caption));
}

void render_film(const RenderArguments& options, const History& history, const Moments& moments,
                 const Scenario& scenario, const View& view) {
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
  if (write_film_page(folder.film_page(), RunFolder{options.source}, view, moments.first,
                      moments.end) == 0)
    std::fprintf(stderr, "quicksand: no %s: one sample is larger than a page may be\n",
                 folder.film_page().c_str());
}

void render_run(const RenderArguments& options, View view) {
  if (options.time && (options.film || options.moments.given()))
    throw InputError("--time", "draws one moment; a film is from --from to --to");
  if (options.moments.given() && !options.film)
    throw InputError("--from and --to",
                     "are of a film; add --film, or draw one moment with --time");
  if (!options.film) require_png(options.out);
  const bool fixed = fixed_scales(options);
  const History history = history_of(RunFolder{options.source});
  const Scenario scenario = read_scene({RunFolder{options.source}.scene(), {}, {}});
  const Moments moments = moments_between(history, options.moments);
  const std::size_t moment =
      options.time ? moment_at(history, "--time", *options.time) : moments.end - 1;
  if (fixed) view = fixed_over(history, view);
  if (options.film)
    render_film(options, history, moments, scenario, view);
  else
    render_moment(options, history, moment, scenario, view);
}

int render(const RenderArguments& options) {
  const View view = view_from(options.picture);
  std::error_code ignored;
  if (fs::is_directory(options.source, ignored))
    render_run(options, view);
  else
    render_state(options, view);
  std::printf("%s\n", options.out.c_str());
  return kFine;
}

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("render", "Draw a state, or any moment or part of a run again.");
  const auto options = std::make_shared<RenderArguments>();
  command
      ->add_option("source", options->source,
                   "checkpoint, or the folder of a run, finished or still computing")
      ->type_name("STATE.cbor|DIR")
      ->required();
  command
      ->add_option("--out", options->out,
                   "picture to write; with --film, folder that receives frames/, film.png, "
                   "film.mp4 and film.html, a page in which the run plays")
      ->type_name("IMAGE.png|DIR")
      ->required();
  command->option_defaults()->group("Moments of a run");
  command
      ->add_option("--time", options->time,
                   "draw the sample nearest to this time [sqrt(d/g)]; the last one if absent")
      ->type_name("TIME")
      ->check(in_range(between(0, 1e12, "sqrt(d/g)")));
  command->add_flag("--film", options->film, "draw all samples, and join them to a film");
  add_moment_options(*command, options->moments);
  command
      ->add_option(
          "--range", options->range,
          "what the range of colours and the scale of forces fit, where no number is given: "
          "the whole history, or each moment by itself [history]")
      ->type_name("history|moment");
  add_picture_options(*command, options->picture);
  command->footer(
      "Moments come from history.qsh in DIR, nothing is computed again; they are as far apart as\n"
      "the samples of the run. In all pictures of a run the same colour is the same value, and "
      "the\n"
      "same width the same force.\n\n"
      "Examples:\n"
      "  quicksand render out/collapse --time 3.2 --colour pressure --out pressure.png\n"
      "  quicksand render out/collapse --film --from 2 --to 4 --forces --out out/forces");
  return {command, [options] { return render(*options); }};
}

}  // namespace quicksand
