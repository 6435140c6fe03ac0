#include "render/picture/side_by_side.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "render/key/key.h"
#include "render/layers/colouring.h"
#include "render/layers/common_scales.h"
#include "render/layers/packing.h"
#include "render/layers/shapes.h"

namespace quicksand {

namespace {

constexpr double kSame = 1e-9;  // rounding of scales and directions that are the same

// One colouring, one range of colours and one force for all.
View with_common_scales(std::span<const SideBySide> panels) {
  View first = panels.front().view;
  const auto by_bonds = std::ranges::find(panels, Colouring::active_bonds, [&](const auto& panel) {
    return colouring_of(panel.world, first);
  });
  first.colouring =
      colouring_of((by_bonds == panels.end() ? panels.front() : *by_bonds).world, first);
  CommonScales scales(first);
  for (const SideBySide& panel : panels) scales.add(panel.world);
  View view = scales.fixed(first);
  view.colours_of_run = first.colours_of_run;
  return view;
}

Frame panel_frame(const SideBySide& panel, View view, const Font& font) {
  view.fit = panel.view.fit;
  view.physical = panel.view.physical;
  view.method = panel.view.method;
  return compose(panel.world, view, font, {&panel.caption, 1});
}

double scale_of(const Frame& panel) { return panel.packing.camera.scale(); }

// The least and the largest scale [px a d].
struct Scales {
  double least, largest;
  bool are_one() const { return largest - least <= kSame * largest; }
};

Scales scales_of(const std::vector<Frame>& panels) {
  const auto [least, largest] = std::ranges::minmax_element(panels, {}, scale_of);
  return {scale_of(*least), scale_of(*largest)};
}

bool have_one_unit(std::span<const SideBySide> panels) {
  return std::ranges::all_of(panels, [&](const SideBySide& panel) {
    return panel.view.physical == panels.front().view.physical;
  });
}

bool have_one_gravity(std::span<const SideBySide> panels) {
  const World& one = panels.front().world;
  const std::optional<Vec2> first = unusual_gravity(one);
  return std::ranges::all_of(panels, [&](const SideBySide& panel) {
    const std::optional<Vec2> own = unusual_gravity(panel.world);
    return has_gravity(panel.world) == has_gravity(one) && own.has_value() == first.has_value() &&
           (!own || (*own - *first).norm() <= kSame);
  });
}

// The world that the key is made for. Of its words, those of periodic sides alone still depend on it.
const World& world_of_key(std::span<const SideBySide> panels) {
  const auto periodic = std::ranges::find(
      panels, Sides::periodic, [](const SideBySide& panel) { return panel.world.box.sides; });
  return (periodic == panels.end() ? panels.front() : *periodic).world;
}

}  // namespace

PanelsOverKey compose_side_by_side(std::span<const SideBySide> panels, const Font& font) {
  View of_key = with_common_scales(panels);
  of_key.text_size = font.size();
  of_key.expects_intruder = std::ranges::any_of(panels, [](const SideBySide& panel) {
    return panel.view.expects_intruder || panel.world.intruder() >= 0;
  });
  of_key.names_bonds =
      std::ranges::any_of(panels, [](const SideBySide& panel) { return has_bonds(panel.world); });
  of_key.names_fixed = std::ranges::any_of(
      panels, [](const SideBySide& panel) { return has_fixed_grains(panel.world); });
  const auto name_arrows = [&](const auto& scale_of_panel) {
    of_key.names_applied_force = of_key.names_reaction = false;
    for (std::size_t k = 0; k < panels.size(); ++k) {
      of_key.names_applied_force |= shows_applied_force(panels[k].world, scale_of_panel(k));
      of_key.names_reaction |= shows_reaction(panels[k].world, scale_of_panel(k));
    }
  };
  // Room for all that may be named, as long as no panel has its scale.
  name_arrows([](std::size_t) { return std::numeric_limits<double>::infinity(); });
  View of_panel = of_key;
  of_key.numbers = false;
  of_panel.legend = of_panel.scale_bar = of_panel.detail = false;
  of_panel.width = of_key.width / static_cast<int>(panels.size());
  if (of_key.legend && !have_one_gravity(panels)) {
    of_key.gravity = GravityWord::none;
    of_panel.gravity = GravityWord::always;
  }
  const World& world = world_of_key(panels);
  std::vector<Frame> frames;
  const auto compose_all = [&] {
    of_panel.height = of_key.height - compose_key(world, of_key, font, 1).height();
    check(of_panel);
    frames.clear();
    for (const SideBySide& panel : panels) frames.push_back(panel_frame(panel, of_panel, font));
  };
  compose_all();
  if (of_key.scale_bar && !(scales_of(frames).are_one() && have_one_unit(panels))) {
    of_panel.scale_bar = true;
    of_key.scale_bar = false;
    compose_all();
  }
  const Scales scales = scales_of(frames);
  if (of_key.forces && !scales.are_one()) {
    const double force = of_key.force_scale > 0 ? of_key.force_scale : 1;
    const double force_per_scale = force / scales.least;
    for (std::size_t k = 0; k < panels.size(); ++k) {
      of_panel.force_scale = force_per_scale * scale_of(frames[k]);
      frames[k] = panel_frame(panels[k], of_panel, font);
    }
    of_key.force_scale = force_per_scale * scales.largest;
  }
  name_arrows([&](std::size_t k) { return scale_of(frames[k]); });
  // The largest scale: bars of broken bonds are named where any panel has them.
  return {std::move(frames), compose_key(world, of_key, font, scales.largest)};
}

}  // namespace quicksand
