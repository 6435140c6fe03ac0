// Text of numbers and of lists.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace quicksand {

// printf into a string of at most 511 bytes.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

// Letters of ASCII in lower case.
std::string lower(std::string_view text);

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
