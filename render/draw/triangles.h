// A picture of triangles, as toolkits for panels give it: pure data.
#pragma once

#include <cstdint>
#include <vector>

#include "render/base/camera.h"
#include "render/base/colour.h"

namespace quicksand {

struct TriangleVertex {
  float x = 0, y = 0;  // [px]
  float u = 0, v = 0;  // in the atlas of letters, (0, 0) its top left corner, (1, 1) the other end
  Colour colour;       // its opacity is multiplied by that of the atlas
};

struct TriangleList {
  // A run of triangles within one clipping rectangle.
  struct Batch {
    std::size_t first = 0;  // among the indices
    std::size_t count = 0;  // of indices
    PixelRect clip;
  };

  std::vector<TriangleVertex> vertices;
  std::vector<std::uint32_t> indices;  // three a triangle
  std::vector<Batch> batches;          // painted in this order
};

}  // namespace quicksand
