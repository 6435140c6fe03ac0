#include "core/bodies/bonds.h"

#include <algorithm>

#include "core/base/memory.h"

namespace quicksand {

Bond* Bonds::find(Pair pair) {
  const auto at = std::ranges::lower_bound(list, pair, {}, &Bond::pair);
  return at != list.end() && at->pair == pair ? &*at : nullptr;
}

namespace {

void insert(std::vector<Bond>& list, const std::vector<Pair>& pairs) {
  const auto old_size = static_cast<std::ptrdiff_t>(list.size());
  for (const Pair& pair : pairs) append(list, {.pair = pair});
  std::inplace_merge(list.begin(), list.begin() + old_size, list.end(),
                     [](const Bond& p, const Bond& q) { return p.pair < q.pair; });
}

}  // namespace

void Bonds::form(const std::vector<Pair>& pairs) {
  insert(list, pairs);
  formed += static_cast<std::int64_t>(pairs.size());
}

void Bonds::form_again(Bond& bond) {
  bond.state = BondState::active;
  ++formed;
}

void Bonds::heal(const std::vector<Pair>& pairs) {
  std::vector<Pair> unlisted;
  for (const Pair& pair : pairs) {
    if (Bond* bond = find(pair))
      bond->state = BondState::active;
    else
      unlisted.push_back(pair);
  }
  insert(list, unlisted);
  healed += static_cast<std::int64_t>(pairs.size());
}

void Bonds::mark_initial() {
  initial = 0;
  for (Bond& bond : list) {
    bond.initial = bond.state == BondState::active;
    initial += bond.initial ? 1 : 0;
  }
}

}  // namespace quicksand
