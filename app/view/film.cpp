#include "app/view/film.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "core/base/format.h"
#include "core/base/whole_file.h"
#include "core/scene/validate.h"
#include "render/film/animation.h"
#include "render/film/video.h"
#include "render/picture/frame.h"
#include "render/picture/renderer.h"

namespace quicksand {

namespace {

constexpr std::size_t kLongestQueue = 2;  // worlds in memory that wait to be drawn

}  // namespace

std::string method_label(const Scenario& scenario) {
  return scenario.step.nscd ? "NSCD, " + count_text(scenario.step.nscd->sweeps, "sweep") : "";
}

View view_of(const Scenario& scenario, View view) {
  view.fit = scenario.box.width > 0 && scenario.box.height > 0 ? Fit::box : Fit::content;
  view.physical = scenario.physical;
  view.expects_intruder = std::ranges::any_of(scenario.phases, brings_intruder) ||
                          std::ranges::any_of(scenario.disks, [](const Disk& disk) {
                            return disk.role == DiskRole::intruder;
                          });
  view.names_reaction = std::ranges::any_of(scenario.phases, brings_shaped_intruder);
  view.names_applied_force = std::ranges::any_of(scenario.phases, [](const Phase& phase) {
    return std::holds_alternative<PushPhase>(phase.kind);
  });
  view.method = method_label(scenario);
  return view;
}

View still_of(const Scenario& scenario, View view) {
  view = view_of(scenario, std::move(view));
  view.expects_intruder = view.names_reaction = view.names_applied_force = false;
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
      sequence_(folder.frames(), first),
      drawing_(kLongestQueue,
               [this, view = view_of(scenario, view), title = scenario.name] {
                 check(view);
                 // Shared because a std::function can be copied; no one copies it.
                 return [this, view, title,
                         renderer = std::make_shared<Renderer>()](const Moment& moment) {
                   const auto caption = std::to_array<std::string>({title, moment.phase});
                   sequence_.add(renderer->draw(moment.world, view, caption));
                 };
               }),
      secured_(first) {}

void Film::add(const World& world, const std::string& phase) { drawing_.add({world, phase}); }

void Film::wait() {
  drawing_.finish();
  sequence_.finish();
}

void Film::secure() {
  wait();
  if (secured_ == sequence_.next()) return;
  for (; secured_ < sequence_.next(); ++secured_)
    bring_to_disk(frame_path(folder_.frames(), secured_));
  bring_to_disk(folder_.frames());
}

std::string Film::finish() {
  wait();
  return join_frames(folder_);
}

}  // namespace quicksand
