// A film that every browser plays: the frames of a folder as an animated PNG, without any other program.
//
// Frames are reduced by a whole factor until they are small, every pixel that stays is left out, and a few frames at a time are in
// memory, shared between the cores. Chunks acTL, fcTL and fdAT: [PNG 2003] with its third edition's animation.
#pragma once

#include <cstddef>
#include <filesystem>

#include "render/film/video.h"

namespace quicksand {

// The most frames of an animation, evenly spaced among those of the folder, and its longest side [px].
constexpr std::size_t kMostAnimatedFrames = 300;
constexpr int kLongestAnimatedSide = 960;

// Puts FOLDER/frame_000000.png ... into `path`, as a whole or not at all; the last frame stays for two seconds,
// then it begins again. Equal frames give equal bytes. Never throws: a film is a bonus.
VideoReport write_animation(const std::filesystem::path& frames, const std::filesystem::path& path);

}  // namespace quicksand
