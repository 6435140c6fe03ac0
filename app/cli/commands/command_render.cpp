// quicksand render: draws a checkpoint.
#include <cstdio>
#include <memory>

#include "app/base/exit_code.h"
#include "app/cli/commands.h"
#include "app/options/picture_options.h"
#include "app/run_folder/state_file.h"
#include "app/view/film.h"
#include "core/base/errors.h"
#include "render/image/png.h"

namespace quicksand {

namespace {

struct RenderArguments {
  std::filesystem::path state;
  std::filesystem::path out;
  PictureOptions picture;
};

int render(const RenderArguments& options) {
  if (options.out.extension() != ".png")
    throw InputError(options.out.string(), "must end in .png; that is what is written");
  const View view = view_from(options.picture);
  const StateFile state = read_state(options.state);
  const std::string caption[] = {state.scenario.name, state.phase};
  Renderer renderer;
  write_png(options.out,
            renderer.draw(state.checkpoint.world, view_of(state.scenario, view), caption));
  std::printf("%s\n", options.out.c_str());
  return kFine;
}

}  // namespace

Command add_render(CLI::App& program) {
  CLI::App* command = program.add_subcommand("render", "Draw the state of a run.");
  const auto options = std::make_shared<RenderArguments>();
  command->add_option("state", options->state, "checkpoint of a run")
      ->type_name("STATE.cbor")
      ->required();
  command->add_option("--out", options->out, "picture to write")
      ->type_name("IMAGE.png")
      ->required();
  add_picture_options(*command, options->picture);
  command->footer(
      "Examples:\n  quicksand render out/collapse/state.cbor --out collapse.png\n"
      "  quicksand render out/collapse/state.cbor --out collapse.png --theme dark --bonds");
  return {command, [options] { return render(*options); }};
}

}  // namespace quicksand
