// A picture of triangles with textures, as toolkits for panels give it: pure data.
#pragma once

#include <cstdint>
#include <vector>

#include "render/camera.h"
#include "render/colour.h"

namespace quicksand {

// Given by a TrianglePainter.
enum class Texture : std::uint32_t {};

struct TriangleVertex {
  float x = 0, y = 0;  // [px]
  float u = 0, v = 0;  // in the texture, (0, 0) its top left corner, (1, 1) the other end
  Colour colour;       // multiplies the texture
};

struct TriangleList {
  // A run of triangles with one texture within one clipping rectangle.
  struct Batch {
    std::size_t first = 0;  // among the indices
    std::size_t count = 0;  // of indices
    Texture texture{};
    PixelRect clip;
  };

  int width = 0, height = 0;  // [px]
  Colour background;
  std::vector<TriangleVertex> vertices = {};
  std::vector<std::uint32_t> indices = {};  // three a triangle
  std::vector<Batch> batches = {};          // painted in this order
};

}  // namespace quicksand
