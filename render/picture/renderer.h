// World + View -> Image, on the processor, without a display.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/world/world.h"
#include "render/base/view.h"
#include "render/image/image.h"

namespace quicksand {

class Font;

// One of several worlds that are drawn side by side.
struct SideBySide {
  const World& world;
  const View& view;  // its units, its method and what it fits; all else is that of the first
  std::string caption;
};

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
  // Side by side, each with a caption and its own numbers, over one key, with one range of colours and one scale of
  // forces. Worlds with equal boxes have equal scales; where those differ, each panel has a bar of its own.
  Image draw_panels(std::span<const SideBySide> panels);

 private:
  struct Impl;
  const Font& font_of(const View& view);

  std::unique_ptr<Impl> impl_;
};

}  // namespace quicksand
