// What belongs to each body, such as its contacts.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/memory.h"

namespace quicksand {

class ByBody {
 public:
  // visit(use) calls use(body, item) for each item, whenever it is called in the same order, which those of a body keep.
  template <class Visit>
  void fill(std::size_t bodies, const Visit& visit) {
    start_.assign(bodies + 2, 0);
    visit([&](int body, int) { ++start_[body + 2]; });
    for (std::size_t k = 2; k < start_.size(); ++k) start_[k] += start_[k - 1];
    set_size(items_, static_cast<std::size_t>(start_.back()));
    // Moves what is the start of a body to its end, the start of the next.
    visit([&](int body, int item) { items_[start_[body + 1]++] = item; });
  }
  std::span<const int> of(std::size_t body) const {
    return {items_.data() + start_[body], items_.data() + start_[body + 1]};
  }
  // Body by body.
  const std::vector<int>& items() const { return items_; }

 private:
  std::vector<int> start_, items_;
};

}  // namespace quicksand
