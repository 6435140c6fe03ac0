// Numbers in text.
#pragma once

#include <string>

namespace quicksand {

// printf into a string of at most 511 bytes.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

}  // namespace quicksand
