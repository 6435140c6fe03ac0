// Walks a list that is sorted by pair beside pairs that ascend.
#pragma once

#include <span>

#include "core/bodies/bonds.h"

namespace quicksand {

template <class Item>
class SortedCursor {
 public:
  explicit SortedCursor(std::span<Item> items) : rest_(items) {}

  // The item of this pair, or null; each pair is asked for once at most. Items of pairs before it that nobody asked
  // for are handed to `skip`.
  template <class Skip>
  Item* at(const Pair& pair, Skip skip) {
    while (!rest_.empty() && rest_.front().pair < pair) skip(next());
    return !rest_.empty() && rest_.front().pair == pair ? &next() : nullptr;
  }
  Item* at(const Pair& pair) {
    return at(pair, [](const Item&) {});
  }
  // The items behind the last pair.
  std::span<Item> rest() const { return rest_; }

 private:
  Item& next() {
    Item& first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }

  std::span<Item> rest_;
};

}  // namespace quicksand
