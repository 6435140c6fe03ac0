#include "app/json/name_field.h"

namespace quicksand {

void describe_heading(Fields& f, std::string& name, std::string& description, const char* help) {
  constexpr std::size_t kLongest = 100;
  std::string schema;  // for editors; means nothing to the program
  f.text({"$schema", "path of this schema, for editors"}, schema);
  f.text({"name", "short name, used for the output folder; the file's name if absent"}, name);
  if (f.reading() &&
      (name.size() > kLongest || name.find('/') != std::string::npos || name.starts_with('.'))) {
    f.refuse("name", "names the output folder: at most " + std::to_string(kLongest) +
                         " bytes, no \"/\", no \".\" first");
  }
  f.text({"description", help}, description);
}

}  // namespace quicksand
