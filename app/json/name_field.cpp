#include "app/json/name_field.h"

#include <algorithm>

#include "app/json/json_text.h"
#include "core/base/errors.h"

namespace quicksand {

void describe_heading(Fields& f, std::string& name, std::string& description, const char* help) {
  constexpr std::size_t kLongest = 100;
  std::string schema;  // for editors; means nothing to the program
  f.text({"$schema", "path of this schema, for editors"}, schema);
  f.text({"name", "short name, used for the output folder; the file's name if absent"}, name);
  if (f.reading() && (name.size() > kLongest || name.find('/') != std::string::npos ||
                      name.starts_with('.') || has_control_characters(name))) {
    f.refuse("name", "names the output folder: at most " + std::to_string(kLongest) +
                         " bytes, no \"/\", no \".\" first, no control characters");
  }
  f.text({"description", help}, description);
}

std::string name_of(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  const char* problem = !is_utf8(name)                 ? "is no UTF-8"
                        : has_control_characters(name) ? "has control characters"
                                                       : nullptr;
  if (problem)
    throw InputError("name", std::string("is missing, and the name of the file, which stands in "
                                         "for it, ") +
                                 problem + "; give one, or rename the file");
  return name;
}

bool has_control_characters(std::string_view text) {
  constexpr unsigned char kFirstShown = ' ', kDelete = 0x7F;
  return std::ranges::any_of(text, [](unsigned char c) { return c < kFirstShown || c == kDelete; });
}

}  // namespace quicksand
