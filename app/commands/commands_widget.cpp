// Commands that act through the panel as a person does: click, set_widget, drag, hover, wheel, key, frames,
// widgets.
#include "app/commands/command_definition.h"
#include "app/gui/gui.h"
#include "app/gui/ui_driver.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr std::string_view kWidgetGroup = "Panel";
constexpr double kLargest = kLargestPicture;

Json given(const std::vector<Json>& commands) { return {{"gave", commands}}; }

// A widget that cannot be reached is no malformed command but a failed one.
template <class Act>
Json act(Console& console, Act act_on) {
  UiDriver& driver = console.ui_driver();
  try {
    return given(act_on(driver));
  } catch (const InputError& error) {
    driver.let_go();
    throw CommandFailure(error.where() + ": " + error.what());
  } catch (...) {
    driver.let_go();
    throw;
  }
}

constexpr Shape kPlace{"the path of a widget, or a place [x, y] in the picture [px]",
                       [](const Json& v) {
                         return v.is_string() || (v.is_array() && v.size() == 2 &&
                                                  v[0].is_number() && v[1].is_number());
                       },
                       [] {
                         return Json{{"type", {"string", "array"}}};
                       }};

UiDriver::Place place_from(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  return Vec2(json[0].get<double>(), json[1].get<double>());
}

void describe_widget(Fields& f, std::string& widget) {
  f.text({"widget", "path of the widget, e.g. Controls/Run; the command widgets lists them",
          Presence::required},
         widget);
}

struct Click {
  Json at;
  void describe(Fields& f) {
    f.json({"at", "path of a widget, e.g. Controls/Run, or a place in the picture [px]",
            Presence::required},
           kPlace, at);
  }
  Json perform(Console& console, const std::string&) {
    return act(console, [&](UiDriver& driver) {
      return at.is_string() ? driver.click(at.get<std::string>())
                            : driver.click_at(std::get<Vec2>(place_from(at)));
    });
  }
};

struct Hover {
  std::string widget;
  void describe(Fields& f) { describe_widget(f, widget); }
  Json perform(Console& console, const std::string&) {
    return act(console, [&](UiDriver& driver) { return driver.hover(widget); });
  }
};

constexpr Shape kValue{
    "true, false, a number or a text",
    [](const Json& v) { return v.is_boolean() || v.is_number() || v.is_string(); },
    [] {
      return Json{{"type", {"boolean", "number", "string"}}};
    }};

struct SetWidget {
  std::string widget;
  Json value;
  void describe(Fields& f) {
    describe_widget(f, widget);
    f.json({"value", "true or false, a word from a list, or a number or text to type",
            Presence::required},
           kValue, value);
  }
  Json perform(Console& console, const std::string&) {
    return act(console, [&](UiDriver& driver) { return driver.set(widget, value); });
  }
};

struct DragMouse {
  Json from, to;
  void describe(Fields& f) {
    f.json({"from", "where the button is pressed: a widget or a place [px]", Presence::required},
           kPlace, from);
    f.json({"to", "where it is released", Presence::required}, kPlace, to);
  }
  Json perform(Console& console, const std::string&) {
    return act(console,
               [&](UiDriver& driver) { return driver.drag(place_from(from), place_from(to)); });
  }
};

struct Wheel {
  Vec2 at{0, 0};
  double notches = 1;
  void describe(Fields& f) {
    f.vector({"at", "place in the picture, [x, y]", Presence::required}, between(0, kLargest, "px"),
             at);
    f.number({"notches", "notches to turn; positive: away from the user"}, between(-100, 100, "1"),
             notches);
  }
  Json perform(Console& console, const std::string&) {
    return act(console, [&](UiDriver& driver) { return driver.wheel(at, notches); });
  }
};

struct PressKey {
  std::string key;
  void describe(Fields& f) {
    f.text({"key", "name of the key, e.g. space, escape, page_up", Presence::required}, key);
  }
  Json perform(Console& console, const std::string&) {
    return act(console, [&](UiDriver& driver) { return driver.press(std::string_view(key)); });
  }
};

struct Frames {
  std::int64_t count = 1;
  void describe(Fields& f) {
    f.integer({"count", "number of frames; after start, each computes its steps"}, 1, 1'000'000,
              count);
  }
  Json perform(Console& console, const std::string&) {
    const std::int64_t first = console.session().loaded() ? console.session().world().step : 0;
    act(console, [&](UiDriver& driver) { return driver.wait(static_cast<int>(count)); });
    return {{"steps", console.session().loaded() ? console.session().world().step - first : 0}};
  }
};

Json widgets_of(Console& console) {
  console.ui_driver().wait(2);  // a panel that was not seen yet has none
  Json list = Json::array();
  for (const Widget& widget : console.panel().widgets())
    list.push_back(
        {{"path", widget.path},
         {"value", widget.value},
         {"disabled", widget.disabled},
         {"rectangle", {widget.rect.x, widget.rect.y, widget.rect.width, widget.rect.height}}});
  return {{"widgets", list}};
}

}  // namespace

std::vector<SessionCommand> widget_commands() {
  return {
      define<Click>(
          {"click", kWidgetGroup, "Clicks a widget or a place in the picture, as the mouse does.",
           R"({"command": "click", "at": "Controls/Step"})"},
          false),
      define<SetWidget>(
          {"set_widget", kWidgetGroup, "Sets the value of a widget by clicking and typing.",
           R"({"command": "set_widget", "widget": "View/bonds", "value": true})"},
          false),
      define<DragMouse>({"drag", kWidgetGroup,
                         "Presses the mouse button, moves the mouse and releases the button.",
                         R"({"command": "drag", "from": [800, 300], "to": [850, 300]})"},
                        false),
      define<Wheel>({"wheel", kWidgetGroup, "Turns the mouse wheel.",
                     R"({"command": "wheel", "at": [800, 300], "notches": 2})"},
                    false),
      define<Hover>(
          {"hover", kWidgetGroup, "Leaves the mouse on a widget, so that its tooltip shows.",
           R"({"command": "hover", "widget": "Controls/Reset"})"},
          false),
      define<PressKey>(
          {"key", kWidgetGroup, "Presses a key.", R"({"command": "key", "key": "space"})"}, false),
      define<Frames>({"frames", kWidgetGroup, "Runs the panel for some frames.",
                      R"({"command": "frames", "count": 10})"},
                     false),
      define<Without<widgets_of>>({"widgets", kWidgetGroup,
                                   "Lists the widgets of the panel, with their values and "
                                   "rectangles (x, y, width, height [px]).",
                                   R"({"command": "widgets"})"},
                                  false)};
}

}  // namespace quicksand
