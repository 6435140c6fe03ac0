// Scenes that other programs compute too: structures whose answer is known, and their starting states
// as a file that a driver in tests/bench/peers reads.
#pragma once

#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "app/json/json_text.h"
#include "core/scene/scenario.h"

namespace quicksand::bench {

// What a program hands back.
struct PeerState {
  std::vector<Vec2> position;  // (nd) [d]
  std::vector<Vec3> velocity;  // (nd) [sqrt(g d)], [sqrt(g/d)]
  std::vector<Pair> broken;    // bonds
  double resolution = 0;       // of positions, where a program is not of double precision [d]
  double ramp = 0;             // time before the scene's in which gravity rose [sqrt(d/g)]
};

// What the state is worth.
struct Verdict {
  bool right = false;
  double off = 0;  // from the answer, in the unit of the scene
  std::string found;
};

struct PeerScene {
  std::string name;
  std::string expected;  // the answer, and where it is known from
  std::string unit;      // of the error
  Scenario scene;        // without phases
  double time = 1;       // under the full gravity [sqrt(d/g)]
  std::function<Verdict(const PeerScene&, const PeerState&)> assess;

  bool cohesive() const { return scene.grain_law.cohesion_force.has_value(); }
};
std::vector<PeerScene> peer_scenes(const Options& options);

// By the scene's rule; off by the state's resolution at least, as what moves by less seems not to move.
Verdict verdict_on(const PeerScene& scene, const PeerState& state);

// Disks, walls and bonds of the scene's start, laws, and the time. In bonds, walls are -1, -2, ...
Json driver_input(const PeerScene& scene);

// A driver's answer for that scene. Throws std::exception if it is none.
PeerState driver_state(const PeerScene& scene, const Json& answer);

}  // namespace quicksand::bench
