// One range of colours and one scale of forces for many moments: what a colour or a width means must not change
// from picture to picture.
#pragma once

#include <vector>

#include "core/world/world.h"
#include "render/base/view.h"

namespace quicksand {

class CommonScales {
 public:
  explicit CommonScales(const View& view);

  // Whether the view takes a scale from the data; else there is nothing to add.
  bool needed() const { return colours_ || forces_; }
  void add(const World& world);
  // A view with a range and a force that suit what was added, where it has none of its own: nine moments in ten have no
  // wider range and no larger force, since in the scale of a shock nothing else would be seen; of a few moments, none has.
  // Where nothing moved or pressed, they are from the data as before.
  View fixed(View view) const;

 private:
  Colouring colouring_;
  bool colours_, forces_;
  std::vector<double> colour_highs_,
      force_scales_;  // of the moments in which there is something to see
};

}  // namespace quicksand
