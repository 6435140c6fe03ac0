#include "app/plot/plot_look.h"

#include <array>
#include <cstdio>

#include "render/base/palette.h"

namespace quicksand {

namespace {

constexpr std::size_t kStyles = kCurveColours.size();
// Markers that differ in shape: circle, square, triangle, diamond, triangle downward, pentagon.
constexpr std::array<int, kStyles> kFilled{7, 5, 9, 13, 11, 15};
constexpr std::array<int, kStyles> kOpen{6, 4, 8, 12, 10, 14};
constexpr std::array<const char*, kStyles> kDashes{"solid",      "(16,5)", "(4,4)",
                                                   "(16,4,4,4)", "(8,4)",  "(16,4,4,4,4,4)"};
constexpr const char* kPaperColour = "#000000";
constexpr const char* kPaperDash = "(14,8)";

std::string style_sheet(Colour colour) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02X%02X%02X", colour.r, colour.g, colour.b);
  return text.data();
}

}  // namespace

std::vector<Look> looks_of(const std::vector<Curve>& curves) {
  std::vector<Look> looks;
  std::size_t ours = 0;
  std::size_t papers = 0;
  for (const Curve& curve : curves) {
    if (curve.role == Curve::Role::paper) {
      looks.push_back({kPaperColour, kOpen.at(papers++ % kStyles), kPaperDash});
    } else {
      // A fit belongs to the curve before it.
      const bool fit = curve.role == Curve::Role::fit && ours > 0;
      const std::size_t i = (fit ? ours - 1 : ours++) % kStyles;
      looks.push_back(
          {style_sheet(kCurveColours.at(i)), kFilled.at(i), fit ? "solid" : kDashes.at(i)});
    }
  }
  return looks;
}

std::string with(const Curve& curve, const Look& look, bool x_bars, bool y_bars) {
  const std::string colour = " lc rgb '" + look.colour + "'";
  const std::string marker = " pt " + std::to_string(look.marker) + " ps 1.1";
  const bool fit = curve.role == Curve::Role::fit;
  const std::string stroke = " dt " + look.dash + (fit ? " lw 1.2" : " lw 1.8");
  switch (curve.kind) {
    case Curve::Kind::points:
      if (x_bars) return "with xyerrorbars lw 1.3" + marker + colour;
      if (y_bars) return "with yerrorbars lw 1.3" + marker + colour;
      return "with points lw 1.3" + marker + colour;
    case Curve::Kind::line:
      return "with lines" + stroke + colour;
    case Curve::Kind::line_points:
      if (x_bars) return "with xyerrorlines" + stroke + marker + colour;
      if (y_bars) return "with yerrorlines" + stroke + marker + colour;
      return "with linespoints" + stroke + marker + colour;
    case Curve::Kind::steps:
      return "with steps" + stroke + colour;
    case Curve::Kind::histogram:
      return "with boxes fs transparent solid 0.3 border lw 1.2" + colour;
    default:
      return "with filledcurves fs transparent solid 0.2 noborder" + colour;
  }
}

std::string line_of(const Reference& reference) {
  return reference.role == Reference::Role::guide
             ? std::string(" lw 0.8 dt solid lc rgb '#999999'")
             : std::string(" lw 1.4 dt ") + kPaperDash + " lc rgb '" + kPaperColour + "'";
}
std::string filling_of(const Reference& reference) {
  const bool guide = reference.role == Reference::Role::guide;
  return std::string(" fs transparent solid ") + (guide ? "0.07" : "0.15") + " noborder fc rgb '" +
         kPaperColour + "'";
}

}  // namespace quicksand
