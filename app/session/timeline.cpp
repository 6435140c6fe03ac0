#include "app/session/timeline.h"

#include <algorithm>
#include <cmath>

#include "app/series/read_series.h"
#include "app/view/history_view.h"

namespace quicksand {

Timeline::Timeline(RunFolder folder, std::size_t most_rows)
    : folder_(std::move(folder)), most_rows_(most_rows), history_(history_of(folder_)) {
  show(moments().size() - 1);
  rows_ = read_series(folder_.series(), most_rows_);
}

void Timeline::show(std::size_t k) {
  world_ = history_.world(k);
  shown_ = k;
}

bool Timeline::refresh() {
  const bool at_end = shown_ + 1 == moments().size();
  const double time = moment().time;
  const int replacements = history_.replacements();
  if (!history_.refresh()) return false;
  // Records may have been thinned out. Whatever fails from here on, the shown moment is one that is listed.
  shown_ = at_end ? moments().size() - 1 : nearest(time);
  if (history_.replacements() != replacements) scales_.clear();
  show(shown_);
  rows_ = read_series(folder_.series(), most_rows_);
  return true;
}

View Timeline::with_fixed_scales(const View& view) {
  const CommonScales fresh(view);
  if (!fresh.needed()) return view;
  const ScalesFromData from_data{view.colouring, view.colour_high == 0,
                                 view.forces && view.force_scale == 0};
  Scales& scales = scales_.try_emplace(from_data, Scales{fresh}).first->second;
  for (; scales.added < moments().size(); ++scales.added)
    scales.common.add(history_.world(scales.added));
  return scales.common.fixed(view);
}

void Timeline::play_frame() {
  on_the_way_ += speed;
  const double whole = std::floor(on_the_way_);
  on_the_way_ -= whole;
  if (whole == 0) return;
  const std::size_t last = moments().size() - 1;
  const auto samples = static_cast<std::size_t>(whole);
  if (shown_ == last) return loop ? show(0) : void(playing = false);
  show(std::min(last, shown_ + samples));
}

}  // namespace quicksand
