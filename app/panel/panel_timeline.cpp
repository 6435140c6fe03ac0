// Walking through a run that was computed before: its controls, and the strip along the picture's lower edge with its
// phases as coloured spans and the rate at which bonds fail.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/panel/panel_frame.h"
#include "app/session/failure_rates.h"
#include "render/base/nice_numbers.h"
#include "render/base/palette.h"

namespace quicksand::gui {
namespace {

// A run of samples of one phase: [first, end).
struct Span {
  std::size_t first, end;
  int phase;
  std::string name;
};

std::vector<Span> spans_of(const std::vector<Moment>& moments) {
  std::vector<Span> spans;
  for (std::size_t k = 0; k < moments.size(); ++k) {
    if (spans.empty() || spans.back().phase != moments[k].phase)
      spans.push_back({k, k, moments[k].phase, moments[k].phase_name});
    spans.back().end = k + 1;
  }
  return spans;
}

std::string title_of(const Span& span) { return std::to_string(span.phase) + " " + span.name; }

void jump_to_phase(PanelFrame& frame, const Timeline& timeline) {
  std::vector<std::string> names;
  std::string now;
  const std::vector<Span> spans = spans_of(timeline.moments());
  for (const Span& span : spans) {
    names.push_back(title_of(span));
    if (span.first <= timeline.shown()) now = names.back();
  }
  const auto chosen =
      frame.widgets.combo({"phase", "Phase", "Shows the first sample of a phase."}, names, now);
  if (!chosen) return;
  const auto at = std::ranges::find(names, *chosen) - names.begin();
  frame.command("show", {{"phase", spans[static_cast<std::size_t>(at)].phase}});
}

}  // namespace

void show_timeline(PanelFrame& frame) {
  Widgets& w = frame.widgets;
  const Timeline& timeline = *frame.session.timeline();
  if (!w.begin_section("Timeline", true)) return;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float third = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const bool playing = timeline.playing;
  if (w.button({"Back", {}, "One sample back; also by the left arrow."}, third))
    frame.command("show", {{"by", -1}});
  ImGui::SameLine();
  if (w.button({"Play", playing ? "Pause" : "Play", "Also by the space bar."}, third, !playing))
    frame.command("play", {{"on", !playing}});
  ImGui::SameLine();
  if (w.button({"Forward", {}, "One sample forward; also by the right arrow."}, third))
    frame.command("show", {{"by", 1}});
  if (const auto speed =
          w.number({"Speed", {}, "Samples between two pictures of the panel.", "a frame"},
                   timeline.speed, false))
    frame.command("play", {{"on", playing}, {"speed", *speed}});
  if (const auto loop = w.checkbox({"Loop", {}, "Starts over at the end."}, timeline.loop))
    frame.command("play", {{"on", playing}, {"loop", *loop}});
  jump_to_phase(frame, timeline);
  w.reading("Sample", std::to_string(timeline.shown() + 1) + " of " +
                          std::to_string(timeline.moments().size()));
  if (w.button(
          {"Go on from here",
           {},
           "Continues computing from the nearest checkpoint: the run's state, or its beginning."},
          ImGui::GetContentRegionAvail().x))
    frame.command("go_on");
  w.end_section();
}

namespace {

class Strip {
 public:
  Strip(PanelFrame& frame, const PixelRect& rect)
      : frame_(frame),
        w_(frame.widgets),
        timeline_(*frame.session.timeline()),
        list_(ImGui::GetWindowDrawList()),
        small_(w_.fonts().small->FontSize),
        low_(static_cast<float>(rect.x) + w_.px(12), static_cast<float>(rect.y) + w_.px(8)),
        high_(static_cast<float>(rect.right()) - w_.px(12),
              static_cast<float>(rect.bottom()) - w_.px(6) - small_) {}

  void show() {
    ImGui::SetCursorScreenPos(low_);
    ImGui::InvisibleButton("###strip",
                           {std::max(1.0F, high_.x - low_.x), std::max(1.0F, high_.y - low_.y)});
    w_.record("Strip", Widget::Kind::plot, short_number(timeline_.moment().time));
    w_.tooltip("Shows the moment clicked or dragged to; bars: bonds that fail per unit time.");
    if (ImGui::IsItemActive()) take_mouse();
    list_->AddRectFilled(low_, high_, ImGui::GetColorU32(w_.colours().field));
    draw_phases();
    draw_failures();
    draw_axis();
    const float at = std::round(place(timeline_.moment().time));
    list_->AddLine({at, low_.y - w_.px(3)}, {at, high_.y + w_.px(3)}, w_.colours().accent,
                   w_.px(2));
    list_->AddRect(low_, high_, w_.colours().line, 0, 0, w_.px(1));
  }

 private:
  double first() const { return timeline_.moments().front().time; }
  double lasts() const { return std::max(timeline_.moments().back().time - first(), 1e-9); }
  float place(double time) const {
    return low_.x + static_cast<float>((time - first()) / lasts()) * (high_.x - low_.x);
  }

  void take_mouse() {
    const float share =
        std::clamp((ImGui::GetIO().MousePos.x - low_.x) / (high_.x - low_.x), 0.0F, 1.0F);
    const std::size_t k = timeline_.nearest(first() + share * lasts());
    if (k != timeline_.shown()) frame_.command("show", {{"sample", k}});
  }

  void draw_phases() {
    const float band = w_.px(16);
    for (const Span& span : spans_of(timeline_.moments())) {
      const std::vector<Moment>& moments = timeline_.moments();
      const float from = span.first == 0 ? low_.x : place(moments[span.first - 1].time);
      const float to = place(moments[span.end - 1].time);
      const Colour& c =
          kCurveColours[static_cast<std::size_t>(span.phase) % std::size(kCurveColours)];
      list_->AddRectFilled({from, low_.y}, {to, low_.y + band}, IM_COL32(c.r, c.g, c.b, 150));
      list_->AddRectFilled({from, low_.y + band}, {to, high_.y}, IM_COL32(c.r, c.g, c.b, 28));
      const float width = w_.fonts().small->CalcTextSizeA(small_, 1e6F, 0, span.name.c_str()).x;
      if (width + w_.px(8) < to - from)
        list_->AddText(w_.fonts().small, small_, {from + w_.px(4), low_.y + (band - small_) / 2},
                       w_.colours().ink, span.name.c_str());
    }
  }

  // A bar a sample, up to the height of the fastest.
  void draw_failures() {
    const std::vector<Moment>& moments = timeline_.moments();
    const std::vector<double> rates = failure_rates(moments);
    const double most = *std::ranges::max_element(rates);
    const float room = high_.y - low_.y - w_.px(20);
    if (most <= 0 || room <= 0) return;
    for (std::size_t k = 1; k < rates.size(); ++k) {
      if (rates[k] <= 0) continue;
      const float from = place(moments[k - 1].time);
      const float to = std::max(place(moments[k].time), from + w_.px(1));
      const float height = std::max(w_.px(1), room * static_cast<float>(rates[k] / most));
      list_->AddRectFilled({from, high_.y - height}, {to, high_.y}, w_.colours().curve);
    }
    const std::string text = "up to " + short_number(most) + " bonds fail per √(d/g)";
    const float width = w_.fonts().small->CalcTextSizeA(small_, 1e6F, 0, text.c_str()).x;
    list_->AddText(w_.fonts().small, small_, {high_.x - width - w_.px(4), low_.y + w_.px(17)},
                   w_.colours().faint, text.c_str());
  }

  void draw_axis() {
    for (const double tick : nice_ticks({first(), first() + lasts()}, 8)) {
      const std::string text = short_number(tick);
      const float width = w_.fonts().small->CalcTextSizeA(small_, 1e6F, 0, text.c_str()).x;
      const float at = std::clamp(place(tick) - width / 2, low_.x, high_.x - width);
      list_->AddLine({place(tick), high_.y}, {place(tick), high_.y - w_.px(4)}, w_.colours().faint);
      list_->AddText(w_.fonts().small, small_, {std::round(at), high_.y + w_.px(3)},
                     w_.colours().faint, text.c_str());
    }
  }

  PanelFrame& frame_;
  Widgets& w_;
  const Timeline& timeline_;
  ImDrawList* list_;
  float small_;
  ImVec2 low_, high_;
};

}  // namespace

void show_timeline_strip(PanelFrame& frame, const PixelRect& rect) { Strip(frame, rect).show(); }

}  // namespace quicksand::gui
