#include "app/view/history_view.h"

#include "render/layers/common_scales.h"

namespace quicksand {

View fixed_over(const History& history, const View& view) {
  CommonScales scales(view);
  if (scales.needed())
    for (std::size_t k = 0; k < history.moments().size(); ++k) scales.add(history.world(k));
  return scales.fixed();
}

}  // namespace quicksand
