// Colours as the screen takes them: 8-bit sRGB and opacity.
#pragma once

#include <cmath>
#include <cstdint>

namespace quicksand {

struct Colour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Colour&) const = default;
};

// 0xRRGGBB, as colours are written in style sheets.
constexpr Colour hex(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16U), static_cast<std::uint8_t>(rgb >> 8U),
          static_cast<std::uint8_t>(rgb), 255};
}

// Of white 1, by the weights of red, green and blue in sRGB.
constexpr double brightness(Colour c) { return (0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b) / 255; }

// The one of two that stands out more on a ground.
constexpr Colour clearer_on(Colour ground, Colour one, Colour other) {
  const auto apart = [&](Colour c) {
    const double d = brightness(c) - brightness(ground);
    return d < 0 ? -d : d;
  };
  return apart(one) >= apart(other) ? one : other;
}

inline Colour with_alpha(Colour c, double alpha) {
  c.a = static_cast<std::uint8_t>(std::lround(alpha * 255));
  return c;
}

// (1 - t) a + t b, channel by channel.
inline Colour mix(Colour a, Colour b, double t) {
  const auto channel = [t](int x, int y) {
    return static_cast<std::uint8_t>(std::lround((1 - t) * x + t * y));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

}  // namespace quicksand
