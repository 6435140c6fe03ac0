// The widgets of the panel: those of ImGui, in our own arrangement (label, value, unit), each written
// down under its path so that it can be found again by name.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/widgets/look.h"
#include "app/widgets/widget.h"

namespace quicksand::gui {

// A curve over time.
struct Curve {
  std::vector<double> x = {}, y = {};
  bool logarithmic = false;           // y; values that are not positive are left out
  std::string unit = {};              // of y
  std::string nothing = {};           // why there is no data, if there is none
  std::optional<double> cursor = {};  // a time that is marked
};

class Widgets {
 public:
  explicit Widgets(float scale) : scale_(scale), fonts_(load_fonts(scale)) {}

  // `close_lists`: a list that is open closes in this frame.
  void begin(Theme theme, bool close_lists);
  std::span<const Widget> all() const { return all_; }
  const Look& colours() const { return *look_; }
  const Fonts& fonts() const { return fonts_; }
  float px(float size) const { return size * scale_; }  // from pixels at scale 1
  // Room for label and value of a line [px]; the rest is for the unit.
  float label_width() const { return px(132); }
  float field_width() const { return px(92); }

  // Disables the widgets of its scope.
  class Disabled {
   public:
    Disabled(Widgets& widgets, bool when);
    ~Disabled();
    Disabled(const Disabled&) = delete;
    Disabled& operator=(const Disabled&) = delete;

   private:
    Widgets& widgets_;
    const bool before_;
  };

  // A part of the panel that can be folded. If true, its widgets follow, then end_section().
  // `open_now` unfolds it.
  bool begin_section(const std::string& name, bool open_at_first, bool open_now = false);
  // The same inside a section.
  bool begin_group(const std::string& name, bool open_at_first);
  void end_section();

  // `name` is the last part of the path. Those with a value return the new one when the user has given
  // it. `help` is shown while the widget is pointed at.
  struct Label {
    std::string name;
    std::string text;  // the name if empty
    std::string help = {};
    std::string unit = {};
    bool bare = false;  // no text before the field: it goes on where the line stands
  };
  bool button(const Label& label, float width, bool first_choice = false);
  std::optional<bool> checkbox(const Label& label, bool on);
  // `helps`: of the choices; none, or one each.
  std::optional<std::string> combo(const Label& label, const std::vector<std::string>& choices,
                                   const std::string& chosen,
                                   const std::vector<std::string>& helps = {});
  // A list that opens from a line with the chosen one. If true, its choices follow, then end_list().
  bool begin_list(const Label& label, const std::string& chosen);
  // Returns whether it is chosen now, which closes the list or not.
  bool choice(const std::string& text, bool now = false, bool stays_open = false);
  void end_list(const Label& label, const std::string& chosen);
  // By dragging, or typed after a click with control held.
  std::optional<double> number(const Label& label, double value, bool integer);
  std::optional<std::string> text(const Label& label, const std::string& value);
  // A number that does not exist.
  void no_number(const Label& label);
  void plot(const std::string& name, const std::string& title, const Curve& curve);

  // Text without function.
  void caption(const std::string& text);                             // small, faint
  void refusal(const std::string& name, const std::string& text);    // of the value above
  void reading(const std::string& label, const std::string& value);  // label left, value right
  void progress(double share);
  // A unit, with "_x" as an index. Returns its width [px]; draws nothing without `list`.
  float unit(ImDrawList* list, const ImVec2& at, const std::string& text) const;

  // Writes the last item of ImGui down.
  void record(const std::string& name, Widget::Kind kind, std::string value = {});
  void tooltip(const std::string& text) const;

 private:
  void line_label(const Label& label) const;
  void line_unit(const Label& label) const;
  // What a plot shows, its unit, and the last value on the right.
  void plot_head(const std::string& title, const std::string& unit, const std::string& last);
  std::string path(const std::string& name) const { return prefix_ + name; }

  float scale_;
  Fonts fonts_;
  const Look* look_ = nullptr;
  bool close_lists_ = false, disabled_ = false;
  std::string prefix_;
  std::vector<Widget> all_;
  // What is being given and not yet finished, by path.
  std::map<std::string, double> numbers_;
  std::map<std::string, std::string> texts_;
};

}  // namespace quicksand::gui
