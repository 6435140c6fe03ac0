#include "app/experiments/experiments.h"
#include "app/run_folder/state_file.h"
#include "app/view/film.h"
#include "core/base/errors.h"
#include "render/base/render_error.h"
#include "render/image/png.h"
#include "render/picture/renderer.h"

namespace quicksand {

void add_snapshots(Section& section, const PaperResults& results, const RunGroup& group,
                   const std::string& caption) {
  const auto runs = results.runs(group);
  if (runs.empty()) return;
  try {
    const RunFolder& run = runs.front()->folder();
    const StateFile state = read_state(run.state());
    const World& world = state.checkpoint.world;
    View view{.width = 640, .height = 960, .detail = false};
    const std::filesystem::path& folder = results.pictures();
    std::filesystem::create_directories(folder);
    const std::string text[] = {caption};
    const std::filesystem::path ours = folder / (group.name + ".png"),
                                two = folder / (group.name + "_two_colours.png");
    write_png(ours, Renderer().draw(world, view_of(state.scenario, view), text));
    view.colouring = Colouring::broken_bonds;
    write_png(two, Renderer().draw(world, view_of(state.scenario, view), text));
    Gallery gallery;
    gallery.pictures.push_back({.file = ours, .caption = caption + ": active bonds of each grain"});
    gallery.pictures.push_back(
        {.file = two, .caption = caption + ": grains all of whose bonds hold, and the others"});
    section.add(std::move(gallery));
  } catch (const RenderError&) {
    // A system without a renderer still gets its numbers.
  } catch (const InputError&) {
    // So does one whose runs are of a build with another format of states.
  }
}

}  // namespace quicksand
