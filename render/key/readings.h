// Time and key numbers of a world, in words.
#pragma once

#include <string>
#include <vector>

#include "core/world/world.h"
#include "render/base/view.h"

namespace quicksand {

struct Reading {
  std::string text;     // in the markup of font.h; empty if there is no such thing now
  std::string longest;  // the room to keep for it in any frame of a film
};
std::vector<Reading> readings(const World& world, const View& view);

}  // namespace quicksand
