// A condition on a quantity of the present moment, as `run` waits for it and `expect` checks it.
#pragma once

#include <optional>
#include <string>

#include "app/json/fields.h"
#include "app/session/session.h"

namespace quicksand {

struct Condition {
  std::string quantity;
  std::optional<double> at_least;
  std::optional<double> at_most;
};

// A quantity of `quicksand list quantities`, and at least one bound.
void describe_condition(Fields& f, Condition& condition);
// The bounds alone: at least one, in `unit`; refuses bounds in the wrong order.
void describe_bounds(Fields& f, Condition& condition, const char* unit);

// The value of a quantity; absent if there is none at this moment, such as a depth without an intruder,
// or if it is no number. Throws InputError for an unknown name.
std::optional<double> quantity_of(const Session& session, const std::string& name,
                                  const std::string& place);

// A quantity without a value meets no condition.
bool holds(const Condition& condition, std::optional<double> value);

// "at least 0.2", "from 0.2 to 0.3".
std::string words_of(const Condition& condition);

}  // namespace quicksand
