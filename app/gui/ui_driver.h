// Acts on the panel as a person does: moves the mouse, presses, types, and looks where things are. So
// what it cannot reach, a person cannot either.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/gui/gui.h"

namespace quicksand {

class UiDriver {
 public:
  // `perform` carries out what a frame returned, often nothing; the next frame shows the result. May be
  // empty. The picture has this size [px].
  using Perform = std::function<void(const std::vector<Json>&)>;
  UiDriver(Gui& gui, const Session& session, int width, int height, Perform perform);

  void resize(int width, int height);
  // After an action that threw: no button or key is held any more, and the mouse is elsewhere.
  void let_go();
  const Vec2& mouse() const { return input_.mouse; }  // [px]; negative: elsewhere

  // All of the following return the commands that they gave, and throw InputError when that cannot be
  // done: there is no such widget, it is disabled, something covers it.

  // Presses a widget with the left button.
  std::vector<Json> click(const std::string& path);
  // Gives a value: true or false to a checkbox, "open" or "closed" to a section, a word to a combo, a
  // number or text to a field.
  std::vector<Json> set(const std::string& path, const Json& value);
  // Moves the mouse there and leaves it.
  std::vector<Json> hover(const std::string& path);
  // A path, or a pixel of the whole picture.
  using Place = std::variant<std::string, Vec2>;
  std::vector<Json> drag(const Place& from, const Place& to);
  std::vector<Json> click_at(const Vec2& pixel);
  // Turns the wheel over a pixel, away from the user if positive.
  std::vector<Json> wheel(const Vec2& pixel, double notches);
  std::vector<Json> press(Key key);
  // By name: "space", "escape", "page_up".
  std::vector<Json> press(std::string_view key);
  // Frames without input, the mouse where it is.
  std::vector<Json> wait(int frames);

 private:
  void frame();
  void move_to(const Vec2& pixel);
  void leave();
  void click_here();
  void type(const std::string& text);
  const Widget* find(const std::string& path) const;
  // Unfolds what the widget is in, scrolls to it, and puts the mouse on it. Returns its middle [px].
  Vec2 reach(const std::string& path);
  const Widget& shown(const std::string& path);
  void scroll_to(const std::string& path);
  void set_number_or_text(const std::string& path, const std::string& text, bool number);
  Vec2 place_of(const Place& place);
  // Around each action.
  void begin();
  std::vector<Json> take();

  Gui& gui_;
  const Session& session_;
  int width_, height_;
  Perform perform_;
  GuiInput input_;
  std::vector<Json> commands_;  // of the present action
};

}  // namespace quicksand
