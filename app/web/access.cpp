#include "app/web/access.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>

#include "core/base/errors.h"
#include "core/base/format.h"
#include "core/base/whole_file.h"

namespace quicksand {

namespace {

constexpr std::size_t kTokenBytes = 16;
constexpr std::size_t kLongestName = 200;

bool is_hex(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

bool is_token(std::string_view text) {
  return text.size() == 2 * kTokenBytes && std::ranges::all_of(text, is_hex);
}

// An address without its port: "[::1]:80" is [::1].
std::string_view host_of(std::string_view address) {
  if (address.starts_with('[')) {
    const std::size_t end = address.find(']');
    return end == std::string_view::npos ? std::string_view() : address.substr(0, end + 1);
  }
  return address.substr(0, address.find(':'));
}

std::string new_token(const std::filesystem::path& file) {
  std::string token = random_token();
  const OpenFile made(open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  const auto refuse = [&](int error) {
    throw InputError(file.string(), std::string("cannot be written: ") + std::strerror(error));
  };
  if (made.number() < 0) refuse(errno);
  if (write(made.number(), token.data(), token.size()) != static_cast<ssize_t>(token.size())) {
    const int error = errno;
    unlink(file.c_str());  // a part of a token would be refused the next time
    refuse(error);
  }
  return token;
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, kTokenBytes> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw InputError("token", "this system provides no random numbers");
  std::string token;
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (const unsigned char byte : bytes) {
    token += kDigits[byte >> 4U];
    token += kDigits[byte & 15U];
  }
  return token;
}

std::string token_of(const std::filesystem::path& file) {
  const OpenFile found(open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (found.number() < 0 && errno == ENOENT) return new_token(file);
  struct stat about {};
  if (found.number() < 0 || fstat(found.number(), &about) != 0)
    throw InputError(file.string(), std::string("cannot be read: ") + std::strerror(errno));
  if ((about.st_mode & 077U) != 0)
    throw InputError(file.string(), "can be read by others; `chmod 600` it");
  std::array<char, 2 * kTokenBytes> text{};
  const ssize_t got = read(found.number(), text.data(), text.size());
  std::string token(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
  if (!is_token(token))
    throw InputError(file.string(), "holds no token: " + std::to_string(2 * kTokenBytes) +
                                        " hexadecimal digits; remove it to get a new one");
  return token;
}

bool same_secret(std::string_view given, std::string_view secret) {
  unsigned different = given.size() == secret.size() ? 0U : 1U;
  for (std::size_t i = 0; i < secret.size(); ++i) {
    const char c = given.empty() ? '\0' : given[i % given.size()];
    different |= static_cast<unsigned char>(static_cast<unsigned char>(c) ^
                                            static_cast<unsigned char>(secret[i]));
  }
  return different == 0 && !secret.empty();
}

std::string_view cookie(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    const std::size_t end = header.find(';');
    std::string_view part = header.substr(0, end);
    while (part.starts_with(' ')) part.remove_prefix(1);
    if (part.starts_with(name) && part.size() > name.size() && part[name.size()] == '=')
      return part.substr(name.size() + 1);
    if (end == std::string_view::npos) break;
    header.remove_prefix(end + 1);
  }
  return {};
}

bool is_our_host(std::string_view host, std::string_view named) {
  const std::string name = lower(host_of(host));
  constexpr auto kOurs = std::to_array<std::string_view>({"127.0.0.1", "localhost", "[::1]"});
  if (std::ranges::find(kOurs, name) != kOurs.end()) return true;
  return !named.empty() && (name == lower(named) || name == "[" + lower(named) + "]");
}

bool is_same_origin(std::string_view origin, std::string_view host) {
  if (origin.empty()) return true;
  const std::size_t at = origin.find("://");
  return at != std::string_view::npos && !host.empty() &&
         lower(origin.substr(at + 3)) == lower(host);
}

bool is_any_address(std::string_view address) {
  return address == "0.0.0.0" || address == "::" || address == "0";
}

bool is_loopback(std::string_view address) {
  return address == "localhost" || address == "::1" || address.starts_with("127.");
}

bool is_plain_name(std::string_view name) {
  if (name.empty() || name.size() > kLongestName) return false;
  bool first = true;  // letter of a word
  for (const char c : name) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    if (c == '/' ? first : !letter && (first || (c != '.' && c != '-'))) return false;
    first = c == '/';
  }
  return !first;
}

}  // namespace quicksand
