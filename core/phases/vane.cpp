// The phase "vane": a vane, or the intruder that is there, is turned in the packing.
#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/forces/reaction.h"
#include "core/phases/drive.h"
#include "core/placing/remove_disks.h"
#include "core/world/extent.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

class Vane final : public DrivePhaseOf<VanePhase> {
 public:
  explicit Vane(const VanePhase& phase)
      : DrivePhaseOf(phase, {.drive = Drive::vane,
                             .search = SearchKind::vane,
                             .direction = {0, 0, 1},
                             .rate = phase.angular_velocity,
                             .load = phase.torque,
                             .whole = phase.angle,
                             .window = 0.02}) {}

  void begin(Stage& stage) override {
    World& world = stage.world;
    stage.form_bonds(settings().bonding, settings().bonds);
    if (settings().shape) embed(stage);
    const int intruder = world.intruder();
    const std::string where = "phases[" + std::to_string(stage.state.phase) + "]";
    if (intruder < 0) throw InputError(where, "turns an intruder, but there is none");
    stage.state.memory["start"] = world.disks.angle[intruder];
    begin_way(stage, 0);
    world.disks.applied[intruder].setZero();
    set_free(world, intruder);
    if (settings().threshold) begin_search_on(stage, SearchKind::vane, intruder, settings().torque);
  }

  bool can_go_on(const Stage& stage) const override {
    return stage.world.intruder() >= 0 && stage.state.memory.contains("start");
  }

 private:
  double way(const Stage& stage) const override {
    return stage.world.disks.angle[stage.world.intruder()] - stage.state.memory.at("start");
  }
  double resistance(const Stage& stage) const override {
    return -reaction_on(stage.world, stage.world.intruder()).torque;
  }
  // Of its tips.
  double speed(const Stage& stage) const override {
    return fastest_point(stage.world, stage.world.intruder());
  }

  void embed(Stage& stage) const {
    require_no_intruder(stage);
    World& world = stage.world;
    world.bonds.mark_initial();
    const Vec2 axis(settings().x.value_or(world.box.width / 2),
                    packing_top(world) - settings().depth);
    add_shape(world, {.position = axis, .density = settings().density},
              parts_of(*settings().shape));
    constexpr double kOverlap = 1e-9;  // [d]
    std::vector<Pair> pairs;
    add_shaped_pairs(world, -kOverlap, pairs);
    std::vector<char> marked(static_cast<std::size_t>(world.disks.size()), 0);
    const std::string where = "phases[" + std::to_string(stage.state.phase) + "]";
    for (const Pair& pair : pairs) {
      if (is_wall(pair.b))
        throw InputError(where + ".depth", "puts the vane into a wall; give another depth or x");
      if (!world.movable(pair.a))
        throw InputError(where + ".depth", "puts the vane onto " + message_name(world, pair.a) +
                                               ", which is fixed; give another depth or x");
      marked[static_cast<std::size_t>(pair.a)] = 1;
    }
    const auto in_the_way = std::ranges::count(marked, 1);
    if (in_the_way > 0 && !settings().clear)
      throw InputError(
          where + ".clear",
          "is false, but " + std::to_string(in_the_way) +
              " grains are in the place of the vane; with \"clear\": true they are removed");
    remove_disks(world, marked);
    stage.state.memory["cleared"] = static_cast<double>(in_the_way);
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const VanePhase& settings) {
  return std::make_unique<Vane>(settings);
}

}  // namespace quicksand
