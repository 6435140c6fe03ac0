#include "core/placing/remove_disks.h"

namespace quicksand {

void remove_disks(World& world, const std::vector<char>& marked) {
  constexpr int kGone = -1;
  const std::size_t nd = marked.size();
  std::vector<int> row(nd);
  int left = 0;
  for (std::size_t i = 0; i < nd; ++i) row[i] = marked[i] ? kGone : left++;

  std::vector<std::uint64_t> taken;
  for (std::size_t i = 0; i < nd; ++i)
    if (marked[i]) taken.push_back(i);
  if (!taken.empty()) become_another_specimen(world, taken);

  const auto compact = [&](auto& values) {
    for (std::size_t i = 0; i < nd; ++i)
      if (row[i] != kGone) values[static_cast<std::size_t>(row[i])] = values[i];
    values.resize(static_cast<std::size_t>(left));
  };
  Disks& disks = world.disks;
  compact(disks.position), compact(disks.angle), compact(disks.velocity), compact(disks.applied);
  compact(disks.radius), compact(disks.mass), compact(disks.inverse_mass), compact(disks.role);
  for (Corner& corner : world.shapes.corners) corner.body = row[corner.body];
  for (ShapedBody& shaped : world.shapes.bodies) shaped.body = row[shaped.body];

  // Rows ascend as before, so pairs stay sorted.
  const auto renumber = [&](int& body) {
    if (is_disk(body)) body = row[body];
    return body != kGone;
  };
  const auto goes = [&](Pair& pair) {
    const bool a = renumber(pair.a), b = renumber(pair.b);
    return !a || !b;
  };
  std::erase_if(world.bonds.list, [&](Bond& bond) {
    if (!goes(bond.pair)) return false;
    world.bonds.initial -= bond.initial ? 1 : 0;
    return true;
  });
  std::erase_if(world.contacts, [&](Contact& contact) { return goes(contact.pair); });
}

}  // namespace quicksand
