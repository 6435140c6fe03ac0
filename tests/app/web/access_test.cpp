// Who is admitted: tokens, names of hosts, origins, names of files.
#include "app/web/access.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "core/base/errors.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

TEST(Access, OnlyTheWholeTokenIsTheToken) {
  EXPECT_TRUE(same_secret("abc", "abc"));
  for (const char* wrong : {"", "a", "ab", "abd", "Abc", "abca", "abcabc"})
    EXPECT_FALSE(same_secret(wrong, "abc")) << wrong;
  EXPECT_FALSE(same_secret("", "")) << "no token admits nobody";
}

TEST(Access, ATokenFileIsMadeOnceAndForItsOwnerAlone) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "token";
  const std::string token = token_of(file);
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(token_of(file), token);
  EXPECT_EQ(std::filesystem::status(file).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  EXPECT_NE(random_token(), token);
  chmod(file.c_str(), 0644);
  EXPECT_THROW(token_of(file), InputError);
}

TEST(Access, AFileWithoutATokenIsRefused) {
  const TemporaryFolder folder;
  const auto file = folder.write("token", "secret\n");
  chmod(file.c_str(), 0600);
  EXPECT_THROW(token_of(file), InputError);
}

TEST(Access, ACookieIsFoundByItsWholeName) {
  EXPECT_EQ(cookie("a=1; quicksand_80=xyz; b=2", "quicksand_80"), "xyz");
  EXPECT_EQ(cookie("quicksand_8080=xyz", "quicksand_80"), "");
  EXPECT_EQ(cookie("", "a"), "");
}

TEST(Access, OnlyNamesThatMeanThisMachineAreItsNames) {
  for (const char* ours : {"127.0.0.1:7878", "localhost:1", "LOCALHOST", "[::1]:80"})
    EXPECT_TRUE(is_our_host(ours, "")) << ours;
  for (const char* other : {"", "example.org", "localhost.example.org:80", "127.0.0.1.example.org",
                            "10.0.0.5:7878", "[::1"})
    EXPECT_FALSE(is_our_host(other, "")) << other;
  EXPECT_TRUE(is_our_host("sim.example.org:443", "sim.example.org"));
  EXPECT_TRUE(is_our_host("[fe80::1]:443", "fe80::1"));
}

TEST(Access, APageFromElsewhereIsOfAnotherOrigin) {
  EXPECT_TRUE(is_same_origin("http://127.0.0.1:80", "127.0.0.1:80"));
  EXPECT_TRUE(is_same_origin("https://sim.example.org", "sim.example.org"));
  EXPECT_TRUE(is_same_origin("", "127.0.0.1:80")) << "a program sends none";
  for (const char* other : {"null", "http://127.0.0.1:81", "http://evil.example", "127.0.0.1:80"})
    EXPECT_FALSE(is_same_origin(other, "127.0.0.1:80")) << other;
}

TEST(Access, NamesOfFilesLeadNowhereElse) {
  for (const char* plain : {"a.csv", "film/film.png", "a-b_c.9/x"})
    EXPECT_TRUE(is_plain_name(plain)) << plain;
  for (const char* other : {"", ".", "..", "../a", "a/../b", "/etc/passwd", "a//b", "a/", ".hidden",
                            "a/.b", "a\\b", "a%2fb", "a b", "-x"})
    EXPECT_FALSE(is_plain_name(other)) << other;
  EXPECT_FALSE(is_plain_name(std::string(1000, 'a')));
  EXPECT_FALSE(is_plain_name(std::string("a\0b", 3)));
}

}  // namespace
}  // namespace quicksand::test
