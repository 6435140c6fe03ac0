#include "render/picture/renderer.h"

#include <optional>

#include "render/draw/font.h"
#include "render/draw/painter.h"
#include "render/picture/frame.h"

namespace quicksand {

struct Renderer::Impl {
  Painter painter;
  std::optional<Font> font;  // of the last picture
};

Renderer::Renderer() : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;

Image Renderer::draw(const World& world, const View& view, std::span<const std::string> caption) {
  check(view);
  const double size = text_size(view);
  if (!impl_->font || impl_->font->size() != size) {
    impl_->font.emplace(size);
    impl_->painter.use_font(*impl_->font);
  }
  return impl_->painter.paint(compose(world, view, *impl_->font, caption).list);
}

}  // namespace quicksand
