// The page of all keys of a scene: `quicksand list scene_reference`, assets/doc/scene_reference.md.
#pragma once

#include <string>

namespace quicksand {

// Markdown, made of the descriptions that the reader obeys. Throws std::out_of_range if a phase has no
// sentence that introduces it.
std::string scene_reference();

}  // namespace quicksand
