#include "render/picture/renderer.h"

#include <algorithm>
#include <optional>

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
  of_panel.height = view.height - compose_key(last, of_key, font, 1).height();
  check(of_panel);
  Image picture(view.width, view.height);
  fill(picture, {0, 0, 1.0 * view.width, 1.0 * view.height}, palette(view.theme).background);
  double scale = 1;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    of_panel.fit = panels[k].view.fit;
    of_panel.physical = panels[k].view.physical;
    of_panel.method = panels[k].view.method;
    const Frame frame = compose(panels[k].world, of_panel, font, {&panels[k].caption, 1});
    scale = frame.packing.camera.scale();
    paste(picture, impl_->painter.paint(frame.list), static_cast<int>(k) * of_panel.width, 0);
  }
  paste(picture, impl_->painter.paint(compose_key(last, of_key, font, scale)), 0, of_panel.height);
  return picture;
}

}  // namespace quicksand
