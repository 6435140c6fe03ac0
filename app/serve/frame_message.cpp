#include "app/serve/frame_message.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>
#include <vector>

#include "app/serve/binary_message.h"
#include "core/forces/reaction.h"
#include "core/world/shaped_contact.h"
#include "quicksand_shaders.h"
#include "render/base/palette.h"
#include "render/layers/colouring.h"
#include "render/layers/network.h"
#include "render/picture/frame.h"

namespace quicksand {

namespace {

// Indices of a table of colours that holds each once.
class ColourTable {
 public:
  std::uint16_t index_of(Colour c) {
    const std::uint32_t key = std::uint32_t{c.r} << 16U | std::uint32_t{c.g} << 8U | c.b;
    const auto [found, is_new] = index_.try_emplace(key, static_cast<std::uint16_t>(index_.size()));
    if (is_new) rgb_.insert(rgb_.end(), {c.r, c.g, c.b});
    return found->second;
  }
  std::span<const std::uint8_t> rgb() const { return rgb_; }

 private:
  std::unordered_map<std::uint32_t, std::uint16_t> index_;
  std::vector<std::uint8_t> rgb_;
};

Json json_of(Colour c) { return {c.r, c.g, c.b, c.a}; }

Json palette_json(Theme theme) {
  const Palette& p = palette(theme);
  return {{"intruder", json_of(p.intruder)}, {"intruder_outline", json_of(p.intruder_outline)},
          {"wall", json_of(p.wall)},         {"wall_body", json_of(p.wall_body)},
          {"broken", json_of(p.broken)},     {"background", json_of(p.background)},
          {"ink", json_of(p.ink)},           {"faint_ink", json_of(p.faint_ink)},
          {"outline", json_of(p.outline)},   {"compressive", json_of(p.compressive)},
          {"tensile", json_of(p.tensile)}};
}

Json legend_json(const ColourScale& scale, Theme theme) {
  Json legend{{"title", scale.title}};
  Json swatches = Json::array();
  for (const Swatch& swatch : scale.swatches)
    swatches.push_back({json_of(swatch.colour), swatch.label});
  for (const Swatch& swatch : scale.others)
    swatches.push_back({json_of(swatch.colour), swatch.label});
  legend["swatches"] = std::move(swatches);
  if (scale.range && scale.map != nullptr) {
    constexpr int kStops = 9;
    Json bar = Json::array();
    for (int i = 0; i < kStops; ++i)
      bar.push_back(json_of(scale.of_map(theme, static_cast<double>(i) / (kStops - 1))));
    legend["bar"] = std::move(bar);
    legend["range"] = {scale.range->low, scale.range->high};
  }
  return legend;
}

Json walls_json(const World& world) {
  Json walls = Json::array();
  for (const Wall& wall : world.walls)
    walls.push_back({wall.point.x(), wall.point.y(), wall.normal.x(), wall.normal.y(),
                     wall.role == WallRole::piston});
  return walls;
}

// Pairs as the page counts bodies: walls are -1, -2 ... In a pair of a shaped body both are nd + k, and entry k of
// the touches says where its lines begin and end.
class PairNumbers {
 public:
  explicit PairNumbers(const World& world) : world_(world) {}

  std::array<std::int32_t, 2> of(Pair pair) {
    if (!is_shaped(pair)) return {pair.a, is_wall(pair.b) ? -1 - (pair.b - kWallBase) : pair.b};
    const auto [found, is_new] = index_.try_emplace(pair, static_cast<int>(index_.size()));
    if (is_new) add_touch(pair);
    const std::int32_t number = world_.disks.size() + found->second;
    return {number, number};
  }
  // Nine numbers each: start of a line and its vector, middle of the gap, normal, and the smaller radius. [d]
  std::span<const float> touches() const { return touches_; }

 private:
  void add_touch(Pair pair) {
    const PairLine link = link_of(world_, pair);
    const ShapedContact at = shaped_contact(world_, pair);
    const Vec2 middle = link.from + link.along - at.gap / 2 * at.normal;
    const auto [a, b] = world_.rows(pair);
    const double radius = world_.disks.radius[a];
    const double smaller = is_wall(b) ? radius : std::min(radius, world_.disks.radius[b]);
    for (const double x : {link.from.x(), link.from.y(), link.along.x(), link.along.y(), middle.x(),
                           middle.y(), at.normal.x(), at.normal.y(), smaller})
      touches_.push_back(static_cast<float>(x));
  }

  const World& world_;
  std::map<Pair, int> index_;
  std::vector<float> touches_;
};

void add_disks(BinaryMessage& message, const Session& session, const ColouredGrains& grains) {
  const World& world = session.world();
  const auto n = static_cast<std::size_t>(world.disks.size());
  std::vector<float> places(3 * n);  // x, y, radius
  std::vector<std::uint16_t> colours(n);
  ColourTable table;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2& x = world.disks.position[k];
    places[3 * k] = static_cast<float>(world.wrapped_x(x.x()));
    places[3 * k + 1] = static_cast<float>(x.y());
    places[3 * k + 2] = static_cast<float>(world.disks.radius[k]);
    colours[k] = table.index_of(grains.fill[k]);
  }
  message.add("disks", std::span<const float>(places));
  message.add("colour", std::span<const std::uint16_t>(colours));
  message.add("colours", table.rgb());
  if (!session.view.orientation) return;
  const std::vector<double>& angle = world.disks.angle;
  std::vector<float> angles(n);
  for (std::size_t k = 0; k < n; ++k)
    angles[k] = static_cast<float>(std::remainder(angle[k], 2 * std::numbers::pi));
  message.add("angle", std::span<const float>(angles));
}

void add_bonds(BinaryMessage& message, const Session& session, PairNumbers& numbers) {
  const World& world = session.world();
  std::vector<std::int32_t> active, broken;
  for (const Bond& bond : world.bonds.list) {
    const bool holds = bond.state == BondState::active;
    if (holds ? !session.view.bonds
              : !session.view.broken_bonds || !(world.gap(bond.pair) < kStillClose))
      continue;
    for (const std::int32_t number : numbers.of(bond.pair))
      (holds ? active : broken).push_back(number);
  }
  message.add("bonds", std::span<const std::int32_t>(active));
  message.add("broken", std::span<const std::int32_t>(broken));
}

void add_forces(BinaryMessage& message, const Session& session, PairNumbers& numbers) {
  const World& world = session.world();
  if (!session.view.forces || !(world.impulse_dt > 0)) return;
  std::vector<std::int32_t> pairs;
  std::vector<float> forces;
  pairs.reserve(2 * world.contacts.size());
  forces.reserve(world.contacts.size());
  for (const Contact& contact : world.contacts) {
    for (const std::int32_t number : numbers.of(contact.pair)) pairs.push_back(number);
    forces.push_back(static_cast<float>(contact.normal_force(world.impulse_dt)));
  }
  message.add("force_pairs", std::span<const std::int32_t>(pairs));
  message.add("forces", std::span<const float>(forces));
}

Json intruders_json(const World& world) {
  Json intruders = Json::array();
  for (std::size_t k = 0; k < world.disks.role.size(); ++k)
    if (world.disks.role[k] == DiskRole::intruder) intruders.push_back(k);
  return intruders;
}

// Shaped bodies: their parts as they are turned, from the centre, and the force of the contacts on them.
Json shapes_json(const World& world) {
  Json shapes = Json::array();
  for (const ShapedBody& shaped : world.shapes.bodies) {
    const double angle = world.disks.angle[shaped.body];
    const Eigen::Rotation2Dd turn(angle);
    Json parts = Json::array();
    world.shapes.for_each_part([&](std::span<const Corner> part, std::size_t) {
      if (part.front().body != shaped.body) return;
      Json places = Json::array();
      for (const Corner& corner : part) {
        const Vec2 place = turn * corner.place;
        places.push_back({place.x(), place.y()});
      }
      parts.push_back({{"corners", std::move(places)}, {"radius", part.front().radius}});
    });
    const Vec2 force = reaction_on(world, shaped.body).force;
    shapes.push_back({{"body", shaped.body},
                      {"angle", angle},
                      {"reach", shaped.reach()},
                      {"radius", shaped.radius},
                      {"force", {force.x(), force.y()}},
                      {"parts", std::move(parts)}});
  }
  return shapes;
}

// The disks that forces are applied to, with these.
Json applied_json(const World& world) {
  Json applied = Json::array();
  for (std::size_t k = 0; k < world.disks.applied.size(); ++k)
    if (const Vec3& force = world.disks.applied[k]; !force.head<2>().isZero(0))
      applied.push_back({k, force.x(), force.y()});
  return applied;
}

}  // namespace

Json shaders_json() {
  return {{"vertex_head", shaders::kVertexHead},
          {"disk_vertex", shaders::kDiskVertex},
          {"disk_fragment", shaders::kDiskFragment},
          {"segment_vertex", shaders::kSegmentVertex},
          {"segment_fragment", shaders::kSegmentFragment}};
}

Json look_of(const Session& session) {
  const World& world = session.world();
  const View& view = session.view;
  const WorldRect window = view_window(world, session.shown());
  Json look{{"theme", view.theme == Theme::dark ? "dark" : "light"},
            {"method", view.method},
            {"palette", palette_json(view.theme)},
            {"text_size", text_size(view)},
            {"box",
             {{"width", world.box.width},
              {"periodic", world.box.sides == Sides::periodic},
              {"floor", world.box.floor}}},
            {"walls", walls_json(world)},
            {"window", {window.low.x(), window.low.y(), window.high.x(), window.high.y()}},
            {"fitted", !view.window.has_value() && !session.view.follow}};
  // How long d and sqrt(d/g) are.
  if (view.physical) {
    const PhysicalScale& scale = *view.physical;
    look["metres"] = scale.grain_diameter;
    if (scale.gravity > 0) look["seconds"] = std::sqrt(scale.grain_diameter / scale.gravity);
  }
  return look;
}

std::string frame_message(const Session& session, Json head) {
  const View view = session.shown();
  const ColouredGrains grains = colour_grains(session.world(), view);
  BinaryMessage message;
  add_disks(message, session, grains);
  PairNumbers numbers(session.world());
  add_bonds(message, session, numbers);
  add_forces(message, session, numbers);
  if (!session.world().shapes.empty()) {
    message.add("touches", numbers.touches());
    head["shapes"] = shapes_json(session.world());
  }
  head.update(look_of(session));
  head["legend"] = legend_json(grains.scale, view.theme);
  head["intruders"] = intruders_json(session.world());
  head["applied"] = applied_json(session.world());
  head["shows"] = {{"legend", view.legend},
                   {"scale_bar", view.scale_bar},
                   {"numbers", view.numbers},
                   {"orientation", view.orientation}};
  if (view.forces) head["force_scale"] = force_scale(session.world(), view);
  return message.finish(std::move(head));
}

}  // namespace quicksand
