// How a world is looked at. Nothing in here changes the physics, and a scene says nothing of it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/types.h"
#include "core/scene/scenario.h"

namespace quicksand {

enum class Theme : std::uint8_t { light, dark };

enum class Colouring : std::uint8_t {
  automatic,
  active_bonds,
  initial_bonds,
  broken_bonds,
  speed,
  pressure,
  coordination
};

struct ColouringInfo {
  Colouring colouring = Colouring::automatic;
  std::string_view name;         // the word of the command line, "active_bonds"
  std::string_view description;  // one line
  std::string_view unit;         // in plain text, "sqrt(g d)"; "1" if none
};
// Every way to colour grains, in the order of the enum.
std::span<const ColouringInfo> colourings();
const ColouringInfo& info(Colouring colouring);
// A rectangle of the world [d].
struct WorldRect {
  Vec2 low{0, 0};
  Vec2 high{0, 0};
  Vec2 size() const { return high - low; }
  bool operator==(const WorldRect&) const = default;
};

struct Range {
  double low = 0;
  double high = 1;
  bool operator==(const Range&) const = default;
};

// What the picture shows when no window is given: the box, the same in every frame, or the bodies.
enum class Fit : std::uint8_t { box, content };

// Whether the key says where gravity points.
enum class GravityWord : std::uint8_t {
  none,
  unless_down,  // as a part of the legend
  always        // even without the legend
};

struct View {
  int width = 1280;  // of the whole picture [px]
  int height = 720;
  Theme theme = Theme::light;
  Colouring colouring = Colouring::automatic;

  bool bonds = false;        // lines along the active bonds
  bool forces = false;       // lines along the contacts, as wide as their normal force
  bool broken_bonds = true;  // bars across the bonds that broke, while their bodies stay close
  bool orientation = false;  // a mark on each disk that turns with it
  bool legend = true;        // what the colours mean
  bool scale_bar = true;
  bool numbers = true;          // time and key numbers
  bool detail = true;           // a close-up of the intruder where a tall box leaves room for it
  bool colours_of_run = false;  // colour_low and _high are of a whole run: the legend says so

  Fit fit = Fit::box;
  // Shown instead of what `fit` finds; keeps a film steady.
  std::optional<WorldRect> window = std::nullopt;
  bool follow =
      false;  // the window is moved so that the intruder, where there is one, is in its middle
  // What the first and the last colour stand for, of a colouring by a value with a unit [its unit]. Both 0: from the data.
  double colour_low = 0;
  double colour_high = 0;
  double force_scale = 0;  // force of a line 0.4 d wide [F_g]; 0: from the data
  // Whether an intruder comes sooner or later: the legend then has its words from the beginning, and nothing in it moves
  // when it comes.
  bool expects_intruder = false;
  // Arrows that the legend names whether this world has any or not: another panel has, or they come.
  bool names_applied_force = false, names_reaction = false;
  bool names_bonds = false;  // the same of bonds, active and broken, and of tension
  bool names_fixed = false;  // and of fixed grains
  GravityWord gravity = GravityWord::unless_down;
  // The time-stepping scheme, where pictures must name it; empty: the exact one.
  std::string method = {};
  // Adds SI units to the scale bar and the time.
  std::optional<PhysicalScale> physical = std::nullopt;
  double text_size = 0;  // [px]; 0: follows from the size of the picture

  bool operator==(const View&) const = default;
};

// Sizes that can be drawn [px].
constexpr int kSmallestPicture = 64;
constexpr int kLargestPicture = 8192;
constexpr double kSmallestText = 6, kLargestText = 100;
// How far from the origin the corners of a window may lie [d].
constexpr double kFarthestWindow = 1e7;

}  // namespace quicksand
