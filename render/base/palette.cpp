#include "render/base/palette.h"

#include <algorithm>
#include <span>

namespace quicksand {
namespace {

// viridis at multiples of 1/8.
constexpr std::array<Colour, 9> kViridis{hex(0x440154), hex(0x472C7A), hex(0x3B528B),
                                         hex(0x2C718E), hex(0x21918C), hex(0x27AD81),
                                         hex(0x5EC962), hex(0xAADC32), hex(0xFDE725)};

Colour interpolate(std::span<const Colour> anchors, double t) {
  const double x = std::clamp(t, 0.0, 1.0) * static_cast<double>(anchors.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(x), anchors.size() - 2);
  return mix(anchors[i], anchors[i + 1], x - static_cast<double>(i));
}

// The darkest end would sink into a dark background, the brightest one into a white page.
double map_position(Theme theme, double t) {
  t = std::clamp(t, 0.0, 1.0);
  return theme == Theme::dark ? 0.16 + 0.84 * t : 0.97 * t;
}

// Most grains of a loose packing have two or three contacts: there the colours differ most.
constexpr std::array<double, 7> kCountPositions{0, 0.25, 0.48, 0.68, 0.82, 0.91, 1};

std::array<Colour, 7> count_colours(Theme theme) {
  std::array<Colour, 7> colours;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    colours[i] = interpolate(kViridis, map_position(theme, kCountPositions[i]));
  }
  return colours;
}

const Palette kLight{
    .bonds = {hex(0x8A1C30), hex(0xD1582B), hex(0xF0A93B), hex(0x78B0D6), hex(0xC3D8E8)},
    .damage = {hex(0x8A1C30), hex(0xD1582B), hex(0xF0A93B), hex(0xF1E2AE), hex(0xC3D8E8)},
    .counts = count_colours(Theme::light),
    .intruder = hex(0x14171C),
    .intruder_outline = hex(0x000000),
    .wall = hex(0x5E584D),
    .wall_body = hex(0x8C8577),
    .broken = hex(0x5B2BD0),
    .background = hex(0xFFFFFF),
    .ink = hex(0x14171C),
    .faint_ink = hex(0x8A9099),
    .outline = with_alpha(hex(0x14171C), 0.55),
    .compressive = hex(0x14171C),
    .tensile = hex(0xC8281E),
    .no_value = hex(0xD6D6D2),
};

const Palette kDark{
    .bonds = {hex(0xAE2540), hex(0xDE6034), hex(0xF8BE4E), hex(0x4A86B8), hex(0x2B4A6B)},
    .damage = {hex(0xAE2540), hex(0xDE6034), hex(0xF8BE4E), hex(0x6FA287), hex(0x2B4A6B)},
    .counts = count_colours(Theme::dark),
    .intruder = hex(0xC3CAD6),
    .intruder_outline = hex(0xFFFFFF),
    .wall = hex(0x9A948A),
    .wall_body = hex(0x6B675F),
    .broken = hex(0xFF66FF),
    .background = hex(0x0F1319),
    .ink = hex(0xE6EAF0),
    .faint_ink = hex(0x6F7884),
    .outline = with_alpha(hex(0x05070A), 0.7),
    .compressive = hex(0xF2F4F7),
    .tensile = hex(0xFF7A5C),
    .no_value = hex(0x3A3F47),
};

}  // namespace

const Palette& palette(Theme theme) { return theme == Theme::light ? kLight : kDark; }

Colour sequential_map(Theme theme, double t) {
  return interpolate(kViridis, map_position(theme, t));
}

Colour damage_map(Theme theme, double t) { return interpolate(palette(theme).damage, t); }

}  // namespace quicksand
