// Reads the fields of an object from JSON, strictly: a value of the wrong type or out of its range,
// a missing required key and an unknown key are refused with an InputError that says where, what,
// the allowed range with its unit and the nearest valid name. The mistakes of a file, at most ten, are told together.
#pragma once

#include <string>

#include "app/json/fields.h"
#include "app/json/json_text.h"

namespace quicksand {

// All fields of an object. `path` is its place inside the file, "" for the whole, which messages call `whole`,
// "a scene". Throws InputError.
void read_fields(const Json& json, const std::string& whole, const Fields::Visit& describe,
                 const std::string& path = {});

}  // namespace quicksand
