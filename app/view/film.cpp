#include "app/view/film.h"

#include <algorithm>
#include <array>

#include "core/base/whole_file.h"
#include "render/film/animation.h"
#include "render/film/video.h"

namespace quicksand {

View view_of(const Scenario& scenario, View view) {
  view.fit = scenario.box.width > 0 && scenario.box.height > 0 ? Fit::box : Fit::content;
  view.physical = scenario.physical;
  view.expects_intruder =
      std::ranges::any_of(
          scenario.phases,
          [](const Phase& phase) { return std::holds_alternative<PushPhase>(phase.kind); }) ||
      std::ranges::any_of(scenario.disks,
                          [](const Disk& disk) { return disk.role == Role::intruder; });
  view.method =
      scenario.step.nscd ? "NSCD, " + std::to_string(scenario.step.nscd->sweeps) + " sweeps" : "";
  return view;
}

std::string join_frames(const RunFolder& folder) {
  using enum VideoReport::Outcome;
  for (const VideoReport& report : {write_animation(folder.frames(), folder.animation()),
                                    write_video(folder.frames(), folder.film())})
    if (report.outcome == failed) return report.message;
  return {};
}

Film::Film(const RunFolder& folder, const Scenario& scenario, const View& view, std::int64_t first)
    : folder_(folder),
      view_(view_of(scenario, view)),
      title_(scenario.name),
      sequence_(folder.frames(), first),
      secured_(first) {}

void Film::add(const World& world, const std::string& phase) {
  const auto caption = std::to_array<std::string>({title_, phase});
  sequence_.add(renderer_.draw(world, view_, caption));
}

void Film::secure() {
  sequence_.finish();
  if (secured_ == frames()) return;
  for (; secured_ < frames(); ++secured_) bring_to_disk(frame_path(folder_.frames(), secured_));
  bring_to_disk(folder_.frames());
}

std::string Film::finish() {
  sequence_.finish();
  return join_frames(folder_);
}

}  // namespace quicksand
