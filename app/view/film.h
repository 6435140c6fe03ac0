// The frames of a run and the film made of them. Pictures are drawn on one thread and packed on another, while
// the next step is computed.
#pragma once

#include <cstdint>
#include <string>

#include "app/run_folder/run_folder.h"
#include "core/scene/scenario.h"
#include "core/world/world.h"
#include "render/base/view.h"
#include "render/film/background.h"
#include "render/film/sequence.h"

namespace quicksand {

// "NSCD, 100 sweeps": what must be said wherever results of a method are shown that does not solve its steps; empty for
// the exact method.
std::string method_label(const Scenario& scenario);

// The view of a scene's whole box, or of its bodies where the box has no size, with SI units where the
// scene gives physical values.
View view_of(const Scenario& scenario, View view);
// The same for a state by itself, of no film: its key names nothing that is yet to come, or has gone.
View still_of(const Scenario& scenario, View view);

// Joins the frames of a folder: an animation that a browser plays, and a film where there is ffmpeg. Returns what
// went wrong, in a sentence, or nothing.
std::string join_frames(const RunFolder& folder);

class Film {
 public:
  // Frames are numbered from `first`. Throws RenderError if this system cannot draw, InputError if
  // it cannot draw the view, or the folder cannot be written.
  Film(const RunFolder& folder, const Scenario& scenario, const View& view, std::int64_t first);

  // A picture of a copy of the world; waits where drawing is far behind. Throws InputError if an earlier one could
  // not be drawn or written.
  void add(const World& world, const std::string& phase);
  // Waits until the frames so far are on the disk. Throws InputError if one could not be written.
  void secure();
  // Waits for the frames and joins them. Returns what is missing, in a sentence, or nothing.
  std::string finish();

 private:
  struct Moment {
    World world;
    std::string phase;
  };

  void wait();

  RunFolder folder_;
  Sequence sequence_;
  Background<Moment> drawing_;
  std::int64_t secured_;  // frames with smaller numbers are on the disk
};

}  // namespace quicksand
