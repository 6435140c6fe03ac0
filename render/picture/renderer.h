// World + View -> Image, on the processor, without a display.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/world/world.h"
#include "render/base/view.h"
#include "render/image/image.h"
#include "render/picture/side_by_side.h"

namespace quicksand {

class Font;

// Owns one drawing context. Use it from one thread; several renderers may live side by side.
class Renderer {
 public:
  // Throws RenderError if this system cannot draw. Sets the environment variables that make the
  // pixels reproducible, unless the user has set them: construct it before starting threads.
  Renderer();
  ~Renderer();

  // The same world and view give the same bytes. `caption` lines stand at the head of the numbers
  // (a scene's name, the present phase); their count should stay the same throughout a film.
  // Throws InputError if the view asks for a size that cannot be drawn.
  Image draw(const World& world, const View& view, std::span<const std::string> caption = {});
  // As high as the packing needs that fills the whole width, with the key above it.
  Image draw_fitting(const World& world, View view, std::span<const std::string> caption = {});
  // As compose_side_by_side() says. Throws as above.
  Image draw_panels(std::span<const SideBySide> panels);

 private:
  struct Impl;
  const Font& font_of(const View& view);

  std::unique_ptr<Impl> impl_;
};

}  // namespace quicksand
