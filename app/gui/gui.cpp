#include "app/gui/gui.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/gui/imgui_input.h"
#include "app/gui/triangles_of.h"
#include "app/panel/panel_frame.h"
#include "core/base/errors.h"
#include "render/base/palette.h"
#include "render/draw/triangle_painter.h"
#include "render/image/image_paste.h"

namespace quicksand {
namespace {

using namespace gui;

constexpr float kColumn = 320;  // width of the panel [px at scale 1]
constexpr float kStatus = 30;   // height of the line along the bottom
constexpr float kStrip = 84;    // of the timeline above it
constexpr double kText = 12;    // size of the text in the picture of the packing

constexpr ImGuiWindowFlags kPart =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoBackground;

// A window of ImGui in this place; ends with ImGui::End().
void begin_part(const char* name, const PixelRect& place, ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos({static_cast<float>(place.x), static_cast<float>(place.y)});
  ImGui::SetNextWindowSize({static_cast<float>(place.width), static_cast<float>(place.height)});
  ImGui::Begin(name, nullptr, flags);
}

double checked_scale(double scale) {
  if (scale >= 0.5 && scale <= 4) return scale;
  throw InputError("scale", "the scale of the panel must be from 0.5 to 4");
}

}  // namespace

struct Gui::Impl {
  struct Context {
    Context() : context(ImGui::CreateContext()) { ImGui::SetCurrentContext(context); }
    ~Context() { ImGui::DestroyContext(context); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ImGuiContext* context;
  };

  explicit Impl(double s) : scale(checked_scale(s)), widgets(static_cast<float>(scale)) {}

  void lay_out(PanelFrame& frame, const GuiInput& input);
  void show_column(PanelFrame& frame, float bottom);
  bool pressed(const GuiInput& input, Key key) const;
  void take_keys(PanelFrame& frame, const GuiInput& input, bool list_open);
  void prepare_view(const Session& session);

  double scale;
  Context context;
  Widgets widgets;
  PanelEntries entries;
  PanelNotes notes;
  Grip grip;
  ViewPicture picture;
  PixelRect view_rect;
  int width = 0, height = 0;
  Theme theme = Theme::light;
  bool styled = false;
  std::vector<Key> held;  // in the last frame
  bool takes_text = false;
  std::optional<TrianglePainter> painter;
};

void Gui::Impl::prepare_view(const Session& session) {
  const auto size = [](double pixels) { return static_cast<int>(pixels); };
  if (!session.loaded() || view_rect.width < kSmallestPicture ||
      view_rect.height < kSmallestPicture) {
    picture.show_nothing();
    return;
  }
  View view = session.shown();
  view.width = size(view_rect.width);
  view.height = size(view_rect.height);
  view.text_size = kText * scale;
  picture.show(session.world(), view);
}

void Gui::Impl::show_column(PanelFrame& frame, float bottom) {
  begin_part("column", {0, 0, widgets.px(kColumn), bottom}, kPart & ~ImGuiWindowFlags_NoScrollbar);
  show_scene(frame);
  const bool computed_before = frame.session.timeline() != nullptr;
  if (computed_before) show_timeline(frame);
  {
    const Widgets::Disabled disabled(widgets, !frame.session.loaded());
    if (!computed_before) {
      show_controls(frame);
      show_parameters(frame);
      show_actions(frame);
    }
    show_view_controls(frame);
    show_plots(frame);
    show_inspection(frame);
  }
  ImGui::End();
}

// Whether the key goes down in this frame.
bool Gui::Impl::pressed(const GuiInput& input, Key key) const {
  return std::ranges::find(input.keys, key) != input.keys.end() &&
         std::ranges::find(held, key) == held.end();
}

// Keys that work wherever the mouse is, unless something is being typed. Escape closes a list first.
void Gui::Impl::take_keys(PanelFrame& frame, const GuiInput& input, bool list_open) {
  if (takes_text) return;
  const Session& session = frame.session;
  if (const Timeline* timeline = session.timeline()) {
    if (pressed(input, Key::space)) frame.command("play", {{"on", !timeline->playing}});
    if (pressed(input, Key::left)) frame.command("show", {{"by", -1}});
    if (pressed(input, Key::right)) frame.command("show", {{"by", 1}});
    if (!list_open && pressed(input, Key::escape)) notes.error.clear();
    return;
  }
  const bool can_run = session.loaded() && !session.finished() && !session.failed();
  if (!session.last_change().empty() && pressed(input, Key::z) &&
      std::ranges::find(input.keys, Key::control) != input.keys.end())
    frame.command("undo");
  if (can_run && pressed(input, Key::space)) frame.command(session.running ? "pause" : "start");
  if (!list_open && pressed(input, Key::escape)) notes.error.clear();
}

void Gui::Impl::lay_out(PanelFrame& frame, const GuiInput& input) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DeltaTime = 1.0F / 60;
  const float status_top = std::max(0.0F, io.DisplaySize.y - widgets.px(kStatus));
  const float left = std::round(widgets.px(kColumn));
  const float line = std::max(1.0F, std::round(widgets.px(1)));  // between the parts
  const float strip =
      frame.session.timeline() != nullptr ? std::min(status_top, widgets.px(kStrip)) : 0.0F;
  view_rect = {left + line, 0, std::max(0.0, width - static_cast<double>(left + line)),
               std::floor(static_cast<double>(status_top - strip))};
  prepare_view(frame.session);  // may throw, so it comes before the frame begins

  give_input(input, io);
  ImGui::NewFrame();
  takes_text = io.WantTextInput;
  const bool list_open =
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  widgets.begin(theme, pressed(input, Key::escape));

  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  begin_part("view", view_rect, kPart | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  show_view(frame, picture, grip, view_rect);
  ImGui::End();

  if (strip > 0) {
    const PixelRect place{view_rect.x, view_rect.height, view_rect.width, strip};
    begin_part("timeline", place, kPart | ImGuiWindowFlags_NoScrollWithMouse);
    show_timeline_strip(frame, place);
    ImGui::End();
  }

  ImGui::GetBackgroundDrawList()->AddRectFilled({left, 0}, {left + line, status_top},
                                                widgets.colours().line);
  show_column(frame, status_top);

  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(widgets.px(12), widgets.px(7)));
  begin_part("status", {0, status_top, io.DisplaySize.x, widgets.px(kStatus)}, kPart);
  ImGui::PopStyleVar();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRectFullScreen();
  list->AddRectFilled({0, status_top}, {io.DisplaySize.x, status_top + line},
                      widgets.colours().line);
  list->PopClipRect();
  show_status(frame);
  ImGui::End();

  if (!notes.error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_WindowBg, widgets.colours().error);
    begin_part("error", {view_rect.x, 0, view_rect.width, 0},
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    show_banner(frame);
    ImGui::End();
    ImGui::PopStyleColor();
  }
  take_keys(frame, input, list_open);
  held = input.keys;
  ImGui::Render();
}

Gui::Gui(double scale) : impl_(std::make_unique<Impl>(scale)) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  // Lines are smooth by their own edges; texels of the atlas would blur them at large scales.
  io.Fonts->Flags |= ImFontAtlasFlags_NoBakedLines | ImFontAtlasFlags_NoMouseCursors;
  prepare_input(io);
  io.Fonts->Build();
}

Gui::~Gui() = default;

std::vector<Json> Gui::frame(const Session& session, const GuiInput& input, int width, int height) {
  if (width < kSmallestPicture || height < kSmallestPicture || width > kLargestPicture ||
      height > kLargestPicture) {
    throw InputError("size", "the panel cannot be drawn in a picture of " + std::to_string(width) +
                                 "x" + std::to_string(height) + " pixels: both must lie from " +
                                 std::to_string(kSmallestPicture) + " to " +
                                 std::to_string(kLargestPicture));
  }
  Impl& m = *impl_;
  ImGui::SetCurrentContext(m.context.context);
  const Theme theme = session.view.theme;
  if (!m.styled || theme != m.theme) {
    apply(look(theme), static_cast<float>(m.scale));
    m.styled = true;
  }
  m.theme = theme;
  std::vector<Json> commands;
  PanelFrame frame{m.widgets, session, m.entries, m.notes, commands};
  if (width != m.width || height != m.height) {
    // ImGui knows what needs to be scrolled after a frame only.
    m.width = width;
    m.height = height;
    m.lay_out(frame, {});
    commands.clear();
  }
  m.lay_out(frame, input);
  if (!commands.empty()) m.notes.hint.clear();
  return commands;
}

Image Gui::paint() {
  Impl& m = *impl_;
  ImGui::SetCurrentContext(m.context.context);
  if (!m.painter) {
    m.painter.emplace();
    unsigned char* letters = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&letters, &width, &height);
    const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    m.painter->use_letters(width, height, {letters, size});
  }
  Image picture(m.width, m.height);
  const Colour ground = colour_of(look(m.theme).panel);
  fill(picture, {0, 0, m.view_rect.x, m.view_rect.height}, ground);
  fill(picture, {0, m.view_rect.height, picture.width + 0.0, picture.height + 0.0}, ground);
  if (m.picture.shows()) {
    paste(picture, m.picture.paint(), static_cast<int>(m.view_rect.x), 0);
  } else {
    fill(picture, m.view_rect, palette(m.theme).background);
  }
  return m.painter->paint(triangles_of(*ImGui::GetDrawData()), std::move(picture));
}

std::span<const Widget> Gui::widgets() const { return impl_->widgets.all(); }
bool Gui::takes_text() const { return impl_->takes_text; }
const Widget* Gui::hovered() const {
  const auto all = widgets();
  const auto found = std::ranges::find(all, true, &Widget::hovered);
  return found == all.end() ? nullptr : &*found;
}

int Gui::width() const { return impl_->width; }
int Gui::height() const { return impl_->height; }
double Gui::scale() const { return impl_->scale; }

std::optional<Camera> Gui::view_camera() const {
  if (!impl_->picture.shows()) return std::nullopt;
  const Camera& camera = impl_->picture.camera();
  PixelRect covered = camera.covered();
  covered.x += impl_->view_rect.x;
  covered.y += impl_->view_rect.y;
  return Camera(camera.window(), covered);
}

void Gui::show_error(std::string message) {
  impl_->notes.error = std::move(message);
  impl_->notes.refused_path.clear();
}

void Gui::show_refusal(const InputError& error) {
  impl_->notes.error = error.where() + ": " + error.what();
  impl_->notes.refused_path = error.where();
  impl_->notes.refusal = error.what();
}

void Gui::show_hint(std::string text) { impl_->notes.hint = std::move(text); }

void Gui::set_rate(std::optional<double> steps_per_second, std::optional<double> eta_seconds) {
  impl_->notes.steps_per_second = steps_per_second;
  impl_->notes.eta_seconds = eta_seconds;
}

void Gui::set_recording(bool on) { impl_->notes.recording = on; }

void Gui::set_recent(std::vector<std::string> paths) { impl_->notes.recent = std::move(paths); }

}  // namespace quicksand
