// Lines of words and little drawings that explain a picture, set in a strip or in a column.
//
// A word is a piece that is not broken: a swatch with its label, a number with its name. Words
// reserve the room that they may need in any frame of a film, so that nothing moves.
#pragma once

#include <functional>
#include <vector>

#include "render/draw/draw_list.h"
#include "render/draw/font.h"

namespace quicksand {

class Legend {
 public:
  // Draws into a box whose left end and middle line are given [px].
  using Paint = std::function<void(DrawList&, const Vec2& left_middle)>;
  struct Word {
    double width = 0;   // reserved [px]
    double height = 0;  // [px]
    Paint paint;
  };
  struct Group {
    std::vector<Word> title;  // none or one
    std::vector<Word> words;
    bool line_each = false;  // in a column, each word on its own line
  };

  explicit Legend(double text_size) : em_(text_size) {}
  void add(Group group);
  bool empty() const { return groups_.empty(); }

  // A column has a title or word a line, short words side by side; a strip, as wide as given, has words one after the
  // other, broken into lines.
  double column_width() const;
  double height(double width, bool column) const;
  void draw(DrawList& list, const PixelRect& rect, bool column) const;

 private:
  using Visit = std::function<void(const Word&, const Vec2& left_middle)>;
  double width_of(const Group& group) const;  // on one line [px]
  double flow(double width, bool column, const Visit& visit) const;

  double em_;
  std::vector<Group> groups_;
};

}  // namespace quicksand
