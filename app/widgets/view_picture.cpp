#include "app/widgets/view_picture.h"

namespace quicksand::gui {

void ViewPicture::show(const World& world, const View& view) {
  const std::uint64_t hash = world_hash(world);
  if (frame_ && hash == world_hash_ && view == view_) return;
  const double size = text_size(view);
  if (!font_ || font_->size() != size) {
    font_.emplace(size);
    font_is_new_ = true;
  }
  frame_ = compose(world, view, *font_);
  world_hash_ = hash;
  view_ = view;
  painted_.reset();
}

const Camera& ViewPicture::camera_at(const Vec2& pixel) const {
  if (frame_->detail) {
    const PixelRect& clip = frame_->detail->clip;
    const bool inside = pixel.x() >= clip.x && pixel.x() < clip.right() && pixel.y() >= clip.y &&
                        pixel.y() < clip.bottom();
    if (inside) return frame_->detail->camera;
  }
  return frame_->packing.camera;
}

void ViewPicture::show_nothing() {
  frame_.reset();
  painted_.reset();
}

const Image& ViewPicture::paint() {
  if (painted_) return *painted_;
  if (!painter_) painter_.emplace();
  if (font_is_new_) painter_->use_font(*font_);
  font_is_new_ = false;
  painted_ = painter_->paint(frame_->list);
  return *painted_;
}

}  // namespace quicksand::gui
