#include "render/picture/frame.h"

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/world/extent.h"
#include "render/base/palette.h"
#include "render/key/key.h"
#include "render/layers/network.h"
#include "render/layers/packing.h"
#include "render/layers/shapes.h"

namespace quicksand {
namespace {

constexpr double kImageMargin = 1.0;  // beyond periodic and open sides of a box [d]
constexpr double kCaptionRoom = 17;   // whatever a caption says, over the size of the text
constexpr double kBodyMargin = 0.04;  // around bodies without a box, over the larger extent
// A key that leaves the packing less than this of the size that it has without is left out.
constexpr double kLeastSize = 0.3;

// The window of the view with the room around it that is part of the world.
WorldRect window_with_margins(const World& world, const View& view) {
  WorldRect window = view_window(world, view);
  if (view.window || follows_intruder(world, view)) return window;
  if (world.box.width > 0) {
    const double side = world.box.sides == Sides::walls ? 0 : kImageMargin;
    window.low.x() -= side;
    window.high.x() += side;
  } else {
    const Vec2 margin = Vec2::Constant(kBodyMargin * window.size().maxCoeff());
    window.low.x() -= margin.x();
    window.high += margin;
    if (!world.box.floor) window.low.y() -= margin.y();
  }
  return window;
}

Margins wall_margins(const World& world, double text) {
  Margins margins{2, 2, 2, 2};
  for (const Wall& wall : world.walls) {
    const double depth = hatch_depth(text) + 1;
    if (wall.normal.x() > 0.5) margins.left = std::max(margins.left, depth);
    if (wall.normal.x() < -0.5) margins.right = std::max(margins.right, depth);
    if (wall.normal.y() > 0.5) margins.bottom = std::max(margins.bottom, depth);
    if (wall.normal.y() < -0.5) margins.top = std::max(margins.top, depth);
  }
  return margins;
}

Panel packing_panel(const PixelRect& place, const WorldRect& window, const Margins& margins) {
  const PixelRect inner{place.x + margins.left, place.y + margins.top,
                        std::max(1.0, place.width - margins.left - margins.right),
                        std::max(1.0, place.height - margins.top - margins.bottom)};
  const Camera camera(window, inner);
  const PixelRect c = camera.covered();
  return {camera,
          {c.x - margins.left, c.y - margins.top, c.width + margins.left + margins.right,
           c.height + margins.top + margins.bottom}};
}

// The whole width of the window; as high as the place allows, around the intruder or the top of the
// packing, but not beyond the window.
Panel detail_panel(const World& world, const PixelRect& place, const WorldRect& window,
                   double floor_margin) {
  const double scale = place.width / window.size().x();
  const double height = place.height / scale;
  const double lowest = window.low.y() - floor_margin / scale;
  const int intruder = world.intruder();
  const double centre = intruder >= 0 ? world.disks.position[static_cast<std::size_t>(intruder)].y()
                                      : packing_top(world) - 0.4 * height;
  const double low =
      std::clamp(centre - height / 2, lowest, std::max(lowest, window.high.y() - height));
  const WorldRect part{{window.low.x(), low}, {window.high.x(), low + height}};
  return {Camera(part, place), place};
}

bool sides_in_sight(const World& world, const WorldRect& window) {
  const auto shown = [&](double x) { return x >= window.low.x() && x <= window.high.x(); };
  return world.box.sides == Sides::periodic && (shown(0) || shown(world.box.width));
}

// What is known before anything has a place.
struct Plan {
  Plan(const World& world, const View& view, const Font& font, std::span<const std::string> caption)
      : grains(colour_grains(world, view)),
        numbers(view.numbers ? readings(world, view) : std::vector<Reading>()),
        window(window_with_margins(world, view)),
        margins(wall_margins(world, font.size())),
        content{world,
                view,
                font,
                grains.scale,
                view.forces ? force_scale(world, view) : 1,
                caption,
                numbers,
                sides_in_sight(world, window)} {}
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  LayoutRequest request() const {
    return {.width = content.view.width,
            .height = content.view.height,
            .world = window.size(),
            .margins = margins,
            .text_size = content.font.size(),
            .detail = content.view.detail};
  }
  // The room of the key does not depend on the scale; what it says does.
  Legend room() const { return make_key(content, 1, widest_caption(), true); }
  Legend key(double pixels_per_diameter) const {
    return make_key(content, pixels_per_diameter, widest_caption(), false);
  }

  ColouredGrains grains;
  std::vector<Reading> numbers;
  WorldRect window;
  Margins margins;
  KeyContent content;  // refers to the grains and numbers

 private:
  double widest_caption() const {
    const double text = content.font.size();
    return std::max(10.0, std::min(content.view.width - 2 * text, kCaptionRoom * text));
  }
};

bool leaves_room(const Panel& packing, const Plan& plan) {
  const View& view = plan.content.view;
  const PixelRect all{0, 0, static_cast<double>(view.width), static_cast<double>(view.height)};
  const Panel alone = packing_panel(all, plan.window, plan.margins);
  return packing.camera.scale() >= kLeastSize * alone.camera.scale();
}

View without_key(View view) {
  view.legend = view.numbers = view.scale_bar = false;
  return view;
}

// Part of the panel between periodic sides: lines would hang in the air beyond.
PixelRect inside_the_sides(const World& world, const Panel& panel) {
  PixelRect rect = panel.clip;
  if (world.box.sides != Sides::periodic) return rect;
  const double left = std::round(panel.camera.to_pixel({0, 0}).x());
  const double right = std::round(panel.camera.to_pixel({world.box.width, 0}).x());
  rect.x = std::max(rect.x, left);
  rect.width = std::min(panel.clip.right(), right) - rect.x;
  return rect;
}

void draw_world(DrawList& list, const World& world, const View& view, const ColouredGrains& grains,
                const Panel& panel, double text, double scale_force) {
  list.clip_to(panel.clip);
  draw_disks(list, world, view, grains, panel);
  draw_shapes(list, world, view, panel);
  list.clip_to(inside_the_sides(world, panel));
  if (view.bonds) draw_bonds(list, world, view, panel);
  if (view.forces) draw_forces(list, world, view, panel, scale_force);
  if (view.broken_bonds) draw_broken_bonds(list, world, view, panel);
  list.clip_to(panel.clip);
  draw_applied_forces(list, world, view, grains, panel);
  draw_periodic_sides(list, world, view, panel);
  draw_walls(list, world, view, panel, text);
  list.clip_to_picture();
}

// Whether bodies, or a part of the box between its sides, lie beyond the window.
bool is_part(const World& world, const WorldRect& window) {
  const bool wide = world.box.width > 0;
  if (wide && (window.low.x() > 0 || window.high.x() < world.box.width)) return true;
  return std::ranges::any_of(world.disks.position, [&](const Vec2& p) {
    return p.y() < window.low.y() || p.y() > window.high.y() ||
           (!wide && (p.x() < window.low.x() || p.x() > window.high.x()));
  });
}

// Around a panel that shows a part of the packing, whose edge would be taken for a side of the box.
void draw_frame(DrawList& list, const Panel& panel, Colour colour) {
  const PixelRect& place = panel.clip;
  list.frame({place.x - 1, place.y - 1, place.width + 2, place.height + 2}, 1, colour);
}

// A frame around the close-up, and around what it shows in the packing.
void draw_detail_frames(DrawList& list, const Panel& packing, const Panel& detail, Colour colour) {
  draw_frame(list, detail, colour);
  const WorldRect& part = detail.camera.window();
  const Vec2 top = packing.camera.to_pixel({part.low.x(), part.high.y()});
  const Vec2 bottom = packing.camera.to_pixel({part.high.x(), part.low.y()});
  const double y = std::max(std::round(top.y()), packing.clip.y);
  const double end = std::min(std::round(bottom.y()), packing.clip.bottom());
  const double left = std::round(top.x()), right = std::round(bottom.x());
  list.frame({left, y, right - left, end - y}, 1, colour);
}

}  // namespace

double text_size(const View& view) {
  if (view.text_size > 0) return view.text_size;
  return std::clamp(std::round(9 + std::min(view.width, view.height) / 120.0), 10.0, 40.0);
}

void check(const View& view) {
  const auto out_of_range = [](int size) {
    return size < kSmallestPicture || size > kLargestPicture;
  };
  if (out_of_range(view.width) || out_of_range(view.height)) {
    throw InputError("size", "a picture of " + std::to_string(view.width) + "x" +
                                 std::to_string(view.height) + " pixels cannot be drawn: both " +
                                 "must lie from " + std::to_string(kSmallestPicture) + " to " +
                                 std::to_string(kLargestPicture));
  }
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (view.window) {
    const auto& [low, high] = *view.window;
    const bool near = low.cwiseAbs().maxCoeff() <= kFarthestWindow &&
                      high.cwiseAbs().maxCoeff() <= kFarthestWindow;
    if (!(near && positive(view.window->size().minCoeff())))
      throw InputError("window",
                       "must have corners within 1e7 d of the origin, the second above "
                       "and to the right of the first");
  }
  const bool from_data = view.colour_low == 0 && view.colour_high == 0;
  if (!from_data && !(view.colour_low >= 0 && positive(view.colour_high - view.colour_low))) {
    throw InputError("colour_high",
                     "must be above colour_low, or both 0, which takes them from the data");
  }
  if (view.force_scale != 0 && !positive(view.force_scale)) {
    throw InputError("force_scale", "must be positive, or 0, which takes it from the data");
  }
  if (view.text_size != 0 && !(view.text_size >= kSmallestText && view.text_size <= kLargestText)) {
    throw InputError("text_size",
                     "text must be from 6 to 100 pixels high, or 0, which takes it from the size");
  }
}

Frame compose(const World& world, const View& view, const Font& font,
              std::span<const std::string> caption) {
  check(view);
  Plan plan(world, view, font, caption);
  const Colour frames = palette(view.theme).faint_ink;
  const Legend room = plan.room();
  const Layout layout = arrange(plan.request(), room);
  Frame frame{DrawList(view.width, view.height, palette(view.theme).background), layout,
              packing_panel(layout.packing, plan.window, plan.margins), std::nullopt};
  plan.content.close_up = layout.detail.has_value();
  if (layout.detail)
    frame.detail = detail_panel(world, *layout.detail, plan.window, plan.margins.bottom);

  if (!room.empty() && !leaves_room(frame.packing, plan))
    return compose(world, without_key(view), font, {});

  DrawList& list = frame.list;
  const double text = font.size(), scale_force = plan.content.force_scale;
  draw_world(list, world, view, plan.grains, frame.packing, text, scale_force);
  const bool chosen = view.window || follows_intruder(world, view);
  if (chosen && is_part(world, view_window(world, view))) draw_frame(list, frame.packing, frames);
  if (frame.detail) {
    draw_world(list, world, view, plan.grains, *frame.detail, text, scale_force);
    draw_detail_frames(list, frame.packing, *frame.detail, frames);
  }
  const Camera& shown = frame.detail ? frame.detail->camera : frame.packing.camera;
  plan.key(shown.scale()).draw(list, layout.key, layout.column);
  return frame;
}

DrawList compose_key(const World& world, const View& view, const Font& font,
                     double pixels_per_diameter) {
  const Plan plan(world, view, font, {});
  const PixelRect place = strip_place(plan.request(), plan.room());
  DrawList list(view.width, static_cast<int>(place.bottom() + place.y),
                palette(view.theme).background);
  plan.key(pixels_per_diameter).draw(list, place, false);
  return list;
}

int fitting_height(const World& world, const View& view, const Font& font,
                   std::span<const std::string> caption) {
  const Plan plan(world, view, font, caption);
  return fitting_height(plan.request(), plan.room());
}

}  // namespace quicksand
