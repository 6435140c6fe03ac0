// Strict JSON text: what an editor accepts silently and a reader would guess at is refused here.
//
// Refused: syntax errors and numbers that are not finite, with line and column; bytes 0; duplicate keys, with
// the object that they are in; nesting deeper than kMaxDepth, objects of more than kMaxKeys, texts
// larger than kMaxBytes. Key order is kept.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/errors.h"

namespace quicksand {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxBytes = std::size_t{64} << 20U;
constexpr int kMaxDepth = 64;
constexpr std::size_t kMaxKeys = 1000;

// Throws InputError, whose `where` is empty; line and column are in the message; NotEnoughMemory where there is too
// little for its values.
Json parse_json(std::string_view text);

// Whether a text can be a text of JSON: what comes from a command line or names a file need not be.
bool is_utf8(const std::string& text);

// What `work` gives; an InputError of it then names the file, too.
template <class Work>
auto in_file(const std::filesystem::path& file, Work work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw error.in(file.string());
  }
}

// That of a file. Throws InputError whose `where` is the file.
Json read_json(const std::filesystem::path& file);

// Contents of a file of at most kMaxBytes. Throws InputError if there is none or it is no file.
std::string read_text(const std::filesystem::path& path);

}  // namespace quicksand
