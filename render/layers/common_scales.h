// One range of colours and one scale of forces for many moments: what a colour or a width means must not change
// from picture to picture.
#pragma once

#include "core/world/world.h"
#include "render/base/view.h"

namespace quicksand {

class CommonScales {
 public:
  explicit CommonScales(const View& view);

  // Whether the view takes a scale from the data; else there is nothing to add.
  bool needed() const { return colours_ || forces_; }
  void add(const World& world);
  // A view with the widest range and the largest force of what was added, where it has none of its own; where nothing
  // moved or pressed, from the data as before.
  View fixed(View view) const;

 private:
  Colouring colouring_;
  bool colours_, forces_;
  double colour_high_ = 0;
  double force_ = 0;
};

}  // namespace quicksand
