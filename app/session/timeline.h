// A run that was computed before, or that another process computes, to be walked through: one moment of its history
// is shown, and can be played on.
#pragma once

#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

#include "app/history/history.h"
#include "app/run_folder/run_folder.h"
#include "app/series/quantities.h"
#include "render/base/view.h"
#include "render/layers/common_scales.h"

namespace quicksand {

class Timeline {
 public:
  // Shows the last moment. Throws InputError if the folder has no history, or an empty one.
  Timeline(RunFolder folder, std::size_t most_rows);

  const RunFolder& folder() const { return folder_; }
  const std::vector<Moment>& moments() const { return history_.moments(); }
  std::size_t nearest(double time) const { return history_.nearest(time); }
  std::size_t shown() const { return shown_; }
  const Moment& moment() const { return moments()[shown_]; }
  const World& world() const { return world_; }
  // Of the first moment. Throws as show() does.
  World first_world() const { return history_.world(0); }
  // Of series.csv, for plots.
  const std::vector<Values>& rows() const { return rows_; }

  // Throws InputError if the record is damaged; the shown moment then stays.
  void show(std::size_t k);
  // Takes over what the run has added since; true if there is something. Who shows the end goes on showing it. Throws
  // InputError if something of it cannot be read.
  bool refresh();

  // The view with scales that fit the whole history. Reads what was not read before.
  View with_fixed_scales(const View& view);

  bool playing = false;  // whether each frame of a panel plays on
  double speed = 1;      // samples a frame
  bool loop = false;     // begins again at the end
  void play_frame();

 private:
  struct Scales {
    CommonScales common;
    std::size_t added = 0;  // moments
  };

  RunFolder folder_;
  std::size_t most_rows_;
  History history_;
  std::size_t shown_ = 0;
  World world_;
  std::vector<Values> rows_;
  double on_the_way_ = 0;  // to the next sample [1]
  // The colouring, and whether the view leaves its range and the scale of forces to the data.
  using ScalesFromData = std::tuple<Colouring, bool, bool>;
  std::map<ScalesFromData, Scales> scales_;
};

}  // namespace quicksand
