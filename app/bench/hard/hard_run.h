// A small scene that is run as a user's would be: by a protocol of one phase, at the default settings
// of step and solver unless the case says otherwise.
#pragma once

#include "app/bench/bench.h"
#include "core/protocol/protocol.h"
#include "core/scene/scenario.h"

namespace quicksand::bench {

inline constexpr double kRange = 5e-5;    // of bonds, d_c [d]
inline constexpr double kDefault = 1e-6;  // tolerance [1]

struct HardCase {
  std::string name;
  std::function<Row()> run;
};
std::vector<HardCase> structure_cases(const Options& options);  // chains, beams, columns, crystals
std::vector<HardCase> motion_cases(const Options& options);     // slopes, impacts, spins, refusals

// Open sides, no floor, gravity -1 if asked for.
Scenario bare_scene(bool gravity);
// Friction 0.3, rolling friction 0.1, and bonds that hold between touching disks from the beginning.
void bond_all(Scenario& scene, double cohesion);

class HardRun {
 public:
  explicit HardRun(const Scenario& scene);

  // Throws std::runtime_error with the program's own words if a step fails.
  void advance(int steps);
  void run_for(double time);  // rounded to whole steps

  const World& world() const { return protocol_.world(); }
  std::int64_t broken() const { return world().bonds.broken; }
  // How far any disk has come from its place [d].
  double displacement() const;
  Vec3 velocity(int disk) const { return world().disks.velocity[static_cast<std::size_t>(disk)]; }
  Vec2 position(int disk) const { return world().disks.position[static_cast<std::size_t>(disk)]; }
  // Force of the last step in a contact, on its second body; 0 if there is none [F_g].
  Vec2 force(Pair pair) const;
  double load_on_walls() const;  // downward, on all of them [F_g]

  // The answer as a row: right where `right` holds and `off` is at most `allowed`.
  Row answer(const std::string& expected, const std::string& found, double off, double allowed,
             const std::string& unit, bool right = true) const;

 private:
  Protocol protocol_;
  std::vector<Vec2> start_;
  double tolerance_;
  double dt_;
  Seconds seconds_;
};

}  // namespace quicksand::bench
