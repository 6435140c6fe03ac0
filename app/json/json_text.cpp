#include "app/json/json_text.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "app/json/fields.h"
#include "core/base/memory.h"

namespace quicksand {

namespace {

std::string line_and_column(std::string_view text, std::size_t position) {
  const std::string_view before = text.substr(0, std::min(position, text.size()));
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

constexpr std::size_t kLongestProblem = 300;  // it holds what was read last

// Builds a value from the parser's events, and refuses what must not be built.
class Builder : public nlohmann::json_sax<Json> {
 public:
  explicit Builder(std::string_view text) : text_(text) {}
  Json take() { return std::move(root_); }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  bool number_integer(number_integer_t value) override { return put(value); }
  bool number_unsigned(number_unsigned_t value) override { return put(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return put(value); }
  bool string(string_t& value) override { return put(std::move(value)); }
  bool binary(binary_t& /*value*/) override { return false; }  // never sent for JSON text
  bool start_object(std::size_t /*size*/) override { return open(Json::object()); }
  bool start_array(std::size_t /*size*/) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (open_.back()->size() >= kMaxKeys) {
      throw InputError("", "an object has more than " + std::to_string(kMaxKeys) + " keys");
    }
    if (open_.back()->contains(name)) {
      throw InputError("", "the key \"" + shortened(name) + "\" is given twice in the same object" +
                               (open_.size() == 1 ? "" : ", the one inside " + place()));
    }
    key_ = name;
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    std::string problem = error.what();
    // The library's prefix "[json.exception...] parse error at line .. column ..: " says it twice.
    if (const std::size_t cut = problem.find(": "); problem.starts_with("[json.exception.parse")) {
      problem = problem.substr(cut == std::string::npos ? 0 : cut + 2);
    } else if (problem.find("number overflow") != std::string::npos) {
      problem = "the number " + shortened(token) + " is not finite in double precision";
    }
    const std::size_t at = position == 0 ? 0 : position - 1;
    throw InputError("", "not valid JSON at " + line_and_column(text_, at) + ": " +
                             shortened(problem, kLongestProblem) + comma_hint(at));
  }

 private:
  // A comma before a closing bracket is usual elsewhere; the parser only says what it did not expect.
  std::string comma_hint(std::size_t at) const {
    if (at >= text_.size() || (text_[at] != ']' && text_[at] != '}')) return {};
    const std::size_t before = text_.find_last_not_of(" \t\r\n", at == 0 ? 0 : at - 1);
    if (before == std::string_view::npos || text_[before] != ',') return {};
    return "; the comma at " + line_and_column(text_, before) + " is one too many";
  }

  Json* insert(Json value) {
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& parent = *open_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    return &(parent[key_] = std::move(value));
  }
  bool put(Json value) {
    insert(std::move(value));
    return true;
  }
  bool open(Json container) {
    if (open_.size() >= static_cast<std::size_t>(kMaxDepth)) {
      throw InputError("", "nested deeper than " + std::to_string(kMaxDepth) + " levels");
    }
    names_.push_back(open_.empty()              ? std::string()
                     : open_.back()->is_array() ? "[" + std::to_string(open_.back()->size()) + "]"
                                                : (names_.size() > 1 ? "." : "") + key_);
    open_.push_back(insert(std::move(container)));
    return true;
  }
  bool close() {
    open_.pop_back();
    names_.pop_back();
    return true;
  }
  std::string place() const {
    std::string path;
    for (const std::string& name : names_) path += name;
    return path;
  }

  std::string_view text_;
  Json root_;
  std::vector<Json*> open_;         // containers from the root to the present one
  std::vector<std::string> names_;  // their names, as path pieces
  std::string key_;
};

// Asked for beforehand: what a half-built list needs to be destroyed must be there, too.
void require_memory(std::string_view text) {
  constexpr double kBytesPerValue = 64;  // of a list that grows
  const auto values = std::ranges::count(text, ',');
  const std::string problem = memory_problem(kBytesPerValue * static_cast<double>(values));
  if (!problem.empty())
    throw NotEnoughMemory("reading " + std::to_string(values) + " JSON values " + problem);
}

}  // namespace

Json parse_json(std::string_view text) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError("", "is empty; a JSON object {...} is expected");
  }
  if (text.size() > kMaxBytes) throw InputError("", "is larger than 64 MB");
  // The parser would take it for the end, and never see what follows.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    throw InputError("", "not valid JSON at " + line_and_column(text, zero) + ": a byte 0");
  require_memory(text);
  Builder builder(text);
  Json::sax_parse(text, &builder);
  return builder.take();
}

bool is_utf8(const std::string& text) {
  try {
    Json(text).dump();
    return true;
  } catch (const Json::type_error&) {
    return false;
  }
}

Json read_json(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  return in_file(file, [&] { return parse_json(text); });
}

std::string read_text(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    throw InputError("", "there is no such file").in(path.string());
  if (std::filesystem::is_directory(status)) {
    throw InputError(path.string(), "is a folder, not a file");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path.string(), "cannot be read");
  std::string text;
  // Read in pieces: a pipe has no size, and an endless one must end.
  std::vector<char> piece(std::size_t{1} << 16U);
  while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())), file.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > kMaxBytes) throw InputError(path.string(), "is larger than 64 MB");
  }
  return text;
}

}  // namespace quicksand
