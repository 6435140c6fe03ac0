#include "render/picture/renderer.h"

#include <algorithm>
#include <optional>

#include "render/base/palette.h"
#include "render/draw/font.h"
#include "render/draw/painter.h"
#include "render/image/image_paste.h"
#include "render/picture/frame.h"
#include "render/picture/side_by_side.h"

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
  const View& view = panels.front().view;
  const PanelsOverKey composed = compose_side_by_side(panels, font_of(view));
  Image picture(view.width, view.height);
  fill(picture, {0, 0, 1.0 * view.width, 1.0 * view.height}, palette(view.theme).background);
  int x = 0;
  for (const Frame& panel : composed.panels) {
    paste(picture, impl_->painter.paint(panel.list), x, 0);
    x += panel.list.width();
  }
  paste(picture, impl_->painter.paint(composed.key), 0, view.height - composed.key.height());
  return picture;
}

}  // namespace quicksand
