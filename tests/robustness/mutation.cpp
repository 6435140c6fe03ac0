#include "tests/robustness/mutation.h"

#include <algorithm>

namespace quicksand::test {

namespace {

constexpr const char* kNumbers[] = {"0",
                                    "-1",
                                    "1e308",
                                    "-1e308",
                                    "1e-308",
                                    "1e999",
                                    "2147483648",
                                    "1e6",
                                    "1000000",
                                    "9007199254740993",
                                    "null",
                                    "true",
                                    "\"x\"",
                                    "[]",
                                    "{}",
                                    "0.1",
                                    "-0",
                                    "1e12",
                                    "18446744073709551616",
                                    "[1,2]"};
constexpr const char* kPieces[] = {
    "{",       "}",  "[",  "]",   ",",  ":", "\"", "\\", "\\u0000", "\xFF", "[[[[[[[[[[[[[[[[",
    "{\"a\":", "\n", "/*", "nan", "../"};
constexpr std::size_t kLongest = std::size_t{1} << 20U;  // [bytes]

bool in_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; }

}  // namespace

Mutation::Mutation(unsigned seed, std::vector<std::string> seeds)
    : random_(seed), seeds_(std::move(seeds)) {}

void Mutation::change_bytes(std::string& text) {
  if (text.empty()) return;
  const std::size_t at = below(text.size());
  if (below(2) == 0)
    text[at] = static_cast<char>(below(256));
  else
    text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << below(8)));
}

// Another value in the place of the first number after a random place.
void Mutation::change_number(std::string& text) {
  const auto from = text.begin() + static_cast<std::ptrdiff_t>(below(text.size()));
  const auto begin = std::find_if(from, text.end(), in_number);
  const auto end = std::find_if_not(begin, text.end(), in_number);
  text.replace(begin, end, kNumbers[below(std::size(kNumbers))]);
}

// A piece is taken away, doubled, or taken from another seed; or a bracket comes in.
void Mutation::change_piece(std::string& text) {
  const std::size_t at = below(text.size());
  const std::size_t length = below(std::min<std::size_t>(text.size() - at, 200) + 1);
  const std::string& other = seeds_[below(seeds_.size())];
  switch (below(4)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(at, text.substr(at, length));
      break;
    case 2:
      text.insert(at, other.substr(below(other.size()), 1 + below(200)));
      break;
    default:
      text.insert(at, kPieces[below(std::size(kPieces))]);
  }
}

std::string Mutation::next() {
  std::string text = seeds_[below(seeds_.size())];
  for (std::size_t changes = 1 + below(1 + below(8)); changes > 0; --changes) {
    const std::size_t kind = below(5);
    if (kind < 2) change_number(text);
    if (kind == 2) change_bytes(text);
    if (kind > 2) change_piece(text);
  }
  if (text.size() > kLongest) text.resize(kLongest);
  return text;
}

}  // namespace quicksand::test
