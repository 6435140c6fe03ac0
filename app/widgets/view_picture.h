// The picture of the packing beside the panel: composed when something in it changes, painted when
// someone looks.
#pragma once

#include <optional>

#include "core/world/world.h"
#include "render/draw/font.h"
#include "render/draw/painter.h"
#include "render/image/image.h"
#include "render/picture/frame.h"

namespace quicksand::gui {

class ViewPicture {
 public:
  // What is to be shown from now on. The view's size is that of the picture.
  void show(const World& world, const View& view);
  void show_nothing();
  bool shows() const { return frame_.has_value(); }

  const Camera& camera() const { return frame_->packing.camera; }
  // The camera that drew this pixel of the picture: of the packing or of its close-up.
  const Camera& camera_at(const Vec2& pixel) const;
  const Image& paint();  // throws RenderError

 private:
  std::optional<Font> font_;
  std::optional<Frame> frame_;
  std::optional<Painter> painter_;
  bool font_is_new_ = false;
  std::uint64_t world_hash_ = 0;
  View view_;
  std::optional<Image> painted_;  // of the frame
};

}  // namespace quicksand::gui
