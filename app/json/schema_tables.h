// Markdown tables of what a JSON Schema says (json_schema.h makes them of field descriptions): the
// reference pages are printed from the same descriptions that the reader obeys.
#pragma once

#include <set>
#include <string>

#include "app/json/json_text.h"

namespace quicksand {

// A table key | values | default | meaning of the object that `schema` describes, with a row for each
// key of the objects inside, by its path. The keys in `left_out` have no row. Empty if there is none.
std::string key_table(const Json& schema, const std::set<std::string>& left_out = {});

// "text or list", of the types that a schema lists where a value may have several.
std::string words_of_types(const Json& types);

}  // namespace quicksand
