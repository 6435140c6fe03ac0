#include "render/gl/offscreen.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <string>

#include "render/base/render_error.h"
#include "render/draw/canvas.h"

namespace quicksand {
namespace {

// Sets the variable until the end of the block.
class Chosen {
 public:
  explicit Chosen(const char* context) : before_(std::getenv(kVariable)) {
    if (before_ != nullptr) kept_ = before_;
    setenv(kVariable, context, 1);
  }
  ~Chosen() { before_ != nullptr ? setenv(kVariable, kept_.c_str(), 1) : unsetenv(kVariable); }
  Chosen(const Chosen&) = delete;
  Chosen& operator=(const Chosen&) = delete;

 private:
  static constexpr const char* kVariable = "QUICKSAND_OFFSCREEN";
  const char* before_;
  std::string kept_;
};

TEST(Offscreen, AContextThatThereIsNotIsRefusedWithThoseThatThereAre) {
  const Chosen context("vulkan");
  try {
    const auto offscreen = offscreen_context();
    FAIL() << "it was taken";
  } catch (const RenderError& error) {
    EXPECT_STREQ(error.what(), "QUICKSAND_OFFSCREEN is \"vulkan\"; it can be osmesa or egl");
  }
}

TEST(Offscreen, HasASurfaceOfEachSizeThatIsAskedFor) {
  for (const char* name : {"osmesa", "egl"}) {
    const Chosen context(name);
    const auto offscreen = offscreen_context();
    for (const int size : {1, 300, 7}) {
      offscreen->make_current(size, 2 * size);
      EXPECT_NE(offscreen->pixels(), nullptr) << name;
    }
    EXPECT_NE(offscreen->function("glClear"), nullptr) << name;
  }
}

// Whoever goes on after a picture that did not fit must not paint beyond the surface of the one before.
TEST(Offscreen, ASizeThatWasRefusedIsRefusedAgainAndOthersAreDrawn) {
  constexpr int kTooLarge = std::numeric_limits<int>::max();
  Canvas canvas;
  canvas.clear(32, 20, {});
  for (int k = 0; k < 2; ++k) EXPECT_ANY_THROW(canvas.clear(kTooLarge, kTooLarge, {}));
  canvas.clear(32, 20, {1, 2, 3});
  EXPECT_EQ(canvas.finish().pixel(31, 19)[2], 3);
}

}  // namespace
}  // namespace quicksand
