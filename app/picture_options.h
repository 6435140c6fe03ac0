// The options that say how pictures look, the same for every command that makes some.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "render/view.h"

namespace quicksand {

struct PictureOptions {
  std::string colour = "active_bonds";
  std::string theme = "light";
  std::string size = "1280x720";
  bool bonds = false;
  bool forces = false;
};

void add_picture_options(CLI::App& command, PictureOptions& options);

// Throws InputError if a name or the size is not valid.
View view_from(const PictureOptions& options);

}  // namespace quicksand
