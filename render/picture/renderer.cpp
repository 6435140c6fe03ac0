#include "render/picture/renderer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "render/base/palette.h"
#include "render/draw/font.h"
#include "render/draw/painter.h"
#include "render/image/image_paste.h"
#include "render/layers/common_scales.h"
#include "render/picture/frame.h"

namespace quicksand {

struct Renderer::Impl {
  Painter painter;
  std::optional<Font> font;  // of the last picture
};

Renderer::Renderer() : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;

// The font of a view, in the painter's hands.
const Font& Renderer::font_of(const View& view) {
  check(view);
  const double size = text_size(view);
  if (!impl_->font || impl_->font->size() != size) {
    impl_->font.emplace(size);
    impl_->painter.use_font(*impl_->font);
  }
  return *impl_->font;
}

Image Renderer::draw(const World& world, const View& view, std::span<const std::string> caption) {
  return impl_->painter.paint(compose(world, view, font_of(view), caption).list);
}

Image Renderer::draw_fitting(const World& world, View view, std::span<const std::string> caption) {
  view.detail = false;
  view.text_size = text_size(view);
  view.height = std::min(fitting_height(world, view, font_of(view), caption), kLargestPicture);
  return draw(world, view, caption);
}

namespace {

std::vector<Frame> panel_frames(std::span<const SideBySide> panels, View view, const Font& font) {
  std::vector<Frame> frames;
  for (const SideBySide& panel : panels) {
    view.fit = panel.view.fit;
    view.physical = panel.view.physical;
    view.method = panel.view.method;
    frames.push_back(compose(panel.world, view, font, {&panel.caption, 1}));
  }
  return frames;
}

// Whether one bar says the length in all panels.
bool have_one_scale(std::span<const SideBySide> panels, const std::vector<Frame>& frames) {
  constexpr double kRounding = 1e-9;
  const double scale = frames.front().packing.camera.scale();
  return std::ranges::all_of(frames,
                             [&](const Frame& frame) {
                               return std::abs(frame.packing.camera.scale() - scale) <=
                                      kRounding * scale;
                             }) &&
         std::ranges::all_of(panels, [&](const SideBySide& panel) {
           return panel.view.physical == panels.front().view.physical;
         });
}

}  // namespace

Image Renderer::draw_panels(std::span<const SideBySide> panels) {
  View view = panels.front().view;
  CommonScales scales(view);
  for (const SideBySide& panel : panels) scales.add(panel.world);
  const bool of_run = view.colours_of_run;
  view = scales.fixed(view);
  view.colours_of_run = of_run;
  view.text_size = text_size(view);
  const Font& font = font_of(view);
  View of_key = view;
  of_key.numbers = false;
  of_key.expects_intruder = std::ranges::any_of(panels, [](const SideBySide& panel) {
    return panel.view.expects_intruder || panel.world.intruder() >= 0;
  });
  const World& last = panels.back().world;
  View of_panel = view;
  of_panel.legend = of_panel.scale_bar = of_panel.detail = false;
  of_panel.expects_intruder = of_key.expects_intruder;
  of_panel.width = view.width / static_cast<int>(panels.size());
  const auto fit_height = [&] {
    of_panel.height = view.height - compose_key(last, of_key, font, 1).height();
    check(of_panel);
  };
  fit_height();
  std::vector<Frame> frames = panel_frames(panels, of_panel, font);
  if (view.scale_bar && !have_one_scale(panels, frames)) {
    of_panel.scale_bar = true;
    of_key.scale_bar = false;
    fit_height();
    frames = panel_frames(panels, of_panel, font);
  }
  Image picture(view.width, view.height);
  fill(picture, {0, 0, 1.0 * view.width, 1.0 * view.height}, palette(view.theme).background);
  for (std::size_t k = 0; k < panels.size(); ++k)
    paste(picture, impl_->painter.paint(frames[k].list), static_cast<int>(k) * of_panel.width, 0);
  const double scale = frames.back().packing.camera.scale();
  paste(picture, impl_->painter.paint(compose_key(last, of_key, font, scale)), 0, of_panel.height);
  return picture;
}

}  // namespace quicksand
