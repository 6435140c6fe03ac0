#include "render/key/key.h"

#include <algorithm>
#include <cmath>

#include "render/base/nice_numbers.h"
#include "render/key/key_words.h"
#include "render/key/scale_bar.h"
#include "render/layers/network.h"
#include "render/layers/packing.h"
#include "render/layers/shapes.h"

namespace quicksand {
namespace {

double reserved_for(const Font& font, const Reading& reading) {
  return std::max(font.width(reading.longest), font.width(reading.text));
}

// A number in two units that is wider than the picture is broken between them.
std::vector<Reading> parts_of(const Font& font, const Reading& reading, double widest) {
  constexpr std::string_view kEqual = " = ";
  const std::size_t last = reading.text.rfind(kEqual), of_longest = reading.longest.rfind(kEqual);
  if (reserved_for(font, reading) <= widest || last == reading.text.find(kEqual)) return {reading};
  return {{reading.text.substr(0, last), reading.longest.substr(0, of_longest)},
          {reading.text.substr(last + 1), reading.longest.substr(of_longest + 1)}};
}

void add_numbers(Legend& key, const KeyContent& content, double widest, bool all) {
  const Colour ink = palette(content.view.theme).ink;
  Legend::Group captions{.title = {}, .words = {}, .line_each = true};
  for (const std::string& line : content.caption) {
    captions.words.push_back(
        text_word(content.font, with_symbols(cut_to_fit(content.font, line, widest)), widest, ink));
  }
  key.add(std::move(captions));
  Legend::Group numbers{.title = {}, .words = {}, .line_each = true};
  for (const Reading& reading : content.readings) {
    if (reading.text.empty() && !all && !content.view.expects_intruder) continue;
    for (const Reading& part : parts_of(content.font, reading, widest))
      numbers.words.push_back(
          text_word(content.font, part.text, reserved_for(content.font, part), ink));
  }
  key.add(std::move(numbers));
}

void add_colours(Legend& key, const KeyContent& content, bool all) {
  const Palette& colours = palette(content.view.theme);
  Legend::Group group{.title = {text_word(content.font, content.colours.title, colours.ink)},
                      .words = {},
                      .line_each = false};
  for (const Swatch& swatch : content.colours.swatches) {
    group.words.push_back(swatch_word(content.font, content.view.theme, swatch));
  }
  if (content.colours.range)
    group.words.push_back(bar_word(content.font, content.view.theme, content.colours));
  for (const Swatch& swatch : content.colours.others)
    group.words.push_back(swatch_word(content.font, content.view.theme, swatch));
  if (all || content.view.expects_intruder || content.world.intruder() >= 0) {
    group.words.push_back(
        swatch_word(content.font, content.view.theme, {colours.intruder, "intruder"}));
  }
  key.add(std::move(group));
}

Legend::Word arrow_word(const Font& font, const std::string& label, const Vec2& along, Colour ink) {
  const double half = 0.5 * font.size();
  return labelled(font, 2 * half, label, ink, [=](DrawList& list, const Vec2& at) {
    const Vec2 centre = at + Vec2(half, 0);
    const Vec2 tip = centre + half * along;
    list.line(centre - half * along, tip, 1.5, ink, true);
    for (const double side : {-1.0, 1.0}) {
      const Vec2 back = along + side * 0.7 * perpendicular(along);
      list.line(tip, tip - 0.5 * half * back, 1.5, ink, true);
    }
  });
}

// Where gravity does not point down the picture, an arrow says where to.
void add_gravity(Legend& key, const KeyContent& content) {
  const View& view = content.view;
  const std::optional<Vec2> unusual = unusual_gravity(content.world);
  const bool always = view.gravity == GravityWord::always;
  const bool told = view.gravity == GravityWord::unless_down && view.legend && unusual;
  if (!always && !told) return;
  const Font& font = content.font;
  const Colour ink = palette(view.theme).ink;
  const std::string none = italic("g") + " = 0";
  Legend::Word word = has_gravity(content.world)
                          ? arrow_word(font, italic("g"), unusual.value_or(Vec2(0, 1)), ink)
                          : text_word(font, none, ink);
  // Panels with and without gravity have equal rooms.
  if (always) word.width = std::max(word.width, font.width(none));
  word.height = 1.3 * font.size();
  key.add({.title = {}, .words = {std::move(word)}, .line_each = true});
}

// The dashed line, and what lies beyond it.
Legend::Word periodic_word(const Font& font, Theme theme) {
  const Palette& colours = palette(theme);
  const double radius = 0.4 * font.size();
  return labelled(font, std::round(1.3 * font.size()), "periodic side, pale images", colours.ink,
                  [=, size = font.size()](DrawList& list, const Vec2& at) {
                    const double line = std::round(at.x()) + 0.5;
                    list.dashed_line({line, at.y() - size / 2}, {line, at.y() + size / 2}, 1,
                                     std::round(size / 6), colours.ink);
                    list.disk(at + Vec2(0.35 * size + radius, 0), radius,
                              mix(colours.bonds[2], colours.background, kPalingBeyondSides), 1,
                              with_alpha(colours.outline,
                                         (1 - kPalingBeyondSides) * colours.outline.a / 255.0));
                  });
}

void add_lines(Legend& key, const KeyContent& content, double scale, bool all) {
  const Font& font = content.font;
  const View& view = content.view;
  const Palette& colours = palette(view.theme);
  const double length = std::round(1.5 * font.size());
  const auto line = [&](const std::string& label, double width, Colour colour) {
    return labelled(font, length, label, colours.ink, [=](DrawList& list, const Vec2& at) {
      const double inset = std::min(width, length) / 2;
      list.line(at + Vec2(inset, 0), at + Vec2(length - inset, 0), width, colour, true);
    });
  };
  // What cannot occur is not named.
  const bool bonds_occur = view.names_bonds || has_bonds(content.world);
  Legend::Group group{.title = {}, .words = {}, .line_each = true};
  if (view.bonds && bonds_occur)
    group.words.push_back(line("active bond", bond_width(scale), bond_colour(view)));
  if (view.forces) {
    // As wide as the force scale says, or as the round force whose line still suits the text.
    const double per_width = content.force_scale / (kReferenceWidth * scale);
    const double least = 0.5 * per_width, most = font.size() * per_width;
    double force = content.force_scale;
    if (force > most) force = nice_below(most);
    if (force < least) force = nice_above(least);
    const double width = force / per_width;
    const std::string value = short_number(force) + " " + italic("F") + subscript("g");
    for (const bool tensile : {false, true}) {
      if (tensile && !bonds_occur) continue;
      const std::string label = tensile ? " tension" : " compression";
      Legend::Word word =
          line(value + label, width, tensile ? colours.tensile : colours.compressive);
      // The value may change from frame to frame; its room must not.
      word.width = length + font.width("00000 Fg" + label) + 0.35 * font.size();
      group.words.push_back(std::move(word));
    }
  }
  if (view.broken_bonds && bonds_occur && (all || scale >= kLeastScaleOfBars)) {
    group.words.push_back(
        labelled(font, std::round(0.8 * font.size()), "broken bond, still near", colours.ink,
                 [=, &font](DrawList& list, const Vec2& at) {
                   const double half = 0.4 * font.size();
                   const double width = std::clamp(bar_width(scale), 2.0, 0.25 * font.size());
                   list.line(at + Vec2(half, -half + width / 2), at + Vec2(half, half - width / 2),
                             width, colours.broken, true);
                 }));
  }
  if (content.world.box.sides == Sides::periodic && (all || content.sides_in_sight))
    group.words.push_back(periodic_word(font, view.theme));
  // Of a disk what pushes it, of a body of several parts what it meets with.
  if (view.names_reaction || shows_reaction(content.world, scale))
    group.words.push_back(arrow_word(font, "reaction on the intruder", {0, -1}, colours.ink));
  if (view.names_applied_force || shows_applied_force(content.world, scale))
    group.words.push_back(arrow_word(font, "applied force", {0, 1}, colours.ink));
  key.add(std::move(group));
}

}  // namespace

bool has_bonds(const World& world) {
  const auto& laws = {world.grain_law, world.wall_law, world.intruder_law};
  return !world.bonds.list.empty() || std::ranges::any_of(laws, [](const ContactLaw& law) {
    return law.cohesion_force.has_value();
  });
}

bool has_gravity(const World& world) { return world.gravity && world.gravity->norm() > 0; }

std::optional<Vec2> unusual_gravity(const World& world) {
  if (!has_gravity(world)) return {};
  const Vec2 along = Vec2(world.gravity->x(), -world.gravity->y()).normalized();
  if (std::abs(along.x()) < 1e-9 && along.y() > 0) return {};
  return along;
}

Legend make_key(const KeyContent& content, double pixels_per_diameter, double widest, bool all) {
  const Font& font = content.font;
  const View& view = content.view;
  const Colour ink = palette(view.theme).ink;
  Legend key(font.size());
  add_numbers(key, content, widest, all);
  if (view.scale_bar) {
    Legend::Group group{.title = {}, .words = {}, .line_each = true};
    if (content.close_up) group.title.push_back(text_word(font, "Close-up", ink));
    group.words.push_back(scale_bar_word(font, view, pixels_per_diameter));
    key.add(std::move(group));
  }
  if (view.legend) {
    add_colours(key, content, all);
    add_lines(key, content, pixels_per_diameter, all);
  }
  add_gravity(key, content);
  return key;
}

}  // namespace quicksand
