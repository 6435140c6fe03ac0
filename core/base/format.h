// Text of numbers, of lists and of numbers of things.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace quicksand {

// printf into a string of at most 511 bytes.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

// Letters of ASCII in lower case.
std::string lower(std::string_view text);

// The noun for so many: "run" for 1, else "runs"; `many` where an s does not make the plural.
std::string noun_for(double n, std::string_view one, std::string_view many = {});

// "1 run", "20 runs".
std::string count_text(std::int64_t n, std::string_view one, std::string_view many = {});

// The items with the separator between them, each as `text` gives it.
template <class Items, class Text = std::identity>
std::string joined(const Items& items, std::string_view separator, Text text = {}) {
  std::string all;
  for (bool first = true; const auto& item : items) {
    if (!std::exchange(first, false)) all += separator;
    all += std::invoke(text, item);
  }
  return all;
}

}  // namespace quicksand
