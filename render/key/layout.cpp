#include "render/key/layout.h"

#include <algorithm>
#include <cmath>

#include "render/base/view.h"

namespace quicksand {
namespace {

constexpr double kPad = 0.7;               // around the key, over the size of the text
constexpr double kDetailFrom = 0.4;        // share of the width; a packing narrower gets a close-up
constexpr double kLeastDetailHeight = 12;  // [d]
constexpr double kTitleLine =
    1.3;  // that says which scale is a close-up's, over the size of the text

// Size of the world in the picture if it may take up that much, with margins [px].
Vec2 fitted(const LayoutRequest& r, double width, double height) {
  const Vec2 margins(r.margins.left + r.margins.right, r.margins.top + r.margins.bottom);
  const Vec2 room = (Vec2(width, height) - margins).cwiseMax(1.0);
  const double scale = std::min(room.x() / r.world.x(), room.y() / r.world.y());
  return r.world * scale + margins;
}

// Whole pixels, so that text and frames are sharp.
PixelRect whole(const PixelRect& rect) {
  return {std::round(rect.x), std::round(rect.y), std::floor(rect.width), std::floor(rect.height)};
}

double pad_of(const LayoutRequest& r) { return std::round(kPad * r.text_size); }
Layout with_strip(const LayoutRequest& r, const Legend& key, double pad) {
  Layout layout;
  const PixelRect place = strip_place(r, key);
  const double head = key.empty() ? 0 : place.height + 2 * pad;
  const Vec2 size = fitted(r, r.width, r.height - head);
  // Key and packing stay together, in the middle.
  const double top = std::max(0.0, (r.height - head - size.y()) / 2);
  layout.key = whole({pad, top + pad, place.width, place.height});
  layout.packing = {0, std::round(top) + head, static_cast<double>(r.width),
                    std::min(size.y(), r.height - head)};
  return layout;
}

Layout with_column(const LayoutRequest& r, const Legend& key, double pad) {
  Layout layout;
  layout.column = true;
  const double key_width = std::ceil(key.column_width());
  const double room = std::max(1.0, r.width - key_width - 3 * pad);
  const Vec2 size = fitted(r, room, r.height);
  double packing_x = 0, detail_width = 0;
  if (r.detail && size.x() < kDetailFrom * room) {
    const double most_scale = (r.height - 2 * pad) / kLeastDetailHeight;
    detail_width = std::min(room - size.x() - 2 * pad, r.world.x() * most_scale);
  }
  const double gaps = detail_width > 0 ? 4 * pad : 2 * pad;
  const double total = size.x() + detail_width + gaps + key_width;
  packing_x = std::max(0.0, (r.width - pad - total) / 2);
  layout.packing = {packing_x, (r.height - size.y()) / 2, size.x(), size.y()};
  double x = layout.packing.right() + 2 * pad;
  if (detail_width > 0) {
    layout.detail = whole({x, pad, detail_width, r.height - 2 * pad});
    x = layout.detail->right() + 2 * pad;
  }
  const double title = layout.detail ? kTitleLine * r.text_size : 0;
  const double key_height = std::ceil(key.height(key_width, true) + title);
  const double key_top =
      std::clamp(layout.packing.y, pad, std::max(pad, r.height - pad - key_height));
  layout.key = whole({x, key_top, key_width, key_height});
  return layout;
}

}  // namespace

PixelRect strip_place(const LayoutRequest& r, const Legend& key) {
  const double pad = pad_of(r), width = std::max(1.0, r.width - 2 * pad);
  return {pad, pad, width, key.empty() ? 0 : std::ceil(key.height(width, false))};
}

int fitting_height(const LayoutRequest& r, const Legend& key) {
  const double head = key.empty() ? 0 : strip_place(r, key).height + 2 * pad_of(r);
  const Vec2 margins(r.margins.left + r.margins.right, r.margins.top + r.margins.bottom);
  const double scale = std::max(1.0, r.width - margins.x()) / r.world.x();
  return static_cast<int>(
      std::min(std::ceil(head + r.world.y() * scale + margins.y()), kLargestPicture + 0.0));
}

Layout arrange(const LayoutRequest& request, const Legend& key) {
  const double pad = pad_of(request);
  const Layout strip = with_strip(request, key, pad);
  if (key.empty()) return strip;
  const Layout column = with_column(request, key, pad);
  const bool column_fits = column.key.bottom() <= request.height &&
                           column.key.right() <= request.width && column.packing.width > 1;
  const bool strip_fits = strip.key.bottom() < request.height;
  const double column_size = column.packing.width * column.packing.height;
  const double strip_size = strip.packing.height *
                            (strip.packing.height - request.margins.top - request.margins.bottom) /
                            request.world.y() * request.world.x();
  if (column_fits && (!strip_fits || column.detail || column_size > strip_size)) return column;
  return strip;
}

}  // namespace quicksand
