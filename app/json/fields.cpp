#include "app/json/fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "app/base/nearest_name.h"
#include "core/base/errors.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

constexpr std::size_t kShortText = 60;

bool admits(const Limits& limits, double number) {
  const bool inside = limits.above ? number > limits.low : number >= limits.low;
  return inside && number <= limits.high;
}

// Empty if it is none of 64 bits. 1e5 is written as a float, but is a whole number.
std::optional<std::int64_t> whole_number(const Json& value) {
  if (value.is_number_unsigned()) {
    const auto number = value.get<std::uint64_t>();
    if (!std::in_range<std::int64_t>(number)) return std::nullopt;
    return static_cast<std::int64_t>(number);
  }
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (!value.is_number_float()) return std::nullopt;
  const auto number = value.get<double>();
  constexpr double kExact = 0x1p53;  // beyond it, floats leave whole numbers out
  if (!(std::abs(number) <= kExact) || number != std::floor(number)) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

double checked_number(const Json& value, const Limits& limits, const std::string& where) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!admits(limits, number)) {
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

Json number_schema(const Limits& limits) {
  Json schema = {{"type", "number"}};
  schema[limits.above ? "exclusiveMinimum" : "minimum"] = limits.low;
  schema["maximum"] = limits.high;
  return schema;
}

Json list_schema(const Limits& limits, std::size_t least, std::size_t most) {
  Json schema = {{"type", "array"}, {"items", number_schema(limits)}};
  if (least > 0) schema["minItems"] = least;
  schema["maxItems"] = most;
  return schema;
}

Json vector_schema(const Limits& limits) { return list_schema(limits, 2, 2); }

Json written(double value, const Limits& limits) { return value / limits.scale; }
Json written(const Vec2& value, const Limits& limits) {
  return {value.x() / limits.scale, value.y() / limits.scale};
}
template <class T>
Json written(const std::optional<T>& value, const Limits& limits) {
  return value ? written(*value, limits) : Json();
}

[[noreturn]] void refuse_value(const Json& value, const std::string& where,
                               const std::string& expected, std::string nearest = {}) {
  throw InputError(where, "is " + described(value) + ", must be " + expected, std::move(nearest));
}

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  while (most > 0 && continues(text[most])) --most;  // not within a letter
  return text.substr(0, most) + "...";
}

std::string described(const Json& value) {
  switch (value.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::object:
      return value.empty() ? "an empty object" : "an object";
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

void refuse_longer_list(const Json& list, std::size_t most, const std::string& where) {
  if (list.size() <= most) return;
  throw InputError(where, "has " + std::to_string(list.size()) + " entries, at most " +
                              std::to_string(most) + " are possible");
}

namespace {

// A number or a vector, or one that may be absent.
template <class T, class Checked>
Leaf measured(const Limits& limits, T& value, Checked checked, Json (*schema)(const Limits&)) {
  constexpr bool kOptional = requires { value.has_value(); };
  const auto read = [&limits, &value, checked](const Json& given, const std::string& where) {
    value = checked(given, limits, where);
  };
  return {read, [&] { return written(value, limits); },
          [&limits, schema] { return schema(limits); }, !kOptional, limits.unit};
}

}  // namespace

void Fields::number(const Field& field, const Limits& limits, double& value) {
  leaf(field, measured(limits, value, checked_number, number_schema));
}

void Fields::number(const Field& field, const Limits& limits, std::optional<double>& value) {
  leaf(field, measured(limits, value, checked_number, number_schema));
}

void Fields::vector(const Field& field, const Limits& limits, Vec2& value) {
  leaf(field, measured(limits, value, checked_vector, vector_schema));
}

void Fields::vector(const Field& field, const Limits& limits, std::optional<Vec2>& value) {
  leaf(field, measured(limits, value, checked_vector, vector_schema));
}

void Fields::numbers(const Field& field, const Limits& limits, std::size_t most,
                     std::vector<double>& values) {
  const auto read = [&](const Json& given, const std::string& where) {
    if (!given.is_array())
      refuse_value(given, where, "a list [...] of numbers, each " + described(limits));
    refuse_longer_list(given, most, where);
    values.clear();
    for (std::size_t i = 0; i < given.size(); ++i)
      values.push_back(checked_number(given[i], limits, where + "[" + std::to_string(i) + "]"));
  };
  const auto write = [&] {
    Json list = Json::array();
    for (const double value : values) list.push_back(written(value, limits));
    return list;
  };
  leaf(field, {read, write, [&] { return list_schema(limits, 0, most); }, false, limits.unit});
}

void Fields::integer(const Field& field, std::int64_t low, std::int64_t high, std::int64_t& value) {
  const auto read = [&](const Json& given, const std::string& where) {
    const std::optional<std::int64_t> number = whole_number(given);
    if (!number || *number < low || *number > high)
      refuse_value(given, where,
                   "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    value = *number;
  };
  const auto schema = [&] {
    return Json{{"type", "integer"}, {"minimum", low}, {"maximum", high}};
  };
  leaf(field, {read, [&] { return value; }, schema, true});
}

void Fields::flag(const Field& field, bool& value) {
  const auto read = [&](const Json& given, const std::string& where) {
    if (!given.is_boolean()) refuse_value(given, where, "true or false");
    value = given.get<bool>();
  };
  leaf(field, {read, [&] { return value; }, [] { return Json{{"type", "boolean"}}; }, true});
}

void Fields::text(const Field& field, std::string& value) {
  const auto read = [&](const Json& given, const std::string& where) {
    if (!given.is_string()) refuse_value(given, where, "a text");
    value = given.get<std::string>();
  };
  // An absent text and an empty one are the same.
  const auto write = [&] { return value.empty() ? Json() : Json(value); };
  leaf(field, {read, write, [] { return Json{{"type", "string"}}; }});
}

void Fields::word(const Field& field, std::span<const std::string_view> words, int& value) {
  const std::vector<std::string> names(words.begin(), words.end());
  const auto read = [&](const Json& given, const std::string& where) {
    const std::string name = given.is_string() ? given.get<std::string>() : "";
    const auto match = std::ranges::find(names, name);
    value = static_cast<int>(match - names.begin());
    if (match != names.end()) return;
    const std::string near = nearest_name(name, names);
    refuse_value(
        given, where,
        "one of " + joined(names, ", ") + (near.empty() ? "" : "; did you mean \"" + near + "\"?"),
        near);
  };
  leaf(field, {read, [&] { return names[static_cast<std::size_t>(value)]; },
               [&] {
                 return Json{{"enum", names}};
               },
               true});
}

void Fields::require_within(const std::string& given, const std::string& key, const Limits& limits,
                            double value) {
  const double number = value / limits.scale;
  if (!admits(limits, number))
    refuse(given.c_str(),
           "makes " + key + " " + message_number(number) + ", which must be " + described(limits));
}

void Fields::json(const Field& field, const Shape& shape, Json& value) {
  const auto read = [&](const Json& given, const std::string& where) {
    if (!shape.fits(given)) refuse_value(given, where, shape.words);
    value = given;
  };
  leaf(field, {read, [&] { return value; }, shape.schema});
}

}  // namespace quicksand
