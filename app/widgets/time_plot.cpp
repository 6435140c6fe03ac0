// A curve over time, with axes, numbers and its last value.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/widgets/widgets.h"
#include "render/base/nice_numbers.h"

namespace quicksand::gui {
namespace {

// Values that can be shown, the logarithm taken.
std::vector<ImVec2> points_of(const Curve& curve) {
  std::vector<ImVec2> points;
  for (std::size_t i = 0; i < curve.y.size(); ++i) {
    const double y = curve.logarithmic ? std::log10(curve.y[i]) : curve.y[i];
    if (std::isfinite(y))
      points.emplace_back(static_cast<float>(curve.x[i]), static_cast<float>(y));
  }
  return points;
}

Range range_of(const std::vector<ImVec2>& points, float ImVec2::*part) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [part](const ImVec2& a, const ImVec2& b) { return a.*part < b.*part; });
  return {static_cast<double>((*low).*part), static_cast<double>((*high).*part)};
}

constexpr double kShortestTime = 1e-2;  // that is shown [sqrt(d/g)]

// At least two ticks inside, and room for a curve that does not change.
Range axis(const Range& data, bool logarithmic) {
  if (logarithmic) {
    const Range decades{std::floor(data.low), std::ceil(data.high)};
    return decades.high > decades.low ? decades : Range{decades.low - 1, decades.low + 1};
  }
  const double size = data.high - data.low;
  const double least = 0.02 * std::max({std::abs(data.low), std::abs(data.high), 0.1});
  const double room = size > least ? 0.08 * size : least;
  return {data.low >= 0 ? std::max(0.0, data.low - room) : data.low - room, data.high + room};
}

std::vector<double> ticks(const Range& range, bool logarithmic) {
  if (!logarithmic) return nice_ticks(range, 3);
  const double every = std::ceil((range.high - range.low) / 3);
  std::vector<double> decades;
  const int count = static_cast<int>((range.high - range.low) / every);
  for (int k = 0; k <= count; ++k) decades.push_back(range.low + k * every);
  return decades;
}

std::string tick_text(double tick, bool logarithmic) {
  return logarithmic ? "1e" + fixed_number(tick, 0) : short_number(tick);
}

}  // namespace

void Widgets::plot_head(const std::string& title, const std::string& unit,
                        const std::string& last) {
  ImGui::TextUnformatted(title.c_str());
  ImGui::SameLine();
  const ImVec2 behind = ImGui::GetCursorScreenPos();
  const float unit_width = this->unit(ImGui::GetWindowDrawList(), behind, unit);
  ImGui::Dummy(ImVec2(unit_width, ImGui::GetTextLineHeight()));
  ImGui::SameLine();
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(last.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, std::floor(room)));
  ImGui::TextUnformatted(last.c_str());
}

void Widgets::plot(const std::string& name, const std::string& title, const Curve& curve) {
  const std::vector<ImVec2> points = points_of(curve);
  const std::string last = points.empty() ? std::string() : short_number(curve.y.back());
  const float small = fonts_.small->FontSize;

  plot_head(title, curve.unit, last);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, px(86));
  ImGui::InvisibleButton(("###" + path(name)).c_str(), size);
  record(name, Widget::Kind::plot, points.empty() ? curve.nothing : last);
  const ImVec2 low(at.x + px(44), at.y + px(3));
  const ImVec2 high(at.x + size.x, at.y + size.y - small - px(4));
  const ImU32 ink = ImGui::GetColorU32(look_->faint), line = ImGui::GetColorU32(look_->line);
  list->AddRectFilled(low, high, ImGui::GetColorU32(look_->field));
  list->AddRect(low, high, line, 0, 0, px(1));
  const auto put = [&](const ImVec2& place, float align, const std::string& text) {
    const float width = fonts_.small->CalcTextSizeA(small, 1e6F, 0, text.c_str()).x;
    const float x = std::min(place.x - align * width, high.x - width);
    list->AddText(fonts_.small, small, {std::round(x), std::round(place.y)}, ink, text.c_str());
  };
  if (points.empty()) {
    const float width = fonts_.small->CalcTextSizeA(small, 1e6F, 0, curve.nothing.c_str()).x;
    put({(low.x + high.x + width) / 2, (low.y + high.y) / 2 - small / 2}, 1, curve.nothing);
    return;
  }

  Range x = range_of(points, &ImVec2::x);
  x.high = std::max(x.high, x.low + kShortestTime);
  x.high += 0.02 * (x.high - x.low);  // the last point is seen whole
  const Range y = axis(range_of(points, &ImVec2::y), curve.logarithmic);
  const auto place_x = [&](double value) {
    return low.x + static_cast<float>((value - x.low) / (x.high - x.low)) * (high.x - low.x);
  };
  const auto place_y = [&](double value) {
    return high.y - static_cast<float>((value - y.low) / (y.high - y.low)) * (high.y - low.y);
  };
  for (const double tick : ticks(y, curve.logarithmic)) {
    const float height = std::round(place_y(tick));
    list->AddLine({low.x, height}, {high.x, height}, line, px(1));
    put({low.x - px(5), height - small / 2}, 1, tick_text(tick, curve.logarithmic));
  }
  for (const double tick : ticks(x, false)) {
    const float place = std::round(place_x(tick));
    list->AddLine({place, high.y}, {place, high.y - px(4)}, ink, px(1));
    put({place, high.y + px(3)}, 0.5F, short_number(tick));
  }
  std::vector<ImVec2> places;
  places.reserve(points.size());
  for (const ImVec2& point : points) places.emplace_back(place_x(point.x), place_y(point.y));
  list->PushClipRect(low, high, true);
  const ImU32 colour = ImGui::GetColorU32(look_->curve);
  list->AddPolyline(places.data(), static_cast<int>(places.size()), colour, 0, px(1.5F));
  if (curve.cursor) {
    const float place = std::round(place_x(*curve.cursor));
    list->AddLine({place, low.y}, {place, high.y}, ImGui::GetColorU32(look_->accent), px(1.5F));
  }
  list->PopClipRect();
  list->AddCircleFilled(places.back(), px(3), colour);
}

}  // namespace quicksand::gui
