#include "core/world/neighbors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

constexpr double kLeastSkin = 0.25;  // [d], a list serves for about ten steps of a fast scene
// A list looks this much farther than asked for, over that distance, but not farther than so many d: where one
// body flies off, there would be too many pairs of all the others.
constexpr double kFarther = 1.5, kFarthest = 4;
// The skin of a list that serves for no distance, as one that is half made.
constexpr double kNothing = -1;

struct Cell {
  int x = 0, y = 0;
  bool operator==(const Cell&) const = default;
};

// Disks sorted into square cells, cells into hash buckets.
class CellGrid {
 public:
  CellGrid(const World& world, double cell_size) : world_(world) {
    const int nd = world.disks.size();
    periodic_ = world.box.sides == Sides::periodic;
    const double columns = std::clamp(world.box.width / cell_size, 1.0, 1e9);
    columns_ = periodic_ ? static_cast<int>(columns) : 0;
    size_x_ = periodic_ ? world.box.width / columns_ : cell_size;
    size_y_ = cell_size;
    const auto buckets = std::bit_ceil(2 * static_cast<std::size_t>(nd) + 16);
    mask_ = buckets - 1;
    start_.assign(buckets + 1, 0);
    cell_.resize(static_cast<std::size_t>(nd));
    for (int i = 0; i < nd; ++i) {
      cell_[i] = cell_of(world.disks.position[i]);
      ++start_[bucket(cell_[i]) + 1];
    }
    for (std::size_t k = 1; k < start_.size(); ++k) start_[k] += start_[k - 1];
    disk_.resize(static_cast<std::size_t>(nd));
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int i = 0; i < nd; ++i) disk_[next[bucket(cell_[i])]++] = i;
  }

  // Calls visit(j) for each disk in the cells within `reach` of the disk's centre, once each.
  template <class Visit>
  void visit_near(int i, double reach, Visit visit) const {
    // Bodies of a failing run may be so fast that their reach counts more cells than an int holds.
    const auto cells = [&](double size) {
      constexpr double kMost = 1e9;
      return static_cast<int>(reach < kMost * size ? std::ceil(reach / size) : kMost);
    };
    const int nx = cells(size_x_), ny = cells(size_y_);
    const Cell c = cell_[i];
    int first = c.x - nx, last = c.x + nx;
    if (periodic_ && last - first + 1 >= columns_) first = 0, last = columns_ - 1;
    // Far larger than the others, it reaches more cells than there are disks.
    if ((last - first + 1.0) * (2.0 * ny + 1) > static_cast<double>(cell_.size())) {
      for (int j = 0; j < static_cast<int>(cell_.size()); ++j) visit(j);
      return;
    }
    for (int y = c.y - ny; y <= c.y + ny; ++y) {
      for (int x = first; x <= last; ++x) {
        const Cell at{periodic_ ? (x % columns_ + columns_) % columns_ : x, y};
        const std::size_t k = bucket(at);
        for (int s = start_[k]; s < start_[k + 1]; ++s)
          if (cell_[disk_[s]] == at) visit(disk_[s]);
      }
    }
  }

 private:
  Cell cell_of(const Vec2& p) const {
    const auto index = [](double x) {
      return static_cast<int>(std::clamp(std::floor(x), -1e9, 1e9));
    };
    const int x = index(world_.wrapped_x(p.x()) / size_x_);
    return {periodic_ ? std::min(x, columns_ - 1) : x, index(p.y() / size_y_)};
  }
  std::size_t bucket(Cell c) const {
    const std::uint64_t h = static_cast<std::uint32_t>(c.x) * 0x9E3779B97F4A7C15ULL ^
                            static_cast<std::uint32_t>(c.y) * 0xC2B2AE3D27D4EB4FULL;
    return static_cast<std::size_t>(h ^ (h >> 32U)) & mask_;
  }

  const World& world_;
  bool periodic_ = false;
  int columns_ = 0;
  double size_x_ = 1, size_y_ = 1;
  std::size_t mask_ = 0;
  std::vector<int> start_, disk_;
  std::vector<Cell> cell_;
};

}  // namespace

std::vector<Pair> pairs_within(const World& world, double distance, std::size_t enough) {
  const Disks& disks = world.disks;
  const int nd = disks.size();
  std::vector<Pair> pairs;
  if (nd == 0) return pairs;

  // Cells fit the ordinary disks; the few that are much larger look farther themselves, so that one
  // intruder does not make every cell coarse.
  std::vector<double> sorted = disks.radius;
  std::ranges::nth_element(sorted, sorted.begin() + nd / 2);
  const double ordinary = 1.5 * sorted[static_cast<std::size_t>(nd / 2)];
  const double largest = std::ranges::max(disks.radius);
  const auto is_large = [&](int i) { return disks.radius[i] > ordinary; };
  const double apart = std::max(0.0, distance);
  const CellGrid grid(world, 2 * ordinary + apart);
  for (int i = 0; i < nd; ++i) {
    const double reach = disks.radius[i] + (is_large(i) ? largest : ordinary) + apart;
    grid.visit_near(i, reach, [&](int j) {
      const bool mine = is_large(i) == is_large(j) ? i < j : is_large(i);
      if (mine && world.gap({i, j}) <= distance) pairs.push_back({std::min(i, j), std::max(i, j)});
    });
    if (pairs.size() >= enough) break;
  }
  for (int i = 0; i < nd && pairs.size() < enough; ++i)
    for (int k = 0; k < static_cast<int>(world.walls.size()); ++k)
      if (world.gap({i, kWallBase + k}) <= distance) pairs.push_back({i, kWallBase + k});
  if (!world.shapes.empty()) {
    // A shaped body is not the disk of equal area that its row is.
    std::erase_if(pairs, [&](Pair pair) {
      return world.shapes.find(pair.a) || (!is_wall(pair.b) && world.shapes.find(pair.b));
    });
    add_shaped_pairs(world, distance, pairs);
  }
  std::ranges::sort(pairs);
  return pairs;
}

// Whether the list was built for these bodies, and not for another world that was here before.
bool NeighborList::same_bodies(const World& world) const {
  return built_at_.size() <= world.disks.position.size() &&
         std::ranges::equal(radius_, std::span(world.disks.radius).first(radius_.size())) &&
         shapes_ == world.shapes &&
         std::ranges::equal(walls_, world.walls, {}, &Wall::normal, &Wall::normal) &&
         box_ == world.box;
}

bool NeighborList::covers(const World& world, double distance) const {
  if (skin_ < distance || !same_bodies(world)) return false;
  double moved = 0;
  for (std::size_t i = 0; i < built_at_.size(); ++i)
    moved = std::max(moved, (world.disks.position[i] - built_at_[i]).squaredNorm());
  for (std::size_t k = 0; k < walls_.size(); ++k)
    moved = std::max(moved, (world.walls[k].point - walls_[k].point).squaredNorm());
  double farthest = std::sqrt(moved);
  for (std::size_t k = 0; k < angle_.size(); ++k) {
    const ShapedBody& shaped = shapes_.bodies[k];
    const double turned = std::abs(world.disks.angle[shaped.body] - angle_[k]);
    const Vec2 shift = world.disks.position[shaped.body] - built_at_[shaped.body];
    farthest = std::max(farthest, shift.norm() + shaped.arm * turned);
  }
  return distance + 2 * farthest <= skin_;
}

void NeighborList::append_new_disks(const World& world) {
  const double skin = std::exchange(skin_, kNothing);
  // The others may have moved by up to half the skin since the list was built, and may move back.
  const double distance = 1.5 * skin;
  const auto old_size = static_cast<std::ptrdiff_t>(pairs_.size());
  for (int j = static_cast<int>(built_at_.size()); j < world.disks.size(); ++j) {
    for (int i = 0; i < j; ++i)
      if (world.gap({i, j}) <= distance) pairs_.push_back({i, j});
    for (int k = 0; k < static_cast<int>(world.walls.size()); ++k)
      if (world.gap({j, kWallBase + k}) <= distance) pairs_.push_back({j, kWallBase + k});
    built_at_.push_back(world.disks.position[j]);
    radius_.push_back(world.disks.radius[j]);
  }
  std::sort(pairs_.begin() + old_size, pairs_.end());
  std::inplace_merge(pairs_.begin(), pairs_.begin() + old_size, pairs_.end());
  skin_ = skin;
}

const std::vector<Pair>& NeighborList::pairs(const World& world, double distance) {
  // A few new disks are compared with all others; more are worth a new list.
  constexpr int kAppendAtMost = 4;
  const int added = world.disks.size() - static_cast<int>(built_at_.size());
  const bool few_new = added <= (world.shapes.empty() ? kAppendAtMost : 0);
  if (few_new && covers(world, distance)) {
    if (world.disks.size() > static_cast<int>(built_at_.size())) append_new_disks(world);
    return pairs_;
  }
  const double skin = std::max(kLeastSkin, distance + std::min(kFarther * distance, kFarthest));
  skin_ = kNothing;
  pairs_ = pairs_within(world, skin);
  built_at_ = world.disks.position;
  radius_ = world.disks.radius;
  shapes_ = world.shapes;
  angle_.clear();
  for (const ShapedBody& shaped : shapes_.bodies) angle_.push_back(world.disks.angle[shaped.body]);
  walls_ = world.walls;
  box_ = world.box;
  skin_ = skin;
  return pairs_;
}

}  // namespace quicksand
