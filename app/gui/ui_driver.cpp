#include "app/gui/ui_driver.h"

#include <algorithm>
#include <array>

#include "app/base/nearest_name.h"
#include "core/base/errors.h"

namespace quicksand {
namespace {

constexpr int kMostScrolls = 200;
constexpr int kSettling = 3;  // frames

Vec2 middle(const PixelRect& r) { return {r.x + r.width / 2, r.y + r.height / 2}; }

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// In the order of the enum.
constexpr std::array<std::string_view, 24> kKeyNames{
    "tab", "left",   "right",  "up",        "down",  "page_up", "page_down", "home",
    "end", "insert", "delete", "backspace", "space", "enter",   "escape",    "a",
    "c",   "v",      "x",      "y",         "z",     "control", "shift",     "alt"};

}  // namespace

UiDriver::UiDriver(Gui& gui, const Session& session, int width, int height, Perform perform)
    : gui_(gui), session_(session), width_(width), height_(height), perform_(std::move(perform)) {}

void UiDriver::resize(int width, int height) {
  width_ = width;
  height_ = height;
}

void UiDriver::let_go() {
  input_ = {};
  commands_.clear();
}

void UiDriver::frame() {
  const std::vector<Json> given = gui_.frame(session_, input_, width_, height_);
  commands_.insert(commands_.end(), given.begin(), given.end());
  input_.text.clear();
  input_.wheel = 0;
  if (perform_) perform_(given);
}

void UiDriver::begin() {
  commands_.clear();
  if (gui_.width() != width_ || gui_.height() != height_) frame();
}

std::vector<Json> UiDriver::take() {
  std::vector<Json> taken;
  std::swap(taken, commands_);
  return taken;
}

void UiDriver::move_to(const Vec2& pixel) {
  input_.mouse = pixel;
  frame();
}

// The frame after shows what the action led to, without the mouse upon it.
void UiDriver::leave() {
  move_to({-1, -1});
  frame();
}

void UiDriver::click_here() {
  input_.buttons[0] = true;
  frame();
  input_.buttons[0] = false;
  frame();
}

const Widget* UiDriver::find(const std::string& path) const {
  const auto all = gui_.widgets();
  const auto found = std::ranges::find(all, path, &Widget::path);
  return found == all.end() ? nullptr : &*found;
}

const Widget& UiDriver::shown(const std::string& path) {
  const Widget* widget = find(path);
  if (widget != nullptr) return *widget;
  // It may lie in a section that is folded, at any depth.
  for (std::size_t slash = path.find('/'); slash != std::string::npos;
       slash = path.find('/', slash + 1)) {
    const std::string section = path.substr(0, slash);
    const Widget* around = find(section);
    if (around == nullptr || around->kind != Widget::Kind::section) break;
    if (around->value == "open") continue;
    reach(section);
    click_here();
    frame();
  }
  widget = find(path);
  if (widget != nullptr) return *widget;
  std::vector<std::string> known;
  for (const Widget& one : gui_.widgets()) known.push_back(one.path);
  refuse_name(path, "there is no such widget", path, known);
}

void UiDriver::scroll_to(const std::string& path) {
  // Two notches are enough to reveal the next widget, and never jump over one.
  for (int i = 0; i < kMostScrolls; ++i) {
    const Widget& widget = shown(path);
    const double top = widget.rect.y, bottom = widget.rect.bottom();
    const bool above = top<widget.clip.y, below = bottom> widget.clip.bottom();
    if (!above && !below) return;
    if (above && below) return;  // larger than what can be seen of it
    input_.wheel = above ? 0.3 : -0.3;
    const PixelRect before = widget.rect;
    move_to(middle(widget.clip));
    frame();
    if (shown(path).rect == before) return;
  }
}

Vec2 UiDriver::reach(const std::string& path) {
  // The last frame may show what has changed since, and a panel may unfold and scroll by itself.
  for (int i = 0; i < kSettling; ++i) frame();
  shown(path);
  scroll_to(path);
  const Widget& widget = shown(path);
  if (widget.disabled) throw InputError(path, "this widget is disabled at present");
  if (!widget.visible) throw InputError(path, "there is no room in the picture for this widget");
  Vec2 place = middle(widget.rect);
  move_to(place);
  const Widget& there = shown(path);
  const Widget* over = gui_.hovered();
  if (over != &there) {
    throw InputError(path, "something covers this widget" +
                               (over == nullptr ? std::string() : ": " + over->path));
  }
  return place;
}

std::vector<Json> UiDriver::click(const std::string& path) {
  begin();
  reach(path);
  click_here();
  leave();
  return take();
}

std::vector<Json> UiDriver::hover(const std::string& path) {
  begin();
  reach(path);
  frame();
  return take();
}

void UiDriver::type(const std::string& text) {
  input_.text = text;
  frame();
}

// As a person replaces what stands in a field: opens it, selects all, types, enters.
void UiDriver::set_number_or_text(const std::string& path, const std::string& text, bool number) {
  reach(path);
  if (number) input_.keys = {Key::control};
  click_here();
  input_.keys = {Key::control, Key::a};
  frame();
  input_.keys.clear();
  frame();
  type(text);
  input_.keys = {Key::enter};
  frame();
  input_.keys.clear();
  leave();
}

std::vector<Json> UiDriver::set(const std::string& path, const Json& value) {
  begin();
  const Widget::Kind kind = shown(path).kind;
  const std::string text = text_of(value);
  const auto refuse = [&](const std::string& wanted) {
    throw InputError(path, "takes " + wanted + ", not " + value.dump());
  };
  switch (kind) {
    case Widget::Kind::checkbox:
      if (!value.is_boolean()) refuse("true or false");
      reach(path);
      if ((shown(path).value == "on") != value.get<bool>()) click_here();
      leave();
      break;
    case Widget::Kind::section:
      if (text != "open" && text != "closed") refuse("\"open\" or \"closed\"");
      reach(path);
      if (shown(path).value != text) click_here();
      leave();
      break;
    case Widget::Kind::combo:
      reach(path);
      click_here();
      frame();
      try {
        reach(path + "/" + text);
      } catch (const InputError&) {
        press(Key::escape);  // closes the list again
        throw;
      }
      click_here();
      leave();
      break;
    case Widget::Kind::number:
      if (!value.is_number()) refuse("a number");
      set_number_or_text(path, text, true);
      break;
    case Widget::Kind::text:
      if (!value.is_string()) refuse("text");
      set_number_or_text(path, text, false);
      break;
    default:
      throw InputError(path, "this widget has no value that can be set");
  }
  return take();
}

Vec2 UiDriver::place_of(const Place& place) {
  if (const auto* pixel = std::get_if<Vec2>(&place)) return *pixel;
  return reach(std::get<std::string>(place));
}

std::vector<Json> UiDriver::drag(const Place& from, const Place& to) {
  begin();
  // Where it goes first: reaching for it must not disturb what is dragged.
  const Vec2 end = place_of(to), start = place_of(from);
  move_to(start);
  input_.buttons[0] = true;
  frame();
  constexpr int kSteps = 4;
  for (int i = 1; i <= kSteps; ++i) move_to(start + (end - start) * i / kSteps);
  input_.buttons[0] = false;
  frame();
  leave();
  return take();
}

std::vector<Json> UiDriver::click_at(const Vec2& pixel) {
  begin();
  move_to(pixel);
  click_here();
  leave();
  return take();
}

std::vector<Json> UiDriver::wheel(const Vec2& pixel, double notches) {
  begin();
  move_to(pixel);
  input_.wheel = notches;
  frame();
  leave();
  return take();
}

std::vector<Json> UiDriver::press(Key key) {
  begin();
  input_.keys = {key};
  frame();
  input_.keys.clear();
  frame();
  return take();
}

std::vector<Json> UiDriver::press(std::string_view key) {
  const auto* const found = std::ranges::find(kKeyNames, key);
  if (found == kKeyNames.end()) {
    refuse_name("key", "there is no key \"" + std::string(key) + "\"", key,
                {kKeyNames.begin(), kKeyNames.end()});
  }
  return press(static_cast<Key>(found - kKeyNames.begin()));
}

std::vector<Json> UiDriver::wait(int frames) {
  begin();
  for (int i = 0; i < frames && !session_.is_to_end(); ++i) frame();
  return take();
}

}  // namespace quicksand
