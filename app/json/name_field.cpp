#include "app/json/name_field.h"

#include <algorithm>

#include "app/json/json_text.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr std::size_t kLongest = 100;  // [bytes]

bool can_name_a_folder(const std::string& name) {
  return name.size() <= kLongest && name.find('/') == std::string::npos && !name.starts_with('.') &&
         !has_control_characters(name);
}

std::string what_can_name_a_folder() {
  return "names the output folder: at most " + std::to_string(kLongest) +
         " bytes, no \"/\", no \".\" first, no control characters";
}

}  // namespace

void describe_heading(Fields& f, std::string& name, std::string& description, const char* help) {
  std::string schema;  // for editors; means nothing to the program
  f.text({"$schema", "path of this schema, for editors"}, schema);
  f.text({"name", "short name, used for the output folder; the file's name if absent"}, name);
  if (f.reading() && !can_name_a_folder(name)) f.refuse("name", what_can_name_a_folder());
  f.text({"description", help}, description);
}

std::string name_of(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  const std::string problem = !is_utf8(name)             ? "is not valid UTF-8"
                              : !can_name_a_folder(name) ? what_can_name_a_folder()
                                                         : "";
  if (!problem.empty())
    throw InputError("name", "is missing, and the file's name, used in its place, " + problem +
                                 "; give a name, or rename the file");
  return name;
}

bool has_control_characters(std::string_view text) {
  constexpr unsigned char kFirstShown = ' ', kDelete = 0x7F;
  return std::ranges::any_of(text, [](unsigned char c) { return c < kFirstShown || c == kDelete; });
}

}  // namespace quicksand
