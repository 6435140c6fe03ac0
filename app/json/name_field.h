// Names: what a scene, campaign or session begins with, its name, which also names its output folder, and what it is; and
// names that must be those of something known.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/base/nearest_name.h"
#include "app/json/fields.h"

namespace quicksand {

// Refuses a name that would lead out of the folder for outputs or hide in it. The file's name stands in for an
// absent one. `help` says what the description tells.
void describe_heading(Fields& f, std::string& name, std::string& description, const char* help);

// That of a file, without its ending, for what has no name of its own. Throws InputError if it cannot be one.
std::string name_of(const std::filesystem::path& file);

// Such as line ends: a name with them would not be shown as it is.
bool has_control_characters(std::string_view text);

// The one of `known` that a field names; refuses a word that is none of them, "is not a `what`", with the nearest.
// Nullptr where nothing is read.
template <class Known, class Name>
auto known_in_field(Fields& f, const char* key, const std::string& word, const Known& known,
                    Name name, const char* what) -> decltype(std::data(known)) {
  if (!f.reading()) return nullptr;
  try {
    return &named(known, word, name, "", "\"" + word + "\" is not a " + what);
  } catch (const InputError& error) {
    f.refuse(key, error.what(), error.nearest());
  }
  return nullptr;
}

}  // namespace quicksand
