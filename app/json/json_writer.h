// Writes the fields of an object as JSON with every default explicit.
#pragma once

#include "app/json/fields.h"
#include "app/json/json_text.h"

namespace quicksand {

Json written_object(const Fields::Visit& describe);

// The fields of a struct, by `describe(Fields&, T&)`.
template <class T, class Describe>
Json written_fields(T value, Describe describe) {  // a copy: a visit may change what it visits
  return written_object([&](Fields& f) { describe(f, value); });
}

}  // namespace quicksand
