#include "app/session/condition.h"

#include "app/base/nearest_name.h"
#include "app/json/name_field.h"
#include "app/series/quantities.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

const Quantity& quantity_named(const std::string& name, const std::string& place) {
  return named(quantities(), name, &Quantity::name, place, "\"" + name + "\" is not a quantity");
}

}  // namespace

void describe_bounds(Fields& f, Condition& condition, const char* unit) {
  constexpr double kAny = 1e300;
  f.number({"at_least", "lower bound, in the unit of the quantity"}, between(-kAny, kAny, unit),
           condition.at_least);
  f.number({"at_most", "upper bound, in the unit of the quantity"}, between(-kAny, kAny, unit),
           condition.at_most);
  if (!f.reading()) return;
  if (!condition.at_least && !condition.at_most)
    f.refuse("at_least", "is absent, and so is at_most; give one or both");
  if (condition.at_least && condition.at_most && *condition.at_least > *condition.at_most)
    f.refuse("at_least", "is above at_most");
}

void describe_condition(Fields& f, Condition& condition) {
  f.text({"quantity", "one of `quicksand list quantities`", Presence::required},
         condition.quantity);
  describe_bounds(f, condition, "1");
  const Quantity* quantity =
      known_in_field(f, "quantity", condition.quantity, quantities(), &Quantity::name, "quantity");
  if (!quantity) return;
  if (std::holds_alternative<std::string>(quantity->get(Row{})))
    f.refuse("quantity", "\"" + condition.quantity + "\" is a word and has no bounds");
}

std::optional<double> quantity_of(const Session& session, const std::string& name,
                                  const std::string& place) {
  const Quantity& quantity = quantity_named(name, place);
  if (session.timeline() && quantity.of_steps)
    throw InputError(place, name +
                                " is counted over steps, which a stored sample does not know; "
                                "it is in series.csv of the run");
  const Value value = quantity.get(session.measure_now());
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* count = std::get_if<std::int64_t>(&value)) return static_cast<double>(*count);
  return std::nullopt;
}

bool holds(const Condition& condition, std::optional<double> value) {
  return value && !(condition.at_least && !(*value >= *condition.at_least)) &&
         !(condition.at_most && !(*value <= *condition.at_most));
}

std::string words_of(const Condition& c) {
  if (c.at_least && c.at_most)
    return "from " + number_text(*c.at_least) + " to " + number_text(*c.at_most);
  return c.at_least ? "at least " + number_text(*c.at_least)
                    : "at most " + number_text(c.at_most.value_or(0));
}

}  // namespace quicksand
