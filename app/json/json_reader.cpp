#include "app/json/json_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/base/nearest_name.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr std::size_t kShortText = 60;

double checked_number(const Json& value, const Limits& limits, const std::string& where) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  const bool inside = limits.above ? number > limits.low : number >= limits.low;
  if (!std::isfinite(number) || !inside || number > limits.high) {
    throw InputError(where, "is " + described(value) + ", must be " + described(limits));
  }
  return number * limits.scale;
}

Vec2 checked_vector(const Json& value, const Limits& limits, const std::string& where) {
  if (!value.is_array() || value.size() != 2) {
    throw InputError(where, "is " + described(value) + ", must be two numbers [x, y], each " +
                                described(limits));
  }
  return {checked_number(value[0], limits, where + "[0]"),
          checked_number(value[1], limits, where + "[1]")};
}

void refuse_longer_list(const Json& list, std::size_t most, const std::string& where) {
  if (list.size() <= most) return;
  throw InputError(where, "has " + std::to_string(list.size()) + " entries, at most " +
                              std::to_string(most) + " are possible");
}

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string described(const Json& value) {
  switch (value.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "a list of " + std::to_string(value.size());
    case Json::value_t::string: {
      const auto& text = value.get_ref<const std::string&>();
      return text.size() > kShortText ? "a long text" : "the text \"" + text + "\"";
    }
    default:
      return value.dump();
  }
}

std::string described(const Limits& limits) {
  const std::string unit =
      std::string_view(limits.unit) == "1" ? "" : std::string(" ") + limits.unit;
  return (limits.above ? "a number above " : "a number from ") + number_text(limits.low) +
         (limits.above ? " and at most " : " to ") + number_text(limits.high) + unit;
}

JsonReader::JsonReader(const Json& value, std::string path, std::string whole)
    : object_(&value), path_(std::move(path)), whole_(std::move(whole)) {
  if (!value.is_object()) {
    throw InputError(path_, "is " + described(value) + ", must be an object {...}");
  }
}

void JsonReader::refuse_unknown_keys() const {
  for (const auto& [key, value] : object_->items()) {
    if (std::ranges::find(known_, key) == known_.end()) {
      throw InputError(place(key), "is not a key of " + (path_.empty() ? whole_ : "this object") +
                                       suggestion(key, known_));
    }
  }
}

const Json* JsonReader::find(const Field& field) {
  known_.emplace_back(field.name);
  const auto found = object_->find(field.name);
  if (found != object_->end()) return &*found;
  if (field.presence == Presence::required) {
    // A misspelt key is the likely reason for a missing one.
    std::vector<std::string> given;
    for (const auto& [key, value] : object_->items()) given.push_back(key);
    const std::string near = nearest_name(field.name, given);
    throw InputError(place(field.name), "is missing; it is required: " + std::string(field.help) +
                                            (near.empty() ? "" : " (you wrote \"" + near + "\")"));
  }
  return nullptr;
}

std::string JsonReader::place(std::string_view name) const {
  return path_.empty() ? std::string(name) : path_ + "." + std::string(name);
}

void JsonReader::number(const Field& field, const Limits& limits, double& value) {
  if (const Json* found = find(field)) value = checked_number(*found, limits, place(field.name));
}

void JsonReader::number(const Field& field, const Limits& limits, std::optional<double>& value) {
  if (const Json* found = find(field)) value = checked_number(*found, limits, place(field.name));
}

void JsonReader::vector(const Field& field, const Limits& limits, Vec2& value) {
  if (const Json* found = find(field)) value = checked_vector(*found, limits, place(field.name));
}

void JsonReader::vector(const Field& field, const Limits& limits, std::optional<Vec2>& value) {
  if (const Json* found = find(field)) value = checked_vector(*found, limits, place(field.name));
}

void JsonReader::numbers(const Field& field, const Limits& limits, std::size_t most,
                         std::vector<double>& values) {
  const Json* found = find(field);
  if (found == nullptr) return;
  const std::string where = place(field.name);
  if (!found->is_array()) {
    throw InputError(where, "is " + described(*found) + ", must be a list [...] of numbers, each " +
                                described(limits));
  }
  refuse_longer_list(*found, most, where);
  values.clear();
  for (std::size_t i = 0; i < found->size(); ++i) {
    values.push_back(checked_number((*found)[i], limits, where + "[" + std::to_string(i) + "]"));
  }
}

void JsonReader::integer(const Field& field, std::int64_t low, std::int64_t high,
                         std::int64_t& value) {
  const Json* found = find(field);
  if (found == nullptr) return;
  // 1e5 is written as a float, but is a whole number.
  const double number = found->is_number() ? found->get<double>() : std::nan("");
  if (!(number >= static_cast<double>(low) && number <= static_cast<double>(high)) ||
      number != std::floor(number)) {
    throw InputError(place(field.name), "is " + described(*found) +
                                            ", must be a whole number from " + std::to_string(low) +
                                            " to " + std::to_string(high));
  }
  value = found->is_number_float() ? static_cast<std::int64_t>(number) : found->get<std::int64_t>();
}

void JsonReader::flag(const Field& field, bool& value) {
  const Json* found = find(field);
  if (found == nullptr) return;
  if (!found->is_boolean()) {
    throw InputError(place(field.name), "is " + described(*found) + ", must be true or false");
  }
  value = found->get<bool>();
}

void JsonReader::text(const Field& field, std::string& value) {
  const Json* found = find(field);
  if (found == nullptr) return;
  if (!found->is_string()) {
    throw InputError(place(field.name), "is " + described(*found) + ", must be a text");
  }
  value = found->get<std::string>();
}

void JsonReader::word(const Field& field, std::span<const std::string_view> words, int& value) {
  const Json* found = find(field);
  if (found == nullptr) return;
  const std::vector<std::string> names(words.begin(), words.end());
  const auto match =
      found->is_string() ? std::ranges::find(names, found->get<std::string>()) : names.end();
  if (match == names.end()) {
    std::string choices;
    for (const std::string& name : names) choices += (choices.empty() ? "" : ", ") + name;
    const std::string near =
        found->is_string() ? nearest_name(found->get<std::string>(), names) : std::string();
    throw InputError(place(field.name),
                     "is " + described(*found) + ", must be one of " + choices +
                         (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
  }
  value = static_cast<int>(match - names.begin());
}

void JsonReader::json(const Field& field, const Shape& shape, Json& value) {
  const Json* found = find(field);
  if (found == nullptr) return;
  if (!shape.fits(*found)) {
    throw InputError(place(field.name), "is " + described(*found) + ", must be " + shape.words);
  }
  value = *found;
}

void JsonReader::object(const Field& field, const Visit& visit) {
  begin_optional(field, false, visit);
}

bool JsonReader::begin_optional(const Field& field, bool /*present*/, const Visit& visit) {
  const Json* found = find(field);
  if (found == nullptr) return false;
  JsonReader inner(*found, place(field.name));
  visit(inner);
  inner.refuse_unknown_keys();
  return true;
}

void JsonReader::items(const Field& field, std::size_t most, std::size_t /*size*/,
                       const std::function<void(std::size_t)>& resize, const VisitItem& visit) {
  const Json* found = find(field);
  if (found == nullptr) return;
  if (!found->is_array()) {
    throw InputError(place(field.name), "is " + described(*found) + ", must be a list [...]");
  }
  refuse_longer_list(*found, most, place(field.name));
  resize(found->size());
  for (std::size_t i = 0; i < found->size(); ++i) {
    JsonReader inner((*found)[i], place(field.name) + "[" + std::to_string(i) + "]");
    visit(inner, i);
    inner.refuse_unknown_keys();
  }
}

void JsonReader::exactly_one(const std::vector<std::string>& names) {
  std::string all;
  std::vector<std::string> given;
  for (const std::string& name : names) {
    all += (all.empty() ? "" : " or ") + name;
    if (object_->contains(name)) given.push_back(name);
  }
  if (given.empty()) throw InputError(place(names.front()), "is missing; give " + all);
  if (given.size() > 1) {
    throw InputError(place(given[1]), "is given besides " + given[0] + "; give only one: " + all);
  }
}

void JsonReader::variant(const Field& field, std::span<const std::string_view> words, int index,
                         const std::function<void(Fields&, int)>& visit) {
  word({field.name, field.help, Presence::required}, words, index);
  visit(*this, index);
}

void JsonReader::refuse(const char* name, const std::string& problem) {
  throw InputError(place(name), problem);
}

}  // namespace quicksand
