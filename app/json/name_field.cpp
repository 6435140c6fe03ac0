#include "app/json/name_field.h"

namespace quicksand {

void describe_name(Fields& f, std::string& name) {
  constexpr std::size_t kLongest = 100;
  f.text({"name", "short name, used for the output folder; the file's name if absent"}, name);
  if (f.reading() &&
      (name.size() > kLongest || name.find('/') != std::string::npos || name.starts_with('.'))) {
    f.refuse("name", "names the output folder: at most " + std::to_string(kLongest) +
                         " bytes, no \"/\", no \".\" first");
  }
}

}  // namespace quicksand
