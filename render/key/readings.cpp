#include "render/key/readings.h"

#include <cmath>

#include "core/measures/measures.h"
#include "render/base/nice_numbers.h"
#include "render/draw/font.h"

namespace quicksand {
namespace {

std::string percent(double share) { return fixed_number(100 * share, 1) + " %"; }

Reading time(const World& world, const View& view) {
  const std::string unit = " √(" + italic("d") + "/" + italic("g") + ")";
  Reading reading{italic("t") + " = " + fixed_number(world.time, 2) + unit,
                  italic("t") + " = 0000.00" + unit};
  if (view.physical && view.physical->gravity > 0) {
    const double second = std::sqrt(view.physical->grain_diameter / view.physical->gravity);
    reading.text += " = " + si_number(world.time * second, "s");
    reading.longest += " = 00.0 ms";
  }
  return reading;
}

Reading depth(const Sample& sample) {
  Reading reading{{}, "intruder depth 000.0 " + italic("d")};
  if (sample.has_intruder)
    reading.text = "intruder depth " + fixed_number(sample.depth, 1) + " " + italic("d");
  return reading;
}

}  // namespace

std::vector<Reading> readings(const World& world, const View& view) {
  const Sample sample = measure(world);
  std::vector<Reading> all{time(world, view)};
  all.push_back({italic("N") + " = " + std::to_string(sample.grains), italic("N") + " = 00000"});
  all.push_back(
      {italic("Z") + " = " + fixed_number(sample.coordination, 2), italic("Z") + " = 0.00"});
  if (sample.volume_fraction) {
    all.push_back(
        {italic("φ") + " = " + fixed_number(*sample.volume_fraction, 3), italic("φ") + " = 0.000"});
  }
  if (!world.bonds.list.empty() || world.grain_law.cohesion_force) {
    const std::optional<double>& active = sample.active_bond_fraction;
    all.push_back(
        {"active share " + (active ? percent(*active) : std::string("-")), "active share 100.0 %"});
  }
  all.push_back(depth(sample));
  if (!world.shapes.empty()) {
    const Reaction& reaction = sample.reaction;
    const std::string force = " " + italic("F") + subscript("g"),
                      torque = force + " " + italic("d");
    all.push_back(
        {"reaction " + short_number(reaction.force.norm()) + force, "reaction 0.000e+00" + force});
    all.push_back(
        {"torque " + short_number(reaction.torque) + torque, "torque −0.000e+00" + torque});
  }
  if (!view.method.empty()) all.push_back({view.method, view.method});
  return all;
}

}  // namespace quicksand
