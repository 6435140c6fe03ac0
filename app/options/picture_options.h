// The options that say how pictures look, the same for every command that makes some.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/options/cli_app.h"
#include "render/base/view.h"

namespace quicksand {

struct PictureOptions {
  View view;                       // its flags and numbers
  std::vector<std::string> words;  // one a word of the view, in their order
  std::string size;
  std::vector<double> window;  // x and y of its corners, or empty
  PictureOptions();
};

void add_picture_options(CLI::App& command, PictureOptions& options);

// The options that make such a picture, " --size 640x480", those that are the usual left out.
std::string picture_words(const View& view);

// Reads "1280x720". Throws InputError if it is not of that form or cannot be drawn.
void read_size(const std::string& text, int& width, int& height);

// Throws InputError if a picture could not be told by its name.
void require_png(const std::filesystem::path& out);

// Throws InputError if a name, the size, the window or the range of the colours is not valid.
View view_from(const PictureOptions& options);

}  // namespace quicksand
