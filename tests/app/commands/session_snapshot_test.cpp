// How a session's pictures look, from a stored state: an intruder half-way through a small packing.
// A new version of the state's format needs a new mid_way.cbor: deposit `collapse` in 14 x 14 d up to 11 d,
// push until depth 6, save.
#include "tests/support/session_snapshots.h"

namespace quicksand::test {
namespace {

class MidWay : public SessionSnapshots {
 protected:
  void SetUp() override {
    perform({{"command", "view"}, {"width", 360}, {"height", 300}});
    perform({{"command", "restore"}, {"file", "mid_way.cbor"}});
  }
};

TEST_F(MidWay, EachColouring) {
  for (const ColouringInfo& known : colourings()) {
    perform({{"command", "view"}, {"colour", known.name}});
    // Its grains form bonds.
    const Colouring shown =
        known.colouring == Colouring::automatic ? Colouring::active_bonds : known.colouring;
    expect_snapshot("mid_way_" + std::string(info(shown).name));
  }
}

TEST_F(MidWay, TheDarkTheme) {
  perform({{"command", "view"}, {"theme", "dark"}, {"bonds", true}});
  expect_snapshot("mid_way_dark");
}

TEST_F(MidWay, CloserAtTheIntruder) {
  perform({{"command", "camera"}, {"follow", "intruder"}, {"zoom", 2.5}});
  perform({{"command", "view"}, {"legend", false}, {"forces", true}});
  expect_snapshot("mid_way_closer");
}

TEST_F(MidWay, BesideThePanelWithATooltip) {
  perform({{"command", "view"}, {"width", 800}, {"height", 500}});
  perform({{"command", "hover"}, {"widget", "Controls/Reset"}});
  expect_snapshot("mid_way_tooltip", "panel");
}

}  // namespace
}  // namespace quicksand::test
