#include <algorithm>

#include "app/experiments/experiments.h"
#include "app/run_folder/state_file.h"
#include "app/view/film.h"
#include "core/base/errors.h"
#include "core/world/extent.h"
#include "render/base/render_error.h"
#include "render/image/png.h"
#include "render/layers/network.h"
#include "render/picture/renderer.h"

namespace quicksand {

namespace {

// The width, or less where a box is so tall that the picture would be higher than a page.
constexpr int kWidth = 480, kLeastWidth = 400, kTallest = 1400;
constexpr double kText = 18;        // legible where a page has two pictures beside each other [px]
constexpr double kBeyond = 1;       // shown of what lies beyond the sides [d]
constexpr double kAbovePack = 1.5;  // room for the piston [d]

// As wide as the box, as high as the packing: all pictures of one box have one scale.
View view_of_packing(const World& world, const Scenario& scenario) {
  View view = still_of(scenario, {.broken_bonds = false, .text_size = kText});
  const double width = world.box.width + 2 * kBeyond;
  const double scale = std::min(kWidth / width, kTallest / std::max(1.0, world.box.height));
  view.width = std::max(kLeastWidth, static_cast<int>(scale * width));
  view.window = WorldRect{{-kBeyond, 0}, {width - kBeyond, packing_top(world) + kAbovePack}};
  return view;
}

}  // namespace

void add_snapshots(Section& section, const PaperResults& results, const RunGroup& group,
                   const std::string& caption) {
  const auto runs = results.runs(group);
  if (runs.empty()) return;
  try {
    const RunFolder& run = runs.front()->folder();
    const StateFile state = read_state(run.state());
    const World& world = state.checkpoint.world;
    View view = view_of_packing(world, state.scenario);
    const std::filesystem::path& folder = results.pictures();
    std::filesystem::create_directories(folder);
    const std::string text[] = {caption};
    const std::filesystem::path ours = folder / (group.name + ".png"),
                                two = folder / (group.name + "_two_colours.png");
    Renderer renderer;
    view.broken_bonds = view.width >= kLeastScaleOfBars * view.window->size().x();
    write_png(ours, renderer.draw_fitting(world, view, text));
    // Here the colours of the grains say which bonds broke.
    view.broken_bonds = false;
    view.colouring = Colouring::broken_bonds;
    write_png(two, renderer.draw_fitting(world, view, text));
    Gallery gallery;
    gallery.pictures.push_back(
        {.file = ours, .caption = caption + ": number of active bonds of each grain"});
    gallery.pictures.push_back(
        {.file = two, .caption = caption + ": grains whose bonds all hold, and the others"});
    section.add(std::move(gallery));
  } catch (const RenderError&) {
    // A system without a renderer still gets its numbers.
  } catch (const InputError&) {
    // So does one whose runs are of a build with another format of states.
  }
}

}  // namespace quicksand
