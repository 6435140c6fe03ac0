#include "render/key/legend.h"

#include <algorithm>

namespace quicksand {
namespace {

// In units of the text's size.
constexpr double kWordGap = 0.9;
constexpr double kGroupGap = 1.6;      // across, in a strip
constexpr double kParagraphGap = 0.9;  // down, in a column
constexpr double kLineGap = 0.28;

}  // namespace

void Legend::add(Group group) {
  if (!group.words.empty()) groups_.push_back(std::move(group));
}

double Legend::width_of(const Group& group) const {
  double width = 0;
  for (const Word& title : group.title) width += title.width + kWordGap * em_;
  for (const Word& word : group.words) width += word.width + kWordGap * em_;
  return width - kWordGap * em_;
}

// Sets the words line by line; a line is as high as its highest word. Returns the height of all.
double Legend::flow(double width, bool column, const Visit& visit) const {
  struct Placed {
    const Word* word;
    double x;
  };
  std::vector<Placed> line;
  double x = 0, y = 0;
  const auto end_line = [&](double gap) {
    if (line.empty()) return;
    double height = 0;
    for (const Placed& placed : line) height = std::max(height, placed.word->height);
    for (const Placed& placed : line) visit(*placed.word, {placed.x, y + height / 2});
    y += height + gap;
    x = 0;
    line.clear();
  };
  const double line_gap = kLineGap * em_;
  const auto place = [&](const Word& word, double gap) {
    if (!line.empty() && x + gap + word.width > width) end_line(line_gap);
    if (!line.empty()) x += gap;
    line.push_back({&word, x});
    x += word.width;
  };
  for (const Group& group : groups_) {
    if (column) {
      end_line(0);
      if (y > 0) y += kParagraphGap * em_;
    } else if (x + kGroupGap * em_ + width_of(group) > width) {
      // What belongs together begins on a new line rather than being broken.
      end_line(line_gap);
    }
    bool first = group.title.empty();
    for (const Word& title : group.title) {
      place(title, kGroupGap * em_);
      if (column) end_line(line_gap);
    }
    for (const Word& word : group.words) {
      place(word, (first ? kGroupGap : kWordGap) * em_);
      first = false;
      if (column && group.line_each) end_line(line_gap);
    }
  }
  end_line(0);
  return y;
}

double Legend::height(double width, bool column) const {
  return flow(width, column, [](const Word&, const Vec2&) {});
}

double Legend::column_width() const {
  // Five short words fit beside each other.
  double width = 14 * em_;
  for (const Group& group : groups_) {
    for (const Word& word : group.title) width = std::max(width, word.width);
    for (const Word& word : group.words) width = std::max(width, word.width);
  }
  return width;
}

void Legend::draw(DrawList& list, const PixelRect& rect, bool column) const {
  flow(rect.width, column, [&](const Word& word, const Vec2& at) {
    if (word.paint) word.paint(list, Vec2(rect.x, rect.y) + at);
  });
}

}  // namespace quicksand
