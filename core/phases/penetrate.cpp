// The phase "penetrate": an intruder of any shape is driven into the packing.
#include "core/forces/reaction.h"
#include "core/phases/drive.h"
#include "core/placing/placing.h"
#include "core/world/extent.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

class Penetrate final : public DrivePhaseOf<PenetratePhase> {
 public:
  explicit Penetrate(const PenetratePhase& phase)
      : DrivePhaseOf(phase, {.drive = Drive::penetrate,
                             .search = SearchKind::penetrate,
                             .direction = {0, -1, 0},
                             .rate = phase.speed,
                             .load = phase.force,
                             .whole = phase.depth,
                             .window = 0.1}) {}

  void begin(Stage& stage) override {
    require_no_intruder(stage);
    World& world = stage.world;
    stage.form_bonds(settings().bonding, settings().bonds);
    world.bonds.mark_initial();
    stage.state.memory["surface"] = packing_top(world);
    const std::vector<ConvexPart> parts = parts_of(settings().shape);
    const double x = settings().x.value_or(world.box.width / 2);
    const Vec2 place = place_on_surface(world, x, parts);
    const Disk placed{.position = place,
                      .radius = parts.front().radius,
                      .density = settings().density,
                      .role = DiskRole::intruder};
    // A disk alone needs no parts.
    if (std::holds_alternative<DiskIntruder>(settings().shape))
      world.disks.add(placed);
    else
      add_shape(world, placed, parts);
    begin_way(stage, way(stage));
    if (settings().threshold)
      begin_search_on(stage, SearchKind::penetrate, world.intruder(), settings().force);
  }

  bool can_go_on(const Stage& stage) const override {
    return stage.world.intruder() >= 0 && stage.state.memory.contains("surface");
  }

 private:
  // Of the lowest point below the surface as it was. [d]
  double way(const Stage& stage) const override {
    return stage.state.memory.at("surface") - lowest_point(stage.world, stage.world.intruder());
  }
  double resistance(const Stage& stage) const override {
    return reaction_on(stage.world, stage.world.intruder()).force.y();
  }
  double speed(const Stage& stage) const override {
    return speed_of_body(stage.world, stage.world.intruder());
  }
};

}  // namespace

std::unique_ptr<RunningPhase> running(const PenetratePhase& settings) {
  return std::make_unique<Penetrate>(settings);
}

}  // namespace quicksand
