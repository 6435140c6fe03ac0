#include "core/world/ballistic.h"

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"

namespace quicksand {

namespace {

// The captured disk after it was drawn to what captured it.
Vec2 drawn_in(const World& world, const Landing& met, double radius, double capture) {
  if (is_wall(met.touched)) return met.centre - capture * world.wall(met.touched).normal;
  Vec2 apart = met.centre - world.disks.position[met.touched];
  apart.x() -= world.box.image_shift(apart.x());
  const double touching = radius + world.disks.radius[met.touched];
  return met.centre - capture / (touching + capture) * apart;
}

bool in_a_side_wall(const World& world, const Vec2& centre, double radius) {
  return std::ranges::any_of(world.walls, [&](const Wall& wall) {
    return !is_floor(wall) && wall.normal.dot(centre - wall.point) < radius;
  });
}

}  // namespace

LandingSite::LandingSite(const World& world) : world_(world) {
  if (!world.shapes.empty())
    throw InputError("the state",
                     "has an intruder of several parts; grains cannot be dropped on it");
  constexpr double kMostStrips = 1e6;
  first_.assign(static_cast<std::size_t>(std::clamp(world.box.width, 1.0, kMostStrips)), -1);
  // Where sides are periodic, strips repeat with the box.
  if (world.box.width > 0) strip_ = world.box.width / static_cast<double>(first_.size());
  for (int i = 0; i < world.disks.size(); ++i) add(i);
}

template <class Visit>
void LandingSite::visit_strips(double x, double reach, Visit visit) const {
  constexpr double kRounding = 1e-6;  // of x, once around the box [d]
  const auto strips = static_cast<double>(first_.size());
  const double low = std::floor((x - reach - kRounding) / strip_);
  const double high = std::floor((x + reach + kRounding) / strip_);
  const double begin = std::fmod(low, strips);
  auto strip = static_cast<std::size_t>(begin < 0 ? begin + strips : begin);
  for (auto left = static_cast<std::size_t>(std::min(high - low + 1, strips)); left > 0; --left) {
    visit(strip);
    strip = strip + 1 == first_.size() ? 0 : strip + 1;
  }
}

void LandingSite::add(int disk) {
  constexpr double kMostStripsOfOne = 16;
  const double radius = world_.disks.radius[disk];
  if (2 * radius > kMostStripsOfOne * strip_) {
    wide_.push_back(disk);
    return;
  }
  visit_strips(world_.disks.position[disk].x(), radius, [&](std::size_t strip) {
    entries_.push_back({disk, first_[strip]});
    first_[strip] = static_cast<int>(entries_.size()) - 1;
  });
}

// Where the disk is when it first comes within `capture` of a body, and of which.
std::optional<Landing> LandingSite::first_met(double x, double radius, double capture) const {
  std::optional<Landing> highest;
  const auto offer = [&](double y, int body) {
    if (!highest || y > highest->centre.y()) highest = Landing{.centre = {x, y}, .touched = body};
  };
  for (std::size_t k = 0; k < world_.walls.size(); ++k) {
    const Wall& wall = world_.walls[k];
    if (!is_floor(wall)) continue;
    const double along = wall.normal.x() * (x - wall.point.x());
    offer(wall.point.y() + (radius + capture - along) / wall.normal.y(),
          kWallBase + static_cast<int>(k));
  }
  const auto offer_disk = [&](int i) {
    double dx = x - world_.disks.position[i].x();
    dx -= world_.box.image_shift(dx);
    const double reach = radius + world_.disks.radius[i] + capture;
    if (std::abs(dx) >= reach) return;
    const double y = world_.disks.position[i].y() + std::sqrt(reach * reach - dx * dx);
    // Of equally high disks the first one counts, whatever the order of the strips.
    if (highest && y == highest->centre.y() && i < highest->touched && !is_wall(highest->touched))
      highest->touched = i;
    offer(y, i);
  };
  std::ranges::for_each(wide_, offer_disk);
  visit_strips(x, radius + capture, [&](std::size_t strip) {
    for (int e = first_[strip]; e >= 0; e = entries_[e].next) offer_disk(entries_[e].disk);
  });
  return highest;
}

std::optional<Landing> LandingSite::land(double x, double radius, double capture) const {
  std::optional<Landing> landing = first_met(x, radius, capture);
  if (!landing || capture == 0) return landing;
  landing->centre = drawn_in(world_, *landing, radius, capture);
  if (in_a_side_wall(world_, landing->centre, radius)) return first_met(x, radius, 0);
  return landing;
}

}  // namespace quicksand
