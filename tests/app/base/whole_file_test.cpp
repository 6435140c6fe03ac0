// A file is there as a whole or not at all, and takes the place of nothing but a file.
#include "core/base/whole_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <string>
#include <thread>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

TEST(WholeFileTest, IsNotThereBeforeItIsFinished) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a";
  {
    WholeFile file(path);
    file.stream() << "half";
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
  write_whole(path, "all");
  EXPECT_EQ(contents(path), "all");
}

// As two processes do that compute the same campaign.
TEST(WholeFileTest, WrittenByTwoAtOnceIsWhatOneOfThemWrote) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a";
  const auto write_often = [&](char letter) {
    for (int i = 0; i < 300; ++i) write_whole(path, std::string(20000, letter));
  };
  std::thread other(write_often, 'b');
  EXPECT_NO_THROW(write_often('a'));
  other.join();
  const std::string text = contents(path);
  EXPECT_EQ(text, std::string(20000, text.front()));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "no part is left";
}

// A film that is under way, and a picture that is given its name.
TEST(WholeFileTest, IsNotWaitedForByWhoWritesTheSame) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a";
  WholeFile first(path);
  first.stream() << "first";
  write_whole(path, "second");
  EXPECT_EQ(contents(path), "second");
  first.finish();
  EXPECT_EQ(contents(path), "first");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1) << "no part is left";
}

TEST(WholeFileTest, WritesWhereALinkLeads) {
  const TemporaryFolder folder;
  folder.write("target", "before");
  fs::create_symlink("target", folder.path() / "link");
  write_whole(folder.path() / "link", "after");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_EQ(contents(folder.path() / "target"), "after");
}

TEST(WholeFileTest, RefusesToReplaceAPipe) {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(write_whole(pipe, "text"), InputError);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(WholeFileTest, AFullDiskIsNoBadInput) {
  EXPECT_THROW(refuse_to_write("a", ENOSPC), DiskFull);
  try {
    refuse_to_write("a", EACCES);
  } catch (const InputError& error) {
    EXPECT_EQ(dynamic_cast<const DiskFull*>(&error), nullptr);
  }
}

}  // namespace
}  // namespace quicksand::test
