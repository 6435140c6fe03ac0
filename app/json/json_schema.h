// Makes the JSON Schema (draft 07, which editors know) of what read_fields() accepts.
#pragma once

#include "app/json/fields.h"
#include "app/json/json_text.h"

namespace quicksand {

// That of an object: `describe` visits the fields of one with its defaults.
Json object_schema(const Fields::Visit& describe);

// The whole schema of a kind of file.
Json file_schema(const char* title, const std::string& description, const Fields::Visit& describe);

}  // namespace quicksand
