// A grain falls on the floor, and the picture is drawn: quicksand as a library, from its installed
// headers. Prints the height of the centre at the end, half a diameter.
#include <cstdio>

#include "core/base/errors.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"
#include "render/image/png.h"
#include "render/picture/renderer.h"

int main() {
  quicksand::Scenario scenario;
  scenario.gravity = quicksand::Vec2(0, -1);
  scenario.box = {.width = 4, .height = 4};
  scenario.disks = {{.position = {2, 3}}};
  scenario.phases = {{quicksand::SettlePhase{.max_time = 10}}};
  try {
    quicksand::validate(scenario);
  } catch (
      const quicksand::InputError& error) {  // such as a grain in the floor, or a negative step
    std::fprintf(stderr, "%s %s\n", error.where().c_str(), error.what());
    return 2;
  }
  quicksand::Protocol protocol(scenario, quicksand::make_world(scenario));
  while (protocol.advance() < quicksand::Progress::finished) {
  }
  quicksand::Renderer renderer;
  quicksand::write_png("grain.png", renderer.draw(protocol.world(), {}));
  std::printf("%.3f\n", protocol.world().disks.position[0].y());
}
