#include "render/layers/colouring.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "render/base/nice_numbers.h"
#include "render/draw/font.h"

namespace quicksand {
namespace {

ColouredGrains by_count(const std::vector<int>& count, std::span<const Colour> colours,
                        std::string title) {
  ColouredGrains grains;
  grains.scale.title = std::move(title);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const bool last = i + 1 == colours.size();
    grains.scale.swatches.push_back({colours[i], std::to_string(i) + (last ? "+" : "")});
  }
  for (const int n : count) {
    grains.fill.push_back(colours[std::min(static_cast<std::size_t>(n), colours.size() - 1)]);
  }
  return grains;
}

ColouredGrains by_value(const World& world, const View& view, const std::string& title) {
  const std::vector<double> values = coloured_values(world, view.colouring);
  const Range range = view.colour_high > 0 ? Range{view.colour_low, view.colour_high}
                                           : range_of(of_grains(world, values));
  ColouredGrains grains;
  grains.scale = {.title = title + (view.colours_of_run ? ", range of the whole run" : ""),
                  .swatches = {},
                  .range = range,
                  .map = &sequential_map};
  for (const double value : values) {
    const double t = (value - range.low) / (range.high - range.low);
    grains.fill.push_back(sequential_map(view.theme, t));
  }
  return grains;
}

// Without the touching neighbours, whose search takes longer than all else of a picture's colours.
NeighbourCounts bonds_of_each(const World& world) {
  return count_neighbours(world, std::span<const Pair>());
}

ColouredGrains by_initial_bonds(const World& world, const View& view) {
  const NeighbourCounts count = bonds_of_each(world);
  const Colour none = palette(view.theme).no_value;
  ColouredGrains grains;
  grains.scale = {.title = "Initial bonds left",
                  .swatches = {},
                  .range = Range{0, 1},
                  .map = &damage_map,
                  .others = {Swatch{none, "had none"}}};
  for (std::size_t i = 0; i < count.initial.size(); ++i) {
    const bool bonded = count.initial[i] > 0;
    const double left =
        bonded ? static_cast<double>(count.initial_active[i]) / count.initial[i] : 0;
    grains.fill.push_back(bonded ? damage_map(view.theme, left) : none);
  }
  return grains;
}

ColouredGrains by_broken_bonds(const World& world, const View& view) {
  const NeighbourCounts count = bonds_of_each(world);
  const Colour holds = kCurveColours[0], broken = kCurveColours[1],
               none = palette(view.theme).no_value;
  ColouredGrains grains;
  grains.scale.title = "Bonds";
  grains.scale.swatches = {{holds, "all hold"}, {broken, "some broken"}, {none, "never any"}};
  for (std::size_t i = 0; i < count.broken.size(); ++i)
    grains.fill.push_back(count.broken[i] > 0 ? broken : count.active[i] > 0 ? holds : none);
  return grains;
}

std::vector<double> speeds(const World& world) {
  std::vector<double> values;
  for (const Vec3& velocity : world.disks.velocity) values.push_back(velocity.head<2>().norm());
  return values;
}

bool is_fixed_grain(const World& world, int disk) {
  return world.disks.fixed(disk) &&
         world.disks.role[static_cast<std::size_t>(disk)] == DiskRole::grain;
}

}  // namespace

std::vector<double> coloured_values(const World& world, Colouring colouring) {
  switch (colouring) {
    case Colouring::speed:
      return speeds(world);
    case Colouring::pressure:
      return contact_pressure(world);
    default:
      return {};
  }
}

std::vector<double> of_grains(const World& world, const std::vector<double>& values) {
  std::vector<double> grains;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (world.disks.role[i] == DiskRole::grain) grains.push_back(values[i]);
  return grains;
}

Range range_of(std::vector<double> values) {
  if (values.empty()) return {0, 1};
  const auto high = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 98 / 100);
  std::nth_element(values.begin(), high, values.end());
  double top = *high;
  // All but a few are zero: then the few are what there is to see.
  if (top <= 0) top = *std::max_element(high, values.end());
  return {0, top > 1e-12 && std::isfinite(top) ? nice_above(top) : 1};
}

double paling_under_forces(const View& view) {
  if (!view.forces) return 0;
  return view.theme == Theme::light ? 0.62 : 0.45;
}

bool has_fixed_grains(const World& world) {
  for (int i = 0; i < world.disks.size(); ++i)
    if (is_fixed_grain(world, i)) return true;
  return false;
}

Colouring colouring_of(const World& world, const View& view) {
  if (view.colouring != Colouring::automatic) return view.colouring;
  return world.grain_law.cohesion_force ? Colouring::active_bonds : Colouring::coordination;
}

namespace {

ColouredGrains in_full_colours(const World& world, const View& view) {
  const Palette& colours = palette(view.theme);
  switch (colouring_of(world, view)) {
    case Colouring::active_bonds:
      return by_count(bonds_of_each(world).active, colours.bonds, "Active bonds");
    case Colouring::coordination:
      return by_count(count_neighbours(world).touching, colours.counts, "Contacts");
    case Colouring::automatic:  // is one of the others
      return {};
    case Colouring::initial_bonds:
      return by_initial_bonds(world, view);
    case Colouring::broken_bonds:
      return by_broken_bonds(world, view);
    case Colouring::speed:
      return by_value(world, view, "Speed " + italic("v") + " / √(" + italic("gd") + ")");
    case Colouring::pressure:
      return by_value(world, view,
                      "Contact pressure " + italic("p") + " / (" + italic("F") + subscript("g") +
                          "/" + italic("d") + ")");
  }
  return {};
}

// Like walls, which they are for the others.
void mark_fixed(const World& world, const View& view, ColouredGrains& grains) {
  const Colour colour = palette(view.theme).wall_body;
  for (int i = 0; i < world.disks.size(); ++i)
    if (is_fixed_grain(world, i)) grains.fill[static_cast<std::size_t>(i)] = colour;
  if (view.names_fixed || has_fixed_grains(world)) grains.scale.others.push_back({colour, "fixed"});
}

}  // namespace

ColouredGrains colour_grains(const World& world, const View& view) {
  ColouredGrains grains = in_full_colours(world, view);
  mark_fixed(world, view, grains);
  ColourScale& scale = grains.scale;
  scale.paling = paling_under_forces(view);
  const auto pale = [&](Colour& colour) {
    colour = mix(colour, palette(view.theme).background, scale.paling);
  };
  std::ranges::for_each(grains.fill, pale);
  for (Swatch& swatch : scale.swatches) pale(swatch.colour);
  for (Swatch& swatch : scale.others) pale(swatch.colour);
  return grains;
}

}  // namespace quicksand
