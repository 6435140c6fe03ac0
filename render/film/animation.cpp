#include "render/film/animation.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/whole_file.h"
#include "render/film/frame_files.h"
#include "render/image/image_difference.h"
#include "render/image/image_paste.h"
#include "render/image/png.h"
#include "render/image/png_reader.h"

namespace quicksand {
namespace {

constexpr int kChannels = 4;  // red, green, blue, opacity
constexpr int kSmaller = 6;   // level of compression; 9 takes four times as long for 3 % less
constexpr std::size_t kTogether = 16;      // frames in memory
constexpr std::uint16_t kRate = 30;        // frames a second
constexpr std::uint16_t kLastFrames = 60;  // for as many the last one stays

// The means of squares of pixels, as many a side; what is left at the right and lower edge goes.
Image reduced(const Image& image, int side) {
  Image small(image.width / side, image.height / side);
  const int squares = side * side;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        int sum = squares / 2;
        for (int k = 0; k < squares; ++k)
          sum += image.pixel(x * side + k % side, y * side + k / side)[channel];
        small.pixel(x, y)[channel] = static_cast<std::uint8_t>(sum / squares);
      }
  return small;
}

// Pixels from (left, top) up to, without, (right, bottom).
struct Part {
  int left, top, right, bottom;
};

// From one frame to the next.
struct Step {
  Image now;
  Part part{};
  std::vector<std::uint8_t> rows;  // of the part, packed in the end
};

// Whether a pixel looks other than the one that is shown, by the rule of all pictures.
bool differs(const Image& shown, const Image& now, int x, int y) {
  const std::uint8_t *a = shown.pixel(x, y), *b = now.pixel(x, y);
  return std::abs(a[0] - b[0]) > kSameLook || std::abs(a[1] - b[1]) > kSameLook ||
         std::abs(a[2] - b[2]) > kSameLook;
}

// Where two pictures of one size differ; a pixel if nowhere.
Part changed(const Image& shown, const Image& now) {
  Part part{now.width, now.height, 0, 0};
  for (int y = 0; y < now.height; ++y)
    for (int x = 0; x < now.width; ++x) {
      if (!differs(shown, now, x, y)) continue;
      part = {std::min(part.left, x), std::min(part.top, y), std::max(part.right, x + 1),
              std::max(part.bottom, y + 1)};
    }
  return part.left < part.right ? part : Part{0, 0, 1, 1};
}

// Rows of a part for a PNG that turn what is shown into the picture: transparent where it stays. Nothing does in the
// first frame, whose dark pixels would let the page behind them through.
std::vector<std::uint8_t> turn(Image& shown, const Image& now, const Part& part, bool first) {
  std::vector<std::uint8_t> rows;
  rows.reserve(static_cast<std::size_t>(part.bottom - part.top) *
               (1 + kChannels * static_cast<std::size_t>(part.right - part.left)));
  for (int y = part.top; y < part.bottom; ++y) {
    rows.push_back(kUnfiltered);
    for (int x = part.left; x < part.right; ++x) {
      if (!first && !differs(shown, now, x, y)) {
        rows.insert(rows.end(), kChannels, 0);
        continue;
      }
      std::copy_n(now.pixel(x, y), 3, shown.pixel(x, y));
      rows.insert(rows.end(), now.pixel(x, y), now.pixel(x, y) + 3);
      rows.push_back(0xFF);
    }
  }
  return rows;
}

class AnimationFile {
 public:
  AnimationFile(const std::filesystem::path& path, int width, int height, std::size_t frames)
      : file_(path), frames_(frames) {
    PngBytes head;
    constexpr std::uint8_t kBits = 8, kRgbWithOpacity = 6;
    head.number(static_cast<std::uint32_t>(width)).number(static_cast<std::uint32_t>(height));
    head.bytes(std::array<std::uint8_t, 5>{kBits, kRgbWithOpacity, 0, 0, 0});
    write(kPngSignature);
    chunk("IHDR", head);
    constexpr std::uint32_t kForEver = 0;
    chunk("acTL", PngBytes().number(static_cast<std::uint32_t>(frames)).number(kForEver));
  }

  // Draws a part over what is there; rows as packed() gives them.
  void add(const Part& part, const std::vector<std::uint8_t>& rows) {
    const bool first = written_ == 0, last = ++written_ == frames_;
    constexpr std::uint8_t kLeave = 0, kReplace = 0, kOver = 1;
    PngBytes control;
    control.number(sequence_++);
    for (const int length : {part.right - part.left, part.bottom - part.top, part.left, part.top})
      control.number(static_cast<std::uint32_t>(length));
    control.half(last ? kLastFrames : 1).half(kRate);
    control.bytes(std::array<std::uint8_t, 2>{kLeave, first ? kReplace : kOver});
    chunk("fcTL", control);
    PngBytes data;
    if (!first) data.number(sequence_++);
    data.bytes(rows);
    chunk(first ? "IDAT" : "fdAT", data);
  }

  void finish() {
    chunk("IEND", {});
    file_.finish();
  }

 private:
  template <class Bytes>
  void write(const Bytes& bytes) {
    file_.stream().write(reinterpret_cast<const char*>(std::data(bytes)),
                         static_cast<std::streamsize>(std::size(bytes)));
  }
  void chunk(std::string_view name, const PngBytes& data) { write(png_chunk(name, data.all())); }

  WholeFile file_;
  std::size_t frames_, written_ = 0;
  std::uint32_t sequence_ = 0;
};

}  // namespace

VideoReport write_animation(const std::filesystem::path& frames,
                            const std::filesystem::path& path) {
  using enum VideoReport::Outcome;
  try {
    std::vector<std::filesystem::path> files;
    for (const auto& [number, file] : frame_files(frames)) files.push_back(file);
    if (files.empty()) return {no_frames, "no film: there are no frames in " + frames.string()};
    const std::size_t count = std::min(files.size(), kMostAnimatedFrames);
    const Image first = read_png(files.front());
    const int side = (std::max(first.width, first.height) - 1) / kLongestAnimatedSide + 1;
    if (std::min(first.width, first.height) < side)
      return {failed, "no film: its frames are too narrow for their length"};
    Image shown(first.width / side, first.height / side);
    AnimationFile film(path, shown.width, shown.height, count);
    const std::size_t last = std::max<std::size_t>(count - 1, 1);
    // Reading and packing take the time, and each frame's its own.
    std::vector<Step> steps;
    for (std::size_t begin = 0; begin < count; begin += steps.size()) {
      steps.assign(std::min(kTogether, count - begin), {});
      share_parts(static_cast<int>(steps.size()), [&](int part) {
        const auto k = static_cast<std::size_t>(part);
        Step& step = steps[k];
        // A picture may change its size on the way.
        step.now = Image(shown.width, shown.height);
        paste(step.now, reduced(read_png(files[(begin + k) * (files.size() - 1) / last]), side), 0,
              0);
      });
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const Image& now = steps[k].now;
        const bool is_first = begin + k == 0;
        steps[k].part = is_first ? Part{0, 0, now.width, now.height} : changed(shown, now);
        steps[k].rows = turn(shown, now, steps[k].part, is_first);
      }
      share_parts(static_cast<int>(steps.size()), [&](int part) {
        std::vector<std::uint8_t>& rows = steps[static_cast<std::size_t>(part)].rows;
        rows = packed(rows, kSmaller);
      });
      for (const Step& step : steps) film.add(step.part, step.rows);
    }
    film.finish();
    return {written, std::to_string(count) + " frames in " + path.string()};
  } catch (const std::exception& error) {
    return {failed, std::string("no film: ") + error.what()};
  }
}

}  // namespace quicksand
