#include "render/gl/shader_texts.h"

#include <array>

#include "quicksand_shaders.h"

namespace quicksand {

std::span<const ShaderText> shader_texts() {
  static constexpr auto kTexts =
      std::to_array<ShaderText>({{"vertex_head", shaders::kVertexHead},
                                 {"disk_vertex", shaders::kDiskVertex},
                                 {"disk_fragment", shaders::kDiskFragment},
                                 {"segment_vertex", shaders::kSegmentVertex},
                                 {"segment_fragment", shaders::kSegmentFragment}});
  return kTexts;
}

}  // namespace quicksand
