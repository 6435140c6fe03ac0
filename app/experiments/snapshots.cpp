// Pictures of last states. The paper's own colours are not among the facts that we have of it: blue stands for grains
// all of whose bonds are active, red for those with a broken one.
#include <algorithm>
#include <cmath>

#include "app/experiments/experiments.h"
#include "app/run_folder/state_file.h"
#include "app/view/film.h"
#include "core/base/errors.h"
#include "core/measures/measures.h"
#include "render/base/render_error.h"
#include "render/draw/painter.h"
#include "render/image/png.h"
#include "render/picture/renderer.h"

namespace quicksand {

namespace {

constexpr int kWidth = 640, kHeight = 960;

Image in_two_colours(const World& world, const Vec2& box) {
  constexpr Colour kPage = hex(0xFFFFFF), kWhole = hex(0x1F5FBF), kBroken = hex(0xD62728),
                   kLoose = hex(0xB5B5B5), kIntruder = hex(0x14171C), kFrame = hex(0x8C8577);
  constexpr double kMargin = 12;  // [px]
  const double scale =
      std::min((kWidth - 2 * kMargin) / box.x(), (kHeight - 2 * kMargin) / box.y());  // [px/d]
  const double left = (kWidth - scale * box.x()) / 2, floor = (kHeight + scale * box.y()) / 2;
  DrawList list(kWidth, kHeight, kPage);
  list.frame({left - 1, floor - scale * box.y() - 1, scale * box.x() + 2, scale * box.y() + 2}, 1,
             kFrame);
  const NeighbourCounts count = count_neighbours(world);
  for (std::size_t i = 0; i < world.disks.radius.size(); ++i) {
    const Vec2& at = world.disks.position[i];
    // Positions are not wrapped by periodic sides.
    const double x = at.x() - box.x() * std::floor(at.x() / box.x());
    const Colour fill = world.disks.role[i] != Role::grain ? kIntruder
                        : count.broken[i] > 0              ? kBroken
                        : count.active[i] > 0              ? kWhole
                                                           : kLoose;
    list.disk({left + scale * x, floor - scale * at.y()}, scale * world.disks.radius[i], fill);
  }
  return Painter().paint(list);
}

}  // namespace

void add_snapshots(Section& section, const PaperResults& results, const RunGroup& group,
                   const std::filesystem::path& folder, const std::string& caption) {
  const auto runs = results.runs(group);
  if (runs.empty()) return;
  try {
    const RunFolder& run = runs.front()->folder();
    const StateFile state = read_state(run.state());
    const World& world = state.checkpoint.world;
    const View view{.width = kWidth, .height = kHeight, .detail = false};
    std::filesystem::create_directories(folder);
    const std::string text[] = {caption};
    const std::filesystem::path ours = folder / (group.name + ".png"),
                                two = folder / (group.name + "_two_colours.png");
    write_png(ours, Renderer().draw(world, view_of(state.scenario, view), text));
    write_png(two, in_two_colours(world, {state.scenario.box.width, state.scenario.box.height}));
    Gallery gallery;
    gallery.pictures.push_back({.file = ours, .caption = caption + ": active bonds of each grain"});
    gallery.pictures.push_back(
        {.file = two,
         .caption = caption + ": blue, all bonds of a grain active; red, one or more broken"});
    section.add(std::move(gallery));
  } catch (const RenderError&) {
    // A system without a renderer still gets its numbers.
  } catch (const InputError&) {
    // So does one whose runs are of a build with another format of states.
  }
}

}  // namespace quicksand
