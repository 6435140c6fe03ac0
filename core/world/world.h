// Everything that is simulated, at one moment.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/bodies/bonds.h"
#include "core/bodies/box.h"
#include "core/bodies/contact_law.h"
#include "core/bodies/contacts.h"
#include "core/bodies/disks.h"
#include "core/bodies/drag.h"
#include "core/bodies/walls.h"
#include "core/shapes/shapes.h"
#include "core/world/intruder_trajectory.h"

namespace quicksand {

struct World {
  Box box;
  std::optional<Vec2> gravity;  // [g]
  std::optional<Drag> drag;
  ContactLaw grain_law, wall_law, intruder_law;
  Disks disks;
  Shapes shapes;
  std::vector<Wall>
      walls;  // the box's floor and two sides, as far as it has them, then the scene's, a piston last
  Bonds bonds;
  bool bonding = false;           // whether first touches form bonds now
  bool rebonding = false;         // ... and so does each touch of a pair whose bond is broken
  std::vector<Contact> contacts;  // of the last step, sorted by pair
  double impulse_dt = 0;          // step that the contacts' impulses belong to [sqrt(d/g)]
  double time = 0;                // [sqrt(d/g)]
  std::int64_t step = 0;
  Random random;
  std::optional<Random> sweep_random;  // of the order of sweeps, from the first that draws on
  // These decide nothing of the future, so they are not in the hash.
  IntruderTrajectory trajectory;
  // Tells specimens apart whose rows are of other bodies, since disks were taken away or replaced; 0 before.
  std::int64_t specimen = 0;

  const ContactLaw& law(Pair pair) const;
  // Centre of b seen from the centre of a, through the nearest periodic image [d] (disks only).
  Vec2 separation(int a, int b) const;
  // x inside [0, width) for periodic sides, otherwise x itself [d].
  double wrapped_x(double x) const;
  // Gap and normal of a pair at the present positions.
  double gap(Pair pair, Vec2* normal = nullptr) const;
  // The gap after all has moved for dt with these velocities (nd + nw).
  double gap_after(Pair pair, const std::vector<Vec3>& velocity, double dt) const;
  // The row in `disks` that a body of a pair has; a wall is itself.
  int row(int body) const {
    return is_disk(body) || is_wall(body)
               ? body
               : shapes.corners[static_cast<std::size_t>(body - kCornerBase)].body;
  }
  // The same where walls follow the disks: in arrays of velocities (nd + nw).
  int velocity_row(int body) const {
    return is_wall(body) ? disks.size() + (body - kWallBase) : row(body);
  }
  Pair rows(Pair pair) const { return {row(pair.a), row(pair.b)}; }
  // Whether forces move a body.
  bool movable(int body) const {
    return is_wall(body) ? wall(body).mass > 0 : !disks.fixed(row(body));
  }
  bool movable(Pair pair) const { return movable(pair.a) || movable(pair.b); }
  const Wall& wall(int body) const { return walls[static_cast<std::size_t>(body - kWallBase)]; }
  // Index of the first intruder, or -1.
  int intruder() const;
};

// The pairs that a bond could hold: they touch within the cohesion range of their law, which has a
// cohesion, and not both are immovable. Sorted.
std::vector<Pair> bondable_pairs(const World& world);

// Index of the last wall that presses from above; -1: there is none.
int pressing_piston(const World& world);

// What messages call a body of a pair, by the scene: body 3, the floor, the left side, walls[0].
std::string message_name(const World& world, int body);

// Takes away the last wall, of which there must be one, with its bonds and contacts. Its bonds do not
// count as broken.
void remove_last_wall(World& world);

// Its disks of these rows are about to be taken away, or others will get their rows: the same change of the same specimen
// makes the same one of it.
void become_another_specimen(World& world, const std::vector<std::uint64_t>& rows = {});

// Whether they differ in nothing that a step reads or changes but the time.
bool same_but_for_time(const World& one, const World& other);

// 64-bit hash of everything that decides the future of the world, bit by bit.
std::uint64_t world_hash(const World& world);

}  // namespace quicksand
